/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Orders of convergence on the pendulum at t = 1, attitude and Omega, against GSL's Prince-Dormand 8(9) in quaternions. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "rig.h"

enum { COARSEST = 32, HALVINGS = 5 };

/** q' = Omega q/2, Omega' = m g (R rho0) x e3/J with y = (x, y, z, w, Omega). */
static int motion(double t, const double y[], double dydt[], void *params)
{
    (void)t;
    const rig *p = params;
    const double *q = y, *w = y + 4, *rho = p->pendulum.rho0, k = p->pendulum.weight / p->inertia;
    const double n = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    dydt[0] = 0.5 * (q[3] * w[0] + w[1] * q[2] - w[2] * q[1]);
    dydt[1] = 0.5 * (q[3] * w[1] + w[2] * q[0] - w[0] * q[2]);
    dydt[2] = 0.5 * (q[3] * w[2] + w[0] * q[1] - w[1] * q[0]);
    dydt[3] = -0.5 * (w[0] * q[0] + w[1] * q[1] + w[2] * q[2]);
    const double ax = (q[3] * q[3] + q[0] * q[0] - q[1] * q[1] - q[2] * q[2]) * rho[0] +
                      2 * (q[0] * q[1] - q[3] * q[2]) * rho[1] + 2 * (q[0] * q[2] + q[3] * q[1]) * rho[2];
    const double ay = 2 * (q[0] * q[1] + q[3] * q[2]) * rho[0] +
                      (q[3] * q[3] - q[0] * q[0] + q[1] * q[1] - q[2] * q[2]) * rho[1] +
                      2 * (q[1] * q[2] - q[3] * q[0]) * rho[2];
    dydt[4] = k * ay / n;
    dydt[5] = -k * ax / n;
    dydt[6] = 0;
    return GSL_SUCCESS;
}

/** The state at t = 1, in the place of p's. */
static void reference(rig *p)
{
    double y[7] = {p->quat[0], p->quat[1], p->quat[2], p->quat[3], p->omega[0], p->omega[1], p->omega[2]}, t = 0;
    gsl_odeiv2_system system = {motion, NULL, 7, p};
    gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-2, 1e-14, 1e-14);
    assert_non_null(driver);
    const int status = gsl_odeiv2_driver_apply(driver, &t, 1.0, y);
    gsl_odeiv2_driver_free(driver);
    assert_int_equal(status, GSL_SUCCESS);
    const rotor q = {y[0], y[1], y[2], y[3]};
    rig_set_attitude(p, q);
    memcpy(p->omega, y + 4, sizeof p->omega);
}

/** Errors of attitude and Omega after t = 1 in n steps. */
static void errors(const vti_stepper *method, rig p, const rig *exact, int n, double e[2])
{
    double inertial[3];
    p.frame = (int)method->frame;
    if (p.frame == VTI_FRAME_BODY)
        quat_rotate(quat_conj(rig_attitude(&p)), p.omega, p.omega);
    rig_run(&p, method, 1.0 / n, n);
    memcpy(inertial, p.omega, sizeof inertial);
    if (p.frame == VTI_FRAME_BODY)
        quat_rotate(rig_attitude(&p), p.omega, inertial);
    for (int k = 0; k < 3; ++k)
        inertial[k] -= exact->omega[k];
    e[0] = quat_distance(rig_attitude(&p), rig_attitude(exact));
    e[1] = vti_norm(inertial);
}

static void orders(const char *name, double order)
{
    const vti_stepper *method = vti_stepper_find(name);
    assert_close(method->order, order, 0);
    for (int storage = 0; storage < 3; ++storage) {
        const rig start = rig_of_the_paper((enum rig_storage)storage);
        rig exact = start;
        reference(&exact);
        double e[HALVINGS + 1][2];
        for (int i = 0; i <= HALVINGS; ++i)
            errors(method, start, &exact, COARSEST << i, e[i]);
        for (int i = 0; i < HALVINGS; ++i)
            for (int k = 0; k < 2; ++k) {
                const double observed = log2(e[i][k] / e[i + 1][k]);
                print_message("%s: %s order %.4f from h = 1/%d\n", name, k ? "Omega" : "attitude", observed,
                              COARSEST << i);
                assert_close(observed, order, 0.05);
            }
    }
}

static void vti1(void **state)
{
    (void)state;
    orders("vti1", 2);
}

static void vti2(void **state)
{
    (void)state;
    orders("vti2", 2);
}

static void vti3(void **state)
{
    (void)state;
    orders("vti3", 1);
}

static void vti3_leapfrog(void **state)
{
    (void)state;
    orders("vti3-leapfrog", 2);
}

static void vti1_body(void **state)
{
    (void)state;
    orders("vti1-body", 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vti1),          cmocka_unit_test(vti2),      cmocka_unit_test(vti3),
        cmocka_unit_test(vti3_leapfrog), cmocka_unit_test(vti1_body),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
