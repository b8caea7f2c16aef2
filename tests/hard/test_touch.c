/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Contacts and bonds at their extremes: what pushes or pulls there, in which direction, and that it is finite. */
#include "hard.h"

static const int64_t first_two[2] = {0, 1};
static const double unit = 1;
static crowd c;
static web w;

static vti_effect bonds(int mask, int form, double stiffness)
{
    memset(&w, 0, sizeof w);
    w.pair[0][1] = 1;
    w.rest[0][0] = w.rest[0][3] = 1;
    w.moment[0] = w.axial[0] = w.shear[0] = stiffness;
    web_terms(&w, 1, mask, form);
    return vti_bonds_effect(&w.bonds);
}

/** Bodies at +- d/2 along e1; loads, and the energy. */
static double apart(const vti_effect *effect, double d)
{
    crowd_clear(&c, 2, CROWD_ALPHA);
    c.x[0][0] = d; /* not halves, so that the least distances exist */
    const vti_bodies b = crowd_bodies(&c);
    assert_int_equal(vti_apply(effect, 1, &b), VTI_OK);
    assert_true(all_finite(c.force[0], 6) && all_finite(c.moment[0], 6));
    assert_true(c.force[0][0] == -c.force[1][0]);
    return vti_energy(effect, 1, &b);
}

/* ---- distances --------------------------------------------------------------------------------------------------- */

/** o = 1 - r/D down to the least distance; no direction below 2^-500, where r^2 begins to vanish. */
TEST(contact_at_all_distances)
{
    const vti_contacts contacts = {.count = 1, .pair = first_two, .diameter = vti_scalars_one(&unit), .stiffness = 10};
    const vti_effect effect = vti_contacts_effect(&contacts);
    for (int e = 0; e <= 1074; ++e)
        for (int side = -1; side <= 1; side += 2) {
            const double d = ldexp(side, -e), o = 1 - fabs(d);
            const double energy = apart(&effect, d);
            assert_close(c.force[0][0], e < 500 ? side * 10 * o * sqrt(o) : 0, 10 * 8 * EPS);
            assert_close(energy, 4 * o * o * sqrt(o), 4 * 8 * EPS);
        }
    robust("separation from D to 5e-324", "contact", "exact; below 3e-151 as for coincident centres");
    const double energy = apart(&effect, 0);
    assert_true(c.force[0][0] == 0);
    assert_close(energy, 4, 4 * EPS);
    robust("coincident centres", "contact", "defined: no direction, no force; U = 2/5 K");
    assert_true(apart(&effect, 1) == 0 && c.force[0][0] == 0);
    assert_true(apart(&effect, 1 - EPS / 2) > 0 && c.force[0][0] > 0);
    robust("overlap of one ulp, and none", "contact", "exact: the least force, and none");
    assert_true(apart(&effect, DBL_MAX) == 0 && c.force[0][0] == 0);
    robust("separation of 1e308", "contact", "exact: no force");
}

TEST(bond_at_all_distances)
{
    static const char *const names[] = {"binder: axial", "binder: shear, objective", "binder: shear, quartic",
                                        "binder: shear, as printed"};
    for (int k = 0; k < 4; ++k) {
        const vti_effect effect = bonds(k == 0 ? AXIAL : SHEAR, k, 10);
        for (int e = 0; e <= 1074; ++e)
            for (int side = -1; side <= 1; side += 2) {
                const double d = ldexp(side, -e);
                apart(&effect, d);
                if (k == 0)
                    assert_close(c.force[0][0], e < 500 ? side * 10 * (1 - fabs(d)) : -side * 0.0, 10 * 8 * EPS);
                else
                    assert_true(c.force[0][0] == 0); /* it acts across the bond only */
            }
        robust("bond compressed from L0 to 5e-324", names[k], "exact; below 3e-151 as for coincident centres");
        const double energy = apart(&effect, 0);
        assert_true(c.force[0][0] == 0 && vti_norm(c.moment[0]) == 0);
        assert_close(energy, k == 0 || k == 2 || k == 3 ? 5 : 10, 10 * 4 * EPS);
        robust("coincident centres", names[k],
               k == 0 ? "defined: no direction, no force; U = K/2"
                      : "defined: no direction, c = 0, no force and no moment");
        apart(&effect, 1e150);
        const double kept = c.force[0][0];
        assert_close(kept, k == 0 ? -10e150 : 0, 10e150 * 4 * EPS);
        crowd_clear(&c, 2, CROWD_ALPHA);
        c.x[0][0] = 1e160;
        const vti_bodies b = crowd_bodies(&c);
        vti_apply(&effect, 1, &b);
        assert_true(!isfinite(vti_energy(&effect, 1, &b)) || k > 0);
        if (k == 0)
            assert_true(!isfinite(c.force[0][0]));
        robust("bond stretched to 1e150", names[k], "exact");
        if (k == 0)
            robust("bond stretched beyond 1e154 (its square overflows)", names[k],
                   "not finite, in force and energy: it shows");
    }
}

/* ---- stiffness and mass ------------------------------------------------------------------------------------------ */

/** A chain of three, bonds K and 1e12 K: stable at the step that the stiff one allows, and the bound says so. */
TEST(unequal)
{
    for (int what = 0; what < 2; ++what)
        for (int64_t k = 0; k < vti_stepper_count(); ++k) {
            static troupe t;
            double p[3], energy = 0;
            const vti_stepper *method = vti_stepper_at(k);
            crowd_clear(&t.c, 3, CROWD_ALPHA);
            memset(&w, 0, sizeof w);
            for (int i = 0; i < 3; ++i)
                t.c.x[i][0] = i;
            for (int i = 0; i < 2; ++i) {
                w.pair[i][0] = i;
                w.pair[i][1] = i + 1;
                w.rest[i][0] = -1;
                w.rest[i][3] = 1;
                w.axial[i] = w.moment[i] = w.shear[i] = what == 0 && i == 0 ? 1e12 : 1;
            }
            if (what == 1)
                t.c.mass[0] = t.c.inertia[0] = 1e9;
            t.c.v[2][0] = 0.01;
            t.c.v[2][1] = -0.01;
            web_terms(&w, 2, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
            const vti_effect effect = vti_bonds_effect(&w.bonds);
            troupe_ready(&t, method, &effect, 1);
            const double start = troupe_energy(&t), h = 0.4 * method->reach / 2 * crowd_stable(&t.c, &effect, 1, 0);
            vti_step_start(method, h, &t.b);
            for (int i = 0; i < 5000; ++i) {
                assert_int_equal(troupe_step(&t, h, NULL), VTI_OK);
                energy = fmax(energy, troupe_energy(&t));
            }
            vti_step_sync(method, h, &t.b);
            vti_momentum(&t.b, p);
            assert_true(troupe_is_finite(&t));
            /* (h omega)^2/4 = 0.16 of the energy in the fastest mode is what a step of order 2 errs by; forces of
             * roundings of distance, K eps, kick by h K eps and do so as sqrt(N) */
            const double noise = what == 0 ? 1e12 * EPS * EPS * 5000 : 0;
            assert_below(energy, 1.25 * start + noise);
            /* equal and opposite kicks of v, |v| <= 0.02, that round apart: eps/2 |v| sqrt(5000 evals), less than 3
             * eps */
            assert_close(p[0], 0.01, 16 * EPS);
            robust(what == 0 ? "stiffness ratio 1e12, at 0.4 of the stable step"
                             : "mass ratio 1e9, at 0.4 of the stable step",
                   method->name, "bounded; momentum to rounding");
        }
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

static double wall(double x, double stiffness)
{
    const double plane[4] = {1, 0, 0, 0};
    const vti_walls walls = {.count = 1, .plane = plane, .diameter = vti_scalars_one(&unit), .stiffness = stiffness};
    const vti_effect effect = vti_walls_effect(&walls);
    crowd_clear(&c, 1, CROWD_ALPHA);
    c.x[0][0] = x;
    const vti_bodies b = crowd_bodies(&c);
    vti_apply(&effect, 1, &b);
    assert_true(c.force[0][1] == 0 && c.force[0][2] == 0);
    return c.force[0][0];
}

TEST(wall_at_all_distances)
{
    assert_true(wall(0.5, 8) == 0 && wall(0.5 + EPS, 8) == 0 && wall(0.5 - EPS / 4, 8) > 0);
    robust("overlap of one ulp, and none", "wall", "exact: the least force, and none");
    const double depth[] = {0, -0.1, -1, -100, -1e100};
    for (int k = 0; k < 5; ++k) {
        const double o = 1 - depth[k] / 0.5;
        assert_close(wall(depth[k], 8), 16 * o * sqrt(o), 8 * EPS * 16 * o * sqrt(o));
    }
    robust("a body behind the wall", "wall",
           "exact: U = 2/5 K (1 - 2g/D)^{5/2} goes on growing with depth, it is pushed back");
}

/** Thrown at the wall so fast that the first step puts it behind, and grazing it. */
TEST(thrown_at_a_wall)
{
    const double plane[4] = {1, 0, 0, 0};
    const vti_walls walls = {.count = 1, .plane = plane, .diameter = vti_scalars_one(&unit), .stiffness = 10};
    const vti_effect effect = vti_walls_effect(&walls);
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        static troupe t;
        const vti_stepper *method = vti_stepper_at(k);
        const double h = 0.02;
        int behind = 0;
        crowd_clear(&t.c, 1, CROWD_ALPHA);
        t.c.x[0][0] = 0.51;
        t.c.v[0][0] = -100; /* 2 of the body's diameters per step */
        t.c.v[0][1] = 1;
        troupe_ready(&t, method, &effect, 1);
        vti_step_start(method, h, &t.b);
        for (int i = 0; i < 2000; ++i) {
            assert_int_equal(troupe_step(&t, h, NULL), VTI_OK);
            behind |= t.c.x[0][0] < 0;
        }
        vti_step_sync(method, h, &t.b);
        assert_true(troupe_is_finite(&t) && behind);
        assert_true(t.c.x[0][0] > 1 && t.c.v[0][0] > 0);
        assert_true(t.c.v[0][1] == 1);
        print_message("%-14s leaves with %.4f of its speed\n", method->name, t.c.v[0][0] / 100);
        robust("a body pushed through a wall in one step", method->name, "comes back out");

        crowd_clear(&t.c, 1, CROWD_ALPHA);
        t.c.x[0][0] = 0.5 + 1e-6;
        t.c.v[0][0] = -1e-4;
        t.c.v[0][1] = 10;
        troupe_ready(&t, method, &effect, 1);
        const double start = troupe_energy(&t);
        vti_step_start(method, h, &t.b);
        for (int i = 0; i < 20000; ++i) {
            assert_int_equal(troupe_step(&t, h, NULL), VTI_OK);
            assert_true(t.c.x[0][0] > 0.49 && t.c.v[0][1] == 10);
        }
        vti_step_sync(method, h, &t.b);
        assert_true(t.c.v[0][0] > 0 && t.c.x[0][0] > 0.5);
        assert_close(troupe_energy(&t), start, 1e-8 * 0.1); /* a tenth of the energy along the normal */
        robust("grazing contact with a wall", method->name, "leaves again; along the wall nothing changes, to the bit");
    }
}

RUN_TESTS(cmocka_unit_test(contact_at_all_distances), cmocka_unit_test(bond_at_all_distances),
          cmocka_unit_test(unequal), cmocka_unit_test(wall_at_all_distances), cmocka_unit_test(thrown_at_a_wall))
