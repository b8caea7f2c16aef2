/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots of bonds: each motion of a pair that its springs make linear against the damped oscillator's closed form,
 * and what a crowd of bonded bodies keeps and books. */
#include "crowd.h"

static crowd c;
static web w;
static vti_sum lost[VTI_BOND_DASHPOT_BOOKS];
static vti_bodies b;

static void go_by(const char *stepper, const vti_effect *effects, double h, int steps)
{
    const vti_stepper *exact = vti_stepper_find(stepper);
    assert_int_equal(vti_apply(effects, 2, &b), VTI_OK);
    for (int step = 0; step < steps; ++step) {
        assert_int_equal(vti_effects_begin(exact, h, effects, 2, &b, NULL), VTI_OK);
        assert_int_equal(vti_apply(effects, 2, &b), VTI_OK);
        assert_int_equal(vti_effects_finish(exact, h, effects, 2, &b), VTI_OK);
    }
}

static void go(const vti_effect *effects, double h, int steps)
{
    go_by("exact", effects, h, steps);
}

/** A pair of unequal bodies on the x axis, L0 = 2, that begins to move along it (motion 0) or to twist about it (3). */
static double oscillator_error(int motion, double zeta, int steps)
{
    const double end = 3, speed = 0.1, stiffness = 30;
    crowd_clear(&c, 2, CROWD_ALPHA);
    memset(&w, 0, sizeof w);
    memset(lost, 0, sizeof lost);
    c.x[0][0] = 2;
    c.mass[0] = 2;
    c.inertia[0] = 0.5;
    w.pair[0][1] = 1;
    w.rest[0][0] = 1;
    w.rest[0][3] = 2;
    w.moment[0] = w.axial[0] = stiffness;
    web_terms(&w, 1, MOMENT | AXIAL, VTI_SHEAR_OBJECTIVE);
    b = crowd_bodies(&c);
    const double mass = motion == 0 ? 2.0 / 3 : 1 / (1 / 0.5 + 1), k = motion == 0 ? stiffness / 4 : stiffness;
    const vti_bond_dashpots dashpots = {.bonds = &w.bonds, .zeta = zeta, .lost = lost};
    const vti_effect effects[] = {vti_bond_dashpots_effect(&dashpots), vti_bonds_effect(&w.bonds)};
    (motion == 0 ? c.v : c.omega)[0][0] = speed;
    const double before = vti_energy(effects, 2, &b);
    go(effects, end / steps, steps);
    const double omega = sqrt(k / mass), damped = omega * sqrt(1 - zeta * zeta);
    const double exact =
        speed * exp(-zeta * omega * end) * (cos(damped * end) - zeta / sqrt(1 - zeta * zeta) * sin(damped * end));
    const double found = motion == 0 ? c.v[0][0] - c.v[1][0] : c.omega[0][0] - c.omega[1][0];
    assert_close(vti_energy(effects, 2, &b) + vti_booked(effects, 2), before, before * 400 / (steps * steps));
    for (int m = 0; m < VTI_BOND_DASHPOT_BOOKS; ++m)
        assert_true((vti_sum_value(&lost[m]) > 1e-3 * before) == (m == motion));
    return fabs(found - exact) / speed;
}

TEST(oscillators)
{
    static const double zetas[] = {0.02, 0.3, 0.9};
    for (int motion = 0; motion < 4; motion += 3)
        for (int k = 0; k < 3; ++k) {
            const double coarse = oscillator_error(motion, zetas[k], 200),
                         fine = oscillator_error(motion, zetas[k], 800);
            print_message("motion %d, zeta %.2f: %.1e, order %.2f\n", motion, zetas[k], coarse,
                          log2(coarse / fine) / 2);
            assert_below(coarse, 2e-2);
            assert_close(log2(coarse / fine) / 2, 2, 0.15);
        }
}

/** No dashpot lowers the stable step 2/omega: just below it a stretched pair comes to rest by any, of VTI-3 too, whose
 *  kick is whole. */
TEST(stable_as_without)
{
    static const char *const names[] = {"vti2", "exact", "vti3", "vti3-leapfrog"};
    const double stiffness = 30, mass = 2.0 / 3, omega = sqrt(stiffness / 4 / mass), h = 1.98 / omega;
    for (int k = 0; k < 4; ++k)
        for (double z = 1.0 / 16; z < 100; z *= 4) {
            crowd_clear(&c, 2, CROWD_ALPHA);
            memset(&w, 0, sizeof w);
            memset(lost, 0, sizeof lost);
            c.x[0][0] = 2.01;
            c.mass[0] = 2;
            w.pair[0][1] = 1;
            w.rest[0][0] = 1;
            w.rest[0][3] = 2;
            w.axial[0] = stiffness;
            web_terms(&w, 1, AXIAL, VTI_SHEAR_OBJECTIVE);
            b = crowd_bodies(&c);
            const vti_bond_dashpots dashpots = {.bonds = &w.bonds, .axial = z * mass / h, .lost = lost};
            const vti_effect effects[] = {vti_bond_dashpots_effect(&dashpots), vti_bonds_effect(&w.bonds)};
            go_by(names[k], effects, h, 4000);
            assert_below(fabs(c.x[0][0] - c.x[1][0] - 2), 1e-4);
            assert_below(fabs(c.v[0][0]), 1e-4);
        }
}

/** Each motion alone decays its own velocity by its own mass, and a crowd keeps its momenta. */
TEST(each_flow)
{
    rng g = rng_seed(1420);
    for (int trial = 0; trial < 2000; ++trial) {
        const double constant = pow(10, uniform(&g, -3, 2)), t = uniform(&g, 0.1, 1), origin[3] = {0, 0, 0};
        const int motion = trial % 4;
        double u[2][3], s[2][3], n[3], spin[3], cross[3], p[3], p1[3], l[3], l1[3], r = 0;
        crowd_clear(&c, 2, CROWD_ALPHA);
        memset(&w, 0, sizeof w);
        memset(lost, 0, sizeof lost);
        w.pair[0][1] = 1;
        w.rest[0][0] = w.rest[0][3] = 1;
        web_terms(&w, 1, 0, VTI_SHEAR_OBJECTIVE);
        for (int i = 0; i < 2; ++i) {
            random_vector(&g, 2, c.x[i]);
            random_vector(&g, 1, c.v[i]);
            random_vector(&g, 1, c.omega[i]);
            c.mass[i] = uniform(&g, 0.3, 3);
            c.inertia[i] = uniform(&g, 0.3, 3);
        }
        b = crowd_bodies(&c);
        for (int k = 0; k < 3; ++k)
            r += pow(c.x[0][k] - c.x[1][k], 2);
        r = sqrt(r);
        const double mn = 1 / (1 / c.mass[0] + 1 / c.mass[1]), jr = 1 / (1 / c.inertia[0] + 1 / c.inertia[1]),
                     mt = 1 / (1 / mn + r * r / 4 / jr);
        const vti_bond_dashpots dashpots = {.bonds = &w.bonds,
                                            .axial = motion == 0 ? constant : 0,
                                            .shear = motion == 1 ? constant : 0,
                                            .bending = motion == 2 ? constant : 0,
                                            .twisting = motion == 3 ? constant : 0,
                                            .lost = lost};
        const vti_effect effect = vti_bond_dashpots_effect(&dashpots);
        const double before = vti_energy(&effect, 1, &b);
        vti_momentum(&b, p);
        vti_angular_momentum(&b, origin, l);
        for (int when = 0; when < 2; ++when) {
            for (int k = 0; k < 3; ++k) {
                n[k] = (c.x[0][k] - c.x[1][k]) / r;
                spin[k] = r * (c.omega[0][k] + c.omega[1][k]) / 2;
                s[when][k] = c.omega[0][k] - c.omega[1][k];
            }
            vti_cross(spin, n, cross);
            for (int k = 0; k < 3; ++k)
                u[when][k] = c.v[0][k] - c.v[1][k] - cross[k];
            if (when == 0)
                assert_int_equal(vti_effects_flow(&effect, 1, t, trial % 8 < 4 ? 1 : -1, &b), VTI_OK);
        }
        const double kept = exp(-constant * t / (motion == 0 ? mn : motion == 1 ? mt : jr));
        const double un = vti_dot(u[0], n), sn = vti_dot(s[0], n);
        for (int k = 0; k < 3; ++k) {
            const double moves =
                             un * n[k] * (motion == 0 ? kept : 1) + (u[0][k] - un * n[k]) * (motion == 1 ? kept : 1),
                         turns =
                             sn * n[k] * (motion == 3 ? kept : 1) + (s[0][k] - sn * n[k]) * (motion == 2 ? kept : 1);
            if (motion < 2)
                assert_close(u[1][k], moves, 1e-13);
            else
                assert_close(s[1][k], turns, 1e-13);
        }
        vti_momentum(&b, p1);
        vti_angular_momentum(&b, origin, l1);
        assert_close3(p1, p, 1e-14);
        assert_close3(l1, l, 1e-13);
        assert_close(vti_energy(&effect, 1, &b) + vti_booked(&effect, 1), before, 1e-14 * before);
        assert_true(lost[motion].high > 0);
    }
}

/** Bodies that do not turn: axial and shear decay the velocity of the centres by the constants and zeta, of the terms
 *  that there are; bodies that coincide have no direction. */
TEST(bodies_that_do_not_turn)
{
    const double zeta = 0.4, t = 0.3, axial = 30, shear = 20, half = 0.5; /* of one body, the reduced mass */
    for (int which = 0; which < 12; ++which) {
        const int terms = which % 4 == 0 ? 0 : which % 4 == 1 ? AXIAL : which % 4 == 2 ? SHEAR : AXIAL | SHEAR;
        const double z = which / 4 == 0 ? 0 : zeta, constant = which / 4 == 1 ? 0 : 0.7;
        crowd_clear(&c, 2, CROWD_ALPHA);
        memset(&w, 0, sizeof w);
        memset(lost, 0, sizeof lost);
        w.pair[0][1] = 1;
        w.rest[0][0] = 1;
        w.rest[0][3] = 2;
        w.axial[0] = axial;
        w.shear[0] = shear;
        web_terms(&w, 1, terms, VTI_SHEAR_OBJECTIVE);
        c.x[0][0] = 2;
        c.v[0][0] = 1;
        c.v[0][1] = -3;
        b = crowd_bodies(&c);
        b.omega = b.moment = b.alpha = vti_view_none();
        const vti_bond_dashpots dashpots = {
            .bonds = &w.bonds, .zeta = z, .axial = constant, .shear = constant, .lost = lost};
        const vti_effect effect = vti_bond_dashpots_effect(&dashpots);
        assert_int_equal(effect.breaks, constant > 0 || (terms & SHEAR && z > 0) ? 0700 : 0);
        const double before = vti_energy(&effect, 1, &b);
        assert_int_equal(vti_effects_flow(&effect, 1, t, 1, &b), VTI_OK);
        const double ca = constant + (terms & AXIAL ? 2 * z * sqrt(half * axial) / 2 : 0),
                     cs = constant + (terms & SHEAR ? 2 * z * sqrt(half * shear) / 2 : 0);
        assert_close(c.v[0][0] - c.v[1][0], exp(-ca * t / half), 1e-15);
        assert_close(c.v[0][1] - c.v[1][1], -3 * exp(-cs * t / half), 4e-15);
        assert_close(vti_energy(&effect, 1, &b) + vti_booked(&effect, 1), before, 4 * EPS * before);
        c.x[0][0] = 0;
        const double v = c.v[0][0];
        assert_int_equal(vti_effects_flow(&effect, 1, t, 1, &b), VTI_OK);
        assert_true(c.v[0][0] == v);
    }
}

TEST(refusals)
{
    crowd_clear(&c, 2, CROWD_ALPHA);
    b = crowd_bodies(&c);
    vti_bond_dashpots dashpots = {.bonds = &w.bonds, .zeta = -1, .lost = lost};
    vti_effect effect = vti_bond_dashpots_effect(&dashpots);
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_DAMPING);
    dashpots.zeta = 1;
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_OK);
    assert_int_equal(vti_step_check(vti_stepper_find("srkn14"), &effect, 1), VTI_E_DISSIPATES);
    dashpots.bonds = NULL;
    effect = vti_bond_dashpots_effect(&dashpots);
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_NULL);
}

/** Velocities of a chain after the flow of t = 1, by so many halves, forwards and backwards by turns. */
static void chain_flow(int halves, double v[12][3])
{
    enum { N = 6 };
    rng g = rng_seed(1422);
    crowd_clear(&c, N, CROWD_ALPHA);
    memset(&w, 0, sizeof w);
    for (int i = 0; i < N; ++i) {
        c.x[i][0] = i;
        c.x[i][1] = 0.3 * (i % 2);
        c.mass[i] = uniform(&g, 0.5, 2);
        random_vector(&g, 1, c.v[i]);
        random_vector(&g, 1, c.omega[i]);
        w.pair[i][0] = i;
        w.pair[i][1] = i + 1;
        w.rest[i][0] = w.rest[i][3] = 1;
    }
    web_terms(&w, N - 1, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
    b = crowd_bodies(&c);
    const vti_bond_dashpots dashpots = {
        .bonds = &w.bonds, .axial = 2, .shear = 1, .bending = 0.5, .twisting = 0.5, .lost = lost};
    const vti_effect effect = vti_bond_dashpots_effect(&dashpots);
    for (int k = 0; k < 2 * halves; ++k)
        assert_int_equal(vti_effects_flow(&effect, 1, 0.5 / halves, k % 2 ? -1e-30 : 1e-30, &b), VTI_OK);
    memcpy(v[0], c.v, sizeof c.v[0] * N);
    memcpy(v[N], c.omega, sizeof c.omega[0] * N);
}

/** Flows of bonds that share bodies do not commute: forwards and backwards together they are of second order. */
TEST(order_of_the_bonds)
{
    double fine[12][3], v[12][3], error[2] = {0};
    chain_flow(256, fine);
    for (int level = 0; level < 2; ++level) {
        chain_flow(8 << level, v);
        for (int k = 0; k < 12; ++k)
            for (int d = 0; d < 3; ++d)
                error[level] = fmax(error[level], fabs(v[k][d] - fine[k][d]));
    }
    print_message("8, 16 flows: %.1e %.1e\n", error[0], error[1]);
    assert_close(log2(error[0] / error[1]), 2, 0.2);
}

RUN_TESTS(cmocka_unit_test(order_of_the_bonds), cmocka_unit_test(oscillators), cmocka_unit_test(stable_as_without),
          cmocka_unit_test(each_flow), cmocka_unit_test(bodies_that_do_not_turn), cmocka_unit_test(refusals))
