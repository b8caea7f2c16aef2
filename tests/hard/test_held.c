/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bodies that do not move, few bodies and tiny numbers. Mass and inertia are finite; a held body is one that is left
 * out of the slice that is stepped, as effects act across slices. A huge mass does almost the same. */
#include "hard.h"

static const double h = 0.01;
static web w;
static vti_effect effect;

/** Two bonded bodies, the first of which is to be held. */
static void pose(crowd *c)
{
    crowd_clear(c, 2, CROWD_ALPHA);
    memset(&w, 0, sizeof w);
    c->x[0][0] = 1;
    c->v[1][1] = 0.5;
    c->omega[1][2] = 0.3;
    w.pair[0][1] = 1;
    w.rest[0][0] = w.rest[0][3] = w.moment[0] = w.axial[0] = w.shear[0] = 1;
    web_terms(&w, 1, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
    effect = vti_bonds_effect(&w.bonds);
}

/** A step of the slice with the forces of all. */
static void step(const vti_stepper *method, const vti_bodies *all, const vti_bodies *slice, const vti_bodies *probed)
{
    for (int64_t k = 0; k <= method->stages; ++k) {
        if (method->probe != NULL && method->probe[k] != 0.0) {
            vti_bodies whole = *probed;
            whole.first = all->first;
            whole.count = all->count;
            assert_int_equal(vti_step_probe(method, k, h, slice, probed), VTI_OK);
            vti_apply(&effect, 1, &whole);
        }
        if (k == method->stages)
            assert_int_equal(vti_step_finish(method, h, slice), VTI_OK);
        else {
            assert_int_equal(vti_step_stage(method, k, h, slice, NULL), VTI_OK);
            vti_apply(&effect, 1, all);
        }
    }
}

TEST(held_bodies)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        static crowd held, heavy, elsewhere[2];
        const vti_stepper *method = vti_stepper_at(k);
        if (method->frame == VTI_FRAME_BODY)
            continue; /* its effects are the host's business */
        pose(&held);
        heavy = held;
        heavy.mass[0] = heavy.inertia[0] = 1e300;
        elsewhere[0] = elsewhere[1] = held;
        const crowd start = held;
        const vti_bodies all = crowd_bodies(&held), slice = vti_bodies_slice(all, 1, 1), huge = crowd_bodies(&heavy);
        vti_bodies probed[2] = {vti_bodies_slice(crowd_bodies(&elsewhere[0]), 1, 1), crowd_bodies(&elsewhere[1])};
        probed[0].force = all.force;
        probed[0].moment = all.moment;
        probed[1].force = huge.force;
        probed[1].moment = huge.moment;
        vti_apply(&effect, 1, &all);
        vti_apply(&effect, 1, &huge);
        for (int i = 0; i < 1000; ++i) {
            step(method, &all, &slice, &probed[0]);
            step(method, &huge, &huge, &probed[1]);
        }
        assert_same_bits(start.x[0], held.x[0], 3);
        assert_same_bits(start.v[0], held.v[0], 3);
        assert_same_bits(start.alpha[0], held.alpha[0], 3);
        assert_same_bits(start.omega[0], held.omega[0], 3);
        assert_true(held.x[1][1] != start.x[1][1]);
        for (int c = 0; c < 3;
             ++c) { /* 10 units of time at an acceleration of 1e-300, and to the rest it is the same */
            assert_close(heavy.x[0][c], start.x[0][c], 1e-297);
            assert_close(heavy.v[0][c], 0, 1e-298);
            assert_close(heavy.omega[0][c], 0, 1e-298);
        }
        assert_same_bits(held.x[1], heavy.x[1], 3);
        assert_same_bits(held.alpha[1], heavy.alpha[1], 3);
        robust("held body: outside the slice that is stepped", method->name,
               "exact: stays to the bit, and acts on others");
        robust("held body: mass and inertia of 1e300", method->name,
               "stays within 1e-297; others to the bit as if held");
    }
}

TEST(infinite_mass)
{
    static crowd c;
    pose(&c);
    vti_fault fault;
    const double infinite = INFINITY;
    vti_bodies b = crowd_bodies(&c);
    c.mass[1] = INFINITY;
    assert_int_equal(vti_bodies_check_values(&b, &fault), VTI_E_MASS);
    assert_int_equal(fault.body, 1);
    b.mass = vti_scalars_one(&infinite);
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        assert_int_equal(vti_step_stage(vti_stepper_at(k), 0, h, &b, NULL), VTI_E_MASS);
        robust("infinite mass", vti_stepper_at(k)->name, "reported: %s", vti_status_text(VTI_E_MASS));
    }
}

TEST(no_body_and_one)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        static troupe t;
        double p[3] = {1, 1, 1};
        crowd_clear(&t.c, 0, CROWD_ALPHA);
        troupe_ready(&t, method, NULL, 0);
        for (int i = 0; i < 3; ++i)
            assert_int_equal(troupe_step(&t, h, NULL), VTI_OK);
        vti_momentum(&t.b, p);
        assert_true(troupe_energy(&t) == 0 && p[0] == 0 && vti_max_turn(h, &t.b) == 0);
        const vti_bodies none = vti_bodies_none(0), bare = vti_bodies_none(7);
        assert_int_equal(vti_step_stage(method, 0, h, &none, NULL), VTI_OK);
        assert_int_equal(vti_step_stage(method, 0, h, &bare, NULL), VTI_OK);
        robust("no bodies, or bodies without any view", method->name, "nothing to do, VTI_OK; sums are 0");
    }
}

/* ---- subnormals -------------------------------------------------------------------------------------------------- */

/** Everything a subnormal number: nothing but underflow happens, and the attitude goes on being the identity. */
TEST(subnormals)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        static crowd c, elsewhere;
        crowd_clear(&c, 2, CROWD_ALPHA);
        for (int i = 0; i < 2; ++i) {
            c.mass[i] = c.inertia[i] = DBL_MIN;
            for (int a = 0; a < 3; ++a)
                c.x[i][a] = c.v[i][a] = c.force[i][a] = c.alpha[i][a] = c.omega[i][a] = c.moment[i][a] =
                    (i == 0 ? 1 : 3) * 0x1p-1074;
        }
        elsewhere = c;
        const vti_bodies b = crowd_bodies(&c), probed = crowd_bodies(&elsewhere);
        for (int64_t s = 0; s < method->stages; ++s) {
            assert_int_equal(vti_step_probe(method, s, 1, &b, &probed), VTI_OK);
            assert_int_equal(vti_step_stage(method, s, 1, &b, NULL), VTI_OK);
        }
        assert_int_equal(vti_step_finish(method, 1, &b), VTI_OK);
        assert_true(all_finite(c.x[0], 6) && all_finite(c.v[0], 6) && all_finite(c.alpha[0], 6) &&
                    all_finite(c.omega[0], 6));
        /* F/m = 2^-1074/2^-1022 = 2^-52, during a step of 1; what is of the attitude is half of it or all, as kicks
         * come */
        for (int a = 0; a < 3; ++a) {
            assert_close(c.v[0][a], 0x1p-52, 0x1p-100);
            assert_close(c.omega[1][a], 3 * 0x1p-52, 0x1p-100);
            assert_close(c.x[0][a], method->order == 1 ? 0x1p-52 : method->lag > 0 ? 0x1p-52 : 0x1p-53, 0x1p-100);
            assert_close(c.alpha[0][a], c.x[0][a], 0x1p-100);
        }
        robust("all numbers subnormal, mass 2e-308", method->name, "exact");
    }
}

RUN_TESTS(cmocka_unit_test(held_bodies), cmocka_unit_test(infinite_mass), cmocka_unit_test(no_body_and_one),
          cmocka_unit_test(subnormals))
