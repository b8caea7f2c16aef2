/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Chains of bonds as beams: a cantilever's deflection is Timoshenko's at every body, a compressed chain buckles where
 * its closed form says, and a chain, free or clamped, with dashpots or without, moves as the linear system does that is
 * written here from the energies of small deformations, where nothing of the library is used. */
#include "crowd.h"

static crowd c;
static web w;
static vti_bodies b;

/** n bodies along x, at rest, r apart, bonds of length rest between neighbours: moment, axial and shear. */
static void make(int n, double r, double rest, const double stiffness[3])
{
    crowd_clear(&c, n, CROWD_QUAT);
    memset(&w, 0, sizeof w);
    for (int i = 0; i < n; ++i)
        c.x[i][0] = i * r;
    for (int k = 0; k < n - 1; ++k) {
        w.pair[k][0] = k;
        w.pair[k][1] = k + 1;
        w.rest[k][0] = -1;
        w.rest[k][3] = rest;
        w.moment[k] = stiffness[0];
        w.axial[k] = stiffness[1];
        w.shear[k] = stiffness[2];
    }
    web_terms(&w, n - 1, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
    b = crowd_bodies(&c);
}

static void load(void)
{
    const vti_effect bonds = vti_bonds_effect(&w.bonds);
    assert_int_equal(vti_apply(&bonds, 1, &b), VTI_OK);
}

static void turn_about_z(int i, double angle)
{
    const double z[3] = {0, 0, 1};
    crowd_turn(&c, i, z, angle);
}

/* ---- statics ----------------------------------------------------------------------------------------------------- */

/** With K^a = E A L, K^m = E I/L and K^s = 1/(1/(G A L) + L/(12 E I)) a bond is a beam: under a load at the tip all
 *  bodies, however few, lie on w(s) = P s^2 (3l - s)/(6 E I) + P s/(G A), turned by P s (l - s/2)/(E I). */
TEST(cantilever)
{
    const double EA = 100, GA = 30, EI = 2, l = 3, P = 1e-6;
    for (int n = 2; n < 20; n = 2 * n - 1) {
        const double L = l / (n - 1), stiffness[] = {EI / L, EA * L, 1 / (1 / (GA * L) + L / (12 * EI))};
        make(n, L, L, stiffness);
        for (int i = 0; i < n; ++i) {
            const double s = i * L;
            c.x[i][1] = P * s * s * (3 * l - s) / (6 * EI) + P * s / GA;
            turn_about_z(i, P * s * (l - s / 2) / EI);
        }
        load();
        for (int i = 0; i < n; ++i) { /* squares of angles, times E A, and rounding: 1e-10 */
            const int end = i == 0 ? 1 : i == n - 1 ? -1 : 0;
            assert_close(c.force[i][1] / P, end, 1e-9);
            assert_close(c.moment[i][2] / P, i == 0 ? l : 0, 1e-9);
        }
    }
}

/** The largest force across and moment that a pinned chain under the pressure P answers with when it bends in its first
 *  mode, w = a sin(k t), turned by A cos(k t), t = pi/(n - 1): A is what no moment is left by. */
static double answer(int n, double r, const double stiffness[3], double P)
{
    const double t = acos(-1.0) / (n - 1), a = 1e-6, s = 2 * sin(t / 2), half = cos(t / 2);
    const double Ka = stiffness[1], rest = (Ka - sqrt(Ka * Ka - 4 * P * Ka * r)) / (2 * P); /* P = K/L (1 - r/L) */
    const double A = stiffness[2] * half * s / r / (stiffness[2] * half * half + stiffness[0] * s * s);
    double most = 0;
    make(n, r, rest, stiffness);
    for (int i = 0; i < n; ++i) {
        c.x[i][1] = a * sin(i * t);
        turn_about_z(i, a * A * cos(i * t));
    }
    load();
    for (int i = 0; i < n; ++i) {
        const double across = i > 0 && i < n - 1 ? c.force[i][1] * r : 0;
        most = fmax(most, fmax(fabs(across), fabs(c.moment[i][2])));
    }
    return most / (P * a);
}

/** Pinned at both ends, 1/P = r/(4 K^m tan^2(t/2)) + r/K^s: Euler's pi^2 E I/l^2 as n grows, less by shear. */
TEST(buckling)
{
    const double stiffness[] = {6, 400, 150};
    for (int n = 3; n < 20; n = 2 * n - 1) {
        const double r = 0.5, t = acos(-1.0) / (n - 1);
        const double P = 1 / (r / (4 * stiffness[0] * pow(tan(t / 2), 2)) + r / stiffness[2]);
        const double critical = answer(n, r, stiffness, P), below = answer(n, r, stiffness, 0.999 * P);
        print_message("%d bodies, P = %.4g: %.1e; a thousandth below %.1e\n", n, P, critical, below);
        assert_below(critical, 1e-8);
        assert_below(1e-6, below);
    }
}

/* ---- motion ------------------------------------------------------------------------------------------------------ */

/** Ways of a body: along x, along y, turned about z, and about x. */
enum { BODIES = 6, WAYS = 4, STATE = BODIES * WAYS };

struct rod {
    int clamped; /* 1: the first body is */
    double L, mass, inertia, stiffness[3], zeta, constant[4];
};

/** The mass, or moment of inertia, of one way. */
static double weight(const struct rod *rod, int way)
{
    return rod->clamped && way / WAYS == 0 ? INFINITY : way % WAYS < 2 ? rod->mass : rod->inertia;
}

/** A small deformation of a bond as a row over the ways of both bodies: stretch and shear, lengths; bending, twist. */
static void row(const struct rod *rod, int motion, double g[2 * WAYS])
{
    memset(g, 0, 2 * WAYS * sizeof *g);
    g[motion] = -1;
    g[WAYS + motion] = 1;
    if (motion == 1)
        g[2] = g[WAYS + 2] = -0.5 * rod->L; /* the bond turns against the mean of both bodies */
}

/** dy/dt of y = (q, q'): for each deformation e = g.q of each bond -(k e + c e') g, c = constant + 2 zeta sqrt(m k). */
static void rates(const struct rod *rod, const double *y, double *dydt)
{
    const double *K = rod->stiffness, L2 = rod->L * rod->L, k[] = {K[1] / L2, K[2] / L2, K[0], K[0]};
    double load[STATE] = {0};
    for (int bond = 0; bond < BODIES - 1; ++bond)
        for (int motion = 0; motion < 4; ++motion) {
            const int from = bond * WAYS;
            double g[2 * WAYS], e = 0, rate = 0, per_mass = 0;
            row(rod, motion, g);
            for (int q = 0; q < 2 * WAYS; ++q) {
                e += g[q] * y[from + q];
                rate += g[q] * y[STATE + from + q];
                per_mass += g[q] * g[q] / weight(rod, from + q);
            }
            const double damping = rod->constant[motion] + 2 * rod->zeta * sqrt(k[motion] / per_mass);
            for (int q = 0; q < 2 * WAYS; ++q)
                load[from + q] -= (k[motion] * e + damping * rate) * g[q];
        }
    for (int q = 0; q < STATE; ++q) {
        dydt[q] = y[STATE + q];
        dydt[STATE + q] = load[q] / weight(rod, q);
    }
}

/** y(t) by Taylor series of parts in which no rate, below 200 here, changes it by more than a third. */
static void follow(const struct rod *rod, double t, double y[2 * STATE])
{
    const int parts = (int)(600 * t) + 1;
    for (int part = 0; part < parts; ++part) {
        double term[2 * STATE], next[2 * STATE];
        memcpy(term, y, sizeof term);
        for (int k = 1; k < 20; ++k) {
            rates(rod, term, next);
            for (int q = 0; q < 2 * STATE; ++q)
                y[q] += term[q] = next[q] * t / parts / k;
        }
    }
}

/** The library's rod from the velocities of y on; in y what it then is. */
static void run(const struct rod *rod, double t, int steps, double y[2 * STATE])
{
    vti_sum lost[VTI_BOND_DASHPOT_BOOKS] = {{0}};
    const double *const C = rod->constant;
    const vti_stepper *const exact = vti_stepper_find("exact");
    make(BODIES, rod->L, rod->L, rod->stiffness);
    for (int i = 0; i < BODIES; ++i) {
        const int held = rod->clamped && i == 0;
        const double *const v = y + STATE + i * WAYS;
        c.mass[i] = held ? 1e300 : rod->mass;
        c.inertia[i] = held ? 1e300 : rod->inertia;
        for (int k = 0; k < 2; ++k) {
            c.v[i][k] = v[k];
            c.omega[i][2 - 2 * k] = v[2 + k];
        }
    }
    const vti_bond_dashpots dashpots = {&w.bonds, rod->zeta, C[0], C[1], C[2], C[3], lost, NULL};
    const vti_effect effects[] = {vti_bond_dashpots_effect(&dashpots), vti_bonds_effect(&w.bonds)};
    assert_int_equal(vti_apply(effects, 2, &b), VTI_OK);
    for (int k = 0; k < steps; ++k) {
        assert_int_equal(vti_effects_begin(exact, t / steps, effects, 2, &b, NULL), VTI_OK);
        assert_int_equal(vti_apply(effects, 2, &b), VTI_OK);
        assert_int_equal(vti_effects_finish(exact, t / steps, effects, 2, &b), VTI_OK);
    }
    for (int i = 0; i < BODIES; ++i)
        for (int k = 0; k < 2; ++k) {
            y[i * WAYS + k] = c.x[i][k] - (k == 0 ? i * rod->L : 0);
            y[i * WAYS + 2 + k] = 2 * c.quat[i][2 - 2 * k] / c.quat[i][3];
            y[STATE + i * WAYS + k] = c.v[i][k];
            y[STATE + i * WAYS + 2 + k] = c.omega[i][2 - 2 * k];
        }
}

/** The largest difference to the linear system at t, as a share of the largest velocity at the start. */
static double error(const struct rod *rod, double t, int steps)
{
    const double amplitude = 1e-6; /* so are the angles, whose squares the linear system leaves out */
    double is[2 * STATE] = {0}, should[2 * STATE], most = 0;
    rng g = rng_seed(88);
    for (int q = rod->clamped ? WAYS : 0; q < STATE; ++q)
        is[STATE + q] = uniform(&g, -amplitude, amplitude);
    memcpy(should, is, sizeof is);
    run(rod, t, steps, is);
    follow(rod, t, should);
    for (int q = 0; q < 2 * STATE; ++q)
        most = fmax(most, fabs(is[q] - should[q]));
    return most / amplitude;
}

/** All modes at once, of bending, stretching and twisting: to second order in h the library's motion is the linear one,
 *  so that its frequencies and decays are. */
TEST(modes)
{
    static const struct rod rods[] = {
        {0, 0.7, 1.3, 0.05, {9, 60, 35}, 0, {0, 0, 0, 0}},
        {1, 0.7, 1.3, 0.05, {9, 60, 35}, 0, {0, 0, 0, 0}},
        {0, 0.7, 1.3, 0.05, {9, 60, 35}, 0.1, {0, 0, 0, 0}},
        {1, 0.7, 1.3, 0.05, {9, 60, 35}, 1, {0, 0, 0, 0}},
        {0, 0.7, 1.3, 0.05, {9, 60, 35}, 0, {1.5, 0.8, 0.3, 0.2}},
        {1, 0.7, 1.3, 0.05, {9, 60, 35}, 0.2, {1, 2, 0.1, 0.3}},
    };
    for (int k = 0; k < 6; ++k) {
        const double coarse = error(&rods[k], 0.5, 500), fine = error(&rods[k], 0.5, 1000);
        print_message("%s, zeta %.1f: %.1e, %.1e\n", rods[k].clamped ? "clamped" : "free", rods[k].zeta, coarse, fine);
        assert_below(fine, 1e-3);
        assert_close(log2(coarse / fine), 2, 0.03);
    }
}

RUN_TESTS(cmocka_unit_test(cantilever), cmocka_unit_test(buckling), cmocka_unit_test(modes))
