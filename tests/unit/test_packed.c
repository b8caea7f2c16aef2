/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Packed arrays: the bits of the views, one mass or n of them, absent arrays, and its refusals. */
#include "support.h"

enum { N = 300, QUANTITIES = 6, DOUBLES = QUANTITIES * 3 * N };

static double ours[QUANTITIES][3 * N], theirs[QUANTITIES][3 * N], mass[N], inertia[N];

static int sound(void **state)
{
    (void)state;
    rng g = rng_seed(31);
    for (int q = 0; q < QUANTITIES; ++q)
        random_vector(&g, 1, ours[q]);
    for (int q = 0; q < QUANTITIES; ++q)
        for (int i = 0; i < 3 * N; ++i)
            ours[q][i] = uniform(&g, -1, 1);
    for (int i = 0; i < N; ++i) {
        mass[i] = uniform(&g, 1, 2);
        inertia[i] = uniform(&g, 1, 2);
    }
    memcpy(theirs, ours, sizeof ours);
    return 0;
}

static double *present(double (*arrays)[3 * N], int which, int q)
{
    return which >> q & 1 ? arrays[q] : NULL;
}

static int of_one_stage(int64_t s)
{
    return vti_stepper_at(s)->stages == 1;
}

static void same_bits_as_views(void **state)
{
    const double h = 0.25;
    for (int which = 0; which < 64; ++which)
        for (int64_t s = 0; s < vti_stepper_count(); ++s)
            for (int arrays = 0; arrays < 4 && of_one_stage(s); ++arrays) {
                sound(state);
                const int64_t masses = arrays & 1 ? N : 1, inertias = arrays & 2 ? N : 1;
                vti_bodies b = vti_bodies_none(N);
                vti_view *const views[] = {&b.x, &b.v, &b.force, &b.alpha, &b.omega, &b.moment};
                for (int q = 0; q < QUANTITIES; ++q)
                    if (which >> q & 1)
                        *views[q] = vti_view_packed(theirs[q]);
                b.mass = masses == 1 ? vti_scalars_one(mass) : vti_scalars_array(mass);
                b.inertia = inertias == 1 ? vti_scalars_one(inertia) : vti_scalars_array(inertia);
                int64_t body = 5;
                double value = 5;
                double *p[QUANTITIES];
                for (int q = 0; q < QUANTITIES; ++q)
                    p[q] = present(ours, which, q);
                assert_int_equal(vti_packed_begin(s, h, N, p[0], p[1], p[2], p[3], p[4], p[5], masses, mass, inertias,
                                                  inertia, &body, &value),
                                 VTI_OK);
                assert_int_equal(body, -1);
                assert_int_equal(vti_packed_finish(s, h, N, p[1], p[2], p[4], p[5], masses, mass, inertias, inertia),
                                 VTI_OK);
                assert_int_equal(vti_step_begin(vti_stepper_at(s), h, &b, NULL), VTI_OK);
                assert_int_equal(vti_step_finish(vti_stepper_at(s), h, &b), VTI_OK);
                assert_same_bits(ours, theirs, DOUBLES);
            }
}

static int begin(int64_t stepper, double h, int64_t n, int64_t masses, int64_t inertias, int64_t *body, double *value)
{
    return vti_packed_begin(stepper, h, n, ours[0], ours[1], ours[2], ours[3], ours[4], ours[5], masses, mass, inertias,
                            inertia, body, value);
}

static int finish(int64_t stepper, double h, int64_t n, int64_t masses, int64_t inertias)
{
    return vti_packed_finish(stepper, h, n, ours[1], ours[2], ours[4], ours[5], masses, mass, inertias, inertia);
}

TEST(refusals)
{
    int64_t body = 5;
    double value = 5;
    const int64_t wrong[] = {-1, vti_stepper_count(), INT64_MAX, INT64_MIN};
    for (int k = 0; k < 4; ++k) {
        assert_int_equal(begin(wrong[k], 0.1, N, N, N, &body, &value), VTI_E_STEPPER);
        assert_true(body == -1 && value == 0.1);
        body = 5, value = 5;
        assert_int_equal(begin(wrong[k], 0.1, N, N, N, NULL, NULL), VTI_E_STEPPER);
        assert_int_equal(finish(wrong[k], 0.1, N, N, N), VTI_E_STEPPER);
    }
    const int64_t counts[] = {0, 2, N - 1, N + 1, -1};
    for (int k = 0; k < 5; ++k) {
        assert_int_equal(begin(0, 0.1, N, counts[k], N, NULL, NULL), VTI_E_COUNT);
        assert_int_equal(begin(0, 0.1, N, N, counts[k], NULL, NULL), VTI_E_COUNT);
        assert_int_equal(finish(0, 0.1, N, counts[k], N), VTI_E_COUNT);
        assert_int_equal(finish(0, 0.1, N, N, counts[k]), VTI_E_COUNT);
    }
    assert_int_equal(begin(0, 0.1, -1, 1, 1, NULL, NULL), VTI_E_COUNT);
    static const int64_t sizes[][3] = {{N, 2, N}, {N, N, 2}, {-1, 1, 1}, {-1, -1, -1}};
    for (int k = 0; k < 4; ++k) {
        body = 5, value = 5;
        assert_int_equal(begin(0, 0.1, sizes[k][0], sizes[k][1], sizes[k][2], &body, &value), VTI_E_COUNT);
        assert_true(body == -1 && value == 0.1);
    }
    assert_int_equal(begin(0, NAN, N, N, N, &body, &value), VTI_E_TIME);
    assert_int_equal(body, -1);
    assert_int_equal(finish(0, -1, N, N, N), VTI_E_TIME);
    assert_int_equal(
        vti_packed_begin(0, 0.1, N, NULL, ours[1], ours[2], NULL, NULL, NULL, 1, NULL, 1, NULL, NULL, NULL),
        VTI_E_MASS);
    assert_int_equal(vti_packed_finish(0, 0.1, N, NULL, NULL, ours[4], ours[5], 1, NULL, 1, NULL), VTI_E_INERTIA);
    assert_int_equal(
        vti_packed_begin(0, 0.1, N, ours[0], ours[0], NULL, NULL, NULL, NULL, 1, mass, 1, mass, NULL, NULL),
        VTI_E_ALIAS);
    assert_same_bits(ours, theirs, DOUBLES);

    ours[5][3 * 77] = ours[5][3 * 77 + 1] = ours[5][3 * 77 + 2] = 0;
    ours[4][3 * 77] = 3;
    ours[4][3 * 77 + 1] = 4;
    ours[4][3 * 77 + 2] = 0;
    memcpy(theirs, ours, sizeof ours);
    assert_int_equal(begin(0, 0.5, N, N, N, &body, &value), VTI_E_TOO_LARGE);
    assert_int_equal(body, 77);
    assert_close(value, 2.5, 0);
    assert_same_bits(ours, theirs, DOUBLES);
}

/** inertias = 3n: three moments of each body, and omega is L. */
TEST(three_moments_of_each)
{
    static double moments[3 * N];
    rng g = rng_seed(32);
    for (int i = 0; i < 3 * N; ++i)
        moments[i] = uniform(&g, 1, 2);
    for (int64_t s = 0; s < vti_stepper_count(); ++s) {
        const vti_stepper *const method = vti_stepper_at(s);
        if (!of_one_stage(s))
            continue;
        vti_bodies b = vti_bodies_none(N);
        b.x = vti_view_packed(theirs[0]);
        b.v = vti_view_packed(theirs[1]);
        b.force = vti_view_packed(theirs[2]);
        b.alpha = vti_view_packed(theirs[3]);
        b.spin = vti_view_packed(theirs[4]);
        b.moment = vti_view_packed(theirs[5]);
        b.mass = vti_scalars_array(mass);
        b.moments = vti_view_packed(moments);
        const int status = vti_step_begin(method, 0.25, &b, NULL);
        assert_int_equal(status, method->frame == VTI_FRAME_BODY ? VTI_E_FRAME : VTI_OK);
        assert_int_equal(vti_packed_begin(s, 0.25, N, ours[0], ours[1], ours[2], ours[3], ours[4], ours[5], N, mass,
                                          3 * N, moments, NULL, NULL),
                         status);
        assert_same_bits(ours, theirs, DOUBLES);
        if (status != VTI_OK)
            continue;
        assert_int_equal(vti_step_finish(method, 0.25, &b), VTI_OK);
        assert_int_equal(vti_packed_finish(s, 0.25, N, ours[1], ours[2], ours[4], ours[5], N, mass, 3 * N, moments),
                         VTI_OK);
        assert_same_bits(ours, theirs, DOUBLES);
    }
    assert_int_equal(
        vti_packed_begin(1, 0.1, N, NULL, NULL, NULL, ours[3], ours[4], NULL, 1, NULL, 3 * N, NULL, NULL, NULL),
        VTI_E_MOMENTS);
    assert_int_equal(vti_packed_finish(1, 0.1, N, NULL, NULL, ours[4], ours[5], 1, NULL, 3 * N + 1, moments),
                     VTI_E_COUNT);
    assert_same_bits(ours, theirs, DOUBLES);
}

/** begin and finish are all that there is: a stepper that needs more is refused by both. */
TEST(several_stages)
{
    int passed = 0;
    for (int64_t s = 0; s < vti_stepper_count(); ++s) {
        if (of_one_stage(s)) {
            ++passed;
            assert_true(vti_stepper_at(s)->drift[1] == 0 && vti_stepper_at(s)->probe == NULL);
            continue;
        }
        assert_int_equal(begin(s, 0.1, N, N, N, NULL, NULL), VTI_E_STEPPER);
        assert_int_equal(finish(s, 0.1, N, N, N), VTI_E_STEPPER);
    }
    assert_int_equal(passed, 6); /* the paper's and exact */
    assert_same_bits(ours, theirs, DOUBLES);
}

TEST(no_bodies)
{
    assert_int_equal(begin(0, 0.1, 0, 0, 1, NULL, NULL), VTI_OK);
    assert_int_equal(finish(0, 0.1, 0, 1, 0), VTI_OK);
    assert_int_equal(vti_packed_begin(1, 0.1, 0, NULL, NULL, NULL, NULL, NULL, NULL, 0, NULL, 0, NULL, NULL, NULL), 0);
    for (int64_t s = 0; s < vti_stepper_count(); ++s) /* 0 = 3n, but there are no bodies of three moments */
        if (of_one_stage(s))
            assert_int_equal(begin(s, 0.1, 0, 0, 0, NULL, NULL), VTI_OK);
    assert_same_bits(ours, theirs, DOUBLES);
}

RUN_TESTS(cmocka_unit_test(same_bits_as_views), cmocka_unit_test_setup(refusals, sound),
          cmocka_unit_test_setup(three_moments_of_each, sound), cmocka_unit_test_setup(several_stages, sound),
          cmocka_unit_test_setup(no_bodies, sound))
