/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bodies of three moments (EQUATIONS 7): what a drift is by theorem. Three equal moments are a sphere, to the bit; two
 * are the free symmetric top, exact but for the law; L keeps its bits; drifts go back the way they came and keep the
 * two-form; hosts of L, of Omega and of both get the same motion. */
#include "top.h"

static const int rotors[] = {2, 4, 6};

static int drifts(int law, int rotor_order, double t, const vti_bodies *b, vti_fault *fault)
{
    const vti_stepper own = drift_alone(law, rotor_order, t < 0);
    return vti_step_begin(&own, fabs(t), b, fault);
}

/** Of any size of spin and step. */
TEST(three_equal_moments_are_a_sphere)
{
    rng g = rng_seed(201);
    for (int trial = 0; trial < 20000; ++trial) {
        top p = top_random(&g, (enum top_storage)(trial % TOP_STORAGES), TOP_L), sphere;
        const int law = 1 + rng_below(&g, 4), order = rotors[rng_below(&g, 3)];
        const double size = law == VTI_LAW_CLOSED ? 0.5 : trial % 7 == 0 ? 1e180 : trial % 5 == 0 ? 50 : 1;
        p.moments[0] = p.moments[1] = p.moments[2] = uniform(&g, 0.5, 2);
        for (int k = 0; k < 3; ++k) {
            p.spin[k] = size * uniform(&g, -0.5, 0.5);
            p.alpha_low[k] = uniform(&g, -EPS, EPS) * p.alpha[k];
        }
        sphere = p;
        for (int k = 0; k < 3; ++k)
            sphere.omega[k] = 1.0 / p.moments[0] * p.spin[k];
        vti_bodies b = top_bodies(&p), s = top_bodies(&sphere);
        s.moments = s.spin = s.moment = s.spin_low = vti_view_none();
        s.principal = vti_bodies_none(1).quat;
        s.omega = vti_view_packed(sphere.omega);
        const double t = uniform(&g, -1, 1);
        assert_int_equal(drifts(law, order, t, &b, NULL), VTI_OK);
        assert_int_equal(vti_drift(law, VTI_FRAME_SPACE, t, &s, NULL), VTI_OK);
        assert_same_bits(p.alpha, sphere.alpha, 3);
        assert_same_bits(p.quat, sphere.quat, 4);
        assert_same_bits(p.alpha_low, sphere.alpha_low, 3);
    }
}

/** Whole steps of spheres of inertia 1, whose L is Omega. */
TEST(steps_of_unit_inertia_are_the_spheres)
{
    rng g = rng_seed(202);
    for (int64_t m = 0; m < vti_stepper_count(); ++m) {
        const vti_stepper *const method = vti_stepper_at(m);
        const double one = 1;
        top p = top_random(&g, TOP_RESIDUALS, TOP_BOTH), sphere;
        if (method->frame != VTI_FRAME_SPACE)
            continue;
        for (int k = 0; k < 3; ++k) {
            p.moments[k] = 1;
            p.omega[k] = p.spin[k] = 0.3 * p.spin[k];
        }
        sphere = p;
        vti_bodies b = top_bodies(&p), s = top_bodies(&sphere);
        s.moments = s.spin = s.spin_low = vti_view_none();
        s.principal = vti_bodies_none(1).quat;
        s.omega = vti_view_packed(sphere.omega);
        s.omega_low = vti_view_packed(sphere.spin_low);
        s.inertia = vti_scalars_one(&one);
        for (int n = 0; n < 3; ++n)
            for (int64_t k = 0; k < method->stages; ++k) {
                assert_int_equal(vti_step_stage(method, k, 0.3, &b, NULL), VTI_OK);
                assert_int_equal(vti_step_stage(method, k, 0.3, &s, NULL), VTI_OK);
            }
        assert_int_equal(vti_step_finish(method, 0.3, &b), VTI_OK);
        assert_int_equal(vti_step_finish(method, 0.3, &s), VTI_OK);
        assert_same_bits(p.alpha, sphere.alpha, 3);
        assert_same_bits(p.alpha_low, sphere.alpha_low, 3);
        assert_same_bits(p.spin, sphere.omega, 3);
        assert_same_bits(p.spin_low, sphere.spin_low, 3);
        assert_close3(p.omega, sphere.omega, 16 * EPS);
    }
}

/** The angle that a law makes of s. */
static long double angle_of(int law, long double s)
{
    const long double z = s * s;
    const long double u = law == VTI_LAW_EXACT ? s * (1 - z / 60) : law == VTI_LAW_EXACT9 ? s * (1 - z / 42) : s;
    const long double c = law == VTI_LAW_CLOSED   ? 1 + sqrtl(1 - z)
                          : law == VTI_LAW_CAYLEY ? 2
                          : law == VTI_LAW_EXACT  ? 2 - z / 5
                                                  : 2 - 3 * z / 14 + z * z / 840;
    return 2 * atan2l(u, c);
}

/** R' = turn(L) R_p turn(axis) P^-1, of angles that the law makes of k t |L| and, half by half, of (k_a - k) t p_a. */
TEST(symmetric_tops_are_exact)
{
    rng g = rng_seed(203);
    for (int trial = 0; trial < 6000; ++trial) {
        top p = top_random(&g, (enum top_storage)(trial % TOP_STORAGES), TOP_L);
        const int law = 1 + trial % 4, axis = rng_below(&g, 3);
        const double equal = uniform(&g, 0.5, 1), other = uniform(&g, 0.05, 2 * equal), t = uniform(&g, -0.3, 0.3);
        for (int k = 0; k < 3; ++k)
            p.moments[k] = k == axis ? other : equal;
        const double size = uniform(&g, 0, 1) * fmin(equal, other);
        random_unit(&g, 3, p.spin);
        for (int k = 0; k < 3; ++k)
            p.spin[k] *= size;
        const rotor start = top_axes(&p);
        double body[3], e[3] = {0, 0, 0}, kept[3];
        memcpy(kept, p.spin, sizeof kept);
        quat_rotate(quat_conj(start), p.spin, body);
        e[axis] = 1;
        const long double half = 0.5L * t * (1.0L / other - 1.0L / equal) * body[axis];
        const rotor about = quat_turn(e, 2 * angle_of(law, half)),
                    whole = quat_turn(p.spin, angle_of(law, t * vti_norm(p.spin) / (long double)equal));
        rotor expected = quat_times(quat_times(whole, start), about);
        if (p.turned)
            expected = quat_times(expected, quat_conj(quat_of_xyzw(p.principal)));
        const vti_bodies b = top_bodies(&p);
        assert_int_equal(drifts(law, 2, t, &b, NULL), VTI_OK);
        assert_close(quat_distance(top_attitude(&p), expected), 0, 64 * EPS);
        assert_same_bits(p.spin, kept, 3);
    }
}

/** Moments and L in other units turn the same body by the same bits: powers of 2 round nothing, though products of
 *  three moments leave the range of numbers. */
TEST(units_do_not_matter)
{
    static const int powers[] = {-1000, -500, -310, -300, -150, 150, 300, 310, 500, 1000};
    rng g = rng_seed(208);
    for (int trial = 0; trial < 600; ++trial) {
        top p = top_random(&g, (enum top_storage)(trial % TOP_STORAGES), TOP_L), q;
        const int law = 1 + trial % 4, order = rotors[trial / 4 % 3], power = powers[trial / 12 % 10];
        q = p;
        for (int k = 0; k < 3; ++k) {
            q.moments[k] = ldexp(p.moments[k], power);
            q.spin[k] = ldexp(p.spin[k], power);
        }
        const vti_bodies b = top_bodies(&p), c = top_bodies(&q);
        const double h = 0.5 * fmin(fmin(p.moments[0], p.moments[1]), p.moments[2]) / p.moments[0];
        assert_int_equal(drifts(law, order, h, &b, NULL), VTI_OK);
        assert_int_equal(drifts(law, order, h, &c, NULL), VTI_OK);
        assert_same_bits(q.alpha, p.alpha, 3);
        assert_same_bits(q.quat, p.quat, 4);
    }
}

/** There and back again, by every law and rotor, with many steps between. */
TEST(drifts_go_back)
{
    rng g = rng_seed(204);
    for (int trial = 0; trial < 600; ++trial) {
        top p = top_random(&g, (enum top_storage)(trial % TOP_STORAGES), (enum top_spin)(trial / 3 % 3));
        const top start = p;
        const int law = 1 + trial / 9 % 4, order = rotors[trial / 36 % 3], steps = 20;
        const double h = 0.5 * fmin(fmin(p.moments[0], p.moments[1]), p.moments[2]) / p.moments[0];
        const vti_bodies b = top_bodies(&p);
        for (int n = 0; n < 2 * steps; ++n)
            assert_int_equal(drifts(law, order, n < steps ? h : -h, &b, NULL), VTI_OK);
        assert_close(quat_distance(top_attitude(&p), top_attitude(&start)), 0, 200 * steps * EPS);
        if (p.shows != TOP_OMEGA)
            assert_same_bits(p.spin, start.spin, 3);
        if (p.shows != TOP_L)
            assert_close3(p.omega, start.omega, 400 * steps * EPS * 10 * vti_norm(start.omega));
    }
}

/** d(theta, L) of the drifted body by d(theta, L) of the body, by central differences. */
static void jacobian(const top *start, int law, int order, double t, double m[6][6])
{
    const double d = 1e-5;
    top ends[2];
    for (int c = 0; c < 6; ++c) {
        for (int side = 0; side < 2; ++side) {
            top p = *start;
            double u[3] = {0, 0, 0};
            if (c < 3) {
                u[c] = side ? d : -d;
                top_set_attitude(&p, quat_times(quat_turn(u, d), top_attitude(&p)));
            } else
                p.spin[c - 3] += side ? d : -d;
            const vti_bodies b = top_bodies(&p);
            assert_int_equal(drifts(law, order, t, &b, NULL), VTI_OK);
            ends[side] = p;
        }
        const rotor q = quat_times(top_attitude(&ends[1]), quat_conj(top_attitude(&ends[0])));
        const long double k = (q.w < 0 ? -2 : 2) / (2 * d);
        m[0][c] = (double)(k * q.x);
        m[1][c] = (double)(k * q.y);
        m[2][c] = (double)(k * q.z);
        for (int n = 0; n < 3; ++n)
            m[3 + n][c] = (ends[1].spin[n] - ends[0].spin[n]) / (2 * d);
    }
}

/** d theta_1 . d L_2 - d theta_2 . d L_1 - L . (d theta_1 x d theta_2), theta in space. */
static double two_form(const double L[3], const double a[6], const double b[6])
{
    double x[3];
    vti_cross(a, b, x);
    return vti_dot(a, b + 3) - vti_dot(b, a + 3) - vti_dot(L, x);
}

TEST(drifts_keep_the_two_form)
{
    rng g = rng_seed(205);
    for (int trial = 0; trial < 240; ++trial) {
        top p = top_random(&g, TOP_QUAT, TOP_L);
        double m[6][6];
        const int law = 1 + trial % 4, order = rotors[trial / 4 % 3];
        const double h = 0.5 * fmin(fmin(p.moments[0], p.moments[1]), p.moments[2]) / p.moments[0];
        jacobian(&p, law, order, h, m);
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < i; ++j) {
                double a[6], b[6], one[6] = {0}, other[6] = {0};
                one[i] = other[j] = 1;
                for (int n = 0; n < 6; ++n) {
                    a[n] = m[n][i];
                    b[n] = m[n][j];
                }
                /* central differences are off by d^2 times third derivatives, and by eps/d */
                assert_close(two_form(p.spin, a, b), two_form(p.spin, one, other), 1e-8);
            }
    }
}

/** Omega beside L is that of L and the attitude, after kicks and drifts; Omega alone goes the same way. */
TEST(hosts_of_omega)
{
    rng g = rng_seed(206);
    for (int trial = 0; trial < 300; ++trial) {
        top p = top_random(&g, (enum top_storage)(trial % 2), TOP_BOTH), q = p;
        const vti_stepper *const method = vti_stepper_at(rng_below(&g, (int)vti_stepper_count()));
        q.shows = TOP_OMEGA;
        const vti_bodies b = top_bodies(&p), c = top_bodies(&q);
        double w[3];
        if (method->frame != VTI_FRAME_SPACE)
            continue;
        for (int64_t n = 0; n < 4 * method->stages; ++n) {
            const double h = 0.1;
            assert_int_equal(vti_step_stage(method, n % method->stages, h, &b, NULL), VTI_OK);
            assert_int_equal(vti_step_stage(method, n % method->stages, h, &c, NULL), VTI_OK);
            top_omega(&p, w);
            assert_close3(p.omega, w, 64 * EPS * vti_norm(w));
        }
        assert_int_equal(vti_kick(0.1, &b), VTI_OK);
        assert_int_equal(vti_kick(0.1, &c), VTI_OK);
        top_omega(&p, w);
        assert_close3(p.omega, w, 64 * EPS * vti_norm(w));
        const double spread = 1e4 * (double)method->stages * EPS * (1 + vti_norm(w));
        assert_close(quat_distance(top_attitude(&p), top_attitude(&q)), 0, spread);
        assert_close3(q.omega, w, spread);
    }
}

/** Without an attitude L is kicked and nothing turns; without a spin nothing is done at all. */
TEST(absent_physics)
{
    rng g = rng_seed(207);
    top p = top_random(&g, TOP_ALPHA, TOP_BOTH);
    const top start = p;
    vti_bodies b = top_bodies(&p);
    b.alpha = vti_view_none();
    assert_int_equal(vti_kick(0.5, &b), VTI_OK);
    for (int k = 0; k < 3; ++k)
        assert_true(p.spin[k] == start.spin[k] + 0.5 * start.moment[k]);
    assert_same_bits(p.omega, start.omega, 3);
    p = start;
    b = top_bodies(&p);
    b.spin = b.omega = vti_view_none();
    assert_int_equal(vti_kick(0.5, &b), VTI_OK);
    assert_int_equal(drifts(VTI_LAW_CLOSED, 2, 0.5, &b, NULL), VTI_OK);
    assert_memory_equal(&p, &start, sizeof p);
    b = top_bodies(&p);
    b.alpha = b.omega = vti_view_none();
    p.spin[0] = 1e9;
    assert_int_equal(drifts(VTI_LAW_CLOSED, 2, 0.5, &b, NULL), VTI_OK);
    assert_same_bits(p.alpha, start.alpha, 3);
}

RUN_TESTS(cmocka_unit_test(three_equal_moments_are_a_sphere), cmocka_unit_test(steps_of_unit_inertia_are_the_spheres),
          cmocka_unit_test(units_do_not_matter), cmocka_unit_test(symmetric_tops_are_exact),
          cmocka_unit_test(drifts_go_back), cmocka_unit_test(drifts_keep_the_two_form),
          cmocka_unit_test(hosts_of_omega), cmocka_unit_test(absent_physics))
