/* SPDX-License-Identifier: BSD-3-Clause
 *
 * One flow of a dashpot where two spheres, or one and a plane, touch: each motion decays by its own mass, by the share
 * of the drift in which they touch, and to where a limit holds it. */
#include "impact.h"

static impact m;

/** Each of the four alone decays its own velocity by its own mass, leaves the parts that it must not touch, keeps
 *  momenta and books what went. */
TEST(each_flow)
{
    rng g = rng_seed(1403);
    for (int trial = 0; trial < 4000; ++trial) {
        const int plane = trial % 2, which = trial / 2 % 4;
        const double c = pow(10, uniform(&g, -4, 4)), t = uniform(&g, 0.01, 1), origin[3] = {0, 0, 0};
        double u[3], w[3], u1[3], w1[3], masses[3], p[3], p1[3], l[3], l1[3];
        impact_touch(&m, &g, plane, 0.01);
        vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                 .walls = plane ? &m.walls : NULL,
                                 .pull = 1,
                                 .reach = INFINITY,
                                 .lost = m.lost};
        double *const coefficient[] = {&dashpots.normal, &dashpots.tangential, &dashpots.rolling, &dashpots.twisting};
        *coefficient[which] = c;
        const vti_effect effect = vti_dashpots_effect(&dashpots);
        const double before = vti_energy(&effect, 1, &m.b);
        vti_momentum(&m.b, p);
        vti_angular_momentum(&m.b, origin, l);
        impact_relative(&m, plane, u, w, masses);
        assert_int_equal(vti_effects_flow(&effect, 1, t, 0, &m.b), VTI_OK);
        impact_relative(&m, plane, u1, w1, masses);
        double *const n = m.plane[0];
        const double kept = exp(-c * t / masses[which > 2 ? 2 : which]), un = vti_dot(u, n), wn = vti_dot(w, n);
        for (int k = 0; k < 3; ++k) {
            const double normal = un * n[k] * (which == 0 ? kept : 1), twist = wn * n[k] * (which == 3 ? kept : 1),
                         slide = (u[k] - un * n[k]) * (which == 1 ? kept : 1),
                         roll = (w[k] - wn * n[k]) * (which == 2 ? kept : 1);
            if (which < 2)
                assert_close(u1[k], normal + slide, 1e-12 * (1 + masses[0] / fmin(m.c.mass[0], m.c.mass[1])));
            else
                assert_close(w1[k], twist + roll, 1e-12);
        }
        const double after = vti_energy(&effect, 1, &m.b);
        assert_close(after + vti_booked(&effect, 1), before, 1e-13 * before);
        assert_true(after <= before * (1 + 4 * EPS) && effect.booked[which].high > 0);
        vti_momentum(&m.b, p1);
        vti_angular_momentum(&m.b, origin, l1);
        if (!plane) {
            assert_close3(p1, p, 1e-13 * (m.c.mass[0] + m.c.mass[1]) * 10);
            assert_close3(l1, l, 1e-13 * (m.c.mass[0] + m.c.mass[1]) * 30);
        }
    }
}

/** Constant coefficients act on the share of the drift on which bodies overlap: of one that ends or begins a quarter of
 *  the way in or out of contact, a quarter. */
TEST(share_of_the_drift)
{
    for (int which = 0; which < 8; ++which) {
        const int plane = which % 2, after = which / 2 % 2, out = which / 4;
        const double c = 3, t = 0.25, deep = out ? -0.03 : 0.01;
        const double way = 0.04; /* from the overlap at one end to 1/4 or 3/4 */
        impact_clear(&m, plane ? 1 : 2, plane, 1e4);
        m.plane[0][2] = 1;
        m.c.x[0][2] = (plane ? 0.5 : 1) - deep;
        const vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                       .walls = plane ? &m.walls : NULL,
                                       .normal = c,
                                       .pull = 1,
                                       .reach = 1,
                                       .lost = m.lost};
        const vti_effect effect = vti_dashpots_effect(&dashpots);
        const double drift = 0.5, share = 0.25;
        const double u = (deep > 0 ? 1 : -1) * (after ? -1 : 1) * way / drift; /* to the other side of the touch */
        m.c.v[0][2] = u;
        assert_int_equal(vti_effects_flow(&effect, 1, t, after ? -drift : drift, &m.b), VTI_OK);
        const double mass = plane ? 1 : 0.5, left = m.c.v[0][2] - (plane ? 0 : m.c.v[1][2]);
        assert_close(left, u * exp(-c * share * t / mass), 1e-12);
    }
}

/** Bodies that do not turn: the normal and the tangential dashpot decay the velocities of the centres, on their reduced
 *  mass. */
TEST(bodies_that_do_not_turn)
{
    rng g = rng_seed(1407);
    for (int trial = 0; trial < 400; ++trial) {
        const int plane = trial % 2;
        const double c = uniform(&g, 0, 20), t = uniform(&g, 0.01, 1);
        double u[3], along[3], p[3], p1[3];
        impact_touch(&m, &g, plane, 0.01);
        memset(m.c.omega, 0, sizeof m.c.omega);
        m.b.omega = m.b.moment = m.b.alpha = vti_view_none();
        m.b.inertia.p = NULL;
        const vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                       .walls = plane ? &m.walls : NULL,
                                       .normal = c,
                                       .tangential = 2 * c,
                                       .pull = 1,
                                       .reach = INFINITY,
                                       .lost = m.lost};
        const vti_effect effect = vti_dashpots_effect(&dashpots);
        const double mass = 1 / (1 / m.c.mass[0] + (plane ? 0 : 1 / m.c.mass[1])),
                     before = vti_energy(&effect, 1, &m.b);
        for (int k = 0; k < 3; ++k)
            u[k] = m.c.v[0][k] - (plane ? 0 : m.c.v[1][k]);
        const double un = vti_dot(u, m.plane[0]);
        for (int k = 0; k < 3; ++k) {
            along[k] = un * m.plane[0][k];
            u[k] = (u[k] - along[k]) * exp(-2 * c * t / mass) + along[k] * exp(-c * t / mass);
        }
        vti_momentum(&m.b, p);
        assert_int_equal(vti_effects_flow(&effect, 1, t, 0, &m.b), VTI_OK);
        vti_momentum(&m.b, p1);
        const double small = 1e-12 * (1 + mass / fmin(m.c.mass[0], m.c.mass[1]));
        for (int k = 0; k < 3; ++k) {
            assert_close(m.c.v[0][k] - (plane ? 0 : m.c.v[1][k]), u[k], small);
            assert_close(plane ? p[k] : p1[k], p[k], 1e-12 * (m.c.mass[0] + m.c.mass[1]));
        }
        assert_close(vti_energy(&effect, 1, &m.b) + vti_booked(&effect, 1), before, 1e-13 * before);
    }
}

/** Without springs of friction a tangential dashpot is held to mu F_n, which stops what is slow; where nothing presses
 *  yet, nothing is lost across the normal; a ratio of no normal coefficient is none; centres that coincide have no
 *  direction; and a velocity that is NaN shows. */
TEST(limits_of_dashpots)
{
    const double t = 0.01, mu = 0.3, limit = t * mu * 1e4 * pow(0.01, 1.5);
    vti_history nothing = {0};
    for (int which = 0; which < 4; ++which) {
        const vti_friction friction = {.sliding = mu, .history = which % 2 ? &nothing : NULL};
        const double gap = which / 2 ? 0.01 : -0.01;
        impact_clear(&m, 2, 0, 1e4);
        m.c.x[0][2] = 1 + gap;
        m.c.v[0][2] = -1;
        m.c.v[0][0] = 0.5;
        const vti_dashpots dashpots = {
            .contacts = &m.contacts, .friction = &friction, .tangential = 1e6, .reach = 1, .lost = m.lost};
        const vti_effect effect = vti_dashpots_effect(&dashpots);
        assert_int_equal(vti_effects_flow(&effect, 1, t, 0.05, &m.b), VTI_OK);
        assert_close(m.c.v[1][0], which / 2 ? 0 : limit, 1e-12);
        assert_close(m.c.v[0][0] + m.c.v[1][0], 0.5, 4 * EPS);
        assert_true((m.lost[1].high > 0) == (gap < 0));
    }
    impact_clear(&m, 2, 0, 1e4);
    m.c.v[0][0] = 1;
    m.c.x[0][2] = 0.99;
    vti_dashpots p = {.contacts = &m.contacts, .ratio = 1, .reach = 1, .lost = m.lost};
    const vti_effect effect = vti_dashpots_effect(&p);
    assert_int_equal(vti_effects_flow(&effect, 1, t, 0, &m.b), VTI_OK);
    p.normal = p.zeta = 1;
    m.c.x[0][2] = 0;
    assert_int_equal(vti_effects_flow(&effect, 1, t, 0, &m.b), VTI_OK);
    assert_true(m.c.v[0][0] == 1 && m.lost[0].high == 0 && m.lost[1].high == 0);
    m.c.x[0][2] = 1.01;
    m.c.v[0][2] = NAN;
    assert_int_equal(vti_effects_flow(&effect, 1, t, 1, &m.b), VTI_OK);
    assert_true(isnan(m.c.v[0][2]) && isnan(m.lost[0].high));
}

/** The impulse of one flow on body 0: of sliding, or the moment impulse of rolling. */
static void impulse_of(const impact *start, const vti_dashpots *dashpots, int rolls, double t, double p[3])
{
    const vti_effect effect = vti_dashpots_effect(dashpots);
    memcpy(&m.c, &start->c, sizeof m.c);
    memset(m.lost, 0, sizeof m.lost);
    const double energy = vti_energy(NULL, 0, &m.b);
    assert_int_equal(vti_effects_flow(&effect, 1, t, 0, &m.b), VTI_OK);
    for (int k = 0; k < 3; ++k)
        p[k] = rolls ? m.c.inertia[0] * (m.c.omega[0][k] - start->c.omega[0][k])
                     : m.c.mass[0] * (m.c.v[0][k] - start->c.v[0][k]);
    const double left = vti_energy(NULL, 0, &m.b);
    assert_true(left <= energy * (1 + 4 * EPS));
    assert_close(left + vti_booked(&effect, 1), energy, 100 * EPS * energy);
}

/** Beside a spring that holds f, at the limit or below, the flow's impulse is the whole one, p, moved so that p - t f
 *  is the nearest place within t mu F_n; it never gains, whichever way f points. */
TEST(limits_beside_springs)
{
    static impact start;
    rng g = rng_seed(1406);
    int limited = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const int plane = trial % 2, rolls = trial / 2 % 2, full = trial / 4 % 2;
        const double t = pow(10, uniform(&g, -3, 0)), mu = 0.3, o = 0.01;
        double p[3], whole[3], load[3];
        impact_touch(&m, &g, plane, o);
        const double length = plane ? 0.5 * m.diameter[0] : 0.5 * (m.diameter[0] + m.diameter[1]),
                     limit = mu * 1e4 / length * pow(o, 1.5);
        random_vector(&g, 1, load);
        const double along = vti_dot(load, m.plane[0]);
        for (int k = 0; k < 3; ++k)
            load[k] -= along * m.plane[0][k];
        const double factor = limit * (full ? 1 : uniform(&g, 0, 1)) / vti_norm(load);
        int64_t slots[4] = {0};
        vti_held entries[4], held = {1, plane ? -1 : 2, {0}, {0}, 0};
        vti_history history = {4, 0, 0, entries, slots};
        for (int k = 0; k < 3; ++k)
            (rolls ? held.rolling : held.sliding)[k] = load[k] *= factor;
        assert_int_equal(vti_history_add(&history, &held), VTI_OK);
        const vti_friction friction = {.sliding = mu, .rolling = mu, .history = &history};
        vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                 .walls = plane ? &m.walls : NULL,
                                 .reach = INFINITY,
                                 .lost = m.lost};
        *(rolls ? &dashpots.rolling : &dashpots.tangential) = pow(10, uniform(&g, -1, 3));
        memcpy(&start.c, &m.c, sizeof m.c);
        impulse_of(&start, &dashpots, rolls, t, whole);
        dashpots.friction = &friction;
        impulse_of(&start, &dashpots, rolls, t, p);
        long double size = 0;
        for (int k = 0; k < 3; ++k)
            size += powl((long double)whole[k] - (long double)t * load[k], 2);
        size = sqrtl(size);
        const double per = rolls ? m.c.inertia[0] : m.c.mass[0], speed = rolls ? 8 : 4;
        for (int k = 0; k < 3; ++k) { /* an overlap of 0.01 is known to some 100 eps, p by a difference of velocities */
            const long double nearest =
                size > t * limit ? t * load[k] + (whole[k] - t * load[k]) * (t * limit / size) : whole[k];
            assert_close(p[k], (double)nearest, EPS * (1000 * t * limit + 100 * per * speed));
        }
        limited += size > t * limit;
    }
    print_message("%d of 2000 are limited\n", limited);
    assert_in_range(limited, 500, 1900);
}

RUN_TESTS(cmocka_unit_test(each_flow), cmocka_unit_test(share_of_the_drift), cmocka_unit_test(bodies_that_do_not_turn),
          cmocka_unit_test(limits_of_dashpots), cmocka_unit_test(limits_beside_springs))
