/* SPDX-License-Identifier: BSD-3-Clause
 *
 * vti_step_probe: x + c h^2 F/m and R(c h^2 RM/J) R, for one mass and for many, in alpha and in quaternions, space and
 * body frame; the bodies themselves are not touched; what it refuses. */
#include "bodies.h"
#include "support.h"

enum { N = 7 };

typedef struct set {
    double x[N][3], v[N][3], force[N][3], alpha[N][3], quat[N][4], omega[N][3], moment[N][3], mass[N], inertia[N];
} set;

static set ours, theirs, before;
static const double wild = 12345;

static vti_bodies bodies(set *s, int quat, int poly)
{
    vti_bodies b = bodies_of(s, N, quat);
    b.mass.stride = b.inertia.stride = poly ? 1 : 0;
    return b;
}

static int fill(void **state)
{
    (void)state;
    rng g = rng_seed(71);
    for (int i = 0; i < N; ++i) {
        double q[4];
        random_unit(&g, 4, q);
        for (int k = 0; k < 3; ++k) {
            ours.alpha[i][k] = 2 * q[k] / q[3];
            theirs.x[i][k] = theirs.alpha[i][k] = theirs.quat[i][k] = wild;
        }
        theirs.quat[i][3] = wild;
        memcpy(ours.quat[i], q, sizeof q);
        random_vector(&g, 2, ours.x[i]);
        random_vector(&g, 2, ours.v[i]);
        random_vector(&g, 2, ours.force[i]);
        random_vector(&g, 2, ours.omega[i]);
        random_vector(&g, 2, ours.moment[i]);
        ours.mass[i] = theirs.mass[i] = uniform(&g, 0.5, 3);
        ours.inertia[i] = theirs.inertia[i] = uniform(&g, 0.5, 3);
    }
    before = ours;
    return 0;
}

/** The attitude of body i, in whichever form it is kept. */
static rotor attitude(const set *s, int quat, int i)
{
    return quat ? quat_of_xyzw(s->quat[i]) : quat_of_alpha(s->alpha[i]);
}

/** The body i of the probe is where the formulas have it. */
static void at_its_place(const vti_stepper *method, double t, int quat, int poly, int i)
{
    const double m = ours.mass[poly ? i : 0], J = ours.inertia[poly ? i : 0];
    double turn[3], x[3];
    for (int k = 0; k < 3; ++k) {
        x[k] = ours.x[i][k] + t * ours.force[i][k] / m;
        turn[k] = t * ours.moment[i][k] / J;
    }
    const double s = vti_norm(turn);
    const rotor d = quat_turn(turn, s), q = attitude(&ours, quat, i);
    const rotor expected = method->frame == VTI_FRAME_SPACE ? quat_times(d, q) : quat_times(q, d);
    assert_close3(theirs.x[i], x, 8 * EPS);
    /* the exact law is off by s^7/100800, its next term being as small again */
    assert_close(quat_distance(attitude(&theirs, quat, i), expected), 0, 16 * EPS + 2 * pow(s, 7) / 100800);
}

static void displaced(void **state)
{
    const double coefficient[] = {0, 1.0 / 24, -0.3}, h = 0.75;
    vti_stepper own = *vti_stepper_find("chin4");
    own.probe = coefficient;
    for (int which = 0; which < 32; ++which)
        for (int64_t k = 0; k < 3; ++k) {
            const int quat = which & 1, poly = which >> 1 & 1, law = 1 + (which >> 3);
            own.frame = which >> 2 & 1 ? VTI_FRAME_BODY : VTI_FRAME_SPACE;
            own.law = law;
            fill(state);
            const vti_bodies b = vti_bodies_slice(bodies(&ours, quat, poly), 1, N - 2);
            vti_bodies probed = vti_bodies_slice(bodies(&theirs, quat, poly), 1, N - 2);
            probed.force = b.force; /* as a host does that takes forces there */
            probed.moment = b.moment;
            assert_int_equal(vti_step_probe(&own, k, h, &b, &probed), VTI_OK);
            assert_memory_equal(&ours, &before, sizeof ours);
            for (int i = 1; i < N - 1; ++i)
                at_its_place(&own, coefficient[k] * h * h, quat, poly, i);
            for (int i = 0; i < N; i += N - 1) /* not of the slice */
                assert_close(theirs.x[i][0] + theirs.alpha[i][1] + theirs.quat[i][3], 3 * wild, 0);
        }
    /* no probe, no displacement: a copy */
    fill(state);
    const vti_bodies b = bodies(&ours, 0, 1), probed = bodies(&theirs, 0, 1);
    assert_int_equal(vti_step_probe(vti_stepper_find("exact"), 1, h, &b, &probed), VTI_OK);
    assert_same_bits(theirs.x, ours.x, 3 * N);
    assert_same_bits(theirs.alpha, ours.alpha, 3 * N);
}

/** Centres alone, attitudes alone. */
static void in_part(void **state)
{
    (void)state;
    const vti_stepper *chin = vti_stepper_find("chin4");
    vti_bodies b = vti_bodies_none(N), probed = b;
    b.x = vti_view_packed(ours.x[0]);
    b.v = vti_view_packed(ours.v[0]);
    b.force = vti_view_packed(ours.force[0]);
    b.mass = vti_scalars_array(ours.mass);
    probed.x = vti_view_packed(theirs.x[0]);
    assert_int_equal(vti_step_probe(chin, 1, 0.5, &b, &probed), VTI_OK);
    assert_close(theirs.x[3][1], ours.x[3][1] + 0.25 / 24 * ours.force[3][1] / ours.mass[3], 4 * EPS);
    assert_close(theirs.alpha[3][1], wild, 0);
    fill(state);
    b = probed = vti_bodies_none(N);
    b.alpha = vti_view_packed(ours.alpha[0]);
    b.omega = vti_view_packed(ours.omega[0]);
    b.moment = vti_view_packed(ours.moment[0]);
    b.inertia = vti_scalars_array(ours.inertia);
    probed.alpha = vti_view_packed(theirs.alpha[0]);
    assert_int_equal(vti_step_probe(chin, 1, 0.5, &b, &probed), VTI_OK);
    assert_true(theirs.alpha[3][1] != ours.alpha[3][1] && fabs(theirs.alpha[3][1] - ours.alpha[3][1]) < 1);
    assert_close(theirs.x[3][1], wild, 0);
    assert_memory_equal(&ours, &before, sizeof ours);
}

static const vti_bodies *b_of;

static void refused(vti_bodies probed, int status)
{
    static set kept;
    kept = theirs;
    assert_int_equal(vti_step_probe(vti_stepper_find("chin4"), 1, 0.5, b_of, &probed), status);
    assert_memory_equal(&ours, &before, sizeof ours);
    assert_memory_equal(&theirs, &kept, sizeof theirs);
}

static void refusals(void **state)
{
    (void)state;
    const vti_stepper *chin = vti_stepper_find("chin4");
    for (int quat = 0; quat < 2; ++quat) {
        const vti_bodies b = bodies(&ours, quat, 1), good = bodies(&theirs, quat, 1);
        b_of = &b;
        vti_bodies bad = good;
        bad.x = b.x;
        refused(bad, VTI_E_ALIAS);
        bad = good;
        bad.alpha = b.alpha;
        bad.quat = b.quat;
        refused(bad, VTI_E_ALIAS);
        double(*const all[])[3] = {ours.v, ours.force, ours.omega, ours.moment};
        for (int k = 0; k < 4; ++k) { /* it would be written over */
            bad = good;
            bad.x = vti_view_packed(all[k][0]);
            refused(bad, VTI_E_ALIAS);
        }
        bad = good;
        bad.x = vti_view_none();
        refused(bad, VTI_E_VIEW);
        bad.x.c[1] = theirs.x[0];
        refused(bad, VTI_E_VIEW);
        bad = good;
        bad.alpha = vti_view_none();
        bad.quat.xyzw[0] = bad.quat.xyzw[1] = bad.quat.xyzw[2] = bad.quat.xyzw[3] = NULL;
        refused(bad, VTI_E_VIEW);
        refused(bodies(&theirs, !quat, 1), VTI_E_VIEW); /* the other form */
        refused(vti_bodies_slice(good, 1, N - 1), VTI_E_COUNT);
        refused(vti_bodies_slice(good, 0, N - 1), VTI_E_COUNT);
        bad = good;
        bad.abi = 0;
        refused(bad, VTI_E_ABI);
        assert_int_equal(vti_step_probe(chin, -1, 0.5, &b, &good), VTI_E_STAGE);
        assert_int_equal(vti_step_probe(chin, 3, 0.5, &b, &good), VTI_E_STAGE);
        assert_int_equal(vti_step_probe(chin, 1, NAN, &b, &good), VTI_E_TIME);
        assert_int_equal(vti_step_probe(chin, 1, 0, &b, &good), VTI_E_TIME);
        vti_stepper own = *chin;
        own.frame = 0;
        assert_int_equal(vti_step_probe(&own, 1, 0.5, &b, &good), VTI_E_FRAME);
        assert_int_equal(vti_step_probe(chin, 2, 0.5, &b, &good), VTI_OK);
        fill(state);
    }
}

RUN_TESTS(cmocka_unit_test_setup(displaced, fill), cmocka_unit_test_setup(in_part, fill),
          cmocka_unit_test_setup(refusals, fill))
