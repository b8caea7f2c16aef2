/* SPDX-License-Identifier: BSD-3-Clause
 * Mistakes in moving bodies of three moments, each named, and nothing else said. */
#include "support.h"

#include "vti_check.h"

enum fault {
    RIGHT,
    OMEGA_FOR_L,
    L_OF_BODY,
    OMEGA_OF_BODY,
    MULTIPLIED,
    INVERSE,
    WRONG_ORDER,
    OTHER_ORDER,
    BODY_SIDE,
    SPHERE,
    TOO_FAST,
    REFUSES,
    MOMENT_TO_BODY,
    MOMENT_OF_BODY,
    DIVIDED,
    LATE,
    EARLY,
    TWICE,
    NO_MOMENT,
    ASKEW,
    REFUSES_MOMENTS,
    START_AXES,
    OLD_MOMENT,
    NEVER_CONVERGES,
    NO_GYROSCOPE,
    WRONG_GYROSCOPE,
    EXPLICIT,
    FAULTS
};

static const char *const sentence[FAULTS] = {
    [OMEGA_FOR_L] = "the angular momentum is taken for an angular velocity: Omega for L",
    [L_OF_BODY] = "the angular momentum is taken along the body's axes, and is spatial",
    [OMEGA_OF_BODY] = "the angular velocity along the body's axes is taken for a spatial one",
    [MULTIPLIED] = "the angular momentum is multiplied by the moments of inertia where it is to be divided by them",
    [INVERSE] = "the attitude is taken for its inverse, space to body",
    [WRONG_ORDER] = "moments of inertia are taken in the wrong order: B, A, C for A, B, C",
    [OTHER_ORDER] = "moments of inertia are taken in the wrong order: C, A, B for A, B, C",
    [BODY_SIDE] = "attitude increments act in the body's frame while the angular velocity is spatial",
    [SPHERE] = "the body is turned about L, as a sphere would be",
    [TOO_FAST] = "a free body does not turn by R diag(1/A, 1/B, 1/C) R^T L",
    [REFUSES] = "a free body of three moments is refused, or not finite",
    [MOMENT_TO_BODY] = "moments are turned into the body's frame while L is spatial",
    [MOMENT_OF_BODY] = "moments are taken along the body's axes, and are spatial",
    [DIVIDED] = "L is kicked by the moment over the inertia, as an angular velocity is",
    [LATE] = "L is half a kick late",
    [EARLY] = "L is half a kick early",
    [TWICE] = "L grows by 2 times the moment",
    [NO_MOMENT] = "moments do not act",
    [ASKEW] = "L does not grow along the moment",
    [REFUSES_MOMENTS] = "a body of three moments under a moment is refused, or not finite",
    [START_AXES] = "order 1.0 of a free body: a step's whole turn goes by the axes of its start?",
    [OLD_MOMENT] = "order 1.0 under moments: they are those of the step's start, or L is half a kick off?",
    [NEVER_CONVERGES] = "bodies of three moments do not converge, for a reason that is not recognised",
    [NO_GYROSCOPE] = "the gyroscopic term w x J w is missing: a free body turns about a fixed axis",
    [WRONG_GYROSCOPE] = "the gyroscopic term w x J w has the wrong sign",
};
static const char slender[] = "the energy of a slender body (1.7231, 0.0658, 1.7243) grows at h|Omega| = 0.2";

/* ---- a host that goes by L --------------------------------------------------------------------------------------- */

/** exp(u) in space, or about the body's axes. */
static void turn(const double u[3], int body, double q[4])
{
    const double angle = vti_norm(u);
    if (angle == 0.0)
        return;
    const double s = sin(0.5 * angle) / angle, p[4] = {s * u[0], s * u[1], s * u[2], cos(0.5 * angle)};
    const double *a = body ? q : p, *b = body ? p : q;
    double x[3], r[4];
    vti_cross(a, b, x);
    for (int k = 0; k < 3; ++k)
        r[k] = a[3] * b[k] + b[3] * a[k] + x[k];
    r[3] = a[3] * b[3] - vti_dot(a, b);
    memcpy(q, r, sizeof r);
}

/** Omega in space, as the host finds it. */
static void omega_of(int fault, const double I[3], const double q[4], const double L[3], double w[3])
{
    static const int order[3][3] = {{0, 1, 2}, {1, 0, 2}, {2, 0, 1}};
    const int *by = order[fault == WRONG_ORDER ? 1 : fault == OTHER_ORDER ? 2 : 0];
    memcpy(w, L, 3 * sizeof *w);
    if (fault == OMEGA_FOR_L)
        return;
    if (fault != L_OF_BODY)
        vti_pair_rotate(q, -1.0, w, w);
    for (int k = 0; k < 3; ++k)
        w[k] = fault == SPHERE ? w[k] / 1.6 : fault == MULTIPLIED ? w[k] * I[k] : w[k] / I[by[k]];
    if (fault != OMEGA_OF_BODY)
        vti_pair_rotate(q, 1.0, w, w);
    for (int k = 0; k < 3 && fault == TOO_FAST; ++k)
        w[k] *= 1.1;
    for (int k = 0; k < 3 && fault == NEVER_CONVERGES; ++k)
        w[k] *= 1.005;
}

/** What L is kicked by. */
static void push(int fault, const double I[3], const double q[4], const double moment[3], double m[3])
{
    memcpy(m, moment, 3 * sizeof *m);
    if (fault == MOMENT_TO_BODY || fault == MOMENT_OF_BODY)
        vti_pair_rotate(q, fault == MOMENT_OF_BODY ? 1.0 : -1.0, m, m);
    if (fault == DIVIDED)
        omega_of(RIGHT, I, q, moment, m);
    for (int k = 0; k < 3; ++k) {
        m[k] *= fault == TWICE ? 2.0 : fault == NO_MOMENT ? 0.0 : 1.0;
        m[k] += fault == ASKEW ? 0.3 * moment[(k + 1) % 3] : 0.0;
    }
}

static void kick(int fault, double t, const double I[3], const double q[4], const double moment[3], double L[3])
{
    double m[3];
    push(fault, I, q, moment, m);
    for (int k = 0; k < 3; ++k)
        L[k] += t * m[k];
}

static void drift(int fault, double h, const double I[3], const double L[3], double q[4])
{
    double w[3], u[3], half[4] = {q[0], q[1], q[2], q[3]};
    omega_of(fault, I, half, L, w);
    for (int k = 0; k < 3; ++k)
        u[k] = 0.5 * h * w[k];
    if (fault != START_AXES) {
        turn(u, fault == BODY_SIDE, half);
        omega_of(fault, I, half, L, w);
    }
    for (int k = 0; k < 3; ++k)
        u[k] = h * w[k];
    turn(u, fault == BODY_SIDE, q);
}

/* ---- a host that goes by Euler's equations ----------------------------------------------------------------------- */

static void gyrate(double g, const double I[3], const double w[3], double t, const double from[3], double to[3])
{
    const double p[3] = {I[0] * w[0], I[1] * w[1], I[2] * w[2]};
    double x[3];
    vti_cross(p, w, x);
    for (int k = 0; k < 3; ++k)
        to[k] = from[k] + t * g * x[k] / I[k];
}

/** The explicit midpoint rule, g times the gyroscopic term. */
static void euler_drift(double g, double h, const double I[3], double L[3], double q[4])
{
    double w[3], middle[3], u[3];
    vti_pair_rotate(q, -1.0, L, w);
    for (int k = 0; k < 3; ++k)
        w[k] /= I[k];
    gyrate(g, I, w, 0.5 * h, w, middle);
    gyrate(g, I, middle, h, w, w);
    for (int k = 0; k < 3; ++k)
        u[k] = h * middle[k];
    turn(u, 1, q);
    for (int k = 0; k < 3; ++k)
        L[k] = I[k] * w[k];
    vti_pair_rotate(q, 1.0, L, L);
}

/* ---- both -------------------------------------------------------------------------------------------------------- */

static int advance(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat, double *L,
                   const double *mass, const double *I, vti_check_forces *forces, void *kit)
{
    const int fault = *(const int *)self, inverse = fault == INVERSE ? -1 : 1;
    double force[3], moment[3], none[6];
    (void)v;
    (void)mass;
    forces(kit, n + 1, x, quat, none, none); /* of so many there are none */
    forces(kit, n, x, quat, force, moment);
    if (fault == REFUSES || (fault == REFUSES_MOMENTS && vti_dot(moment, moment) > 0.0))
        return 1;
    for (int64_t k = 0; k < steps; ++k) {
        for (int c = 0; c < 3; ++c)
            quat[c] *= inverse;
        kick(fault, fault == LATE && k == 0 ? 0.0 : fault == EARLY && k == 0 ? h : 0.5 * h, I, quat, moment, L);
        if (fault >= NO_GYROSCOPE)
            euler_drift(fault == NO_GYROSCOPE ? 0.0 : fault == WRONG_GYROSCOPE ? -1.0 : 1.0, h, I, L, quat);
        else
            drift(fault, h, I, L, quat);
        for (int c = 0; c < 3; ++c)
            quat[c] *= inverse;
        if (fault == OLD_MOMENT)
            kick(fault, 0.5 * h, I, quat, moment, L);
        forces(kit, n, x, quat, force, moment);
        if (fault != OLD_MOMENT)
            kick(fault, 0.5 * h, I, quat, moment, L);
    }
    return 0;
}

TEST(every_mistake)
{
    for (int fault = 0; fault < FAULTS; ++fault) {
        vti_check_report report;
        const int faults = vti_check_run_inertia("host", advance, &fault, &report);
        for (int k = 0; k < report.words; ++k)
            print_message("%d: %s\n", fault, report.word[k].text);
        assert_int_equal(faults, report.faults);
        assert_int_equal(faults, sentence[fault] != NULL);
        for (int k = 0; k < faults; ++k) {
            assert_int_equal(report.word[k].is_fault, 1);
            assert_string_equal(report.word[k].text, sentence[fault]);
        }
        /* the host by L goes by an explicit half step, which winds up slender bodies */
        assert_int_equal(report.words, faults > 0 ? 1 : fault == RIGHT || fault == EXPLICIT);
        if (faults == 0 && report.words > 0)
            assert_string_equal(report.word[0].text, slender);
        assert_int_equal(report.lines, 7);
    }
}

RUN_TESTS(cmocka_unit_test(every_mistake))
