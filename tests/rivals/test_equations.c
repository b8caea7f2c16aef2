/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The equations that rivals solve: Campello's implicit one, and the rates of the Runge-Kutta methods. */
#include "journey.h"

#include "rates.h"

/* ---- Campello ---------------------------------------------------------------------------------------------------- */

/** a+ - a = h rate, to the tolerance. */
static void assert_advance(const vti_view *before, const vti_view *after, double h, const double *rate, int64_t n,
                           double tolerance)
{
    for (int64_t i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k)
            assert_close(after->c[k][i * after->stride] - before->c[k][i * before->stride], h * rate[3 * i + k],
                         tolerance);
}

/** (1/2) (F + F+)/m */
static void mean_acceleration(const double *before, const vti_view *after, double mass, int64_t n, double *a)
{
    for (int64_t i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k)
            a[3 * i + k] = 0.5 * (before[3 * i + k] + after->c[k][i * after->stride]) / mass;
}

static void copy_view(const vti_view *from, int64_t n, double *to)
{
    for (int64_t i = 0; i < n && from->c[0] != NULL; ++i)
        for (int k = 0; k < 3; ++k)
            to[3 * i + k] = from->c[k][i * from->stride];
}

/** Campello's step solves the equations that the paper prints, with phi = 1/2. */
static void implicit_step(int turns)
{
    enum { BODIES = 16 };
    const double h = 1.0 / 128;
    double x[3 * BODIES], v[3 * BODIES], f[3 * BODIES], w[3 * BODIES], m[3 * BODIES], a[3 * BODIES] = {0.0};
    struct scene scene;
    struct journey j;
    read_scene("chain", &scene);
    if (!turns) {
        *number_setting(&scene, "binder.moment") = *number_setting(&scene, "binder.shear.stiffness") = 0.0;
        scene.random.omega = 0.0;
        scene.turns = 0;
    }
    begin(&j, &scene, method_of("campello"), h);
    go(&j, 10);
    const vti_bodies b = travel_bodies(&j.travel);
    assert_true(b.count <= BODIES);
    const vti_view x0 = vti_view_packed(x), v0 = vti_view_packed(v), w0 = vti_view_packed(w);
    copy_view(&b.x, b.count, x);
    copy_view(&b.v, b.count, v);
    copy_view(&b.force, b.count, f);
    copy_view(&b.omega, b.count, w);
    copy_view(&b.moment, b.count, m);
    go(&j, 1);
    mean_acceleration(f, &b.force, 1.0, b.count, a);
    assert_advance(&v0, &b.v, h, a, b.count, 1e-10);
    copy_view(&b.v, b.count, a);
    assert_advance(&x0, &b.x, h, a, b.count, 32.0 * EPS);
    if (turns) {
        mean_acceleration(m, &b.moment, 0.1, b.count, a);
        assert_advance(&w0, &b.omega, h, a, b.count, 1e-10);
    }
    end(&j);
}

TEST(campello)
{
    implicit_step(1);
    implicit_step(0);
}

/* ---- rates ------------------------------------------------------------------------------------------------------- */

/** Where no effect gives a force or a moment, velocities have rates too: 0, whatever stood in memory. */
TEST(rates_without_loads)
{
    static const char *const where[] = {"pile", "spin"};
    for (int k = 0; k < 2; ++k) {
        struct scene scene;
        struct model model;
        struct message message;
        read_scene(where[k], &scene);
        memset(scene.has, 0, sizeof scene.has);
        make_model(&scene, &model);
        struct course *course = course_create(&rival_rk4, &model, 0.1, &message);
        assert_non_null(course);
        const int64_t n = rates_width(course);
        double *y = calloc((size_t)(2 * n), sizeof *y), *rate = y + n;
        assert_non_null(y);
        rates_start(course, y);
        for (int64_t i = 0; i < n; ++i)
            rate[i] = NAN;
        assert_int_equal(rates(course, y, rate), VTI_OK);
        for (int64_t i = 0; i < n; ++i)
            assert_true(isfinite(rate[i]));
        for (int64_t i = n - 3; i < n; ++i) /* the last body's v or Omega */
            assert_close(rate[i], 0.0, 0.0);
        free(y);
        course_destroy(course);
        model_destroy(&model);
    }
}

RUN_TESTS_OF_SCENES(cmocka_unit_test(campello), cmocka_unit_test(rates_without_loads))
