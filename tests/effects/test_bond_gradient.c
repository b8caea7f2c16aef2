/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Forces and moments of every combination of binder terms are minus the derivatives of its energy, by the positions
 * and by spatial rotations of both bodies, and they balance. */
#include "pair.h"

/** The energy with coordinate k of body i, 0-2 its position and 3-5 a rotation, moved by t; *moved is by how much. */
static double energy_moved(pair *p, int i, int k, double t, double *moved)
{
    const double axis[3] = {k == 3, k == 4, k == 5};
    const crowd kept = p->c;
    if (k < 3)
        p->c.x[i][k] += t;
    else
        crowd_turn(&p->c, i, axis, t);
    *moved = k < 3 ? p->c.x[i][k] - kept.x[i][k] : t;
    const double energy = pair_energy(p);
    p->c = kept;
    return energy;
}

/** (4 D(t/2) - D(t))/3 of the central differences D. */
static double slope(pair *p, int i, int k, double t)
{
    double d[2];
    for (int half = 0; half < 2; ++half, t /= 2) {
        double up, down;
        const double high = energy_moved(p, i, k, t, &up), low = energy_moved(p, i, k, -t, &down);
        d[half] = (high - low) / (up - down);
    }
    return (4 * d[1] - d[0]) / 3;
}

/* With a step of tau times the distance s to the nearest singularity of the energy (bond of no length, b_i = -b_j),
 * which bounds the fifth derivative by 5! U/s^5 (Cauchy), the extrapolated difference errs by
 *     tau^4/480 * 120 U/s                     truncation
 *     3 * 16 eps U/(tau s)                    rounding of the energies, of which 16 eps are reckoned with
 * and tau makes both about equal. */
static double share_of_step(void)
{
    return pow(200 * EPS, 0.2);
}

static double tolerance(double size, double s)
{
    const double tau = share_of_step();
    return size / s * (pow(tau, 4) / 4 + 48 * EPS / tau);
}

/** A pair, bonded by the combination of terms of that trial, and its loads. */
static void draw_loaded(pair *p, rng *g, int trial, int *terms, int *form, double *s, double *size)
{
    pair_draw(p, g, trial & 1 ? CROWD_QUAT : CROWD_ALPHA, s, size);
    web_combination(trial % 15, terms, form);
    web_terms(&p->w, 1, *terms, *form);
    const vti_effect effect = vti_bonds_effect(&p->w.bonds);
    const vti_bodies b = crowd_bodies(&p->c);
    vti_apply(&effect, 1, &b);
}

TEST(loads_are_minus_the_gradient)
{
    rng g = rng_seed(3021);
    for (int trial = 0; trial < 15 * 2000; ++trial) {
        pair p;
        int terms, form;
        double s, size;
        draw_loaded(&p, &g, trial, &terms, &form, &s, &size);
        const crowd at = p.c;
        for (int i = 0; i < 2; ++i)
            for (int k = 0; k < 6; ++k)
                assert_close(k < 3 ? at.force[i][k] : at.moment[i][k - 3], -slope(&p, i, k, share_of_step() * s),
                             tolerance(size, s));
    }
}

/** F_i = -F_j to the bit. Objective: x_i x F_i + x_j x F_j + T_i + T_j = 0. Moment and printed shear: T_i = -T_j to the
 *  bit, and the whole does not balance. */
TEST(loads_balance)
{
    rng g = rng_seed(3022);
    double unbalanced = 0;
    for (int trial = 0; trial < 15 * 2000; ++trial) {
        pair p;
        int terms, form;
        double s, size, arms[2][3], total[3], most = 0;
        draw_loaded(&p, &g, trial, &terms, &form, &s, &size);
        vti_cross(p.c.x[0], p.c.force[0], arms[0]);
        vti_cross(p.c.x[1], p.c.force[1], arms[1]);
        for (int k = 0; k < 3; ++k) {
            total[k] = arms[0][k] + arms[1][k] + p.c.moment[0][k] + p.c.moment[1][k];
            most = fmax(most, fabs(total[k]));
            assert_true(p.c.force[0][k] == -p.c.force[1][k]);
            if (!(terms & SHEAR) || form == VTI_SHEAR_PRINTED)
                assert_true(p.c.moment[0][k] == -p.c.moment[1][k]);
        }
        if (form != VTI_SHEAR_PRINTED)
            /* each load is rounded by some 16 eps of size/s, and so is n, with arms of sqrt 3 */
            assert_below(most, 64 * EPS * size / s);
        else
            unbalanced = fmax(unbalanced, most / size);
    }
    assert_true(unbalanced > 0.1);
}

/** apply adds to the loads that are there, as a force and a moment each; without a view it leaves the other as it
 *  is. */
TEST(loads_are_added)
{
    rng g = rng_seed(3023);
    for (int trial = 0; trial < 15; ++trial) {
        pair p;
        int terms, form;
        double s, size;
        pair_draw(&p, &g, CROWD_QUAT, &s, &size);
        web_combination(trial, &terms, &form);
        web_terms(&p.w, 1, terms, form);
        const vti_effect effect = vti_bonds_effect(&p.w.bonds);
        const vti_bodies b = crowd_bodies(&p.c);
        vti_apply(&effect, 1, &b);
        const crowd once = p.c;
        effect.apply(effect.self, &b);
        for (int i = 0; i < 2; ++i)
            for (int k = 0; k < 3; ++k) {
                assert_true(p.c.force[i][k] == 2 * once.force[i][k]);
                assert_true(p.c.moment[i][k] == 2 * once.moment[i][k]);
            }
        for (int without = 0; without < 2; ++without) {
            vti_bodies part = b;
            *(without ? &part.moment : &part.force) = vti_view_none();
            memset(p.c.force, 0, sizeof p.c.force);
            memset(p.c.moment, 0, sizeof p.c.moment);
            effect.apply(effect.self, &part);
            for (int i = 0; i < 2; ++i)
                for (int k = 0; k < 3; ++k) {
                    assert_true(p.c.force[i][k] == (without ? once.force[i][k] : 0));
                    assert_true(p.c.moment[i][k] == (without ? 0 : once.moment[i][k]));
                }
        }
    }
}

/** Where there is no direction there is no force of it, and never a NaN: coincident centres, b_i = -b_j, half a
 *  turn. */
TEST(singular_bonds_stay_finite)
{
    const double e3[3] = {0, 0, 1};
    for (int trial = 0; trial < 15 * 3; ++trial) {
        pair p;
        int terms, form;
        memset(&p.w, 0, sizeof p.w);
        crowd_clear(&p.c, 2, CROWD_QUAT);
        p.w.pair[0][1] = 1;
        p.w.rest[0][0] = p.w.rest[0][3] = p.w.moment[0] = p.w.axial[0] = p.w.shear[0] = 1;
        if (trial % 3 != 0)
            p.c.x[0][1] = 1.5;
        if (trial % 3 == 1)
            p.c.quat[0][2] = 1, p.c.quat[0][3] = 0; /* half a turn about e3: b_i = -b_j */
        if (trial % 3 == 2)
            crowd_turn(&p.c, 0, e3, PI_L);
        web_combination(trial / 3, &terms, &form);
        web_terms(&p.w, 1, terms, form);
        const vti_effect effect = vti_bonds_effect(&p.w.bonds);
        const vti_bodies b = crowd_bodies(&p.c);
        vti_apply(&effect, 1, &b);
        assert_true(all_finite(p.c.force[0], 6) && all_finite(p.c.moment[0], 6));
        assert_true(isfinite(pair_energy(&p)));
        for (int k = 0; k < 3 && trial % 3 == 0; ++k)
            assert_true(p.c.force[0][k] == 0 && p.c.force[1][k] == 0);
        if (terms & MOMENT && !(terms & SHEAR) && trial % 3 != 0)
            assert_close(fabs(p.c.moment[0][2]), PI, 4 * EPS * PI);
    }
}

RUN_TESTS(cmocka_unit_test(loads_are_minus_the_gradient), cmocka_unit_test(loads_balance),
          cmocka_unit_test(loads_are_added), cmocka_unit_test(singular_bonds_stay_finite))
