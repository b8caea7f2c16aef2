/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Chains that break as they move: the ledger is of second order in h whatever breaks, momenta stay, and a run goes on
 * from a rupture with the bits of one in which the broken bonds have never been. */
#include "crowd.h"

enum { N = 12, BONDS = N - 1 };

static crowd c, other;
static web w, rest_of_it;
static int64_t id[BONDS];
static vti_sum lost, damped[VTI_BOND_DASHPOT_BOOKS];

/** A chain along x whose bodies fly apart and turn, each at its own rate, so that every bond breaks in its time. */
static vti_bodies start(double speed)
{
    rng g = rng_seed(1455);
    crowd_clear(&c, N, CROWD_ALPHA);
    memset(&w, 0, sizeof w);
    for (int i = 0; i < N; ++i) {
        random_vector(&g, 0.3 * speed, c.v[i]);
        random_vector(&g, speed, c.omega[i]);
        c.x[i][0] = i;
        c.v[i][0] += speed * (i - (N - 1) / 2.0) / 2;
        c.mass[i] = uniform(&g, 0.5, 2);
        c.inertia[i] = 0.1 * c.mass[i];
    }
    for (int k = 0; k < BONDS; ++k) {
        w.pair[k][0] = k + 1;
        w.pair[k][1] = k;
        w.rest[k][0] = w.rest[k][3] = 1;
        w.moment[k] = 4;
        w.axial[k] = 100;
        w.shear[k] = 20;
        id[k] = k;
    }
    web_terms(&w, BONDS, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
    memset(&lost, 0, sizeof lost);
    memset(damped, 0, sizeof damped);
    return crowd_bodies(&c);
}

/** One step as vti_effect.h has it. Returns how many bonds broke. */
static int64_t step(const vti_stepper *method, double h, const vti_effect *effects, int64_t n, const vti_bodies *b)
{
    int64_t broken = 0;
    assert_int_equal(vti_effects_begin(method, h, effects, n, b, NULL), VTI_OK);
    assert_int_equal(vti_apply(effects, n, b), VTI_OK);
    assert_int_equal(vti_effects_finish(method, h, effects, n, b), VTI_OK);
    assert_int_equal(vti_effects_rupture(effects, n, b, &broken), VTI_OK);
    if (broken > 0)
        assert_int_equal(vti_apply(effects, n, b), VTI_OK);
    return broken;
}

static const double stretch = 0.1, normal = 12, shear = 6, bending = 4, torsion = 4, energy = 2;

static vti_rupture limits_of(int which)
{
    vti_rupture r = {.bonds = &w.bonds, .id = id, .lost = &lost};
    if (which == 0)
        r.stretch = vti_scalars_one(&stretch);
    if (which == 1) {
        r.normal = vti_scalars_one(&normal);
        r.shear = vti_scalars_one(&shear);
        r.bending = vti_scalars_one(&bending);
        r.torsion = vti_scalars_one(&torsion);
    }
    if (which == 2)
        r.energy = vti_scalars_one(&energy);
    return r;
}

/** The largest error of the ledger until t = 2, as a share of the energy at the start. */
static double ledger_error(const char *stepper, int which, double zeta, double h, int64_t *broken)
{
    const vti_bodies b = start(3);
    const vti_stepper *method = vti_stepper_find(stepper);
    const vti_rupture rupture = limits_of(which);
    const vti_bond_dashpots dashpots = {.bonds = &w.bonds, .zeta = zeta, .lost = damped};
    const vti_effect effects[] = {vti_bonds_effect(&w.bonds), vti_rupture_effect(&rupture),
                                  vti_bond_dashpots_effect(&dashpots)};
    const int n = zeta > 0 ? 3 : 2;
    double before[9], after[9], worst = 0;
    crowd_momenta(&c, before);
    assert_int_equal(vti_apply(effects, n, &b), VTI_OK);
    const double e0 = vti_energy(effects, n, &b);
    *broken = 0;
    for (long k = 0; k < lround(2 / h); ++k) {
        *broken += step(method, h, effects, n, &b);
        worst = fmax(worst, fabs(vti_energy(effects, n, &b) + vti_booked(effects, n) - e0));
    }
    crowd_momenta(&c, after);
    for (int k = 0; k < 6; ++k)
        assert_close(after[k], before[k], 1e-12 * N * 20);
    assert_true(*broken == BONDS - w.bonds.count);
    return worst / e0;
}

TEST(ledger)
{
    static const char *const steppers[] = {"vti2", "exact"};
    for (int which = 0; which < 3; ++which)
        for (int s = 0; s < 2; ++s) {
            const double zeta = s == 0 ? 0 : 0.2;
            double error[3];
            int64_t broken[3];
            for (int k = 0; k < 3; ++k)
                error[k] = ledger_error(steppers[s], which, zeta, 0.02 / (1 << 2 * k) / 4, &broken[k]);
            const double order = log2(error[0] / error[2]) / 4;
            print_message("criterion %d, %s, zeta %.1f: %.1e %.1e %.1e, order %.2f, %d of %d broken\n", which,
                          steppers[s], zeta, error[0], error[1], error[2], order, (int)broken[2], BONDS);
            assert_int_equal(broken[0], broken[2]);
            assert_true(broken[2] >= 5);
            assert_close(order, 2, 0.2);
        }
}

/** After the first rupture, the run of a fresh list without the broken bonds, by the same forces, to the bit. */
TEST(goes_on_as_if_never_bonded)
{
    const vti_bodies b = start(3);
    const vti_rupture rupture = limits_of(1);
    const vti_stepper *exact = vti_stepper_find("exact");
    const vti_effect effects[] = {vti_bonds_effect(&w.bonds), vti_rupture_effect(&rupture)};
    const double h = 0.005;
    assert_int_equal(vti_apply(effects, 2, &b), VTI_OK);
    while (step(exact, h, effects, 2, &b) == 0)
        ;
    other = c;
    memset(&rest_of_it, 0, sizeof rest_of_it);
    int64_t kept = 0;
    for (int k = 0; k < BONDS; ++k) { /* as start makes them */
        int there = 0;
        for (int64_t m = 0; m < w.bonds.count; ++m)
            there |= id[m] == k;
        if (!there)
            continue;
        rest_of_it.pair[kept][0] = k + 1;
        rest_of_it.pair[kept][1] = k;
        rest_of_it.rest[kept][0] = rest_of_it.rest[kept][3] = 1;
        rest_of_it.moment[kept] = 4;
        rest_of_it.axial[kept] = 100;
        rest_of_it.shear[kept++] = 20;
    }
    assert_true(kept < BONDS);
    web_terms(&rest_of_it, kept, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
    const vti_effect fresh = vti_bonds_effect(&rest_of_it.bonds);
    const vti_bodies twin = crowd_bodies(&other);
    assert_int_equal(vti_apply(&fresh, 1, &twin), VTI_OK);
    assert_same_bits(other.force[0], c.force[0], 3 * N);
    for (int k = 0; k < 20; ++k) {
        if (step(exact, h, effects, 2, &b) > 0)
            break;
        step(exact, h, &fresh, 1, &twin);
        assert_same_bits(other.x[0], c.x[0], 3 * N);
        assert_same_bits(other.omega[0], c.omega[0], 3 * N);
    }
}

RUN_TESTS(cmocka_unit_test(ledger), cmocka_unit_test(goes_on_as_if_never_bonded))
