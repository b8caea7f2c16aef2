/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots of contacts and planes: restitution against its closed forms, the ledger of oblique impacts, random impacts
 * that never gain, what a crowd keeps. What one flow does is in test_dashpot_flow.c. */
#include "impact.h"

static impact m;

static const vti_stepper *vti2(void)
{
    return vti_stepper_find("vti2");
}

/* ---- restitution ------------------------------------------------------------------------------------------------- */

/** e of zeta in libm's functions (EQUATIONS 6.3). */
static double closed_form(double zeta, int pull)
{
    if (pull)
        return exp(-PI * zeta / sqrt(1 - zeta * zeta));
    return zeta < 1   ? exp(-2 * zeta * acos(zeta) / sqrt(1 - zeta * zeta))
           : zeta > 1 ? exp(-2 * zeta * acosh(zeta) / sqrt(zeta * zeta - 1))
                      : exp(-2.0);
}

TEST(zeta_of_restitution)
{
    for (int pull = 0; pull < 2; ++pull)
        for (int k = 1; k < 400; ++k) {
            const double e = pow(10, -4.0 * k / 400), zeta = vti_dashpots_zeta(e, pull);
            assert_close(closed_form(zeta, pull), e, e * 1e-13 * (1 + 1 / fabs(1 - zeta)));
        }
    for (int k = 5; k < 300; k += 3) { /* hardly a rebound */
        const double e = pow(10, -k), zeta = vti_dashpots_zeta(e, 0);
        assert_close(2 * zeta * acosh(zeta) / sqrt(1 - 1 / (zeta * zeta)) / zeta, -log(e), 1e-12 * -log(e));
    }
    assert_true(vti_dashpots_zeta(1, 0) == 0 && vti_dashpots_zeta(1, 1) == 0);
    assert_true(isnan(vti_dashpots_zeta(0, 0)) && isnan(vti_dashpots_zeta(-0.5, 1)) &&
                isnan(vti_dashpots_zeta(1.5, 0)) && isnan(vti_dashpots_zeta(NAN, 1)));
}

/** A pair of masses m that its dashpot brakes: exp(-2 c t/m) of the velocity is left, however light or heavy. */
TEST(any_scale)
{
    static const int power[] = {0, 100, -100, -350, 330};
    double left[sizeof power / sizeof *power][2];
    for (size_t k = 0; k < sizeof power / sizeof *power; ++k) {
        const double mass = ldexp(1, power[k]), J = 0.125 * mass, D = 1;
        double x[2][3] = {{0}, {0.9}}, v[2][3] = {{1}, {-1}}, w[2][3] = {{1}};
        const int64_t pair[2] = {0, 1};
        vti_bodies b = vti_bodies_none(2);
        b.x = vti_view_packed(x[0]);
        b.v = vti_view_packed(v[0]);
        b.omega = vti_view_packed(w[0]);
        b.mass = vti_scalars_one(&mass);
        b.inertia = vti_scalars_one(&J);
        const vti_contacts contacts = {.count = 1, .pair = pair, .diameter = vti_scalars_one(&D), .stiffness = mass};
        vti_sum lost[VTI_DASHPOT_BOOKS] = {{0, 0}};
        const vti_dashpots dashpots = {
            .contacts = &contacts, .normal = mass, .rolling = mass, .pull = 1, .reach = INFINITY, .lost = lost};
        const vti_effect effect = vti_dashpots_effect(&dashpots);
        assert_int_equal(vti_effects_flow(&effect, 1, 1, 0, &b), VTI_OK);
        left[k][0] = v[0][0];
        left[k][1] = w[0][1];
        assert_close(left[k][0], exp(-2), 4 * EPS);
        assert_true(lost[0].high > 0.9 * mass);
        assert_close(left[k][1], left[0][1], 4 * EPS);
    }
}

/** The share of the speed that is left after head-on impacts of two unequal spheres (or one and a plane) by so many
 *  steps in a contact without damping: the largest error over places of the first touch within a step. */
static double restitution_error(double zeta, int pull, int plane, double speed, int steps)
{
    double worst = 0;
    for (int start = 0; start < 5; ++start) {
        impact_clear(&m, 2, plane, 1e4);
        m.c.mass[0] = 2;
        m.diameter[0] = 1.5;
        m.plane[0][2] = 1;
        const double reduced = plane ? 2 : 2.0 / 3, length = plane ? 0.75 : 1.25, k_h = 1e4 / pow(length, 2.5);
        const double duration = impact_duration(reduced, k_h, speed), h = duration / steps;
        const vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                       .walls = plane ? &m.walls : NULL,
                                       .zeta = zeta,
                                       .pull = pull,
                                       .reach = INFINITY,
                                       .lost = m.lost};
        impact_add(&m, plane ? vti_walls_effect(&m.walls) : vti_contacts_effect(&m.contacts));
        impact_add(&m, vti_dashpots_effect(&dashpots));
        m.c.x[0][2] = length + speed * h * (0.5 + 0.2 * start);
        m.c.v[0][2] = plane ? -speed : -speed / 3;
        m.c.v[1][2] = plane ? 0 : speed * 2 / 3;
        m.c.x[1][2] = plane ? 40 : 0;
        impact_go(&m, vti2(), h, 4 * steps);
        worst = fmax(worst, fabs((m.c.v[0][2] - m.c.v[1][2]) / speed - closed_form(zeta, pull)));
        assert_true(m.c.v[0][2] > (pull ? -1 : 0) && m.lost[0].high > 0);
    }
    return worst;
}

/** Of order 2, within 4e-4 at 50 steps in a contact, at any speed (EQUATIONS 6.3). */
TEST(restitution)
{
    static const double zetas[] = {0.05, 0.3, 0.8, 1.2};
    for (int k = 0; k < 4; ++k)
        for (int plane = 0; plane < 2; ++plane)
            for (int pull = 0; pull < (zetas[k] < 0.5 ? 2 : 1); ++pull) {
                const double coarse = restitution_error(zetas[k], pull, plane, plane ? 0.01 : 10, 50),
                             fine = restitution_error(zetas[k], pull, plane, plane ? 0.01 : 10, 400);
                print_message("zeta %.2f, %s, %s: error %.1e, order %.2f\n", zetas[k], pull ? "pull" : "no pull",
                              plane ? "plane" : "pair", coarse, log2(coarse / fine) / 3);
                assert_below(coarse, 4e-4);
                assert_below(1.7, log2(coarse / fine) / 3);
            }
}

/** A held sphere is outside of the slice and, as flows change both bodies of a pair, has a mass and an inertia of
 *  1e300: it stays, and another one leaves it as a plane. */
TEST(held_by_mass)
{
    impact_clear(&m, 2, 0, 1e4);
    m.c.x[0][2] = 1.0;
    m.c.v[0][2] = -1.0;
    m.c.mass[1] = m.c.inertia[1] = 1e300;
    m.b.count = 1;
    const vti_dashpots dashpots = {
        .contacts = &m.contacts, .zeta = vti_dashpots_zeta(0.5, 0), .reach = INFINITY, .lost = m.lost};
    impact_add(&m, vti_contacts_effect(&m.contacts));
    impact_add(&m, vti_dashpots_effect(&dashpots));
    impact_go(&m, vti2(), 1e-4, 2000);
    assert_close(m.c.v[0][2], 0.5, 1e-3);
    assert_below(fabs(m.c.v[1][2]), 1e-290);
}

/* ---- impacts ----------------------------------------------------------------------------------------------------- */

/** T + U + what is lost after an oblique impact at so many degrees, against before. */
static double ledger_error(double degrees, int plane, int steps)
{
    rng g = rng_seed(1404);
    impact_touch(&m, &g, plane, -0.01);
    memset(m.c.v, 0, sizeof m.c.v);
    const double a = degrees * PI / 180, side[3] = {m.plane[0][1], -m.plane[0][0], 0}, s = vti_norm(side);
    for (int k = 0; k < 3; ++k)
        m.c.v[0][k] = -cos(a) * m.plane[0][k] + sin(a) * side[k] / s;
    const vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                   .walls = plane ? &m.walls : NULL,
                                   .zeta = 0.2,
                                   .ratio = 0.5,
                                   .rolling = 0.2,
                                   .twisting = 0.1,
                                   .reach = INFINITY,
                                   .lost = m.lost};
    impact_add(&m, plane ? vti_walls_effect(&m.walls) : vti_contacts_effect(&m.contacts));
    impact_add(&m, vti_dashpots_effect(&dashpots));
    const double before = impact_ledger(&m);
    impact_go(&m, vti2(), 0.4 / steps, steps);
    double energy;
    m.effects[0].energy(m.effects[0].self, &m.b, &energy);
    assert_true(energy == 0 && m.lost[0].high > 0 && m.lost[1].high > 0 && m.lost[2].high > 0 && m.lost[3].high > 0);
    return fabs(impact_ledger(&m) - before) / before;
}

TEST(ledger)
{
    static const double angles[] = {10, 45, 76};
    for (int k = 0; k < 3; ++k)
        for (int plane = 0; plane < 2; ++plane) {
            double error[5];
            for (int level = 0; level < 5; ++level)
                error[level] = ledger_error(angles[k], plane, 2000 << level);
            print_message("%.0f degrees, %s: %.1e to %.1e, order %.2f\n", angles[k], plane ? "plane" : "pair", error[0],
                          error[4], log2(error[0] / error[4]) / 4);
            assert_below(error[0], 1e-3);
            assert_below(1.7, log2(error[0] / error[4]) / 4);
        }
}

/* ---- many -------------------------------------------------------------------------------------------------------- */

/** A dense crowd: velocities after the flow of t = 1, forwards and backwards by so many halves. */
static void crowd_flow(int halves, double v[40][3])
{
    rng g = rng_seed(1406);
    const double origin[3] = {0, 0, 0};
    double p[3], p1[3], l[3], l1[3];
    const int n = 20;
    impact_clear(&m, n, 1, 1e4);
    crowd_scatter(&m.c, &g, 1, 0.6);
    m.plane[0][2] = 1;
    m.plane[0][3] = -100;
    for (int i = 0; i < n; ++i) {
        random_vector(&g, 1, m.c.v[i]);
        random_vector(&g, 1, m.c.omega[i]);
    }
    const vti_dashpots dashpots = {.contacts = &m.contacts,
                                   .walls = &m.walls,
                                   .normal = 1,
                                   .tangential = 0.5,
                                   .rolling = 0.05,
                                   .twisting = 0.02,
                                   .pull = 1,
                                   .reach = INFINITY,
                                   .lost = m.lost};
    impact_add(&m, vti_dashpots_effect(&dashpots));
    vti_momentum(&m.b, p);
    vti_angular_momentum(&m.b, origin, l);
    double last = vti_energy(m.effects, 1, &m.b);
    for (int k = 0; k < 2 * halves; ++k) {
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.5 / halves, k % 2 ? -1e-30 : 1e-30, &m.b), VTI_OK);
        const double now = vti_energy(m.effects, 1, &m.b);
        assert_true(now < last);
        last = now;
    }
    vti_momentum(&m.b, p1);
    vti_angular_momentum(&m.b, origin, l1);
    assert_close3(p1, p, 256 * EPS);
    assert_close3(l1, l, 1024 * EPS);
    for (int i = 0; i < n; ++i) {
        memcpy(v[i], m.c.v[i], sizeof v[i]);
        memcpy(v[n + i], m.c.omega[i], sizeof v[i]);
    }
}

/** Forward and backward together are of second order in t, and every flow contracts. */
TEST(crowds)
{
    double fine[40][3], v[40][3], error[3] = {0};
    crowd_flow(256, fine);
    for (int level = 0; level < 3; ++level) {
        crowd_flow(4 << level, v);
        for (int i = 0; i < 40; ++i)
            for (int k = 0; k < 3; ++k)
                error[level] = fmax(error[level], fabs(v[i][k] - fine[i][k]));
    }
    print_message("4, 8, 16 flows: %.1e %.1e %.1e\n", error[0], error[1], error[2]);
    assert_close(log2(error[1] / error[2]), 2, 0.2);
}

RUN_TESTS(cmocka_unit_test(zeta_of_restitution), cmocka_unit_test(any_scale), cmocka_unit_test(restitution),
          cmocka_unit_test(held_by_mass), cmocka_unit_test(ledger), cmocka_unit_test(crowds))
