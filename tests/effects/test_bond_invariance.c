/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What a bond does not see: a rigid motion of the whole, the order of its bodies. The objective forms do not; the
 * printed form does (E11). */
#include "pair.h"

enum { PRINTED_FROM = 11 }; /* combinations 0-10 are objective or without shear, 11-14 have the printed shear */

static void loads(pair *p, int terms, int form)
{
    web_terms(&p->w, 1, terms, form);
    const vti_effect effect = vti_bonds_effect(&p->w.bonds);
    const vti_bodies b = crowd_bodies(&p->c);
    vti_apply(&effect, 1, &b);
}

/** x -> Q x + shift, R -> Q R */
static void move_rigidly(crowd *c, rotor q, const double shift[3])
{
    for (int i = 0; i < c->n; ++i) {
        quat_rotate(q, c->x[i], c->x[i]);
        for (int k = 0; k < 3; ++k)
            c->x[i][k] += shift[k];
        crowd_set_attitude(c, i, quat_times(q, crowd_attitude(c, i)));
    }
}

/** The largest differences of loads of two states after the first is turned by q, and of their energies. */
static void compare(pair *before, pair *after, rotor q, double *load, double *energy)
{
    *load = 0;
    *energy = fabs(pair_energy(before) - pair_energy(after));
    for (int i = 0; i < 2; ++i) {
        double force[3], moment[3];
        quat_rotate(q, before->c.force[i], force);
        quat_rotate(q, before->c.moment[i], moment);
        for (int k = 0; k < 3; ++k) {
            *load = fmax(*load, fabs(force[k] - after->c.force[i][k]));
            *load = fmax(*load, fabs(moment[k] - after->c.moment[i][k]));
        }
    }
}

static void rigid_motion(void **state)
{
    (void)state;
    rng g = rng_seed(3031);
    int printed = 0, seen = 0;
    for (int trial = 0; trial < 15 * 1000; ++trial) {
        pair p;
        int terms, form;
        double s, size, shift[3], axis[3], load, energy;
        pair_draw(&p, &g, trial & 1 ? CROWD_QUAT : CROWD_ALPHA, &s, &size);
        web_combination(trial % 15, &terms, &form);
        loads(&p, terms, form);
        pair moved = p;
        random_vector(&g, 3, shift);
        random_unit(&g, 3, axis);
        const rotor q = quat_turn(axis, uniform(&g, 0.5, PI));
        move_rigidly(&moved.c, q, shift);
        loads(&moved, terms, form);
        web_terms(&p.w, 1, terms, form); /* its own bonds, not those of the copy */
        compare(&p, &moved, q, &load, &energy);
        /* the moved state is rounded by 8 eps (|x| <= 5), the unmoved evaluation by 16 eps; energies change by
         * size/s and loads by 2 size/s^2 per length */
        if (trial % 15 < PRINTED_FROM) {
            assert_below(energy, 24 * EPS * size / s);
            assert_below(load, 48 * EPS * size / (s * s));
        } else {
            ++printed;
            seen += energy > 1e-3 * size && load > 1e-3 * size;
        }
    }
    assert_true(seen > 0.9 * printed);
}

/** E11: a relaxed pair turned by 30 degrees about an axis across its bond, K/2 (1 - cos 30)^2 = 0.00897 K. */
TEST(printed_shear_sees_a_rotation)
{
    rng g = rng_seed(3032);
    for (int trial = 0; trial < 300; ++trial) {
        pair p;
        double spare[3], across[3];
        const double none[3] = {0, 0, 0};
        crowd_clear(&p.c, 2, trial & 1 ? CROWD_QUAT : CROWD_ALPHA);
        pair_stiffen(&p, &g);
        random_unit(&g, 3, p.w.rest[0]);
        random_unit(&g, 3, spare);
        vti_cross(p.w.rest[0], spare, across);
        p.w.rest[0][3] = uniform(&g, 0.5, 2);
        for (int k = 0; k < 3; ++k)
            p.c.x[0][k] = p.w.rest[0][3] * p.w.rest[0][k];
        move_rigidly(&p.c, quat_turn(across, PI_L / 6), none);
        /* c rounds by 24 eps, and the energy by K (1 - c) of that */
        const double k = p.w.shear[0], one_minus_c = 1 - sqrt(0.75);
        web_terms(&p.w, 1, SHEAR, VTI_SHEAR_PRINTED);
        assert_close(pair_energy(&p), k / 2 * one_minus_c * one_minus_c, 24 * EPS * k * one_minus_c);
        assert_close(pair_energy(&p), 0.00897 * k, 0.5e-5 * k);
        /* the other forms see the square of a chord that rounds by 24 eps, and its square */
        web_terms(&p.w, 1, SHEAR, VTI_SHEAR_OBJECTIVE);
        assert_below(pair_energy(&p), k / 2 * pow(24 * EPS, 2));
        web_terms(&p.w, 1, SHEAR, VTI_SHEAR_QUARTIC);
        assert_below(pair_energy(&p), k / 8 * pow(24 * EPS, 4));
    }
}

/** Bond (j, i) with -n0. By the formulas the same sums are made in another order or with another sign, so that loads
 *  agree to rounding. */
TEST(swap_of_the_bodies)
{
    rng g = rng_seed(3033);
    int seen = 0, printed = 0;
    for (int trial = 0; trial < 15 * 1000; ++trial) {
        pair p;
        int terms, form;
        double s, size, load, energy;
        pair_draw(&p, &g, trial & 1 ? CROWD_QUAT : CROWD_ALPHA, &s, &size);
        web_combination(trial % 15, &terms, &form);
        loads(&p, terms, form);
        pair swapped = p;
        swapped.w.pair[0][0] = 1;
        swapped.w.pair[0][1] = 0;
        for (int k = 0; k < 3; ++k)
            swapped.w.rest[0][k] *= -1;
        loads(&swapped, terms, form);
        web_terms(&p.w, 1, terms, form);
        const rotor unturned = {0, 0, 0, 1};
        compare(&p, &swapped, unturned, &load, &energy);
        if (trial % 15 < PRINTED_FROM) {
            assert_below(energy, 16 * EPS * size / s);
            assert_below(load, 32 * EPS * size / (s * s));
        } else {
            ++printed;
            seen += load > 1e-3 * size;
        }
    }
    assert_true(seen > 0.9 * printed);
}

/* ---- ten free bodies --------------------------------------------------------------------------------------------- */

/** 1e5 steps of VTI-2 at half the stable step; the largest change of each momentum over the run. */
static void long_run(int form, double change[9])
{
    static crowd c;
    static web w;
    double start[9], now[9];
    rng g = rng_seed(3034);
    crowd_clear(&c, 10, form == VTI_SHEAR_QUARTIC ? CROWD_QUAT : CROWD_ALPHA);
    crowd_scatter(&c, &g, 1, 0.7);
    for (int i = 0; i < c.n; ++i) {
        c.mass[i] = uniform(&g, 0.5, 2);
        c.inertia[i] = uniform(&g, 0.5, 2);
        random_vector(&g, 0.3, c.v[i]);
        random_vector(&g, 0.3, c.omega[i]);
    }
    web_terms(&w, web_grow(&w, &g, &c, 6, 5, 20), MOMENT | AXIAL | SHEAR, form);
    const vti_effect effect = vti_bonds_effect(&w.bonds);
    const vti_bodies b = crowd_bodies(&c);
    assert_int_equal(vti_bonds_check(&w.bonds, c.n, NULL), VTI_OK);
    const double h = crowd_stable(&c, &effect, 1, 0);
    crowd_momenta(&c, start);
    memset(change, 0, 9 * sizeof *change);
    const double energy = vti_energy(&effect, 1, &b);
    for (int block = 0; block < 1000; ++block) {
        crowd_steps(&c, vti_stepper_find("vti2"), 0.5 * h, 100, &effect, 1);
        crowd_momenta(&c, now);
        for (int k = 0; k < 9; ++k)
            change[k] = fmax(change[k], fabs(now[k] - start[k]));
    }
    /* a run that had blown up, or stood still, would prove nothing */
    assert_close(vti_energy(&effect, 1, &b), energy, 0.3 * energy);
    print_message("form %d: P %.2g, L %.2g, sum J Omega %.2g, |x| %.3g, h %g\n", form, vti_max3(change),
                  vti_max3(change + 3), vti_max3(change + 6), vti_max3(c.x[0]), h);
}

/* At random, 1e5 steps of ten bodies make sqrt(1e6) = 1e3 roundings. Of the momenta, of the size 0.5: 1e3 * eps/2 =
 * 1e-13. Of positions, which travel to |x| = 160, times those momenta: 1e3 * 0.5 * 160 * eps/4 = 4e-12 of angular
 * momentum. */
#define KEPT 1e-11

TEST(ten_bodies_objective)
{
    for (int form = VTI_SHEAR_OBJECTIVE; form <= VTI_SHEAR_QUARTIC; ++form) {
        double change[9];
        long_run(form, change);
        assert_below(vti_max3(change), KEPT);
        assert_below(vti_max3(change + 3), KEPT);
        assert_true(vti_max3(change + 6) > 1e-3);
    }
}

TEST(ten_bodies_printed)
{
    double change[9];
    long_run(VTI_SHEAR_PRINTED, change);
    assert_below(vti_max3(change), KEPT);
    assert_below(vti_max3(change + 6), KEPT);
    assert_true(vti_max3(change + 3) > 1e-3); /* the angular momentum is not conserved */
}

RUN_TESTS(cmocka_unit_test(rigid_motion), cmocka_unit_test(printed_shear_sees_a_rotation),
          cmocka_unit_test(swap_of_the_bodies), cmocka_unit_test(ten_bodies_objective),
          cmocka_unit_test(ten_bodies_printed))
