/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Orders of convergence of bodies with three moments: free ones against Jacobi's elliptic functions, in orders 2, 4 and
 * 6 of the rotor; a heavy top and a bonded pair against GSL's Prince-Dormand 8(9), in the orders of the steppers. */
#include "chain.h"
#include "fit.h"
#include "free_body.h"
#include "top.h"

/* ---- free -------------------------------------------------------------------------------------------------------- */

/** The error of attitude after n steps of the rotor, L kept to the bit. */
static double free_error(const struct free_body *f, int order, int storage, double t_end, int n)
{
    vti_stepper own = *vti_stepper_find("exact");
    top p;
    memset(&p, 0, sizeof p);
    own.rotor = order;
    p.storage = (enum top_storage)storage;
    memcpy(p.moments, f->I, sizeof p.moments);
    top_set_attitude(&p, free_attitude(f, 0));
    p.spin[2] = f->L;
    const vti_bodies b = top_bodies(&p);
    for (int k = 0; k < n; ++k) {
        assert_int_equal(vti_step_begin(&own, t_end / n, &b, NULL), VTI_OK);
        assert_int_equal(vti_step_finish(&own, t_end / n, &b), VTI_OK);
    }
    assert_true(p.spin[0] == 0 && p.spin[1] == 0 && p.spin[2] == f->L);
    return quat_distance(top_attitude(&p), free_attitude(f, t_end));
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

/* ---- a bonded pair ----------------------------------------------------------------------------------------------- */

enum { NUMBERS = 13 }; /* of a body: x, v, q, L */

/** Two bodies of three moments each, bonded, displaced, turned and set moving. omega of the chain is L. */
static chain bonded_pair(void)
{
    chain c;
    chain_make(&c, 2, 412, CHAIN_ALPHA);
    return c;
}

static vti_bodies pair_bodies(chain *c)
{
    static double moments[2][3] = {{0.5, 0.9, 1.1}, {1.2, 0.7, 0.8}};
    vti_bodies b = chain_bodies(c);
    b.spin = b.omega;
    b.omega = vti_view_none();
    b.inertia = vti_bodies_none(2).inertia;
    b.moments = vti_view_packed(moments[0]);
    return b;
}

/** x' = v, v' = F/m, q' = Omega q/2, Omega = R diag(1/moments) R^T L, L' = RM with y = (x, v, q, L) of each. */
static int pair_motion(double t, const double y[], double dydt[], void *params)
{
    chain *const c = params;
    (void)t;
    for (int i = 0; i < 2; ++i) {
        memcpy(c->x[i], y + NUMBERS * i, sizeof c->x[i]);
        memcpy(c->quat[i], y + NUMBERS * i + 6, sizeof c->quat[i]);
    }
    const vti_bodies b = pair_bodies(c);
    chain_load(c, &b);
    for (int i = 0; i < 2; ++i) {
        const double *const from = y + NUMBERS * i, *const q = from + 6;
        double *const d = dydt + NUMBERS * i, w[3], x[3];
        quat_rotate(quat_conj(quat_of_xyzw(q)), from + 10, w);
        for (int k = 0; k < 3; ++k)
            w[k] /= b.moments.c[k][3 * i];
        quat_rotate(quat_of_xyzw(q), w, w);
        vti_cross(w, q, x);
        for (int k = 0; k < 3; ++k) {
            d[k] = from[3 + k];
            d[3 + k] = c->force[i][k] / c->mass[i];
            d[6 + k] = 0.5 * (q[3] * w[k] + x[k]);
            d[10 + k] = c->moment[i][k];
        }
        d[9] = -0.5 * vti_dot(w, q);
    }
    return GSL_SUCCESS;
}

static chain pair_reference(double t_end)
{
    chain c = bonded_pair();
    double y[2 * NUMBERS];
    c.storage = CHAIN_QUAT;
    for (int i = 0; i < 2; ++i) {
        double *const to = y + NUMBERS * i;
        memcpy(to, c.x[i], sizeof c.x[i]);
        memcpy(to + 3, c.v[i], sizeof c.v[i]);
        memcpy(to + 6, c.quat[i], sizeof c.quat[i]);
        memcpy(to + 10, c.omega[i], sizeof c.omega[i]);
    }
    gsl_odeiv2_system system = {pair_motion, NULL, 2 * NUMBERS, &c};
    fit_reference(&system, t_end, y);
    for (int i = 0; i < 2; ++i) {
        memcpy(c.x[i], y + NUMBERS * i, sizeof c.x[i]);
        memcpy(c.v[i], y + NUMBERS * i + 3, sizeof c.v[i]);
        memcpy(c.quat[i], y + NUMBERS * i + 6, sizeof c.quat[i]);
        memcpy(c.omega[i], y + NUMBERS * i + 10, sizeof c.omega[i]);
    }
    return c;
}

/** Of attitudes, L, x and v. */
static void pair_shows(const char *name, double order, int coarsest)
{
    static const char *const quantity[] = {"attitude", "L", "x", "v"};
    const double t_end = 2;
    const vti_stepper *const method = vti_stepper_find(name);
    const chain exact = pair_reference(t_end);
    double e[4][RUNGS];
    int n[RUNGS];
    for (int i = 0; i < RUNGS; ++i) {
        chain c = bonded_pair(), elsewhere = c;
        double all[4];
        const vti_bodies b = pair_bodies(&c);
        vti_bodies probed = pair_bodies(&elsewhere);
        probed.force = b.force;
        probed.moment = b.moment;
        n[i] = fit_steps(coarsest, i);
        chain_load(&c, &b);
        for (int k = 0; k < n[i]; ++k)
            play_step(method, t_end / n[i], &b, &probed, chain_load, &c);
        chain_difference(&c, &exact, all);
        for (int k = 0; k < 4; ++k)
            e[k][i] = all[k];
    }
    for (int k = 0; k < 4; ++k) {
        char what[64];
        snprintf(what, sizeof what, "%s, bonded pair: %s", name, quantity[k]);
        assert_order(what, n, e[k], order, 0.05 * order);
    }
}

TEST(bonded_pair_orders)
{
    pair_shows("exact", 2, 32);
    pair_shows("suzuki4", 4, 16);
    pair_shows("srkn6", 4, 16);
    pair_shows("chin4", 4, 16);
    pair_shows("srkn11", 6, 8);
    pair_shows("srkn14", 6, 7);
    pair_shows("kl6", 6, 10);
    pair_shows("kl8", 8, 7);
}

RUN_TESTS(cmocka_unit_test(free_2), cmocka_unit_test(free_4), cmocka_unit_test(free_6),
          cmocka_unit_test(heavy_top_orders), cmocka_unit_test(bonded_pair_orders))
