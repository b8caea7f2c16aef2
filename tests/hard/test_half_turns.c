/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Attitudes where Rodrigues vectors are at their worst: through and at half a turn, and of any size of alpha. The truth
 * is the product of unit quaternions in long double. */
#include "hard.h"

static const double axis[3] = {0.6, -0.64, 0.48}, across[3] = {0.48, 0.6, 0.64};

/** Each drift rounds its increment and its product, by 4 eps each at worst, and cuts off at half a turn. */
static double tolerance(const vti_stepper *method)
{
    return (double)(method->stages + 1) * (8 * EPS + CUT);
}

/** One step of a free body: the distance from the start turned by the closed form. */
static double step_error(const vti_stepper *method, const double alpha[3], const double omega[3], double h)
{
    static troupe t;
    troupe_free(&t, method, alpha, omega);
    /* the angular velocity is the same in both frames only about the body's own axis: turn in space in each */
    const rotor start = quat_of_alpha(t.c.alpha[0]);
    assert_int_equal(troupe_step(&t, h, NULL), VTI_OK);
    assert_true(troupe_is_finite(&t));
    const long double s = h * sqrtl((long double)omega[0] * omega[0] + (long double)omega[1] * omega[1] +
                                    (long double)omega[2] * omega[2]);
    return quat_distance(quat_of_alpha(t.c.alpha[0]), quat_times(quat_turn(omega, step_angle(method, s)), start));
}

/** theta = pi - 2 offset and pi + 2 offset, and away from there and back to it. */
TEST(through_half_a_turn)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        double worst = 0;
        for (int e = 0; e <= 1075; ++e)
            for (int side = 0; side < 8; ++side) {
                /* 2^-1075 is 0: half a turn itself, of either sign of zero */
                const double w = ldexp(side & 1 ? -1 : 1, -e), turn = side & 2 ? -0.1 : 0.1;
                const double q[4] = {axis[0], axis[1], axis[2], w}, *about = side & 4 ? across : axis;
                const double omega[3] = {turn * about[0], turn * about[1], turn * about[2]};
                const double back[3] = {-omega[0], -omega[1], -omega[2]};
                static troupe t;
                double alpha[3];
                vti_rrv_from_quat_xyzw(q, alpha);
                worst = fmax(worst, step_error(method, alpha, omega, 1));
                troupe_free(&t, method, alpha, omega);
                assert_int_equal(troupe_step(&t, 1, NULL), VTI_OK);
                worst = fmax(worst, step_error(method, t.c.alpha[0], back, 1));
            }
        assert_below(worst, tolerance(method));
        robust("spin through theta = pi, at and beside it by 1 to 5e-324 rad", method->name,
               "exact: within 8 eps per drift of the quaternion product");
    }
}

TEST(sizes_of_alpha)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        double worst = 0;
        for (int e = -320; e <= 300; ++e)
            for (int side = 0; side < 4; ++side) {
                const double size = pow(10, e), turn = side & 1 ? 0.9 : -1e-3, *about = side & 2 ? across : axis;
                const double alpha[3] = {size * axis[0], size * axis[1], size * axis[2]};
                const double omega[3] = {turn * about[0], turn * about[1], turn * about[2]};
                worst = fmax(worst, step_error(method, alpha, omega, 1));
            }
        assert_below(worst, tolerance(method));
        robust("|alpha| from 1e-320 to 1e300", method->name, "exact: within 8 eps per drift of the quaternion product");
    }
}

/* ---- effects ----------------------------------------------------------------------------------------------------- */

/** Loads of the effect on two bodies with |alpha| = 10^e, and on the same attitudes as unit quaternions. */
static void compare_loads(const vti_effect *effect, int e, int f, double scale)
{
    static crowd a, q;
    crowd_clear(&a, 2, CROWD_ALPHA);
    for (int k = 0; k < 3; ++k) {
        a.alpha[0][k] = pow(10, e) * axis[k];
        a.alpha[1][k] = pow(10, f) * across[k];
        a.x[0][k] = 0.9 * across[k];
    }
    q = a;
    q.storage = CROWD_QUAT;
    for (int i = 0; i < 2; ++i) {
        const rotor r = quat_of_alpha(a.alpha[i]);
        const double xyzw[4] = {(double)r.x, (double)r.y, (double)r.z, (double)r.w};
        memcpy(q.quat[i], xyzw, sizeof xyzw);
    }
    const vti_bodies ab = crowd_bodies(&a), qb = crowd_bodies(&q);
    vti_apply(effect, 1, &ab);
    vti_apply(effect, 1, &qb);
    for (int i = 0; i < 2; ++i) {
        assert_close3(a.moment[i], q.moment[i], scale * 32 * EPS);
        assert_close3(a.force[i], q.force[i], scale * 32 * EPS);
    }
    assert_close(vti_energy(effect, 1, &ab), vti_energy(effect, 1, &qb), scale * 32 * EPS);
}

TEST(effects_at_sizes_of_alpha)
{
    static web w;
    const vti_pendulum pendulum = {2, {0.5, -1, 0.25}};
    const struct {
        const char *name;
        int terms, form;
    } all[] = {{"binder: moment", MOMENT, 0},
               {"binder: shear, objective", SHEAR, VTI_SHEAR_OBJECTIVE},
               {"binder: shear, quartic", SHEAR, VTI_SHEAR_QUARTIC},
               {"binder: shear, as printed", SHEAR, VTI_SHEAR_PRINTED},
               {"pendulum", 0, 0}};
    w.pair[0][1] = 1;
    w.rest[0][0] = w.rest[0][3] = w.moment[0] = w.shear[0] = 1;
    for (int k = 0; k < 5; ++k) {
        web_terms(&w, 1, all[k].terms, all[k].form);
        const vti_effect effect = all[k].terms != 0 ? vti_bonds_effect(&w.bonds) : vti_pendulum_effect(&pendulum);
        for (int e = -320; e <= 300; e += 4)
            for (int f = -320; f <= 300; f += 20)
                compare_loads(&effect, e, f, 10); /* no load here is larger than K pi or K/r, K = 1, or m g |rho0| */
        robust("|alpha| from 1e-320 to 1e300", all[k].name, "exact: as from unit quaternions, within 32 eps");
    }
}

/* ---- quarter and half turns -------------------------------------------------------------------------------------- */

enum { WALK = 400 };

/** R <- the quarter turn about the axis, or its inverse, times R; exactly. */
static void quarter(int about, int sense, int R[9])
{
    const int i = (about + 1) % 3, j = (about + 2) % 3;
    for (int c = 0; c < 3; ++c) {
        const int ri = R[3 * i + c], rj = R[3 * j + c];
        R[3 * i + c] = -sense * rj;
        R[3 * j + c] = sense * ri;
    }
}

/** A walk of quarter turns (Cayley, t|w| = 2) and half turns (exact law, t|w| = 2^31) about the axes. */
static void walk(rng *g, enum crowd_storage storage, int compensated)
{
    static crowd c;
    double low[3] = {0, 0, 0}, R[9], a[3];
    int exact[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    crowd_clear(&c, 1, storage);
    vti_bodies b = crowd_bodies(&c);
    if (compensated)
        b.alpha_low = vti_view_packed(low);
    for (int n = 1; n <= WALK; ++n) {
        const int about = rng_below(g, 3), sense = rng_below(g, 2) ? 1 : -1, half = rng_below(g, 3) == 0;
        memset(c.omega[0], 0, sizeof c.omega[0]);
        c.omega[0][about] = half ? sense * 0x1p31 : sense * 2.0;
        assert_int_equal(vti_drift(half ? VTI_LAW_EXACT : VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 1, &b, NULL), VTI_OK);
        for (int k = 0; k < 1 + half; ++k)
            quarter(about, sense, exact);
        memcpy(a, c.alpha[0], sizeof a);
        if (storage == CROWD_QUAT)
            vti_rrv_from_quat_xyzw(c.quat[0], a);
        assert_true(all_finite(a, 3));
        vti_rrv_to_matrix(a, R);
        for (int k = 0; k < 9; ++k)
            assert_close(R[k], exact[k], 4 * EPS + n * (EPS + CUT));
    }
}

TEST(products_of_quarter_and_half_turns)
{
    static const char *const who[3] = {"drift of alpha", "drift of quaternions", "drift of alpha, residuals carried"};
    rng g = rng_seed(51);
    for (int k = 0; k < 3; ++k) {
        for (int trial = 0; trial < 250; ++trial)
            walk(&g, k == 1 ? CROWD_QUAT : CROWD_ALPHA, k == 2);
        robust("products of exact quarter and half turns about all axes", who[k],
               "exact: the 24 rotations of the cube, within eps per product");
    }
}

/** The residual of an alpha near half a turn is as large as 2^-53 of it, and means nothing to the alpha on the other
 *  side. */
TEST(residuals_at_half_a_turn)
{
    for (int e = 4; e < 60; ++e)
        for (int side = -1; side <= 1; side += 2) {
            static crowd c;
            double low[3] = {ldexp(0.4, e - 52), ldexp(-0.3, e - 52), 0};
            crowd_clear(&c, 1, CROWD_ALPHA);
            vti_bodies b = crowd_bodies(&c);
            b.alpha_low = vti_view_packed(low);
            c.alpha[0][0] = ldexp(side, e);
            c.omega[0][0] = 1;
            c.omega[0][1] = 0.5;
            const rotor start = quat_of_alpha(c.alpha[0]);
            assert_int_equal(vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 1, &b, NULL), VTI_OK);
            const rotor truth = quat_times(quat_turn(c.omega[0], law_angle(VTI_LAW_CAYLEY, sqrtl(1.25L))), start);
            assert_below(quat_distance(quat_of_alpha(c.alpha[0]), truth), 8 * EPS + CUT);
        }
    robust("residuals carried through half a turn", "drift of alpha, residuals carried",
           "exact: those of the old alpha go with it");
}

RUN_TESTS(cmocka_unit_test(through_half_a_turn), cmocka_unit_test(sizes_of_alpha),
          cmocka_unit_test(effects_at_sizes_of_alpha), cmocka_unit_test(products_of_quarter_and_half_turns),
          cmocka_unit_test(residuals_at_half_a_turn))
