/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What the tests share: a seeded generator, random states, comparisons that print all digits, and a textbook algebra of
 * unit quaternions in long double, which is the reference that the library's own algebra is held against. */
#ifndef VTI_TESTS_SUPPORT_H
#define VTI_TESTS_SUPPORT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "vti.h"

#define EPS DBL_EPSILON
#define PI 3.14159265358979323846
#define PI_L 3.14159265358979323846264338327950288L

/** A test, and the main function of a program of tests. */
#define TEST(name) static void name(void **state __attribute__((unused)))
#define RUN_TESTS(...)                                                                                                 \
    int main(void)                                                                                                     \
    {                                                                                                                  \
        const struct CMUnitTest tests[] = {__VA_ARGS__};                                                               \
        return cmocka_run_group_tests(tests, NULL, NULL);                                                              \
    }

/* ---- comparisons ------------------------------------------------------------------------------------------------- */

/** |value - expected| <= tolerance. A NaN fails, and so does an infinite tolerance, within which everything would
 *  be. */
#define assert_close(value, expected, tolerance)                                                                       \
    assert_close_at(#value, (double)(value), (double)(expected), (double)(tolerance), __FILE__, __LINE__)
#define assert_close3(value, expected, tolerance)                                                                      \
    assert_close_all(#value, value, expected, 3, (double)(tolerance), __FILE__, __LINE__)
/** value <= bound; a NaN fails. */
#define assert_below(value, bound) assert_below_at(#value, (double)(value), (double)(bound), __FILE__, __LINE__)
/** The same bits, so that 0 and -0 differ and a NaN equals itself. */
#define assert_same_bits(a, b, doubles) assert_memory_equal(a, b, (size_t)(doubles) * sizeof(double))

static inline void assert_close_at(const char *what, double value, double expected, double tolerance, const char *file,
                                   int line)
{
    if (value == expected || (fabs(value - expected) <= tolerance && isfinite(tolerance)))
        return;
    print_error("%s = %.17g, expected %.17g, off by %.3g, tolerance %.3g\n", what, value, expected, value - expected,
                tolerance);
    _fail(file, line);
}

static inline void assert_close_all(const char *what, const double *value, const double *expected, int n,
                                    double tolerance, const char *file, int line)
{
    for (int k = 0; k < n; ++k)
        assert_close_at(what, value[k], expected[k], tolerance, file, line);
}

static inline void assert_below_at(const char *what, double value, double bound, const char *file, int line)
{
    if (value <= bound)
        return;
    print_error("%s = %.17g, bound %.17g\n", what, value, bound);
    _fail(file, line);
}

static inline int all_finite(const double *a, int n)
{
    for (int k = 0; k < n; ++k)
        if (!isfinite(a[k]))
            return 0;
    return 1;
}

/* ---- random numbers: xoshiro256** seeded by splitmix64 ----------------------------------------------------------- */

typedef struct rng {
    uint64_t s[4];
} rng;

static inline rng rng_seed(uint64_t seed)
{
    rng g;
    for (int k = 0; k < 4; ++k) {
        uint64_t z = (seed += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        g.s[k] = z ^ (z >> 31);
    }
    return g;
}

static inline uint64_t rng_left(uint64_t x, int k)
{
    return (x << k) | (x >> (64 - k));
}

static inline uint64_t rng_bits(rng *g)
{
    uint64_t *s = g->s;
    const uint64_t result = rng_left(s[1] * 5, 7) * 9, t = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = rng_left(s[3], 45);
    return result;
}

static inline double uniform(rng *g, double low, double high)
{
    return low + (high - low) * ((double)(rng_bits(g) >> 11) * 0x1p-53);
}

static inline int rng_below(rng *g, int n)
{
    return (int)(rng_bits(g) % (uint64_t)n);
}

static inline void random_vector(rng *g, double scale, double v[3])
{
    for (int k = 0; k < 3; ++k)
        v[k] = uniform(g, -scale, scale);
}

/** A unit vector of n <= 4 components, uniform on the sphere. */
static inline void random_unit(rng *g, int n, double v[])
{
    double norm2;
    do {
        norm2 = 0.0;
        for (int k = 0; k < n; ++k) {
            v[k] = uniform(g, -1.0, 1.0);
            norm2 += v[k] * v[k];
        }
    } while (norm2 > 1.0 || norm2 < 1e-4);
    for (int k = 0; k < n; ++k)
        v[k] /= sqrt(norm2);
}

/** alpha of an attitude that is uniform on SO(3). */
static inline void random_alpha(rng *g, double a[3])
{
    double q[4];
    do
        random_unit(g, 4, q);
    while (fabs(q[3]) < 1e-12);
    for (int k = 0; k < 3; ++k)
        a[k] = 2.0 * q[k] / q[3];
}

/** A finite number of random bits: its exponent is uniform over the whole range, zero and subnormals included. */
static inline double random_finite(rng *g)
{
    for (;;) {
        const uint64_t bits = rng_bits(g);
        double x;
        memcpy(&x, &bits, sizeof x);
        if (isfinite(x))
            return x;
    }
}

/* ---- reference algebra: unit quaternions (x, y, z, w) in long double --------------------------------------------- */

typedef struct rotor {
    long double x, y, z, w;
} rotor;

/** The product p q: first q, then p. */
static inline rotor quat_times(rotor p, rotor q)
{
    const rotor r = {p.w * q.x + q.w * p.x + p.y * q.z - p.z * q.y, p.w * q.y + q.w * p.y + p.z * q.x - p.x * q.z,
                     p.w * q.z + q.w * p.z + p.x * q.y - p.y * q.x, p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z};
    return r;
}

static inline rotor quat_unit(rotor q)
{
    const long double n = sqrtl(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    const rotor r = {q.x / n, q.y / n, q.z / n, q.w / n};
    return r;
}

static inline rotor quat_conj(rotor q)
{
    const rotor r = {-q.x, -q.y, -q.z, q.w};
    return r;
}

/** The rotation by the angle about the axis, which need not be a unit vector. */
static inline rotor quat_turn(const double axis[3], long double angle)
{
    const long double x = axis[0], y = axis[1], z = axis[2], n = sqrtl(x * x + y * y + z * z);
    const long double s = n > 0 ? sinl(angle / 2) / n : 0;
    const rotor q = {s * x, s * y, s * z, cosl(angle / 2)};
    return q;
}

static inline rotor quat_of_xyzw(const double q[4])
{
    const rotor r = {q[0], q[1], q[2], q[3]};
    return quat_unit(r);
}

/** alpha = 2 v/w, read backwards. */
static inline rotor quat_of_alpha(const double a[3])
{
    const rotor q = {a[0], a[1], a[2], 2.0L};
    return quat_unit(q);
}

/** An attitude as bodies hold it: the quaternion x, y, z, w of length 1 and alpha = 2 v/w. */
static inline void quat_store(rotor q, double xyzw[4], double alpha[3])
{
    q = quat_unit(q);
    const double r[4] = {(double)q.x, (double)q.y, (double)q.z, (double)q.w};
    for (int k = 0; k < 4; ++k)
        xyzw[k] = r[k];
    for (int k = 0; k < 3; ++k)
        alpha[k] = 2 * r[k] / r[3];
}

/** The angle in [0, pi] by which p and q differ. */
static inline double quat_distance(rotor p, rotor q)
{
    const rotor d = quat_times(p, quat_conj(q));
    return (double)(2 * atan2l(sqrtl(d.x * d.x + d.y * d.y + d.z * d.z), fabsl(d.w)));
}

static inline void quat_rotate(rotor q, const double p[3], double r[3])
{
    const rotor v = {p[0], p[1], p[2], 0}, t = quat_times(quat_times(q, v), quat_conj(q));
    r[0] = (double)t.x;
    r[1] = (double)t.y;
    r[2] = (double)t.z;
}

#endif
