/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots in bonds of bodies with moments and of clumps: flows against the exponential of the whole system in long
 * double, modes by closed forms, what they keep and lose, spheres as the limit. */
#include "linear.h"

static uneven m;
static web w;

/** A bond between spheres 0 and 1, or the bodies that they are, as short as chance has it. */
static void bond(rng *g, struct linear *at)
{
    double d[3], n[3];
    memset(&w, 0, sizeof w);
    random_vector(g, 1, m.t.c.x[0]);
    random_vector(g, 1, m.t.c.x[1]);
    const vec r0 = linear_lever(&m, 0), r1 = linear_lever(&m, 1);
    for (int k = 0; k < 3; ++k)
        d[k] = m.t.c.x[0][k] + (double)r0.c[k] - m.t.c.x[1][k] - (double)r1.c[k];
    const double r = vti_norm(d);
    for (int k = 0; k < 3; ++k)
        n[k] = d[k] / r;
    *at = (struct linear){.body = {0, 1}, .n = vec_of(n)};
    at->arm[0] = vec_add(r0, -0.5L * r, at->n);
    at->arm[1] = vec_add(r1, 0.5L * r, at->n);
    w.pair[0][1] = 1;
    w.rest[0][0] = 1;
    w.rest[0][3] = r;
    web_terms(&w, 1, 0, VTI_SHEAR_OBJECTIVE);
}

/** Each of the four alone. */
TEST(each_flow)
{
    rng g = rng_seed(5201);
    for (int trial = 0; trial < 216; ++trial) {
        const int which = trial % 4;
        const double c = pow(10, uniform(&g, -3, 0.3)), t = uniform(&g, 0.05, 1);
        struct linear at;
        linear_bodies(&m, &g, trial / 4 % UNEVEN_KINDS, trial / 12 % UNEVEN_STATES, 2, 1);
        bond(&g, &at);
        /* axial, shear, bending, twisting: as normal, tangential, rolling, twisting of a touch */
        at.c[which] = c;
        vti_bond_dashpots dashpots = {.bonds = &w.bonds, .lost = m.lost};
        double *const coefficient[] = {&dashpots.axial, &dashpots.shear, &dashpots.bending, &dashpots.twisting};
        *coefficient[which] = c;
        uneven_add(&m, vti_bond_dashpots_effect(&dashpots));
        linear_assert_flow(&m, &at, t, trial % 3 ? 0 : -1);
        assert_true(m.lost[which].high > 0);
    }
}

/** By zeta each mode has a coefficient of its own, 2 zeta sqrt(m k): a bond along x of bodies whose principal axes are
 *  x, y, z, so that the modes are known. */
TEST(modes_by_zeta)
{
    const double zeta = 0.2, t = 0.7, k = 3, r = 1.5, a = r / 2;
    const double moments[2][3] = {{0.3, 0.5, 0.7}, {0.9, 0.6, 0.8}}, mass[2] = {1.5, 0.8};
    double per[3] = {0, 0, 0}, per_m = 0;
    for (int i = 0; i < 2; ++i) {
        per_m += 1 / mass[i];
        for (int c = 0; c < 3; ++c)
            per[c] += 1 / moments[i][c];
    }
    /* axial; shear along y (which turns about z) and z; bending about y and z; twisting */
    const double yield[6] = {per_m, per_m + a * a * per[2], per_m + a * a * per[1], per[1], per[2], per[0]};
    static const int term[6] = {AXIAL, SHEAR, SHEAR, MOMENT, MOMENT, MOMENT}, along[6] = {0, 1, 2, 1, 2, 0};
    for (int mode = 0; mode < 6; ++mode) {
        const int turns = mode >= 3;
        uneven_clear(&m, UNEVEN_BODIES, CROWD_ALPHA, 2);
        memset(&w, 0, sizeof w);
        for (int i = 0; i < 2; ++i) {
            m.t.c.mass[i] = mass[i];
            memcpy(m.moments[i], moments[i], sizeof moments[i]);
            uneven_sphere(&m, i, m.t.offset[i], 1);
        }
        m.t.c.x[0][0] = r;
        (turns ? m.t.c.omega : m.t.c.v)[0][along[mode]] = 1;
        w.pair[0][1] = 1;
        w.rest[0][0] = 1;
        w.rest[0][3] = r;
        w.moment[0] = w.axial[0] = w.shear[0] = k;
        web_terms(&w, 1, term[mode], VTI_SHEAR_OBJECTIVE);
        uneven_link(&m, UNEVEN_BOTH, 1, 1);
        uneven_spin_up(&m);
        const vti_bond_dashpots dashpots = {.bonds = &w.bonds, .zeta = zeta, .lost = m.lost};
        const vti_effect effect = vti_bond_dashpots_effect(&dashpots);
        assert_int_equal(vti_effects_flow(&effect, 1, t, 1, &m.b), VTI_OK);
        const double length = turns ? 1 : r, rate = 2 * zeta * sqrt(yield[mode] * k) / length; /* 2 zeta omega */
        double u = 0;
        for (int j = 0; j < 2; ++j) { /* arms -a and a along x: Omega x arm is (0, -+a Omega_z, +-a Omega_y) */
            const double *omega = m.t.c.omega[j], arm = j ? a : -a, moves[3] = {0, arm * omega[2], -arm * omega[1]};
            u += (j ? -1 : 1) * (turns ? omega[along[mode]] : m.t.c.v[j][along[mode]] + moves[along[mode]]);
        }
        assert_close(u, exp(-rate * t), 20 * EPS);
        assert_true(m.lost[mode == 0 ? 0 : mode < 3 ? 1 : mode < 5 ? 2 : 3].high > 0);
    }
}

/** Steps of a chain of bonded bodies: error of the ledger, the largest over the way. */
static double chain_ledger(int kind, int steps)
{
    enum { N = 4 };
    rng g = rng_seed(5203);
    double worst = 0;
    linear_bodies(&m, &g, kind, UNEVEN_BOTH, N, 1);
    memset(&w, 0, sizeof w);
    for (int i = 0; i < N; ++i) {
        m.t.c.x[i][0] = 1.2 * i;
        m.t.c.x[i][1] = 0.3 * (i % 2);
    }
    vti_bodies at = m.b;
    if (kind != UNEVEN_BODIES) {
        assert_int_equal(vti_clumps_spread(&m.t.clumps, &m.b), VTI_OK);
        at = m.t.clumps.spheres;
    }
    for (int i = 0; i < N - 1; ++i) {
        w.pair[i][0] = i;
        w.pair[i][1] = i + 1;
        w.moment[i] = w.axial[i] = w.shear[i] = 20;
    }
    assert_int_equal(vti_bonds_rest(N - 1, w.pair[0], 0, &at.x, w.rest[0], NULL), VTI_OK);
    web_terms(&w, N - 1, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
    const vti_bond_dashpots dashpots = {.bonds = &w.bonds, .zeta = 0.1, .bending = 0.02, .lost = m.lost};
    uneven_add(&m, vti_bond_dashpots_effect(&dashpots));
    uneven_add(&m, vti_bonds_effect(&w.bonds));
    const double before = uneven_ledger(&m);
    double momenta[6], after[6];
    uneven_momenta(&m, momenta);
    for (int part = 0; part < 20; ++part) {
        uneven_go(&m, vti_stepper_find("exact"), 2.0 / steps, steps / 20);
        worst = fmax(worst, fabs(uneven_ledger(&m) - before));
    }
    uneven_momenta(&m, after);
    for (int k = 0; k < 6; ++k)
        assert_close(after[k], momenta[k], 1e-11);
    assert_true(m.lost[0].high > 0 && m.lost[1].high > 0 && m.lost[2].high > 0 && m.lost[3].high > 0);
    return worst / before;
}

/** The energy that is there and booked is constant to second order, and both momenta are to rounding. */
TEST(ledger)
{
    for (int kind = 0; kind < UNEVEN_KINDS; ++kind) {
        const double coarse = chain_ledger(kind, 400), fine = chain_ledger(kind, 1600);
        print_message("kind %d: %.1e %.1e, order %.2f\n", kind, coarse, fine, log2(coarse / fine) / 2);
        assert_below(coarse, 2e-2);
        assert_close(log2(coarse / fine) / 2, 2, 0.15);
    }
}

/** Velocities of a chain after the flow of t = 1, by so many halves, forwards and backwards by turns. */
static void chain_flow(int kind, int halves, vec y[4])
{
    rng g = rng_seed(5204);
    linear_bodies(&m, &g, kind, UNEVEN_BOTH, 6, 1);
    crowd_scatter(&m.t.c, &g, 1.5, 0.8);
    memset(&w, 0, sizeof w);
    for (int i = 0; i < 5; ++i) {
        w.pair[i][0] = i;
        w.pair[i][1] = i + 1;
        w.rest[i][0] = w.rest[i][3] = 1;
    }
    web_terms(&w, 5, 0, VTI_SHEAR_OBJECTIVE);
    const vti_bond_dashpots dashpots = {
        .bonds = &w.bonds, .axial = 0.5, .shear = 0.3, .bending = 0.1, .twisting = 0.1, .lost = m.lost};
    uneven_add(&m, vti_bond_dashpots_effect(&dashpots));
    for (int k = 0; k < 2 * halves; ++k)
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.5 / halves, k % 2 ? -1e-30 : 1e-30, &m.b), VTI_OK);
    linear_state(&m, y);
}

/** Flows of bonds that share bodies do not commute: forwards and backwards together they are of second order. */
TEST(order_of_the_bonds)
{
    for (int kind = 0; kind < UNEVEN_KINDS; ++kind) {
        vec fine[4], y[4];
        double error[2] = {0};
        chain_flow(kind, 256, fine);
        for (int level = 0; level < 2; ++level) {
            chain_flow(kind, 16 << level, y);
            for (int q = 0; q < 4; ++q)
                error[level] = fmax(error[level], (double)vec_norm(vec_add(y[q], -1, fine[q])));
        }
        print_message("16, 32 flows: %.1e %.1e\n", error[0], error[1]);
        assert_close(log2(error[0] / error[1]), 2, 0.2);
    }
}

/** Three equal moments are the sphere's flows to rounding; bodies that coincide have no direction, and nothing is
 *  done. */
TEST(equal_moments_are_spheres)
{
    rng g = rng_seed(5205);
    for (int trial = 0; trial < 200; ++trial) {
        static crowd spheres;
        vti_sum lost[VTI_BOND_DASHPOT_BOOKS] = {{0, 0}};
        linear_bodies(&m, &g, UNEVEN_BODIES, UNEVEN_BOTH, 4, 1);
        crowd_scatter(&m.t.c, &g, 1, 0.4);
        memset(&w, 0, sizeof w);
        for (int i = 0; i < 4; ++i)
            m.moments[i][0] = m.moments[i][1] = m.moments[i][2] = m.t.c.inertia[i];
        uneven_spin_up(&m);
        web_terms(&w, web_grow(&w, &g, &m.t.c, 2, 1, 20), MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
        vti_bond_dashpots dashpots = {.bonds = &w.bonds,
                                      .zeta = 0.3,
                                      .axial = 0.1,
                                      .shear = 0.2,
                                      .bending = 0.05,
                                      .twisting = 0.1,
                                      .lost = m.lost},
                          of_spheres = dashpots;
        of_spheres.lost = lost;
        spheres = m.t.c;
        const vti_bodies b = crowd_bodies(&spheres);
        const vti_effect effects[2] = {vti_bond_dashpots_effect(&dashpots), vti_bond_dashpots_effect(&of_spheres)};
        for (int step = 0; step < 4; ++step) {
            assert_int_equal(vti_effects_flow(&effects[0], 1, 0.05, step % 2 ? -1 : 1, &m.b), VTI_OK);
            assert_int_equal(vti_effects_flow(&effects[1], 1, 0.05, step % 2 ? -1 : 1, &b), VTI_OK);
        }
        for (int i = 0; i < 4; ++i) { /* some 24 flows of 200 operations */
            assert_close3(m.t.c.v[i], spheres.v[i], 5000 * EPS);
            assert_close3(m.t.c.omega[i], spheres.omega[i], 5000 * EPS);
        }
        for (int k = 0; k < VTI_BOND_DASHPOT_BOOKS; ++k)
            assert_close(m.lost[k].high, lost[k].high, 5000 * EPS);
        for (int i = 1; i < 4; ++i)
            memcpy(m.t.c.x[i], m.t.c.x[0], sizeof m.t.c.x[i]);
        memcpy(spheres.v, m.t.c.v, sizeof spheres.v);
        assert_int_equal(vti_effects_flow(&effects[0], 1, 0.05, 1, &m.b), VTI_OK);
        assert_same_bits(m.t.c.v, spheres.v, 12);
    }
}

/** Bodies that only turn, and bodies that nothing turns: what is left of the motions is damped. */
TEST(absent_motions)
{
    rng g = rng_seed(5206);
    struct linear at;
    linear_bodies(&m, &g, UNEVEN_CLUMPS, UNEVEN_SPIN, 2, 1);
    bond(&g, &at);
    web_terms(&w, 1, AXIAL, VTI_SHEAR_OBJECTIVE);
    w.axial[0] = 1e-3;
    const vti_bond_dashpots dashpots = {.bonds = &w.bonds, .zeta = 0.1, .axial = 1e9, .lost = m.lost};
    uneven_add(&m, vti_bond_dashpots_effect(&dashpots));
    m.b.v = vti_view_none();
    assert_int_equal(vti_effects_flow(m.effects, 1, 1, 0, &m.b), VTI_OK);
    assert_true(m.lost[0].high > 0);
    m.lost[0].high = 0;
    memset(m.t.offset, 0, sizeof m.t.offset); /* an axial pull does not turn them: no mode is left */
    assert_int_equal(vti_effects_flow(m.effects, 1, 1, 0, &m.b), VTI_OK);
    assert_true(m.lost[0].high == 0 && all_finite(m.spin[0], 6));
    m.b.v = crowd_bodies(&m.t.c).v;
    m.b.spin = m.b.moment = m.b.moments = vti_view_none();
    m.b.principal = vti_bodies_none(1).quat;
    assert_int_equal(vti_effects_flow(m.effects, 1, 1, 0, &m.b), VTI_OK);
    vec d = vec_add(vec_of(m.t.c.v[0]), -1, vec_of(m.t.c.v[1])),
        x = vec_add(vec_of(m.t.c.x[0]), -1, vec_of(m.t.c.x[1]));
    assert_close((double)(vec_dot(d, x) / vec_norm(x)), 0, 1e-14);
    assert_true(m.lost[0].high > 0);
}

RUN_TESTS(cmocka_unit_test(each_flow), cmocka_unit_test(modes_by_zeta), cmocka_unit_test(ledger),
          cmocka_unit_test(order_of_the_bonds), cmocka_unit_test(equal_moments_are_spheres),
          cmocka_unit_test(absent_motions))
