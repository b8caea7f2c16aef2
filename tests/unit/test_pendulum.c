/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The pendulum against its closed form, U = -m g e3 . R rho0 and RM = m g (R rho0) x e3 (E1, E2), whichever way the
 * attitude is stored; and effects as data: what vti_apply clears, adds and leaves alone. */
#include "bodies.h"
#include "support.h"

enum { N = 500 };

static double alpha[3 * N], quaternion[4 * N], force[3 * N], moment[3 * N];
static rotor exact[N];
static const vti_pendulum pendulum = {2.5, {0.3, -0.4, 1.2}}; /* |rho0| = 1.3 */
static vti_effect effect;
static vti_bodies b;

static int hang(void **state)
{
    (void)state;
    rng g = rng_seed(51);
    effect = vti_pendulum_effect(&pendulum);
    b = vti_bodies_none(N);
    b.alpha = vti_view_packed(alpha);
    b.force = vti_view_packed(force);
    b.moment = vti_view_packed(moment);
    for (int i = 0; i < N; ++i) {
        random_alpha(&g, alpha + 3 * i);
        if (i % 50 == 0)
            alpha[3 * i + i % 3] = i % 100 == 0 ? 1e300 : VTI_RRV_LARGE; /* half turns too */
        exact[i] = quat_of_alpha(alpha + 3 * i);
        const double q[4] = {(double)exact[i].x, (double)exact[i].y, (double)exact[i].z, (double)exact[i].w};
        memcpy(quaternion + 4 * i, q, sizeof q);
    }
    for (int i = 0; i < 3 * N; ++i)
        force[i] = moment[i] = i;
    return 0;
}

static void as_quaternions(void)
{
    b.alpha = vti_view_none();
    b.quat = quats_packed(quaternion);
}

/* 8 eps of rotation, as in test_rrv_table.c, and a unit quaternion rounded to 4 eps more */
#define ARM (12 * EPS * 1.3)

TEST(arm_moment_and_energy)
{
    for (int stored = 0; stored < 2; ++stored) {
        hang(NULL);
        if (stored)
            as_quaternions();
        assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
        double sum = 0;
        for (int i = 0; i < N; ++i) {
            double arm[3], expected[3];
            vti_pendulum_arm(&pendulum, &b, i, arm);
            quat_rotate(exact[i], pendulum.rho0, expected);
            assert_close3(arm, expected, ARM);
            const double turning[3] = {2.5 * expected[1], -2.5 * expected[0], 0};
            assert_close3(moment + 3 * i, turning, 2.5 * (ARM + EPS));
            const vti_bodies one = vti_bodies_slice(b, i, 1);
            assert_close(vti_energy(&effect, 1, &one), -2.5 * expected[2], 2.5 * (ARM + EPS));
            sum -= 2.5 * expected[2];
        }
        assert_close(vti_energy(&effect, 1, &b), sum, N * 2.5 * (ARM + EPS));
        for (int i = 0; i < 3 * N; ++i)
            assert_true(force[i] == 0);
    }
}

/** The paper's state: 135 degrees about e2, E0 = 0.04 + 1/sqrt 2. */
TEST(of_the_paper)
{
    const vti_pendulum paper = {1, {0, 0, 1}};
    const vti_effect gravity = vti_pendulum_effect(&paper);
    const double theta[3] = {0, 0.75 * PI, 0}, one = 1, turning[3] = {0, -sqrt(0.5), 0};
    double a[3], m[3], w[3] = {0.2, 0, 0.2};
    vti_rrv_from_rotvec(theta, a);
    b = vti_bodies_none(1);
    b.alpha = vti_view_packed(a);
    b.omega = vti_view_packed(w);
    b.moment = vti_view_packed(m);
    b.inertia = vti_scalars_one(&one);
    assert_int_equal(vti_apply(&gravity, 1, &b), VTI_OK);
    assert_close3(m, turning, 4 * EPS);
    assert_close(vti_energy(&gravity, 1, &b), 0.04 + sqrt(0.5), 4 * EPS);
}

TEST(what_it_says_of_itself)
{
    assert_string_equal(effect.name, "pendulum");
    assert_int_equal(effect.terms, 1);
    assert_string_equal(effect.term[0], "pendulum");
    assert_ptr_equal(effect.self, &pendulum);
    /* the pivot takes linear momentum (bits 0-2); gravity along e3 turns about e1 and e2 only, so that the components
     * along e3 of the angular momentum (bit 5) and of the sum of J Omega (bit 8) are kept */
    assert_int_equal(effect.breaks, 0x7 | 1 << 3 | 1 << 4 | 1 << 6 | 1 << 7);
}

/** Twice in the list is twice the moment; an empty list clears; outside the slice nothing is written. */
TEST(lists_and_slices)
{
    double once[3 * N];
    const vti_effect twice[] = {effect, effect};
    vti_apply(&effect, 1, &b);
    memcpy(once, moment, sizeof once);
    vti_apply(twice, 2, &b);
    for (int i = 0; i < 3 * N; ++i)
        assert_true(moment[i] == 2 * once[i]);
    assert_close(vti_energy(twice, 2, &b), 2 * vti_energy(&effect, 1, &b), 4 * EPS * N);
    hang(NULL);
    const vti_bodies part = vti_bodies_slice(b, 100, 50);
    assert_int_equal(vti_apply(&effect, 1, &part), VTI_OK);
    for (int i = 0; i < 3 * N; ++i) {
        const int inside = i >= 300 && i < 450;
        assert_true(moment[i] == (inside ? once[i] : i) && force[i] == (inside ? 0 : i));
    }
    assert_int_equal(vti_apply(NULL, 0, &b), VTI_OK);
    for (int i = 0; i < 3 * N; ++i)
        assert_true(moment[i] == 0 && force[i] == 0);
}

TEST(absent_views)
{
    vti_bodies none = b;
    none.alpha = vti_view_none();
    assert_int_equal(vti_apply(&effect, 1, &none), VTI_E_NEEDS);
    assert_true(isnan(vti_energy(&effect, 1, &none)));
    none = b;
    none.moment = vti_view_none();
    none.force = vti_view_none();
    assert_int_equal(vti_apply(&effect, 1, &none), VTI_OK);
    for (int i = 0; i < 3 * N; ++i)
        assert_true(moment[i] == i && force[i] == i);
}

/** The arm of a body that there is not, or that has no attitude, is no number. */
TEST(no_arm)
{
    vti_bodies still = b;
    still.alpha = vti_view_none();
    const struct {
        const vti_bodies *bodies;
        int64_t i;
    } wrong[] = {{&b, -1}, {&b, N}, {&still, 0}, {NULL, 0}};
    for (int k = 0; k < 4; ++k) {
        double arm[3] = {1, 2, 3};
        vti_pendulum_arm(&pendulum, wrong[k].bodies, wrong[k].i, arm);
        assert_true(isnan(arm[0]) && isnan(arm[1]) && isnan(arm[2]));
    }
    vti_pendulum_arm(&pendulum, &b, 0, NULL); /* nowhere to write to */
}

RUN_TESTS(cmocka_unit_test_setup(arm_moment_and_energy, hang), cmocka_unit_test_setup(of_the_paper, hang),
          cmocka_unit_test_setup(what_it_says_of_itself, hang), cmocka_unit_test_setup(lists_and_slices, hang),
          cmocka_unit_test_setup(absent_views, hang), cmocka_unit_test_setup(no_arm, hang))
