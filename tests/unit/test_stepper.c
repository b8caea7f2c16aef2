/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Steppers as data: how they are found, that their coefficients are consistent, and that a step is what its list of kicks
 * and drifts says, for a list of the caller's own as well. */
#include "support.h"

static void found_by_name_and_index(void **state)
{
    (void)state;
    const char *const names[] = {"vti1", "vti2", "vti3", "vti3-leapfrog", "vti1-body"};
    assert_true(vti_stepper_count() >= 5);
    for (int k = 0; k < 5; ++k) {
        const vti_stepper *s = vti_stepper_find(names[k]);
        assert_non_null(s);
        assert_string_equal(s->name, names[k]);
    }
    /* the packed door promises these three indices */
    for (int64_t k = 0; k < 3; ++k)
        assert_ptr_equal(vti_stepper_at(k), vti_stepper_find(names[k]));
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        assert_ptr_equal(vti_stepper_find(vti_stepper_at(k)->name), vti_stepper_at(k));
}

static void unknown(void **state)
{
    (void)state;
    const char *const names[] = {"", "vti", "vti4", "VTI1", "vti1 ", "vti3-leap"};
    for (int k = 0; k < 6; ++k)
        assert_null(vti_stepper_find(names[k]));
    assert_null(vti_stepper_find(NULL));
    assert_null(vti_stepper_at(-1));
    assert_null(vti_stepper_at(vti_stepper_count()));
    assert_null(vti_stepper_at(INT64_MAX));
    assert_null(vti_stepper_at(INT64_MIN));
}

/** Kicks and drifts each add up to a step, and a reversible method reads the same from both ends. */
static void coefficients(void **state)
{
    (void)state;
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *s = vti_stepper_at(k);
        double kicks = 0, drifts = 0;
        for (int64_t i = 0; i <= s->stages; ++i)
            kicks += s->kick[i];
        for (int64_t i = 0; i < s->stages; ++i)
            drifts += s->drift[i];
        assert_true(s->stages >= 1 && s->order >= 1 && strlen(s->about) > 0);
        assert_true(s->law == VTI_LAW_CLOSED || s->law == VTI_LAW_CAYLEY);
        assert_true(s->frame == (strcmp(s->name, "vti1-body") == 0 ? VTI_FRAME_BODY : VTI_FRAME_SPACE));
        /* a sum of a dozen numbers of order 1 */
        assert_close(kicks, 1, 16 * EPS);
        assert_close(drifts, 1, 16 * EPS);
        if (!s->reversible)
            continue;
        for (int64_t i = 0; i <= s->stages; ++i) {
            /* as read at whole steps: the lag is taken from the first kick and given to the last */
            const int64_t j = s->stages - i;
            const double first = s->kick[i] - (i == 0 ? s->lag : 0) + (j == 0 ? s->lag : 0);
            const double last = s->kick[j] - (j == 0 ? s->lag : 0) + (i == 0 ? s->lag : 0);
            assert_close(first, last, 0);
        }
        for (int64_t i = 0; i < s->stages; ++i)
            assert_close(s->drift[i], s->drift[s->stages - 1 - i], 0);
    }
    assert_int_equal(vti_stepper_find("vti3")->reversible, 0);
    assert_close(vti_stepper_find("vti3-leapfrog")->lag, 0.5, 0);
    assert_close(vti_stepper_find("vti3")->lag, 0, 0);
}

typedef struct body {
    double v[3], w[3], x[3], a[3], force[3], moment[3];
} body;

static vti_bodies bodies_of(body *p, const double *mass, const double *inertia)
{
    vti_bodies b = vti_bodies_none(1);
    b.v = vti_view_packed(p->v);
    b.omega = vti_view_packed(p->w);
    b.x = vti_view_packed(p->x);
    b.alpha = vti_view_packed(p->a);
    b.force = vti_view_packed(p->force);
    b.moment = vti_view_packed(p->moment);
    b.mass = vti_scalars_one(mass);
    b.inertia = vti_scalars_one(inertia);
    return b;
}

/** The stages of a list, written out: the velocities after kicks of constant force, the positions after the drifts. */
static void step_plays_its_list(void **state)
{
    (void)state;
    const double kick[] = {0.2, -0.7, 1.1, 0.4}, drift[] = {0.5, -0.25, 0.75}, mass = 2, inertia = 0.5, h = 0.25;
    const vti_stepper own = {"own", VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 1, 0, 3, 0.25, kick, drift, "for this test"};
    const body start = {{1, 2, 3}, {0, 0, 0.5}, {4, 5, 6}, {0, 0, 0}, {8, -8, 4}, {0, 0, 2}};
    body p = start;
    const vti_bodies b = bodies_of(&p, &mass, &inertia);
    double v[3], x[3], w = 0.5, turned = 0;
    memcpy(v, start.v, sizeof v);
    memcpy(x, start.x, sizeof x);
    for (int64_t s = 0; s < 3; ++s) {
        vti_fault fault = {0, 0};
        assert_int_equal(s == 0 ? vti_step_begin(&own, h, &b, &fault) : vti_step_stage(&own, s, h, &b, &fault), VTI_OK);
        for (int k = 0; k < 3; ++k) {
            v[k] += kick[s] * h * start.force[k] / mass;
            x[k] += drift[s] * h * v[k];
        }
        w += kick[s] * h * 2 / inertia;
        turned += 2 * atan(0.5 * drift[s] * h * w); /* about e3 all the while */
        assert_close3(p.v, v, 16 * EPS * 8);
        assert_close3(p.x, x, 16 * EPS * 8);
        assert_close(p.w[2], w, 16 * EPS);
        assert_close(p.a[2], 2 * tan(0.5 * turned), 16 * EPS);
    }
    assert_int_equal(vti_step_finish(&own, h, &b), VTI_OK);
    for (int k = 0; k < 3; ++k)
        v[k] += kick[3] * h * start.force[k] / mass;
    assert_close3(p.v, v, 16 * EPS * 8);

    p = start;
    assert_int_equal(vti_step_start(&own, h, &b), VTI_OK);
    for (int k = 0; k < 3; ++k)
        assert_close(p.v[k], start.v[k] - 0.25 * h * start.force[k] / mass, 8 * EPS);
    assert_close(p.w[2], 0.5 - 0.25 * h * 2 / inertia, EPS);
    assert_int_equal(vti_step_sync(&own, h, &b), VTI_OK);
    assert_close3(p.v, start.v, 8 * EPS);
    assert_same_bits(p.x, start.x, 6);
}

/** Steppers without lag are neither started nor read out: not a bit changes, whatever the force. */
static void no_lag_no_change(void **state)
{
    (void)state;
    const double one = 1;
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        if (vti_stepper_at(k)->lag != 0)
            continue;
        const body start = {{-0.0, 2, 3}, {-0.0, 1, 0.5}, {4, 5, 6}, {0, 0, 0}, {8, -8, NAN}, {0, INFINITY, 2}};
        body p = start;
        const vti_bodies b = bodies_of(&p, &one, &one);
        assert_int_equal(vti_step_start(vti_stepper_at(k), 0.1, &b), VTI_OK);
        assert_int_equal(vti_step_sync(vti_stepper_at(k), 0.1, &b), VTI_OK);
        assert_memory_equal(&p, &start, sizeof p);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(found_by_name_and_index), cmocka_unit_test(unknown),          cmocka_unit_test(coefficients),
        cmocka_unit_test(step_plays_its_list),     cmocka_unit_test(no_lag_no_change),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
