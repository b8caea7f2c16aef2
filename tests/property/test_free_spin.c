/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A free body turns in each drift about Omega by exactly the angle of its law: asin s (closed), 2 atan(s/2) (Cayley),
 * that of the continued fractions of tan(s/2) (exact); in each step by the sum of them, and its Omega keeps every
 * bit. */
#include "rig.h"

/** tan(angle/2) = u/c for s = |t Omega| of either sign. */
static void half_tangent(int law, long double s, long double *u, long double *c)
{
    const long double z = s * s;
    *u = law == VTI_LAW_EXACT ? s * (1 - z / 60) : law == VTI_LAW_EXACT9 ? s * (1 - z / 42) : s;
    *c = law == VTI_LAW_CLOSED   ? 1 + sqrtl(1 - z)
         : law == VTI_LAW_CAYLEY ? 2
         : law == VTI_LAW_EXACT  ? 2 - z / 5
                                 : 2 - 3 * z / 14 + z * z / 840;
}

static long double angle_of_drift(int law, long double s)
{
    long double u, c;
    half_tangent(law, s, &u, &c);
    return 2 * atan2l(u, c);
}

static long double angle_of_step(const vti_stepper *method, long double s)
{
    long double sum = 0;
    for (int64_t k = 0; k <= method->stages; ++k)
        sum += angle_of_drift((int)method->law, method->drift[k] * s);
    return sum;
}

/** What the rounding of h Omega and of the law's own formula may do to the angle of a drift: 2 eps of s, which asin' =
 *  1/sqrt(1 - s^2) may enlarge, and a few eps of each of the terms of u and c. */
static double slope_of_drift(int law, double s)
{
    const double z = s * s;
    long double u, c;
    half_tangent(law, s, &u, &c);
    if (law == VTI_LAW_CLOSED)
        return fabs(s) / sqrt(1 - z);
    if (law == VTI_LAW_CAYLEY)
        return 1;
    const double du = fabs(s) * (1 + z / 42), dc = 2 + 3 * z / 14 + z * z / 840;
    return 4 * (law == VTI_LAW_EXACT ? fabs(s) * (1 + z / 60) + 2 + z / 5 : du + dc) / (double)hypotl(u, c);
}

static double slope_of_step(const vti_stepper *method, double s)
{
    double sum = 0;
    for (int64_t k = 0; k <= method->stages; ++k)
        sum += 8 + 2 * slope_of_drift((int)method->law, method->drift[k] * s);
    return sum;
}

/** A whole step without a moment. */
static void step(const vti_stepper *method, double h, const vti_bodies *b)
{
    for (int64_t k = 0; k < method->stages; ++k)
        assert_int_equal(vti_step_stage(method, k, h, b, NULL), VTI_OK);
    assert_int_equal(vti_step_finish(method, h, b), VTI_OK);
}

/** The smallest s that the closed form refuses, or none. */
static double most_turn(const vti_stepper *method)
{
    double most = 0;
    for (int64_t k = 0; k <= method->stages; ++k)
        most = fmax(most, fabs(method->drift[k]));
    return method->law == VTI_LAW_CLOSED ? 1 / most : INFINITY;
}

/** The attitude after a turn by angle about omega, in space or in the body's frame. */
static rotor turned(const vti_stepper *method, rotor q, const double omega[3], long double angle)
{
    const rotor d = quat_turn(omega, angle);
    return method->frame == VTI_FRAME_SPACE ? quat_times(d, q) : quat_times(q, d);
}

static long double length(const double v[3])
{
    return sqrtl((long double)v[0] * v[0] + (long double)v[1] * v[1] + (long double)v[2] * v[2]);
}

TEST(one_step)
{
    const double sizes[] = {1e-12, 1e-6, 1e-3, 0.1, 0.5, 0.9, 0.999, 1.5, 3, 1e3};
    rng g = rng_seed(201);
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int trial = 0; trial < 20000; ++trial) {
            const vti_stepper *method = vti_stepper_at(k);
            const double s = sizes[trial % 10], h = uniform(&g, 0.01, 2);
            if (s >= most_turn(method))
                continue;
            rig p = rig_random(&g, (enum rig_storage)(trial % 3));
            random_unit(&g, 3, p.omega);
            for (int c = 0; c < 3; ++c)
                p.omega[c] *= s / h;
            const rig start = p;
            vti_bodies b = rig_bodies(&p);
            b.moment = vti_view_none();
            step(method, h, &b);
            assert_same_bits(p.omega, start.omega, 3);
            const long double turn = h * length(start.omega);
            const rotor expected = turned(method, rig_attitude(&start), start.omega, angle_of_step(method, turn));
            /* 8 eps of each composition */
            assert_close(quat_distance(rig_attitude(&p), expected), 0, slope_of_step(method, s) * EPS);
        }
}

/** Thousands of steps, through theta = pi many times: the errors of single steps at worst add up. */
TEST(many_steps)
{
    enum { STEPS = 10000 };
    const double h = 0.125;
    rng g = rng_seed(202);
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int trial = 0; trial < 30; ++trial) {
            const vti_stepper *method = vti_stepper_at(k);
            rig p = rig_random(&g, (enum rig_storage)(trial % 3));
            if (trial < 6) {
                /* about an axis of the frame from rest: alpha goes through infinity on a straight line */
                memset(p.omega, 0, sizeof p.omega);
                memset(p.alpha, 0, sizeof p.alpha);
                memset(p.quat, 0, sizeof p.quat);
                p.quat[3] = 1;
                p.omega[trial % 3] = trial < 3 ? 4 : -1;
            }
            const rotor start = rig_attitude(&p);
            vti_bodies b = rig_bodies(&p);
            b.moment = vti_view_none();
            const long double angle = angle_of_step(method, h * length(p.omega));
            double most = 0;
            for (int i = 1; i <= STEPS; ++i) {
                step(method, h, &b);
                if (i % 100 == 0)
                    most = fmax(most, quat_distance(rig_attitude(&p), turned(method, start, p.omega, i * angle)));
            }
            assert_below(most, 4 * EPS * STEPS * (double)method->stages);
        }
}

/** Right angles in VTI-2: h|Omega| = 2 turns by pi/2 exactly, so four steps are a whole turn through alpha =
 *  infinity. */
TEST(right_angles)
{
    const vti_stepper *vti2 = vti_stepper_find("vti2");
    for (int storage = 0; storage < 3; ++storage)
        for (int axis = 0; axis < 3; ++axis) {
            rig p = rig_of_the_paper((enum rig_storage)storage);
            memset(p.omega, 0, sizeof p.omega);
            p.omega[axis] = axis == 1 ? -4 : 4;
            const rotor start = rig_attitude(&p);
            vti_bodies b = rig_bodies(&p);
            b.moment = vti_view_none();
            for (int i = 1; i <= 4000; ++i) {
                step(vti2, 0.5, &b);
                assert_true(all_finite(p.alpha, 3) && all_finite(p.quat, 4));
                const rotor expected = turned(vti2, start, p.omega, (i % 4) * PI_L / 2);
                assert_close(quat_distance(rig_attitude(&p), expected), 0, 4 * EPS * (i + 2));
            }
        }
}

/** One drift by u = t Omega, t = 1, from the random attitude of the rig. */
static rotor drifted(rig *p, int law, double size, const double axis[3], rotor *start)
{
    for (int k = 0; k < 3; ++k)
        p->omega[k] = size * axis[k];
    *start = rig_attitude(p);
    vti_bodies b = rig_bodies(p);
    b.moment = vti_view_none();
    assert_int_equal(vti_drift(law, VTI_FRAME_SPACE, 1, &b, NULL), VTI_OK);
    assert_true(all_finite(p->storage == RIG_QUAT ? p->quat : p->alpha, p->storage == RIG_QUAT ? 4 : 3));
    return rig_attitude(p);
}

/** s where c or u vanishes, the pole of the pair: s^2 = 10 and 60; s^2 = 90 -+ sqrt(90^2 - 1680) and 42; and
 *  between. */
TEST(through_the_pole)
{
    const double root = sqrt(90 * 90 - 1680);
    const double squares[] = {10, 60, 90 - root, 90 + root, 42, 9.999999, 10.000001, 1e2, 1e4, 1e8, 0x1p59};
    rng g = rng_seed(203);
    for (int law = VTI_LAW_EXACT; law <= VTI_LAW_EXACT9; ++law)
        for (int trial = 0; trial < 3300; ++trial) {
            double axis[3];
            rotor start;
            random_unit(&g, 3, axis);
            rig p = rig_random(&g, (enum rig_storage)(trial % 3));
            const double s = sqrt(squares[trial % 11]);
            const rotor end = drifted(&p, law, s, axis, &start);
            const rotor expected = quat_times(quat_turn(axis, angle_of_drift(law, length(p.omega))), start);
            assert_close(quat_distance(end, expected), 0, (8 + 2 * slope_of_drift(law, s)) * EPS);
        }
}

/** s + O(s^7) and s + O(s^9): by how much, from the next convergent of the continued fraction. */
TEST(nearly_exact)
{
    for (int law = VTI_LAW_EXACT; law <= VTI_LAW_EXACT9; ++law) {
        const int power = law == VTI_LAW_EXACT ? 7 : 9;
        const long double next = law == VTI_LAW_EXACT ? 100800 : 25401600;
        for (double s = 0.05; s < 0.6; s *= 2) {
            const long double off = s - angle_of_drift(law, s);
            /* the term after the next is about s^2/30 of it; 1e-18 rounds long double */
            assert_close(fabsl(off) * next / powl(s, power), 1, s * s / 10 + 1e-18 * (double)(next / powl(s, power)));
        }
    }
}

/** From s = 2^30 on the exact laws turn by half a turn about Omega, and every law stays finite to the largest
 *  numbers. */
TEST(beyond_all_bounds)
{
    const double sizes[] = {0x1p30, 0x1p31, 1e12, 1e77, 1e100, 1e154, 1e160, 1e250, 1e300, 1.7e308};
    rng g = rng_seed(204);
    for (int law = VTI_LAW_CAYLEY; law <= VTI_LAW_EXACT9; ++law)
        for (int trial = 0; trial < 300; ++trial) {
            double axis[3];
            rotor start;
            random_unit(&g, 3, axis);
            rig p = rig_random(&g, (enum rig_storage)(trial % 3));
            const double s = sizes[trial % 10] * (1 + 4 * EPS);
            const rotor end = drifted(&p, law, fmin(s, 1.7e308), axis, &start);
            const rotor expected = quat_times(quat_turn(axis, PI_L), start);
            assert_close(quat_distance(end, expected), 0, 16 * EPS + (law == VTI_LAW_CAYLEY ? 4 / s : 0));
        }
}

/** What is not a number is seen, and not mistaken for a half turn. */
TEST(not_a_number)
{
    rng g = rng_seed(205);
    for (int law = VTI_LAW_CAYLEY; law <= VTI_LAW_EXACT9; ++law)
        for (int trial = 0; trial < 18; ++trial) {
            rig p = rig_random(&g, (enum rig_storage)(trial % 3));
            p.omega[trial / 3 % 3] = trial < 9 ? NAN : INFINITY;
            vti_bodies b = rig_bodies(&p);
            assert_int_equal(vti_drift(law, VTI_FRAME_SPACE, 1, &b, NULL), VTI_OK);
            assert_false(all_finite(p.storage == RIG_QUAT ? p.quat : p.alpha, p.storage == RIG_QUAT ? 4 : 3));
        }
}

/** 5e6 steps at h|Omega| = 0.01: where the Cayley drift of VTI-2 is 2/3 of a radian of phase per 1e7 behind. */
TEST(steady_spin)
{
    enum { STEPS = 5000000 };
    const char *const names[] = {"exact", "vti2"};
    double off[2];
    for (int k = 0; k < 2; ++k) {
        rig p = rig_of_the_paper(RIG_ALPHA);
        const double omega[3] = {0.6, 0.48, -0.64}, h = 0.01;
        memcpy(p.omega, omega, sizeof omega);
        const rotor start = rig_attitude(&p);
        vti_bodies b = rig_bodies(&p);
        b.moment = vti_view_none();
        vti_bodies_seal(&b);
        for (int i = 0; i < STEPS; ++i) {
            vti_step_begin(vti_stepper_find(names[k]), h, &b, NULL);
            vti_step_finish(vti_stepper_find(names[k]), h, &b);
        }
        const rotor truth = quat_times(quat_turn(omega, fmodl(STEPS * (h * length(omega)), 4 * PI_L)), start);
        off[k] = quat_distance(rig_attitude(&p), truth);
    }
    print_message("5e6 steps: exact off by %.2g, vti2 by %.6g rad\n", off[0], off[1]);
    assert_below(off[0], 1e-10);
    /* 5e6 (s - 2 atan(s/2)) = 5e6 s^3/12 (1 - 3 s^2/20) */
    assert_close(off[1], 5e6 * 1e-6 / 12, 1e-4);
}

RUN_TESTS(cmocka_unit_test(one_step), cmocka_unit_test(many_steps), cmocka_unit_test(right_angles),
          cmocka_unit_test(through_the_pole), cmocka_unit_test(nearly_exact), cmocka_unit_test(beyond_all_bounds),
          cmocka_unit_test(not_a_number), cmocka_unit_test(steady_spin))
