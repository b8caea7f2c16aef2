/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots of bodies with moments and of clumps: flows against the exponential of the whole system in long double, what
 * they keep and lose, spheres as the limit, impacts. */
#include "linear.h"

static uneven m;

/* ---- one touch --------------------------------------------------------------------------------------------------- */

/** Moves body 0 so that its sphere 0 and sphere 1 of body 1, or the plane through 0, overlap by a share o along n. */
static void press(rng *g, int plane, double o, struct linear *at)
{
    double n[3];
    random_unit(g, 3, n);
    random_vector(g, 1, m.t.c.x[1]);
    const vec r0 = linear_lever(&m, 0), r1 = linear_lever(&m, 1);
    const double di = m.t.diameter[0], dj = m.t.diameter[1], length = plane ? 0.5 * di : 0.5 * (di + dj),
                 r = length * (1 - o), si = plane ? 1 : di / (di + dj);
    *at = (struct linear){.plane = plane, .body = {0, 1}, .n = vec_of(n)};
    for (int k = 0; k < 3; ++k) {
        m.plane[0][k] = n[k];
        m.t.c.x[1][k] = plane ? 40 * n[k] : m.t.c.x[1][k];
        m.t.c.x[0][k] = (plane ? 0 : m.t.c.x[1][k] + (double)r1.c[k]) + r * n[k] - (double)r0.c[k];
        at->arm[0].c[k] = r0.c[k] - si * r * at->n.c[k];
        at->arm[1].c[k] = r1.c[k] + (1 - si) * r * at->n.c[k];
    }
}

/** Each of the four alone. */
TEST(each_flow)
{
    rng g = rng_seed(5101);
    for (int trial = 0; trial < 720; ++trial) {
        const int plane = trial % 2, which = trial / 2 % 4;
        const double c = pow(10, uniform(&g, -3, 0.3)), t = uniform(&g, 0.05, 1);
        struct linear at;
        linear_bodies(&m, &g, trial / 8 % UNEVEN_KINDS, trial / 24 % UNEVEN_STATES, 2, 1);
        press(&g, plane, 0.05, &at);
        at.c[which] = c;
        vti_dashpots dashpots = {.contacts = plane ? NULL : &m.t.contacts,
                                 .walls = plane ? &m.walls : NULL,
                                 .pull = 1,
                                 .reach = INFINITY,
                                 .lost = m.lost};
        double *const coefficient[] = {&dashpots.normal, &dashpots.tangential, &dashpots.rolling, &dashpots.twisting};
        *coefficient[which] = c;
        uneven_add(&m, vti_dashpots_effect(&dashpots));
        linear_assert_flow(&m, &at, t, trial % 3 ? 0 : -0.0);
        assert_true(m.lost[which].high > 0);
    }
}

/** A dashpot pulls no harder than the contact pushes, and across the normal and about it no harder than friction lets
 *  it together with what its springs hold. */
TEST(limits)
{
    rng g = rng_seed(5102);
    int limited = 0;
    for (int trial = 0; trial < 600; ++trial) {
        const int which = trial % 4, kind = trial / 4 % UNEVEN_KINDS;
        const double t = 0.01, c = pow(10, uniform(&g, 0, 4)), mu = 0.3;
        struct linear at;
        double v[3], load[3], along = 0, size = 0;
        long double ahead = 0;
        vec before[4], after[4];
        linear_bodies(&m, &g, kind, UNEVEN_BOTH, 2, 1);
        press(&g, 0, 0.01, &at);
        /* slow, as what friction allows may be more than what stops them */
        for (int k = 0; k < 6 && trial / 24 % 2; ++k) {
            m.t.c.v[k / 3][k % 3] *= 0.05;
            m.spin[k / 3][k % 3] *= 0.05;
        }
        vti_friction friction = {.sliding = mu, .rolling = mu, .twisting = mu, .history = &m.history};
        vti_dashpots dashpots = {.contacts = &m.t.contacts, .friction = &friction, .reach = INFINITY, .lost = m.lost};
        double *const coefficient[] = {&dashpots.normal, &dashpots.tangential, &dashpots.rolling, &dashpots.twisting};
        *coefficient[which] = c;
        const double length = 0.5 * (m.t.diameter[0] + m.t.diameter[1]);
        const double force = 1e4 * pow(0.01, 1.5) / length; /* Hertz: K/L o^{3/2} */
        random_vector(&g, mu * force, load);
        vti_held held = {m.t.pair[0][0] + 1, m.t.pair[0][1] + 1, {0}, {0}, 0};
        const double along_n = vti_dot(load, m.plane[0]);
        for (int k = 0; k < 3; ++k)
            load[k] -= along_n * m.plane[0][k];
        const double share = trial / 12 % 2 ? mu * force / vti_norm(load) : 0.5; /* on the limit, or half of any */
        for (int k = 0; k < 3; ++k)
            held.sliding[k] = held.rolling[k] = share * load[k];
        held.twisting = 0.5 * load[0];
        assert_int_equal(vti_history_add(&m.history, &held), VTI_OK);
        uneven_add(&m, vti_dashpots_effect(&dashpots));
        for (int k = 0; k < 3; ++k) /* they part */
            m.t.c.v[0][k] += 3 * m.plane[0][k];
        const double energy = vti_energy(m.effects, 1, &m.b);
        linear_state(&m, before);
        assert_int_equal(vti_effects_flow(m.effects, 1, t, 0, &m.b), VTI_OK);
        linear_state(&m, after);
        for (int k = 0; k < 3; ++k) {
            v[k] = which < 2 ? m.t.c.mass[0] * (double)(after[0].c[k] - before[0].c[k])
                             : (double)(after[1].c[k] - before[1].c[k]);
            along += v[k] * m.plane[0][k];
        }
        for (int k = 0; k < 3; ++k) { /* the impulse less what the spring has given by then */
            const double f = which == 1   ? held.sliding[k]
                             : which == 2 ? held.rolling[k]
                                          : held.twisting * m.plane[0][k];
            size += pow(v[k] - t * f, 2);
        }
        if (which == 0)
            assert_below(-along, t * force * (1 + 1e-9));
        else
            assert_below(sqrt(size), t * mu * force * (1 + 1e-9));
        limited += (which == 0 ? -along : sqrt(size)) > t * (which == 0 ? 1 : mu) * force * (1 - 1e-9);
        const double left = vti_energy(m.effects, 1, &m.b);
        assert_close(left + vti_booked(m.effects, 1), energy, 100 * EPS * energy);
        assert_true(left <= energy * (1 + 4 * EPS)); /* though modes decay by masses of their own */
        for (int q = 0; q < 4; ++q) { /* p.u: no impulse pushes on beyond where the kinetic energy is least */
            const vec p = vec_add(after[q], -1, before[q]);
            ahead +=
                q % 2 ? vec_dot(p, linear_over(&m, q / 2, after[q], -1)) : m.t.c.mass[q / 2] * vec_dot(p, after[q]);
        }
        assert_below(ahead, 1e4 * EPS);
    }
    print_message("%d of 600 are limited\n", limited);
    assert_in_range(limited, 100, 500);
}

/* ---- many touches ------------------------------------------------------------------------------------------------ */

/** All motions at many touches of the same bodies, forwards and backwards, and at a plane that moves: each sees the
 *  velocities that those before it have left, as else energy would not be what is booked. */
TEST(many_touches)
{
    rng g = rng_seed(5103);
    for (int trial = 0; trial < 300; ++trial) {
        const int planes = trial / 2 % 2;
        double before[6], after[6];
        vti_sum work = {0, 0};
        vti_wall_motion motion = {.velocity = {0.3, -0.2, 0.1}, .spin = 0.5};
        linear_bodies(&m, &g, trial % UNEVEN_KINDS, trial / 6 % UNEVEN_STATES, 3, trial % UNEVEN_KINDS ? 4 : 1);
        crowd_scatter(&m.t.c, &g, 0.3, 0.1);
        m.plane[0][2] = 1;
        m.walls.motion = trial % 8 < 4 ? &motion : NULL;
        m.walls.work = &work;
        const vti_dashpots dashpots = {.contacts = &m.t.contacts,
                                       .walls = planes ? &m.walls : NULL,
                                       .zeta = 0.4,
                                       .ratio = 2,
                                       .rolling = 0.5,
                                       .twisting = 0.4,
                                       .pull = trial % 5 == 0,
                                       .reach = 0.1,
                                       .lost = m.lost};
        uneven_add(&m, vti_dashpots_effect(&dashpots));
        const double energy = vti_energy(m.effects, 1, &m.b);
        uneven_momenta(&m, before);
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.01, trial % 2 ? -0.01 : 0.01, &m.b), VTI_OK);
        uneven_momenta(&m, after);
        for (int k = 0; k < 6 && !planes; ++k)
            assert_close(after[k], before[k], 1e4 * EPS); /* up to 48 touches of some 200 operations */
        assert_close(vti_energy(m.effects, 1, &m.b) + vti_booked(m.effects, 1) + vti_sum_value(&work), energy,
                     1e4 * EPS * energy);
        assert_true(m.lost[0].high > 0 && m.lost[3].high > 0);
    }
}

/** A plane's own zeta stands in the place of that of all, which may be none. */
TEST(zeta_of_a_plane)
{
    rng g = rng_seed(5108);
    for (int trial = 0; trial < 2 * UNEVEN_KINDS; ++trial) {
        const int kind = trial / 2;
        struct linear at;
        double zeta = 0;
        linear_bodies(&m, &g, kind, UNEVEN_BOTH, 2, 1);
        press(&g, 1, 0.05, &at);
        const vti_dashpots dashpots = {.walls = &m.walls,
                                       .zeta = trial % 2 ? 0.5 : 0,
                                       .pull = 1,
                                       .reach = INFINITY,
                                       .lost = m.lost,
                                       .wall_zeta = &zeta};
        uneven_add(&m, vti_dashpots_effect(&dashpots));
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.01, 0, &m.b), VTI_OK);
        assert_true(m.lost[0].high == 0);
        zeta = 0.5;
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.01, 0, &m.b), VTI_OK);
        assert_true(m.lost[0].high > 0);
    }
}

/** Without friction of its own a plane lets slide what damps along it. */
TEST(no_friction_at_a_plane)
{
    rng g = rng_seed(5109);
    for (int kind = 0; kind < UNEVEN_KINDS; ++kind) {
        static vti_history nothing;
        struct linear at;
        double mu = 0, lost;
        linear_bodies(&m, &g, kind, UNEVEN_BOTH, 2, 1);
        press(&g, 1, 0.05, &at);
        const vti_friction friction = {.sliding = 0.5, .wall_sliding = &mu, .history = &nothing};
        const vti_dashpots dashpots = {
            .walls = &m.walls, .friction = &friction, .tangential = 1, .reach = INFINITY, .lost = m.lost};
        uneven_add(&m, vti_dashpots_effect(&dashpots));
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.01, 0, &m.b), VTI_OK);
        lost = m.lost[1].high;
        mu = 0.5;
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.01, 0, &m.b), VTI_OK);
        assert_true(m.lost[1].high > 0);
        assert_close(lost, 0, 8 * EPS * m.lost[1].high); /* |g| |g| of a root is g.g to rounding */
    }
}

/** Backwards is forwards with the list in the other order. */
TEST(backwards_is_the_other_order)
{
    rng g = rng_seed(5104);
    for (int trial = 0; trial < 60; ++trial) {
        static crowd start;
        vec once[4], again[4];
        linear_bodies(&m, &g, trial % 2 ? UNEVEN_CLUMPS : UNEVEN_SPHERICAL, UNEVEN_BOTH, 2, 4);
        crowd_scatter(&m.t.c, &g, 0.2, 0.1);
        const vti_dashpots dashpots = {
            .contacts = &m.t.contacts, .normal = 3, .pull = 1, .reach = INFINITY, .lost = m.lost};
        uneven_add(&m, vti_dashpots_effect(&dashpots));
        start = m.t.c;
        double spin[2][3];
        memcpy(spin, m.spin, sizeof spin);
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.1, -1e-9, &m.b), VTI_OK);
        linear_state(&m, once);
        m.t.c = start;
        memcpy(m.spin, spin, sizeof spin);
        for (int64_t k = 0, n = m.t.contacts.count; k < n / 2; ++k)
            for (int side = 0; side < 2; ++side) {
                const int64_t other = m.t.pair[n - 1 - k][side];
                m.t.pair[n - 1 - k][side] = m.t.pair[k][side];
                m.t.pair[k][side] = other;
            }
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.1, 1e-9, &m.b), VTI_OK);
        linear_state(&m, again);
        for (int q = 0; q < 4; ++q)
            for (int k = 0; k < 3; ++k)
                assert_close(once[q].c[k], again[q].c[k], 1e-6); /* the means over drifts of 1e-9 differ by as much */
    }
}

/** Two bodies of one sphere each, far from each other in the corner of the same two planes. */
static void in_a_corner(rng *g, int kind)
{
    static const double planes[2][3] = {{1, 0, 0}, {0.6, 0.8, 0}};
    linear_bodies(&m, g, kind, UNEVEN_BOTH, 2, 1);
    m.walls.count = 2;
    for (int k = 0; k < 2; ++k)
        memcpy(m.plane[k], planes[k], sizeof planes[k]);
    for (int i = 0; i < 2; ++i) {
        const vec lever = linear_lever(&m, i);
        const double gap = 0.475 * m.t.diameter[i], place[3] = {gap, 0.5 * gap, 40 * i};
        for (int k = 0; k < 3; ++k)
            m.t.c.x[i][k] = place[k] - (double)lever.c[k];
    }
}

/** Where a body is at several planes they go one by one, backwards in the other order; a slice has its own bodies
 *  alone; and each plane has its own zeta. */
TEST(in_corners)
{
    rng g = rng_seed(5110);
    for (int trial = 0; trial < 10 * UNEVEN_KINDS; ++trial) {
        static crowd start, all;
        static double spin[CROWD_MAX][3], spun[CROWD_MAX][3];
        vec once[4], again[4];
        double zeta[2] = {0, 0}, changed = 0;
        in_a_corner(&g, trial % UNEVEN_KINDS);
        vti_dashpots dashpots = {.walls = &m.walls, .normal = 3, .pull = 1, .reach = INFINITY, .lost = m.lost};
        uneven_add(&m, vti_dashpots_effect(&dashpots));
        start = m.t.c;
        memcpy(spin, m.spin, sizeof spin);
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.1, 1e-9, &m.b), VTI_OK);
        all = m.t.c;
        memcpy(spun, m.spin, sizeof spin);
        linear_state(&m, once);

        m.t.c = start;
        memcpy(m.spin, spin, sizeof spin);
        const vti_bodies second = vti_bodies_slice(m.b, 1, 1);
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.1, 1e-9, &second), VTI_OK);
        assert_same_bits(m.t.c.v[0], start.v[0], 3);
        assert_same_bits(m.t.c.v[1], all.v[1], 3);
        assert_same_bits(m.spin[0], spin[0], 3);
        assert_same_bits(m.spin[1], spun[1], 3);

        for (int swapped = 0; swapped < 2; ++swapped) {
            m.t.c = start;
            memcpy(m.spin, spin, sizeof spin);
            for (int k = 0; k < 3 && swapped; ++k) {
                const double other = m.plane[0][k];
                m.plane[0][k] = m.plane[1][k];
                m.plane[1][k] = other;
            }
            assert_int_equal(vti_effects_flow(m.effects, 1, 0.1, -1e-9, &m.b), VTI_OK);
            linear_state(&m, again);
            for (int q = 0; q < 4; ++q)
                for (int k = 0; k < 3; ++k)
                    if (swapped)
                        assert_close(once[q].c[k], again[q].c[k], 1e-6);
                    else
                        changed = fmax(changed, fabs((double)(once[q].c[k] - again[q].c[k])));
        }
        assert_true(changed > 1e-4); /* the order tells */

        dashpots.normal = 0;
        dashpots.wall_zeta = zeta;
        m.plane[0][3] = -1e3; /* so that they are at the second one alone */
        for (int w = 0; w < 2; ++w) {
            zeta[w] = 0.5;
            memset(m.lost, 0, sizeof m.lost);
            assert_int_equal(vti_effects_flow(m.effects, 1, 0.1, 1e-9, &m.b), VTI_OK);
            assert_true((m.lost[0].high > 0) == (w == 1));
        }
    }
}

/* ---- limits of what bodies may be -------------------------------------------------------------------------------- */

/** Three equal moments are the sphere's flows to rounding, in steps with contacts and walls. */
TEST(equal_moments_are_spheres)
{
    rng g = rng_seed(5105);
    for (int trial = 0; trial < 12; ++trial) {
        static crowd spheres;
        linear_bodies(&m, &g, UNEVEN_BODIES, UNEVEN_BOTH, 3, 1);
        crowd_scatter(&m.t.c, &g, 0.5, 0.5);
        for (int i = 0; i < 3; ++i) {
            const double j = m.t.c.inertia[i] = uniform(&g, 0.05, 0.2);
            m.moments[i][0] = m.moments[i][1] = m.moments[i][2] = j;
            m.t.diameter[i] = 0.6;
        }
        uneven_spin_up(&m);
        m.plane[0][2] = 1;
        m.plane[0][3] = -0.5;
        vti_sum other[4] = {{0, 0}}, rubbed[3] = {{0, 0}};
        static vti_held entries[UNEVEN_SLOTS];
        static int64_t slots[UNEVEN_SLOTS];
        memset(slots, 0, sizeof slots);
        vti_history history = {UNEVEN_SLOTS, 0, 0, entries, slots};
        const vti_friction friction = {.contacts = &m.t.contacts,
                                       .walls = &m.walls,
                                       .sliding = 0.4,
                                       .rolling = 0.05,
                                       .twisting = 0.05,
                                       .mindlin = 0.8,
                                       .rolling_stiffness = 100,
                                       .twisting_stiffness = 100,
                                       .reach = 0.1,
                                       .history = &m.history,
                                       .lost = m.rubbed};
        const vti_dashpots dashpots = {.contacts = &m.t.contacts,
                                       .walls = &m.walls,
                                       .friction = &friction,
                                       .zeta = 0.3,
                                       .ratio = 0.5,
                                       .rolling = 0.02,
                                       .twisting = 0.01,
                                       .reach = 0.1,
                                       .lost = m.lost};
        vti_dashpots of_spheres = dashpots;
        of_spheres.lost = other;
        vti_friction rubbing = friction;
        rubbing.history = &history;
        rubbing.lost = rubbed;
        of_spheres.friction = &rubbing;
        const vti_effect contact = vti_contacts_effect(&m.t.contacts), wall = vti_walls_effect(&m.walls);
        uneven_add(&m, contact);
        uneven_add(&m, wall);
        uneven_add(&m, vti_friction_effect(&friction));
        uneven_add(&m, vti_dashpots_effect(&dashpots));
        spheres = m.t.c;
        const vti_effect effects[4] = {contact, wall, vti_friction_effect(&rubbing), vti_dashpots_effect(&of_spheres)};
        const vti_bodies b = crowd_bodies(&spheres);
        const vti_stepper *vti2 = vti_stepper_find("vti2");
        uneven_go(&m, vti2, 0.001, 400);
        assert_int_equal(vti_apply(effects, 4, &b), VTI_OK);
        for (int step = 0; step < 400; ++step) {
            assert_int_equal(vti_effects_begin(vti2, 0.001, effects, 4, &b, NULL), VTI_OK);
            assert_int_equal(vti_apply(effects, 4, &b), VTI_OK);
            assert_int_equal(vti_effects_finish(vti2, 0.001, effects, 4, &b), VTI_OK);
        }
        for (int i = 0; i < 3; ++i) { /* rounding of 400 steps, which impacts make grow */
            assert_close3(m.t.c.v[i], spheres.v[i], 1e-9);
            assert_close3(m.t.c.omega[i], spheres.omega[i], 1e-9);
        }
        assert_true(m.lost[0].high > 0.01 && m.rubbed[0].high > 0 && m.rubbed[1].high > 0);
        for (int k = 0; k < 3; ++k)
            assert_close(m.rubbed[k].high, rubbed[k].high, 1e-9);
        for (int k = 0; k < 4; ++k)
            assert_close(m.lost[k].high, other[k].high, 1e-9);
    }
}

/** Needles and plates, moments 1 : 1e6 and 1 : 1e20, by any coefficient: finite, and no energy is gained. */
TEST(extreme_moments)
{
    rng g = rng_seed(5106);
    for (int trial = 0; trial < 2000; ++trial) {
        struct linear at;
        const double thin = trial % 4 < 2 ? 1e-6 : 1e-20, c = pow(10, uniform(&g, -6, 12));
        linear_bodies(&m, &g, trial % 2 ? UNEVEN_BODIES : UNEVEN_CLUMPS, UNEVEN_BOTH, 2, 1);
        press(&g, trial / 4 % 2, 0.05, &at);
        for (int i = 0; i < 2; ++i) {
            m.moments[i][0] = thin;
            m.moments[i][1] = m.moments[i][2] = 1;
            random_vector(&g, 1, m.spin[i]);
            for (int k = 0; k < 3; ++k) /* turning about the thin axis as about the others */
                m.spin[i][k] *= thin == 1e-6 ? 1 : 0;
            m.b.principal = quats_packed(m.principal[0]);
        }
        const vti_dashpots dashpots = {.contacts = trial / 4 % 2 ? NULL : &m.t.contacts,
                                       .walls = trial / 4 % 2 ? &m.walls : NULL,
                                       .normal = c,
                                       .tangential = c,
                                       .rolling = c,
                                       .twisting = c,
                                       .pull = 1,
                                       .reach = INFINITY,
                                       .lost = m.lost};
        uneven_add(&m, vti_dashpots_effect(&dashpots));
        const double energy = vti_energy(m.effects, 1, &m.b);
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.1, trial % 3 ? 0.01 : -0.01, &m.b), VTI_OK);
        const double left = vti_energy(m.effects, 1, &m.b);
        assert_true(left <= energy * (1 + 1e-9)); /* the energy of L across a thin axis is known to eps 1e6 */
        assert_true(all_finite(m.spin[0], 6) && all_finite(m.t.c.v[0], 6));
    }
}

/** Bodies that only turn, or that nothing turns; a pair of one body, which does nothing. */
TEST(absent_motions)
{
    rng g = rng_seed(5107);
    struct linear at;
    for (int kind = UNEVEN_CLUMPS; kind < UNEVEN_KINDS; ++kind) {
        linear_bodies(&m, &g, kind, UNEVEN_SPIN, 2, 1);
        press(&g, 0, 0.05, &at);
        vti_dashpots dashpots = {
            .contacts = &m.t.contacts, .normal = 1e9, .pull = 1, .reach = INFINITY, .lost = m.lost};
        uneven_add(&m, vti_dashpots_effect(&dashpots));
        const crowd start = m.t.c;
        double spin[3], u[3];
        memcpy(spin, m.spin[0], sizeof spin);
        m.b.v = vti_view_none();
        assert_int_equal(vti_effects_flow(m.effects, 1, 1, 0, &m.b), VTI_OK);
        assert_same_bits(m.t.c.v, start.v, 6);
        vti_clumps_spread(&m.t.clumps, &m.b);
        for (int k = 0; k < 3; ++k)
            u[k] = m.t.s.v[0][k] - m.t.s.v[1][k];
        assert_close(vti_dot(u, m.plane[0]), 0, 1e-12); /* turning is all that there is, and it stops */
        assert_true(m.lost[0].high > 0);
        m.lost[0].high = 0;
        memset(m.t.offset, 0, sizeof m.t.offset); /* where what acts on them does not turn them */
        memcpy(m.t.c.x[0], m.t.c.x[1], sizeof m.t.c.x[0]);
        m.t.c.x[0][2] += 0.5 * m.t.diameter[0];
        dashpots.zeta = dashpots.ratio = 1;
        dashpots.tangential = 1e-6;
        assert_int_equal(vti_effects_flow(m.effects, 1, 1, 0, &m.b), VTI_OK);
        assert_true(m.lost[0].high == 0 && m.lost[1].high > 0);
        assert_true(all_finite(m.spin[0], 6) && all_finite(m.t.c.omega[0], 6));
        dashpots.zeta = dashpots.ratio = dashpots.normal = 0;
        assert_int_equal(vti_effects_flow(m.effects, 1, 1, 0, &m.b), VTI_OK);
        assert_true(all_finite(m.spin[0], 6) && all_finite(m.t.c.omega[0], 6));
        dashpots.normal = 1e9;

        m.b.v = crowd_bodies(&m.t.c).v;
        m.b.omega = m.b.spin = m.b.moment = vti_view_none();
        m.b.moments = vti_view_none();
        m.b.principal = vti_bodies_none(1).quat;
        assert_int_equal(vti_effects_flow(m.effects, 1, 100, 0, &m.b), VTI_OK);
        assert_close(m.t.c.v[0][2], m.t.c.v[1][2], 1e-12); /* one body as a whole */
        assert_true(m.lost[0].high > 0);
        m.t.body[1] = 0;
        m.lost[0].high = 0;
        assert_int_equal(vti_effects_flow(m.effects, 1, 100, 0, &m.b), VTI_OK);
        assert_below(fabs(m.lost[0].high), 100 * EPS);
    }
}

RUN_TESTS(cmocka_unit_test(each_flow), cmocka_unit_test(limits), cmocka_unit_test(many_touches),
          cmocka_unit_test(zeta_of_a_plane), cmocka_unit_test(no_friction_at_a_plane),
          cmocka_unit_test(backwards_is_the_other_order), cmocka_unit_test(in_corners),
          cmocka_unit_test(equal_moments_are_spheres), cmocka_unit_test(extreme_moments),
          cmocka_unit_test(absent_motions))
