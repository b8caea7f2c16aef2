/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Steps by a tolerance: what is accepted and tried next is what the equations say; what is undone leaves no trace;
 * errors of a run go with the tolerance, and every step keeps the momenta. */
#include <float.h>

#include "chain.h"

enum { BODIES = 4, ROWS = 3, WIDTH = 34 };

/* ---- what is tried next ------------------------------------------------------------------------------------------ */

static vti_control started(const char *name, double tolerance, double h)
{
    vti_control control;
    assert_int_equal(vti_control_start(vti_stepper_find(name), tolerance, h, &control), VTI_OK);
    return control;
}

/** The next h after one of 1 with this error over the tolerance. */
static double next_of(vti_control control, double ratio, int64_t wanted)
{
    int64_t accepted = -1;
    const double error = ratio * control.tolerance;
    assert_int_equal(vti_control_judge(&control, 1.0, error, 0.5 * error, &accepted), VTI_OK);
    assert_int_equal(accepted, wanted);
    assert_int_equal(control.accepted, wanted);
    assert_int_equal(control.rejected, 1 - wanted);
    assert_int_equal(control.held, 1 - wanted);
    assert_true(control.error == error || isnan(error));
    return control.h;
}

TEST(next_step_is_that_of_the_equation)
{
    static const char *const names[] = {"srkn6", "srkn11", "srkn14"};
    for (int m = 0; m < 3; ++m) {
        const vti_control control = started(names[m], 1e-7, 1.0);
        assert_true(control.power == (double)(vti_stepper_find(names[m])->estimate_order + 1));
        for (double ratio = 1e-9; ratio < 1e9; ratio *= 1.37) {
            const long double power = 0.85L * powl(1.0L / ratio, 1.0L / control.power);
            long double factor = fminl(4, fmaxl(0.2L, power));
            factor = ratio > 1 ? fminl(factor, 0.9L) : factor;
            assert_close(next_of(control, ratio, ratio <= 1), factor, 4e-15); /* Newton's last step: a few ulps of 4 */
        }
        assert_close(next_of(control, 0.0, 1), 4, 0);
        assert_close(next_of(control, INFINITY, 0), 0.2, 1e-16);
        assert_close(next_of(control, NAN, 0), 0.2, 1e-16);
    }
}

TEST(held_cut_and_limited)
{
    vti_control c = started("srkn11", 1e-6, 1.0);
    int64_t accepted;
    assert_int_equal(vti_control_judge(&c, 1.0, 1e-3, 0, &accepted), VTI_OK);
    const double h = c.h;
    assert_true(!accepted && h < 0.9);
    assert_int_equal(vti_control_judge(&c, h, 1e-12, 0, &accepted), VTI_OK);
    assert_true(accepted && c.h == h); /* after one that was undone none grows */
    assert_int_equal(vti_control_judge(&c, h, 0, 1e-12, &accepted), VTI_OK);
    assert_true(accepted && c.h == 4 * h); /* the next one may */
    assert_int_equal(vti_control_judge(&c, 0.1 * h, 0, 0.9e-6, &accepted), VTI_OK);
    assert_true(accepted && c.h == 4 * h); /* one that was cut leaves h */
    assert_int_equal(vti_control_judge(&c, 0.1 * h, 2e-6, 0, &accepted), VTI_OK);
    assert_true(!accepted && c.h < 0.1 * h);
    assert_int_equal(c.accepted, 3);
    assert_int_equal(c.rejected, 2);
    c = started("srkn11", 1e-6, 1.0);
    c.most = 2.0;
    c.least = 0.5;
    assert_int_equal(vti_control_judge(&c, 1.0, 0, 0, &accepted), VTI_OK);
    assert_true(accepted && c.h == 2.0);
    assert_int_equal(vti_control_judge(&c, 1.0, NAN, 0, &accepted), VTI_OK);
    assert_true(!accepted && c.h == 0.5);
    const vti_control before = c;
    assert_int_equal(vti_control_judge(&c, 0.5, 0, NAN, &accepted), VTI_E_CONTROL);
    assert_int_equal(vti_control_judge(&c, 1.0, -1e-9, 0, &accepted), VTI_E_CONTROL);
    assert_int_equal(vti_control_judge(&c, 1.0, 0, -1e-9, &accepted), VTI_E_CONTROL);
    assert_memory_equal(&c, &before, sizeof c);
    assert_int_equal(vti_control_judge(&c, 0.5, 0, 1e-7, &accepted), VTI_OK);
    assert_true(accepted && c.h == 0.5);
    c = started("srkn11", 1e-6, 1.0); /* no limits: h stays positive and finite all the same */
    assert_int_equal(vti_control_judge(&c, 1e308, 0, 0, &accepted), VTI_OK);
    assert_true(accepted && c.h == DBL_MAX);
    assert_int_equal(vti_control_judge(&c, 2 * DBL_MIN, NAN, 0, &accepted), VTI_OK);
    assert_true(!accepted && c.h == DBL_MIN);
    assert_int_equal(vti_control_judge(&c, DBL_MIN, NAN, 0, &accepted), VTI_E_CONTROL);
}

/** Speeds and spins are measured in units of their own. */
TEST(scales)
{
    vti_control c = started("srkn11", 1e-3, 1.0);
    int64_t accepted;
    c.speed = 100.0;
    c.turning = 1e-4;
    assert_int_equal(vti_control_judge(&c, 1.0, 0.05, 0.5e-7, &accepted), VTI_OK);
    assert_true(accepted);
    assert_close(c.error, 5e-4, 1e-18);
    assert_int_equal(vti_control_judge(&c, 1.0, 0.05, 2e-7, &accepted), VTI_OK);
    assert_true(!accepted);
    assert_close(c.error, 2e-3, 1e-17);
}

TEST(refused_controls)
{
    const vti_stepper *s = vti_stepper_find("srkn11");
    vti_control c;
    int64_t accepted = 7;
    assert_int_equal(vti_control_start(s, 1e-3, 0.1, NULL), VTI_E_NULL);
    assert_int_equal(vti_control_start(NULL, 1e-3, 0.1, &c), VTI_E_STEPPER);
    assert_int_equal(vti_control_start(vti_stepper_find("exact"), 1e-3, 0.1, &c), VTI_E_STEPPER);
    assert_int_equal(vti_control_start(s, -1e-3, 0.1, &c), VTI_E_CONTROL);
    assert_int_equal(vti_control_start(s, INFINITY, 0.1, &c), VTI_E_CONTROL);
    assert_int_equal(vti_control_start(s, 1e-3, NAN, &c), VTI_E_TIME);
    const vti_control good = started("srkn11", 1e-3, 0.1);
    c = good;
    assert_int_equal(vti_control_judge(NULL, 0.1, 0, 0, &accepted), VTI_E_NULL);
    assert_int_equal(vti_control_judge(&c, 0.1, 0, 0, NULL), VTI_E_NULL);
    assert_int_equal(vti_control_judge(&c, 0.0, 0, 0, &accepted), VTI_E_TIME);
    double *const wrong[] = {&c.tolerance, &c.speed, &c.turning, &c.most, &c.least, &c.h, &c.power, &c.power, &c.power};
    static const double value[] = {0, NAN, -1, 0, -1, 0, 1, 17, 2.5};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; ++k) {
        c = good;
        *wrong[k] = value[k];
        const vti_control before = c;
        assert_int_equal(vti_control_judge(&c, 0.1, 0, 0, &accepted), VTI_E_CONTROL);
        assert_memory_equal(&c, &before, sizeof c);
    }
    assert_int_equal(accepted, 7);
    for (int k = 0; k < 2; ++k) { /* the least power and the most */
        c = good;
        c.power = k == 0 ? 2 : 16;
        assert_int_equal(vti_control_judge(&c, 0.1, 0, 0, &accepted), VTI_OK);
    }
}

/* ---- what is undone ---------------------------------------------------------------------------------------------- */

/** A chain whose bodies have residuals too, where they are asked for. */
struct subject {
    chain c;
    double low[4][BODIES][3];
    vti_bodies b;
    double memory[BODIES][WIDTH], sums[BODIES][ROWS][6];
    vti_kept kept;
    vti_errors errors;
};

static void make(struct subject *s, enum chain_storage storage, int residuals)
{
    memset(s, 0, sizeof *s);
    chain_make(&s->c, BODIES, 11, storage);
    s->b = chain_bodies(&s->c);
    if (residuals) {
        s->b.x_low = vti_view_packed(s->low[0][0]);
        s->b.v_low = vti_view_packed(s->low[1][0]);
        s->b.alpha_low = storage == CHAIN_ALPHA ? vti_view_packed(s->low[2][0]) : vti_view_none();
        s->b.omega_low = vti_view_packed(s->low[3][0]);
    }
    s->kept = (vti_kept){s->memory[0], WIDTH};
    s->errors = (vti_errors){s->sums[0][0], ROWS};
    chain_load(&s->c, &s->b);
}

/** A step that is watched. */
static void step(struct subject *s, const vti_stepper *method, double h, double *velocity, double *spin)
{
    for (int64_t k = 0; k <= method->stages; ++k) {
        assert_int_equal(vti_step_watch(method, k, h, &s->b, &s->errors), VTI_OK);
        if (k == method->stages)
            break;
        assert_int_equal(vti_step_stage(method, k, h, &s->b, NULL), VTI_OK);
        chain_load(&s->c, &s->b);
    }
    assert_int_equal(vti_step_finish(method, h, &s->b), VTI_OK);
    assert_int_equal(vti_step_error(method, &s->b, &s->errors, velocity, spin), VTI_OK);
}

TEST(undone_to_the_bit)
{
    const vti_stepper *method = vti_stepper_find("srkn11");
    static const int64_t width[2][2] = {{18, 30}, {19, 28}};
    for (int storage = CHAIN_ALPHA; storage <= CHAIN_QUAT; ++storage)
        for (int residuals = 0; residuals < 2; ++residuals) {
            static struct subject s, before;
            double v, o;
            make(&s, (enum chain_storage)storage, residuals);
            step(&s, method, 0.1, &v, &o); /* residuals are no longer 0 */
            before = s;
            assert_int_equal(vti_step_keeps(&s.b), width[storage][residuals]);
            assert_int_equal(vti_step_keep(&s.b, &s.kept), VTI_OK);
            step(&s, method, 0.3, &v, &o);
            const chain after = s.c;
            const vti_bodies middle = vti_bodies_slice(s.b, 1, 2);
            assert_int_equal(vti_step_undo(&middle, &s.kept), VTI_OK); /* the slice, and nothing else */
            assert_memory_equal(s.c.x[1], before.c.x[1], 2 * sizeof s.c.x[1]);
            assert_memory_equal(s.c.x[0], after.x[0], sizeof s.c.x[0]);
            assert_memory_equal(s.c.omega[3], after.omega[3], sizeof s.c.omega[3]);
            assert_int_equal(vti_step_undo(&s.b, &s.kept), VTI_OK);
            assert_memory_equal(&s.c, &before.c, sizeof s.c);
            assert_memory_equal(s.low, before.low, sizeof s.low);
        }
}

TEST(refused_copies)
{
    static struct subject s;
    make(&s, CHAIN_ALPHA, 0);
    const chain before = s.c;
    vti_bodies bad = s.b;
    bad.count = -1;
    const vti_kept none = {NULL, WIDTH}, narrow = {s.memory[0], 17};
    const struct {
        const vti_bodies *b;
        const vti_kept *kept;
        int status;
    } all[] = {{NULL, &s.kept, VTI_E_NULL},
               {&bad, &s.kept, VTI_E_COUNT},
               {&s.b, NULL, VTI_E_NULL},
               {&s.b, &none, VTI_E_NULL},
               {&s.b, &narrow, VTI_E_COUNT}};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k) {
        assert_int_equal(vti_step_keep(all[k].b, all[k].kept), all[k].status);
        assert_int_equal(vti_step_undo(all[k].b, all[k].kept), all[k].status);
    }
    assert_int_equal(vti_step_keeps(NULL), VTI_E_NULL);
    assert_memory_equal(&s.c, &before, sizeof before);
}

/* ---- runs -------------------------------------------------------------------------------------------------------- */

static void momenta(const struct subject *s, double p[3], double l[3])
{
    vti_momentum(&s->b, p);
    static const double origin[3] = {0, 0, 0};
    vti_angular_momentum(&s->b, origin, l);
}

/** To t_end by the tolerance; every step keeps both momenta to rounding. Returns the control at the end. */
static vti_control run(struct subject *s, const char *name, double tolerance, double first, double t_end)
{
    const vti_stepper *method = vti_stepper_find(name);
    vti_control control = started(name, tolerance, first);
    double p0[3], l0[3];
    momenta(s, p0, l0);
    for (double t = 0; t < t_end;) {
        const double left = t_end - t, h = control.h < left ? control.h : left;
        double velocity, spin, p[3], l[3];
        int64_t accepted;
        assert_int_equal(vti_step_keep(&s->b, &s->kept), VTI_OK);
        step(s, method, h, &velocity, &spin);
        assert_int_equal(vti_control_judge(&control, h, velocity, spin, &accepted), VTI_OK);
        t = accepted ? (h < left ? t + h : t_end) : t;
        if (!accepted)
            assert_int_equal(vti_step_undo(&s->b, &s->kept), VTI_OK);
        momenta(s, p, l);
        for (int k = 0; k < 3; ++k) { /* 1e-15 of numbers up to 10, and up to 1000 stages of it */
            assert_close(p[k], p0[k], 1e-12);
            assert_close(l[k], l0[k], 1e-12);
        }
    }
    return control;
}

TEST(errors_go_with_the_tolerance)
{
    static const char *const names[] = {"srkn6", "srkn11", "srkn14"};
    static struct subject exact, s;
    const double t_end = 6.0;
    make(&exact, CHAIN_QUAT, 0);
    chain_run(&exact.c, vti_stepper_find("kl8"), t_end / 1024, 1024);
    for (int m = 0; m < 3; ++m) {
        double error[2][4], mean[2];
        for (int level = 0; level < 2; ++level) {
            make(&s, CHAIN_QUAT, 0);
            const vti_control c = run(&s, names[m], level == 0 ? 1e-4 : 1e-7, 1.0, t_end);
            chain_difference(&s.c, &exact.c, error[level]);
            mean[level] = t_end / (double)c.accepted;
            print_message("%s: tolerance %g: %d steps, %d undone; attitudes to %.2e, Omega to %.2e\n", names[m],
                          c.tolerance, (int)c.accepted, (int)c.rejected, error[level][0], error[level][1]);
            assert_true(c.rejected > 0 && c.rejected < c.accepted);
        }
        /* steps go with the power 1/(q+1), errors at the end with h^p: a factor 10^3 is more than 10^1.5 */
        const double power = (double)vti_stepper_find(names[m])->estimate_order + 1;
        assert_close(log10(mean[0] / mean[1]) * power, 3, 0.8);
        for (int e = 0; e < 4; ++e) {
            assert_true(error[1][e] < 1e-7 * t_end * 10); /* the estimate is above the true error of a step */
            assert_true(error[1][e] < 0.03 * error[0][e]);
        }
    }
}

/** A first step that is far too long is undone until it is accepted: what follows has the bits of a run that began
 *  with that. */
TEST(undone_steps_leave_no_trace)
{
    static struct subject once, again;
    make(&once, CHAIN_ALPHA, 1);
    make(&again, CHAIN_ALPHA, 1);
    double v, o, h = 4.0;
    const vti_stepper *method = vti_stepper_find("srkn11");
    vti_control control = started("srkn11", 1e-9, h);
    for (int64_t accepted = 0; !accepted;) {
        assert_int_equal(vti_step_keep(&once.b, &once.kept), VTI_OK);
        step(&once, method, h = control.h, &v, &o);
        assert_int_equal(vti_control_judge(&control, h, v, o, &accepted), VTI_OK);
        if (!accepted)
            assert_int_equal(vti_step_undo(&once.b, &once.kept), VTI_OK);
    }
    assert_true(control.rejected > 2);
    step(&again, method, h, &v, &o);
    assert_memory_equal(&once.c, &again.c, sizeof once.c);
    assert_memory_equal(once.low, again.low, sizeof once.low);
}

RUN_TESTS(cmocka_unit_test(next_step_is_that_of_the_equation), cmocka_unit_test(held_cut_and_limited),
          cmocka_unit_test(scales), cmocka_unit_test(refused_controls), cmocka_unit_test(undone_to_the_bit),
          cmocka_unit_test(refused_copies), cmocka_unit_test(errors_go_with_the_tolerance),
          cmocka_unit_test(undone_steps_leave_no_trace))
