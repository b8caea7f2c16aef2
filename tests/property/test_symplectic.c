/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Each stepper conserves the symplectic two-form of T*SO(3) exactly (E14, E15). On the pendulum chin4 does so too,
 * because a probe's moment is a function of the tilt alone and thereby a gradient; elsewhere it does not, see
 * test_symplectic_chain.c.
 *
 * A tangent vector at (R, mu), mu = J Omega, is (eta, dmu) with the spatial variation dR = S(eta) R. The canonical
 * one-form is theta = mu . eta. Fields of constant eta are right-invariant, so their bracket is that of -eta1 x eta2,
 * and
 *
 *     d theta(X1, X2) = dmu1 . eta2 - dmu2 . eta1 + mu . (eta1 x eta2).
 *
 * In the body's frame dR = R S(xi) is left-invariant and the last term changes its sign. The Jacobian of one step is
 * made of central differences in the chart exp(eta) R at each end. */
#include "rig.h"

typedef void map(rig *p, double h);

/** The two-form on tangent vectors (eta, dmu) of six numbers. */
static double two_form(const double mu[3], int frame, const double *t1, const double *t2)
{
    double bracket[3];
    vti_cross(t1, t2, bracket);
    return vti_dot(t1 + 3, t2) - vti_dot(t2 + 3, t1) + (frame == VTI_FRAME_SPACE ? 1 : -1) * vti_dot(mu, bracket);
}

/** p moved by e times the k-th of the six coordinate directions. */
static rig moved(const rig *p, int k, double e)
{
    rig q = *p;
    const double axis[3] = {k == 0, k == 1, k == 2};
    const rotor turn = quat_turn(axis, e), now = rig_attitude(p);
    if (k < 3)
        rig_set_attitude(&q, p->frame == VTI_FRAME_SPACE ? quat_times(turn, now) : quat_times(now, turn));
    else
        q.omega[k - 3] += e / p->inertia;
    return q;
}

/** (log(R_p R_m^T), mu_p - mu_m)/(2 e), the logarithm in the body's frame where that is the frame. */
static void quotient(const rig *plus, const rig *minus, double e, double t[6])
{
    const rotor p = rig_attitude(plus), m = quat_conj(rig_attitude(minus));
    const rotor d = plus->frame == VTI_FRAME_SPACE ? quat_times(p, m) : quat_times(m, p);
    /* 2 v/w is the rotation vector but for e^3/12 of it */
    t[0] = (double)(2 * d.x / d.w) / (2 * e);
    t[1] = (double)(2 * d.y / d.w) / (2 * e);
    t[2] = (double)(2 * d.z / d.w) / (2 * e);
    for (int k = 0; k < 3; ++k)
        t[3 + k] = plus->inertia * (plus->omega[k] - minus->omega[k]) / (2 * e);
}

/** The largest change of the two-form on pairs of coordinate directions by one step. */
static double defect(map *step, const rig *start, double h)
{
    const double e = cbrt(EPS);
    double image[6][6], mu[3], mu_after[3], most = 0;
    rig end = *start;
    step(&end, h);
    for (int k = 0; k < 3; ++k) {
        mu[k] = start->inertia * start->omega[k];
        mu_after[k] = end.inertia * end.omega[k];
    }
    for (int k = 0; k < 6; ++k) {
        rig plus = moved(start, k, e), minus = moved(start, k, -e);
        step(&plus, h);
        step(&minus, h);
        quotient(&plus, &minus, e, image[k]);
    }
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < i; ++j) {
            double ei[6] = {0}, ej[6] = {0};
            ei[i] = ej[j] = 1;
            const double before = two_form(mu, start->frame, ei, ej);
            most = fmax(most, fabs(two_form(mu_after, start->frame, image[i], image[j]) - before));
        }
    return most;
}

/* The quotients err by e^2/6 of third derivatives and 8 eps/e of rounding, both about 4e-11 at e = eps^(1/3); a form is
 * a sum of nine products of them with numbers of order 1 to 4. */
#define TOLERANCE (100 * (cbrt(EPS) * cbrt(EPS)))

static const vti_stepper *method;

static void one_step(rig *p, double h)
{
    rig_steps(p, method, h, 1);
}

static void one_step_as_read(rig *p, double h)
{
    rig_run(p, method, h, 1);
}

/** Explicit Euler: the drift by the old Omega, the kick by the old moment. */
static void explicit_euler(rig *p, double h)
{
    const vti_bodies b = rig_bodies(p);
    rig_moment(p);
    vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, h, &b, NULL);
    vti_kick(h, &b);
}

/** VTI-2 with the moment as the paper prints it, (R rho0) x (R^T e3), which is no gradient (E1). */
static void printed_moment(rig *p, double h)
{
    const vti_bodies b = rig_bodies(p);
    for (int half = 0; half < 2; ++half) {
        const double e3[3] = {0, 0, p->pendulum.weight};
        double arm[3], down[3];
        quat_rotate(rig_attitude(p), p->pendulum.rho0, arm);
        quat_rotate(quat_conj(rig_attitude(p)), e3, down);
        vti_cross(arm, down, p->moment);
        vti_kick(0.5 * h, &b);
        if (half == 0)
            vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, h, &b, NULL);
    }
}

TEST(every_stepper_conserves_it)
{
    const double steps[] = {1.0 / 64, 0.125, 0.4};
    rng g = rng_seed(241);
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int trial = 0; trial < 60; ++trial) {
            method = vti_stepper_at(k);
            rig p = rig_random(&g, trial & 1 ? RIG_QUAT : RIG_ALPHA);
            p.frame = (int)method->frame;
            assert_below(defect(one_step, &p, steps[trial % 3]), TOLERANCE);
            assert_below(defect(one_step_as_read, &p, steps[trial % 3]), TOLERANCE);
        }
}

/** The yardstick itself: it sees the term mu . (eta1 x eta2), and maps that are not symplectic. */
TEST(other_maps_do_not)
{
    rng g = rng_seed(242);
    double euler = 0, printed = 0, wrong_frame = 0;
    for (int trial = 0; trial < 20; ++trial) {
        rig p = rig_random(&g, RIG_ALPHA);
        euler = fmax(euler, defect(explicit_euler, &p, 0.125));
        printed = fmax(printed, defect(printed_moment, &p, 0.125));
        method = vti_stepper_find("vti2");
        p.frame = VTI_FRAME_BODY; /* spatial quantities read as if they were the body's */
        wrong_frame = fmax(wrong_frame, defect(one_step, &p, 0.125));
        /* explicit Euler misses by h^2 |grad moment| = 0.016 |grad moment| */
        assert_true(defect(explicit_euler, &p, 0.125) > 1e-4);
    }
    assert_true(euler > 1e-3 && printed > 1e-3 && wrong_frame > 1e-3);
}

RUN_TESTS(cmocka_unit_test(every_stepper_conserves_it), cmocka_unit_test(other_maps_do_not))
