/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Clumps: spread against a textbook algebra, gather as its transpose, momenta, and effects that pass through. */
#include "troop.h"

static troop t;
static crowd free_spheres;

static vti_bodies bodies(void)
{
    return crowd_bodies(&t.c);
}

/** r = R rho in long double. */
static void textbook_lever(int s, double r[3])
{
    quat_rotate(crowd_attitude(&t.c, (int)t.body[s]), t.offset[s], r);
}

/* ---- spread and gather ------------------------------------------------------------------------------------------- */

TEST(spread_places_spheres)
{
    rng g = rng_seed(4101);
    for (int trial = 0; trial < 200; ++trial) {
        troop_draw(&t, &g, 5, 4, 0.7, trial & 1 ? CROWD_QUAT : CROWD_ALPHA, trial & 2 ? CROWD_QUAT : CROWD_ALPHA);
        const vti_bodies b = bodies();
        assert_int_equal(vti_clumps_spread(&t.clumps, &b), VTI_OK);
        for (int s = 0; s < t.s.n; ++s) {
            const int i = (int)t.body[s];
            double r[3], turn[3];
            textbook_lever(s, r);
            vti_cross(t.c.omega[i], r, turn);
            for (int k = 0; k < 3; ++k) {
                assert_close(t.s.x[s][k], t.c.x[i][k] + r[k], 16 * EPS); /* numbers below 3, some 10 operations */
                assert_close(t.s.v[s][k], t.c.v[i][k] + turn[k], 16 * EPS);
            }
            assert_same_bits(t.s.omega[s], t.c.omega[i], 3);
            assert_below(quat_distance(crowd_attitude(&t.s, s), crowd_attitude(&t.c, i)), 8 * EPS);
            if (t.s.storage == CROWD_QUAT) /* a unit quaternion, where alpha has a length of its own */
                assert_close(vti_dot(t.s.quat[s], t.s.quat[s]) + t.s.quat[s][3] * t.s.quat[s][3], 1, 8 * EPS);
            if (t.c.storage == CROWD_ALPHA && t.s.storage == CROWD_ALPHA)
                assert_same_bits(t.s.alpha[s], t.c.alpha[i], 3);
            if (t.c.storage == CROWD_QUAT && t.s.storage == CROWD_QUAT)
                assert_same_bits(t.s.quat[s], t.c.quat[i], 4);
        }
    }
}

/** Half turns too, of any length of alpha. */
TEST(same_form_same_bits)
{
    rng g = rng_seed(4114);
    for (int trial = 0; trial < 40; ++trial) {
        do
            troop_draw(&t, &g, 2, 3, 0.7, CROWD_ALPHA, CROWD_ALPHA);
        while (t.clumps.count == 0);
        const vti_bodies b = bodies();
        for (int i = 0; i < 2; ++i)
            for (int k = 0; k < 3; ++k)
                t.c.alpha[i][k] *= pow(10, 8 * trial - 12);
        assert_int_equal(vti_clumps_spread(&t.clumps, &b), VTI_OK);
        for (int s = 0; s < t.s.n; ++s)
            assert_same_bits(t.s.alpha[s], t.c.alpha[t.body[s]], 3);
    }
}

/** Of bodies that turn by L the spheres do, whatever stands in Omega, which steps only write. */
TEST(turns_by_spin)
{
    static double moments[CROWD_MAX][3], spin[CROWD_MAX][3];
    rng g = rng_seed(4115);
    for (int trial = 0; trial < 40; ++trial) {
        troop_draw(&t, &g, 5, 4, 0.7, CROWD_QUAT, CROWD_QUAT);
        for (int i = 0; i < 5; ++i) { /* three equal moments: Omega = L/J */
            moments[i][0] = moments[i][1] = moments[i][2] = t.c.inertia[i];
            for (int k = 0; k < 3; ++k)
                spin[i][k] = t.c.inertia[i] * t.c.omega[i][k];
        }
        vti_bodies b = bodies();
        assert_int_equal(vti_clumps_spread(&t.clumps, &b), VTI_OK);
        const crowd spheres = t.s;
        b.inertia.p = NULL;
        b.moments = vti_view_packed(moments[0]);
        b.spin = vti_view_packed(spin[0]);
        for (int i = 0; i < 5; ++i)
            t.c.omega[i][trial % 3] = NAN;
        assert_int_equal(vti_clumps_spread(&t.clumps, &b), VTI_OK);
        for (int s = 0; s < t.s.n; ++s) { /* numbers below 1, to the body's axes and back */
            assert_close3(t.s.v[s], spheres.v[s], 40 * EPS);
            assert_close3(t.s.omega[s], spheres.omega[s], 40 * EPS);
        }
    }
}

/** What bodies do not have is 0, and what spheres do not have is not made. */
TEST(absent_views)
{
    rng g = rng_seed(4102);
    const vti_view none = vti_view_none();
    troop_draw(&t, &g, 3, 3, 0.7, CROWD_ALPHA, CROWD_ALPHA);
    vti_bodies b = bodies();
    b.x = b.v = b.omega = b.moment = none;
    t.clumps.spheres.moment = t.clumps.spheres.alpha = none;
    assert_int_equal(vti_clumps_spread(&t.clumps, &b), VTI_OK);
    for (int s = 0; s < t.s.n; ++s) {
        const double still[3] = {0, 0, 0};
        double r[3];
        textbook_lever(s, r);
        assert_close3(t.s.x[s], r, 16 * EPS);
        assert_close3(t.s.v[s], still, 0);
        assert_close3(t.s.omega[s], still, 0);
        random_vector(&g, 1, t.s.force[s]);
    }
    memset(t.c.force, 0, sizeof t.c.force);
    memset(t.c.moment, 0, sizeof t.c.moment);
    assert_int_equal(vti_clumps_gather(&t.clumps, &b), VTI_OK);
    for (int i = 0; i < t.c.n; ++i) { /* in the order of the spheres, to the bit; moments have nowhere to go */
        double sum[3] = {0, 0, 0};
        for (int s = 0; s < t.s.n; ++s)
            for (int k = 0; k < 3 && t.body[s] == i; ++k)
                sum[k] += t.s.force[s][k];
        assert_same_bits(t.c.force[i], sum, 3);
        assert_close(vti_norm(t.c.moment[i]), 0, 0);
    }
    b = bodies();
    b.force = none;
    t.clumps.spheres = crowd_bodies(&t.s);
    t.clumps.spheres.x = t.clumps.spheres.v = t.clumps.spheres.omega = t.clumps.spheres.force = none;
    const double moment[3] = {1, 2, 4};
    memcpy(t.s.moment[0], moment, sizeof moment);
    memset(t.c.moment, 0, sizeof t.c.moment);
    assert_int_equal(vti_clumps_spread(&t.clumps, &b), VTI_OK);
    assert_int_equal(vti_clumps_gather(&t.clumps, &b), VTI_OK);
    assert_same_bits(t.c.moment[t.body[0]], moment, 3);
}

/** F.v_s + RM.Omega_s summed over spheres is F.v + RM.Omega of the bodies: gather is the transpose of spread. */
TEST(gather_is_the_transpose)
{
    rng g = rng_seed(4103);
    for (int trial = 0; trial < 200; ++trial) {
        double of_spheres = 0, of_bodies = 0;
        troop_draw(&t, &g, 4, 5, 0.7, trial & 1 ? CROWD_QUAT : CROWD_ALPHA, CROWD_ALPHA);
        const vti_bodies b = bodies();
        vti_clumps_spread(&t.clumps, &b);
        for (int s = 0; s < t.s.n; ++s) {
            random_vector(&g, 1, t.s.force[s]);
            random_vector(&g, 1, t.s.moment[s]);
            of_spheres += vti_dot(t.s.force[s], t.s.v[s]) + vti_dot(t.s.moment[s], t.s.omega[s]);
        }
        assert_int_equal(vti_clumps_gather(&t.clumps, &b), VTI_OK);
        for (int i = 0; i < t.c.n; ++i)
            of_bodies += vti_dot(t.c.force[i], t.c.v[i]) + vti_dot(t.c.moment[i], t.c.omega[i]);
        assert_close(of_bodies, of_spheres, 400 * EPS); /* 20 spheres, products of order 1 */
    }
}

/** Bodies in any slices, one after another, of spread, gather and effect: the bits of one call for all. */
TEST(slices)
{
    static crowd whole, spheres;
    rng g = rng_seed(4104);
    for (int trial = 0; trial < 60; ++trial) {
        troop_draw(&t, &g, 9, 3, 0.7, CROWD_ALPHA, trial & 1 ? CROWD_QUAT : CROWD_ALPHA);
        const vti_effect contact = vti_contacts_effect(&t.contacts);
        const vti_clumped clumped = {&t.clumps, &contact};
        const vti_effect effect = vti_clumped_effect(&clumped);
        const vti_bodies b = bodies();
        assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
        whole = t.c;
        spheres = t.s;
        memset(t.s.x, 0, sizeof t.s.x);
        for (int i = 0, n; i < 9; i += n) {
            n = 1 + rng_below(&g, 9 - i);
            const vti_bodies slice = vti_bodies_slice(b, i, n);
            assert_int_equal(vti_clumps_spread(&t.clumps, &slice), VTI_OK);
        }
        assert_same_bits(t.s.x, spheres.x, 3 * CROWD_MAX);
        memset(t.c.force, 1, sizeof t.c.force[0] * 9);
        memset(t.s.x, 0, sizeof t.s.x);
        for (int i = 0, n; i < 9; i += n) {
            n = 1 + rng_below(&g, 9 - i);
            const vti_bodies slice = vti_bodies_slice(b, i, n);
            assert_int_equal(vti_apply(&effect, 1, &slice), VTI_OK);
        }
        assert_memory_equal(&t.c, &whole, sizeof whole);
    }
}

/* ---- one sphere at the centre ------------------------------------------------------------------------------------ */

/** A clump of one sphere at its centre gives the bits of that sphere: of the loop over all effects of the spheres, and
 *  of one effect as it passes through. */
TEST(one_centred_sphere)
{
    static web w;
    static const double plane[4] = {0, 0, 1, -1.5};
    const vti_stepper *vti2 = vti_stepper_find("vti2");
    const vti_gravity gravity = {{0.25, 0, -1}};
    for (int trial = 0; trial < 8; ++trial) {
        rng g = rng_seed(4105 + (uint64_t)trial);
        troop_draw(&t, &g, 6, 0, 0.7, trial & 1 ? CROWD_QUAT : CROWD_ALPHA, trial & 1 ? CROWD_QUAT : CROWD_ALPHA);
        crowd_clear(&t.s, 6, t.c.storage);
        for (int i = 0; i < 6; ++i) {
            t.body[i] = i;
            t.diameter[i] = uniform(&g, 0.5, 1);
            memset(t.offset[i], 0, sizeof t.offset[i]);
            memcpy(t.s.mass, t.c.mass, sizeof t.s.mass);
        }
        troop_link(&t);
        troop_touch(&t, 10);
        web_terms(&w, web_grow(&w, &g, &t.c, 3, 1, 5), MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
        const vti_walls walls = {
            .count = 1, .plane = plane, .diameter = vti_scalars_array(t.diameter), .stiffness = 20};
        const vti_effect all[] = {vti_bonds_effect(&w.bonds), vti_contacts_effect(&t.contacts),
                                  vti_walls_effect(&walls), vti_gravity_effect(&gravity)};
        free_spheres = t.c;
        crowd_steps(&free_spheres, vti2, 0.01, 200, all, 4);
        const vti_bodies b = bodies();
        vti_effect clumped_bonds = all[0];
        const vti_clumped clumped = {&t.clumps, &all[0]};
        crowd alone = t.c;
        vti_clumps_spread(&t.clumps, &b);
        vti_apply(all, 4, &t.clumps.spheres);
        vti_apply(NULL, 0, &b);
        vti_clumps_gather(&t.clumps, &b);
        for (int step = 0; step < 200; ++step) {
            assert_int_equal(vti_step_begin(vti2, 0.01, &b, NULL), VTI_OK);
            vti_clumps_spread(&t.clumps, &b);
            vti_apply(all, 4, &t.clumps.spheres);
            vti_apply(NULL, 0, &b);
            vti_clumps_gather(&t.clumps, &b);
            assert_int_equal(vti_step_finish(vti2, 0.01, &b), VTI_OK);
        }
        assert_memory_equal(&t.c, &free_spheres, sizeof t.c);

        free_spheres = t.c = alone;
        clumped_bonds = vti_clumped_effect(&clumped);
        crowd_steps(&free_spheres, vti2, 0.01, 200, all, 1);
        crowd_steps(&t.c, vti2, 0.01, 200, &clumped_bonds, 1);
        assert_memory_equal(&t.c, &free_spheres, sizeof t.c);
    }
}

/** The pendulum is the clump of one sphere at rho0 with its weight. The effect has m g R rho0 as R (m g rho0), the
 *  clump as (R rho0) x (m g e3): one product is rounded before and one after the turn, which is some 20 operations
 *  long. */
TEST(pendulum_is_a_clump)
{
    rng g = rng_seed(4106);
    const vti_stepper *vti1 = vti_stepper_find("vti1");
    for (int trial = 0; trial < 40; ++trial) {
        troop_draw(&t, &g, 1, 0, 0.7, trial & 1 ? CROWD_QUAT : CROWD_ALPHA, CROWD_ALPHA);
        crowd_clear(&t.s, 1, CROWD_ALPHA);
        troop_link(&t);
        t.body[0] = 0;
        random_vector(&g, 0.5, t.offset[0]);
        t.s.mass[0] = 2;
        const vti_gravity gravity = {{0, 0, 1.5}};
        const vti_pendulum pendulum = {3, {t.offset[0][0], t.offset[0][1], t.offset[0][2]}};
        const vti_effect field = vti_gravity_effect(&gravity), hung = vti_pendulum_effect(&pendulum);
        const vti_clumped clumped = {&t.clumps, &field};
        const vti_effect effect = vti_clumped_effect(&clumped);
        vti_bodies b = bodies();
        b.x = b.v = b.force = vti_view_none();
        double moment[3], scratch[1];
        vti_stable of_clump, of_pendulum;
        assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
        memcpy(moment, t.c.moment[0], sizeof moment);
        vti_apply(&hung, 1, &b);
        assert_close3(moment, t.c.moment[0], 3 * vti_norm(t.offset[0]) * 20 * EPS);
        assert_close(vti_energy(&effect, 1, &b), vti_energy(&hung, 1, &b), 20 * EPS * 10);
        assert_int_equal(vti_stable_step(&effect, 1, &b, NULL, scratch, &of_clump), VTI_OK);
        assert_int_equal(vti_stable_step(&hung, 1, &b, NULL, scratch, &of_pendulum), VTI_OK);
        assert_close(of_clump.h, of_pendulum.h, 8 * EPS * of_pendulum.h);
        free_spheres = t.c;
        vti_bodies other = crowd_bodies(&free_spheres);
        other.x = other.v = other.force = vti_view_none();
        for (int step = 0; step < 100; ++step) {
            vti_step_begin(vti1, 0.02, &b, NULL);
            vti_apply(&effect, 1, &b);
            vti_step_finish(vti1, 0.02, &b);
            vti_step_begin(vti1, 0.02, &other, NULL);
            vti_apply(&hung, 1, &other);
            vti_step_finish(vti1, 0.02, &other);
        }
        /* 100 steps of some 40 roundings each, which the swing and the turn make grow no faster than with time */
        assert_close3(t.c.omega[0], free_spheres.omega[0], 100 * 40 * EPS);
    }
}

static double before_drift[CROWD_MAX][3], after_drift[CROWD_MAX][3];
static int carried;

static void nothing(const void *self, const vti_bodies *b)
{
    (void)self, (void)b;
}

/** Keeps where spheres come from, by their velocities, and where they are. */
static void follow(const void *self, const vti_bodies *b, const vti_drifted *drifted)
{
    (void)self;
    ++carried;
    for (int64_t s = 0; s < b->count; ++s)
        for (int k = 0; k < 3; ++k) {
            after_drift[s][k] = b->x.c[k][s * b->x.stride];
            before_drift[s][k] = after_drift[s][k] - drifted->t * b->v.c[k][s * b->v.stride];
        }
}

/* ---- what is kept ------------------------------------------------------------------------------------------------ */

/** Two clumps of four spheres fly into each other: linear and angular momentum stay to rounding, as of spheres. */
TEST(momenta_of_a_collision)
{
    double start[9], now[9];
    for (int trial = 0; trial < 10; ++trial) {
        rng g = rng_seed(4120 + (uint64_t)trial);
        troop_draw(&t, &g, 2, 0, 1, trial & 1 ? CROWD_QUAT : CROWD_ALPHA, CROWD_ALPHA);
        crowd_clear(&t.s, 8, CROWD_ALPHA);
        for (int s = 0; s < 8; ++s) {
            t.body[s] = s / 4;
            random_vector(&g, 0.3, t.offset[s]);
            t.diameter[s] = 0.6;
        }
        troop_link(&t);
        troop_touch(&t, 20);
        for (int k = 0; k < 3; ++k) {
            t.c.x[0][k] = k == 0 ? -1 : 0.1;
            t.c.x[1][k] = k == 0 ? 1 : 0;
            t.c.v[0][k] = k == 0 ? 1 : 0;
            t.c.v[1][k] = k == 0 ? -0.5 : 0.1;
        }
        const vti_effect contact = vti_contacts_effect(&t.contacts);
        const vti_clumped clumped = {&t.clumps, &contact};
        const vti_effect effect = vti_clumped_effect(&clumped);
        assert_int_equal(effect.breaks, 0x1c0);
        assert_int_equal(effect.gives, 1 << VTI_QUANTITY_FORCE | 1 << VTI_QUANTITY_MOMENT);
        const double v = t.c.v[0][0];
        crowd_momenta(&t.c, start);
        crowd_steps(&t.c, vti_stepper_find("vti2"), 0.005, 800, &effect, 1);
        crowd_momenta(&t.c, now);
        assert_true(fabs(t.c.v[0][0] - v) > 0.1); /* they did collide */
        for (int k = 0; k < 6; ++k)               /* 800 steps of some 20 roundings of numbers up to 4, at random */
            assert_close(now[k], start[k], 4 * sqrt(800 * 20) * EPS);
    }
}

/** Two asymmetric bodies of three spheres each, which turn by L: their spheres move by Omega = R diag(1/I) R^T L, and
 *  momenta stay to rounding as they collide. */
TEST(bodies_with_moments)
{
    static double moments[CROWD_MAX][3], spin[CROWD_MAX][3];
    double start[2][3], now[2][3];
    for (int trial = 0; trial < 10; ++trial) {
        rng g = rng_seed(4140 + (uint64_t)trial);
        troop_draw(&t, &g, 2, 0, 1, trial & 1 ? CROWD_QUAT : CROWD_ALPHA, CROWD_ALPHA);
        crowd_clear(&t.s, 6, CROWD_ALPHA);
        for (int s = 0; s < 6; ++s) {
            t.body[s] = s / 3;
            random_vector(&g, 0.3, t.offset[s]);
            t.diameter[s] = 0.6;
        }
        troop_link(&t);
        troop_touch(&t, 20);
        vti_bodies b = bodies();
        const vti_scalars none = {NULL, 0, 0};
        b.inertia = none;
        b.omega = vti_view_none();
        b.moments = vti_view_packed(moments[0]);
        b.spin = vti_view_packed(spin[0]);
        for (int i = 0; i < 2; ++i) {
            const double I[3] = {0.7, 1.1, 1.6}, x[3] = {i ? 1 : -1, 0.1 * i, 0}, v[3] = {i ? -0.5 : 1, 0, 0};
            memcpy(moments[i], I, sizeof I);
            memcpy(t.c.x[i], x, sizeof x);
            memcpy(t.c.v[i], v, sizeof v);
            random_vector(&g, 0.5, spin[i]);
        }
        assert_int_equal(vti_clumps_spread(&t.clumps, &b), VTI_OK);
        for (int s = 0; s < 6; ++s) {
            const int i = s / 3;
            const rotor q = crowd_attitude(&t.c, i), back = {-q.x, -q.y, -q.z, q.w};
            double p[3], omega[3];
            quat_rotate(back, spin[i], p);
            for (int k = 0; k < 3; ++k)
                p[k] /= moments[i][k];
            quat_rotate(q, p, omega);
            assert_close3(t.s.omega[s], omega, 32 * EPS);
        }
        const vti_effect contact = vti_contacts_effect(&t.contacts);
        const vti_clumped clumped = {&t.clumps, &contact};
        const vti_effect effect = vti_clumped_effect(&clumped);
        const vti_stepper *exact = vti_stepper_find("exact");
        const double speed = t.c.v[0][0];
        vti_apply(&effect, 1, &b);
        for (int step = 0; step <= 800; ++step) {
            double total[2][3] = {{0}};
            for (int i = 0; i < 2; ++i) {
                double orbit[3];
                vti_cross(t.c.x[i], t.c.v[i], orbit);
                for (int k = 0; k < 3; ++k) {
                    total[0][k] += t.c.mass[i] * t.c.v[i][k];
                    total[1][k] += t.c.mass[i] * orbit[k] + spin[i][k];
                }
            }
            memcpy(step == 0 ? start : now, total, sizeof total);
            assert_int_equal(vti_step_begin(exact, 0.005, &b, NULL), VTI_OK);
            assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
            assert_int_equal(vti_step_finish(exact, 0.005, &b), VTI_OK);
        }
        assert_true(fabs(t.c.v[0][0] - speed) > 0.1);
        assert_close3(now[0], start[0], 4 * sqrt(800 * 20) * EPS);
        assert_close3(now[1], start[1], 4 * sqrt(800 * 20) * EPS);
    }
}

/** Loads are minus the gradient of the energy, by central differences. */
TEST(loads_are_the_gradient)
{
    const double d = 1e-5;
    rng g = rng_seed(4108);
    for (int trial = 0; trial < 40; ++trial) {
        troop_draw(&t, &g, 3, 4, 0.4, trial & 1 ? CROWD_QUAT : CROWD_ALPHA, trial & 2 ? CROWD_QUAT : CROWD_ALPHA);
        const vti_effect contact = vti_contacts_effect(&t.contacts);
        const vti_clumped clumped = {&t.clumps, &contact};
        const vti_effect effect = vti_clumped_effect(&clumped);
        const vti_bodies b = bodies();
        vti_apply(&effect, 1, &b);
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 6; ++k) {
                const double load = k < 3 ? t.c.force[i][k] : t.c.moment[i][k - 3];
                const double axis[3] = {k == 3, k == 4, k == 5};
                const crowd before = t.c;
                double energy[2];
                for (int side = 0; side < 2; ++side) {
                    if (k < 3)
                        t.c.x[i][k] += side ? d : -d;
                    else
                        crowd_turn(&t.c, i, axis, side ? d : -d);
                    effect.energy(effect.self, &b, &energy[side]);
                    t.c = before;
                }
                /* Hertz's third derivative, 10/L^3 15/4 o^-1/2 of 12 pairs, is below 1e4 but where a pair just parts,
                 * and there the force it belongs to is d^{3/2}; energies below 10 are good to 1e-15 */
                assert_close(-(energy[1] - energy[0]) / (2 * d), load, 1e4 * d * d + 1e-9);
            }
    }
}

/* ---- effects that remember, break or flow ------------------------------------------------------------------------ */

static void see_nothing(const void *self, const vti_bodies *b, const vti_drifted *drifted)
{
    (void)self, (void)b, (void)drifted;
    ++carried;
}

/** In a carry t v_s is the way that a sphere has come over the drift, of any law. */
TEST(carry_has_the_chord)
{
    static const char *const stepper[] = {"vti1", "vti2", "exact"};
    rng g = rng_seed(4109);
    const vti_effect inner = {.name = "follow", .apply = nothing, .carry = follow};
    for (int trial = 0; trial < 60; ++trial) {
        troop_draw(&t, &g, 4, 4, 0.7, trial & 1 ? CROWD_QUAT : CROWD_ALPHA, CROWD_ALPHA);
        const vti_clumped clumped = {&t.clumps, &inner};
        const vti_effect effect = vti_clumped_effect(&clumped);
        const vti_bodies b = bodies();
        static double x[CROWD_MAX][3], v[CROWD_MAX][3];
        carried = 0;
        vti_clumps_spread(&t.clumps, &b);
        memcpy(x, t.s.x, sizeof x);
        assert_int_equal(vti_effects_begin(vti_stepper_find(stepper[trial % 3]), 0.5, &effect, 1, &b, NULL), VTI_OK);
        assert_int_equal(carried, 1);
        memcpy(v, t.s.v, sizeof v);
        vti_clumps_spread(&t.clumps, &b);
        assert_same_bits(v, t.s.v, 3 * t.s.n); /* and afterwards the velocity at the end */
        for (int s = 0; s < t.s.n; ++s) {
            assert_close3(before_drift[s], x[s], 40 * EPS);
            assert_close3(after_drift[s], t.s.x[s], 0);
        }
        const vti_drifted still = {.t = 0, .law = VTI_LAW_CAYLEY, .frame = VTI_FRAME_SPACE};
        assert_int_equal(vti_effects_carry(&effect, 1, &still, &b), VTI_OK);
        assert_true(all_finite(before_drift[0], 3 * t.s.n));
        const vti_effect blind = {.name = "blind", .apply = nothing, .carry = see_nothing};
        const vti_clumped unseen = {&t.clumps, &blind};
        const vti_effect seeing_nothing = vti_clumped_effect(&unseen);
        t.clumps.spheres.v = vti_view_none(); /* nor is it made for an effect that has no use for it */
        assert_int_equal(vti_effects_carry(&seeing_nothing, 1, &still, &b), VTI_OK);
        assert_int_equal(carried, 3);
        const vti_effect none = {.name = "none", .apply = nothing, .carry = NULL, .rupture = NULL};
        const vti_clumped without = {&t.clumps, &none};
        assert_null(vti_clumped_effect(&without).carry);
    }
}

/** A bond between two clumps breaks, and its energy is booked, through the clumps. */
TEST(rupture_passes_through)
{
    rng g = rng_seed(4110);
    int64_t pair[2] = {0, 1}, id[1] = {0}, broken = 0;
    double rest[4] = {1, 0, 0, 0.1};
    const double stiffness = 2, limit = 0.01;
    vti_sum lost = {0, 0};
    vti_bonds bonds = {.count = 1, .pair = pair, .rest = rest, .axial = vti_scalars_one(&stiffness)};
    const vti_rupture rupture = {.bonds = &bonds, .id = id, .stretch = vti_scalars_one(&limit), .lost = &lost};
    crowd_clear(&t.s, 2, CROWD_ALPHA);
    troop_draw(&t, &g, 2, 0, 0.3, CROWD_ALPHA, CROWD_ALPHA);
    crowd_clear(&t.s, 2, CROWD_ALPHA);
    t.body[0] = 0;
    t.body[1] = 1;
    random_vector(&g, 0.02, t.offset[0]);
    random_vector(&g, 0.02, t.offset[1]);
    troop_link(&t);
    const vti_effect inner = vti_rupture_effect(&rupture);
    const vti_clumped clumped = {&t.clumps, &inner};
    const vti_effect effect = vti_clumped_effect(&clumped);
    const vti_bodies b = bodies();
    assert_null(effect.apply);
    assert_int_equal(vti_effects_rupture(&effect, 1, &b, &broken), VTI_OK);
    assert_int_equal(broken, 1);
    assert_true(vti_booked(&effect, 1) > 0 && effect.booked == &lost);
    assert_null(effect.energy);
}

/* ---- numbers ----------------------------------------------------------------------------------------------------- */

/** Steps of clumps that touch, rub, damp and slow each other, bodies of three moments; and how long they may be. */
static void stepped(troop *all, int64_t base, vti_stable stable[2])
{
    static vti_held held[2][1024];
    static int64_t slot[2][1024];
    static double moments[CROWD_MAX][3];
    const double rate = 0.3;
    double scratch[CROWD_MAX];
    rng g = rng_seed(4113);
    vti_sum lost[3][4] = {{{0, 0}}};
    troop_draw(all, &g, 12, 3, 0.6, CROWD_ALPHA, CROWD_ALPHA);
    for (int64_t s = 0; s < all->s.n; ++s)
        all->body[s] += base;
    for (int64_t k = 0; k < all->contacts.count; ++k)
        for (int side = 0; side < 2; ++side)
            all->pair[k][side] += base;
    for (int i = 0; i < 12; ++i)
        for (int k = 0; k < 3; ++k)
            moments[i][k] = 1 + 0.1 * ((i + k) % 5);
    all->clumps.base = all->contacts.base = base;
    vti_bodies b = crowd_bodies(&all->c);
    b.inertia.p = NULL;
    b.moments = vti_view_packed(moments[0]);
    b.spin = b.omega;
    b.omega = vti_view_none();
    memset(slot, 0, sizeof slot);
    vti_history history = {.slots = 1024, .held = held[base], .slot = slot[base]};
    const vti_friction friction = {.contacts = &all->contacts,
                                   .sliding = 0.3,
                                   .stiffness = 5,
                                   .reach = INFINITY,
                                   .history = &history,
                                   .lost = lost[0]};
    const vti_dashpots dashpots = {
        .contacts = &all->contacts, .normal = 0.2, .tangential = 0.1, .reach = INFINITY, .lost = lost[1]};
    const vti_drag drag = {.linear = vti_scalars_one(&rate), .lost = lost[2]};
    const vti_effect inner[] = {vti_contacts_effect(&all->contacts), vti_friction_effect(&friction),
                                vti_dashpots_effect(&dashpots), vti_drag_effect(&drag)};
    vti_clumped clumped[4];
    vti_effect effects[4];
    for (int k = 0; k < 4; ++k) {
        clumped[k] = (vti_clumped){&all->clumps, &inner[k]};
        effects[k] = vti_clumped_effect(&clumped[k]);
    }
    assert_int_equal(vti_clumps_check(&all->clumps, 12, NULL), VTI_OK);
    assert_int_equal(vti_contacts_check(&all->contacts, all->s.n, NULL), VTI_OK);
    for (int step = 0; step < 4; ++step) {
        assert_int_equal(vti_effects_begin(vti_stepper_find("exact"), 0.05, effects, 4, &b, NULL), VTI_OK);
        assert_int_equal(vti_apply(effects, 4, &b), VTI_OK);
        assert_int_equal(vti_effects_finish(vti_stepper_find("exact"), 0.05, effects, 4, &b), VTI_OK);
    }
    const vti_deformation deep = {0.5, 0, 0};
    assert_int_equal(vti_stable_step(effects, 4, &b, NULL, scratch, &stable[0]), VTI_OK);
    assert_int_equal(vti_stable_step(effects, 4, &b, &deep, scratch, &stable[1]), VTI_OK);
    assert_true(history.used > 5 && lost[0][0].high > 0 && lost[1][1].high > 0);
}

/** Lists that count bodies and spheres from 1, as those of Fortran, give the same bits. */
TEST(counted_from_one)
{
    static troop from[2];
    static vti_stable stable[2][2];
    for (int base = 0; base < 2; ++base)
        stepped(&from[base], base, stable[base]);
    assert_memory_equal(&from[0].c, &from[1].c, sizeof from[0].c);
    assert_memory_equal(&from[0].s, &from[1].s, sizeof from[0].s);
    assert_memory_equal(stable[0], stable[1], sizeof stable[0]);
}

RUN_TESTS(cmocka_unit_test(spread_places_spheres), cmocka_unit_test(same_form_same_bits),
          cmocka_unit_test(turns_by_spin), cmocka_unit_test(absent_views), cmocka_unit_test(gather_is_the_transpose),
          cmocka_unit_test(slices), cmocka_unit_test(one_centred_sphere), cmocka_unit_test(pendulum_is_a_clump),
          cmocka_unit_test(momenta_of_a_collision), cmocka_unit_test(loads_are_the_gradient),
          cmocka_unit_test(bodies_with_moments), cmocka_unit_test(carry_has_the_chord),
          cmocka_unit_test(rupture_passes_through), cmocka_unit_test(counted_from_one))
