/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Orders of convergence of bodies with three moments: free ones against Jacobi's elliptic functions, in orders 2, 4 and
 * 6 of the rotor; a heavy top against GSL's Prince-Dormand 8(9), in the orders of the steppers. */
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_elljac.h>
#include <gsl/gsl_sf_ellint.h>

#include "fit.h"
#include "top.h"

/* ---- free -------------------------------------------------------------------------------------------------------- */

/** A free body of moments A < B < C, L along e3 and L^2 > 2 T B, which turns about C (Landau and Lifshitz, Mechanics,
 *  37): w_A = a cn, w_B = b sn, w_C = c dn of rate t, m. */
struct free_body {
    double I[3], w[3], rate, m, L;
};

static struct free_body free_body_of(const double I[3], double w_a, double w_c)
{
    struct free_body f = {{I[0], I[1], I[2]}, {w_a, 0, w_c}, 0, 0, 0};
    const double A = I[0], B = I[1], C = I[2], L2 = A * A * w_a * w_a + C * C * w_c * w_c,
                 T2 = A * w_a * w_a + C * w_c * w_c;
    f.L = sqrt(L2);
    f.w[1] = sqrt((T2 * C - L2) / (B * (C - B)));
    f.rate = sqrt((C - B) * (L2 - T2 * A) / (A * B * C));
    f.m = (B - A) * (T2 * C - L2) / ((C - B) * (L2 - T2 * A));
    return f;
}

static void at_time(const struct free_body *f, double t, double w[3])
{
    double sn, cn, dn;
    assert_int_equal(gsl_sf_elljac_e(f->rate * t, f->m, &sn, &cn, &dn), 0);
    w[0] = f->w[0] * cn;
    w[1] = f->w[1] * sn;
    w[2] = f->w[2] * dn;
}

/** How fast the line of nodes turns about L: L (A w_A^2 + B w_B^2)/(A^2 w_A^2 + B^2 w_B^2). */
static double precession(double t, void *params)
{
    const struct free_body *f = params;
    double w[3], above = 0, below = 0;
    at_time(f, t, w);
    for (int k = 0; k < 2; ++k) {
        above += f->I[k] * w[k] * w[k];
        below += f->I[k] * f->I[k] * w[k] * w[k];
    }
    return f->L * above / below;
}

/** The attitude at t by Euler's angles z, x, z about L along e3: cos theta = C w_C/L, A w_A = L sin theta sin psi. */
static rotor attitude_at(const struct free_body *f, double t)
{
    static const double e1[3] = {1, 0, 0}, e3[3] = {0, 0, 1};
    double w[3], phi = 0, error = 0;
    gsl_function speed = {precession, (void *)f};
    gsl_integration_workspace *work = gsl_integration_workspace_alloc(1000);
    if (t > 0)
        assert_int_equal(gsl_integration_qag(&speed, 0, t, 0, 1e-13, 1000, GSL_INTEG_GAUSS61, work, &phi, &error), 0);
    gsl_integration_workspace_free(work);
    at_time(f, t, w);
    const double across = hypot(f->I[0] * w[0], f->I[1] * w[1]);
    const rotor nod = quat_turn(e1, atan2(across, f->I[2] * w[2])),
                own = quat_turn(e3, atan2(f->I[0] * w[0], f->I[1] * w[1]));
    return quat_times(quat_times(quat_turn(e3, phi), nod), own);
}

/** The error of attitude after n steps of the rotor, L kept to the bit. */
static double free_error(const struct free_body *f, int order, int storage, double t_end, int n)
{
    vti_stepper own = *vti_stepper_find("exact");
    top p;
    memset(&p, 0, sizeof p);
    own.rotor = order;
    p.storage = (enum top_storage)storage;
    memcpy(p.moments, f->I, sizeof p.moments);
    top_set_attitude(&p, attitude_at(f, 0));
    p.spin[2] = f->L;
    const vti_bodies b = top_bodies(&p);
    for (int k = 0; k < n; ++k) {
        assert_int_equal(vti_step_begin(&own, t_end / n, &b, NULL), VTI_OK);
        assert_int_equal(vti_step_finish(&own, t_end / n, &b), VTI_OK);
    }
    assert_true(p.spin[0] == 0 && p.spin[1] == 0 && p.spin[2] == f->L);
    return quat_distance(top_attitude(&p), attitude_at(f, t_end));
}

static void free_order(int order, int coarsest)
{
    static const double moments[2][3] = {{1, 1.7, 2.3}, {0.2, 1.0, 1.1}};
    for (int which = 0; which < 2; ++which) {
        const struct free_body f = free_body_of(moments[which], 0.4, 0.9);
        int n[RUNGS];
        double e[RUNGS];
        char what[40];
        for (int i = 0; i < RUNGS; ++i) {
            n[i] = fit_steps(coarsest, i);
            e[i] = free_error(&f, order, which, 20, n[i]);
        }
        snprintf(what, sizeof what, "free body %d, rotor %d", which, order);
        assert_order(what, n, e, order, 0.2);
    }
}

TEST(free_2)
{
    free_order(2, 100);
}

TEST(free_4)
{
    free_order(4, 140);
}

TEST(free_6)
{
    free_order(6, 40);
}

/* ---- a heavy top ------------------------------------------------------------------------------------------------- */

static const double heavy[3] = {0.6, 1, 1.5}, arm[3] = {0.3, 0.2, 0.9};

/** RM = (R arm) x (0, 0, -1) = of a weight 1 along -e3. */
static void weight(void *self, const vti_bodies *b)
{
    double q[4], r[3];
    (void)self;
    if (b->alpha.c[0] != NULL) {
        double a[3] = {b->alpha.c[0][0], b->alpha.c[1][0], b->alpha.c[2][0]};
        vti_rrv_to_quat_xyzw(a, q);
    } else
        for (int k = 0; k < 4; ++k)
            q[k] = b->quat.xyzw[k][0];
    vti_pair_rotate(q, 1.0, arm, r);
    b->moment.c[0][0] = -r[1];
    b->moment.c[1][0] = r[0];
    b->moment.c[2][0] = 0;
}

/** q' = Omega q/2, L' = RM with y = (x, y, z, w, L). */
static int motion(double t, const double y[], double dydt[], void *params)
{
    top p;
    double w[3];
    (void)t;
    (void)params;
    memset(&p, 0, sizeof p);
    memcpy(p.moments, heavy, sizeof heavy);
    memcpy(p.quat, y, sizeof p.quat);
    memcpy(p.spin, y + 4, sizeof p.spin);
    p.storage = TOP_QUAT;
    const vti_bodies b = top_bodies(&p);
    weight(NULL, &b);
    top_omega(&p, w);
    vti_cross(w, y, dydt);
    for (int k = 0; k < 3; ++k) {
        dydt[k] = 0.5 * (dydt[k] + y[3] * w[k]);
        dydt[4 + k] = p.moment[k];
    }
    dydt[3] = -0.5 * vti_dot(w, y);
    return GSL_SUCCESS;
}

static top heavy_top(void)
{
    top p;
    const double axis[3] = {1, 1, 0}, spin[3] = {0.4, -0.3, 1.2};
    memset(&p, 0, sizeof p);
    memcpy(p.moments, heavy, sizeof heavy);
    memcpy(p.spin, spin, sizeof spin);
    top_set_attitude(&p, quat_turn(axis, 1));
    p.storage = TOP_ALPHA;
    return p;
}

static void shows(const char *name, double order, int coarsest)
{
    const double t_end = 4;
    const vti_stepper *const method = vti_stepper_find(name);
    top end = heavy_top();
    double y[7], e[RUNGS];
    int n[RUNGS];
    memcpy(y, end.quat, sizeof end.quat);
    memcpy(y + 4, end.spin, sizeof end.spin);
    gsl_odeiv2_system system = {motion, NULL, 7, NULL};
    fit_reference(&system, t_end, y);
    const rotor exact = {y[0], y[1], y[2], y[3]};
    for (int i = 0; i < RUNGS; ++i) {
        top p = heavy_top(), elsewhere = p;
        n[i] = fit_steps(coarsest, i);
        const vti_bodies b = top_bodies(&p);
        vti_bodies probed = top_bodies(&elsewhere);
        probed.moment = b.moment;
        weight(NULL, &b);
        for (int k = 0; k < n[i]; ++k)
            play_step(method, t_end / n[i], &b, &probed, weight, NULL);
        e[i] = quat_distance(top_attitude(&p), quat_unit(exact));
    }
    assert_order(name, n, e, order, 0.35);
}

TEST(heavy_top_orders)
{
    shows("vti1", 2, 100);
    shows("vti2", 2, 100);
    shows("exact", 2, 100);
    shows("suzuki4", 4, 30);
    shows("srkn6", 4, 30);
    shows("chin4", 4, 40);
    shows("srkn11", 6, 10);
    shows("srkn14", 6, 8);
    shows("kl6", 6, 14);
    shows("kl8", 8, 12);
}

RUN_TESTS(cmocka_unit_test(free_2), cmocka_unit_test(free_4), cmocka_unit_test(free_6),
          cmocka_unit_test(heavy_top_orders))
