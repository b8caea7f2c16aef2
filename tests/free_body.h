/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The motion of a free body of three moments by Jacobi's elliptic functions and a quadrature, both GSL's: what methods
 * and references are measured against that go by differential equations. */
#ifndef VTI_TESTS_FREE_BODY_H
#define VTI_TESTS_FREE_BODY_H

#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_elljac.h>

#include "support.h"

/** A free body of moments A < B < C, L along e3 and L^2 > 2 T B, which turns about C (Landau and Lifshitz, Mechanics,
 *  37): w_A = a cn, w_B = b sn, w_C = c dn of rate t, m. */
struct free_body {
    double I[3], w[3], rate, m, L;
};

static inline struct free_body free_body_of(const double I[3], double w_a, double w_c)
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

static inline void free_omega(const struct free_body *f, double t, double w[3])
{
    double sn, cn, dn;
    assert_int_equal(gsl_sf_elljac_e(f->rate * t, f->m, &sn, &cn, &dn), 0);
    w[0] = f->w[0] * cn;
    w[1] = f->w[1] * sn;
    w[2] = f->w[2] * dn;
}

/** How fast the line of nodes turns about L: L (A w_A^2 + B w_B^2)/(A^2 w_A^2 + B^2 w_B^2). */
static inline double free_precession(double t, void *params)
{
    const struct free_body *f = params;
    double w[3], above = 0, below = 0;
    free_omega(f, t, w);
    for (int k = 0; k < 2; ++k) {
        above += f->I[k] * w[k] * w[k];
        below += f->I[k] * f->I[k] * w[k] * w[k];
    }
    return f->L * above / below;
}

/** The attitude at t by Euler's angles z, x, z about L along e3: cos theta = C w_C/L, A w_A = L sin theta sin psi. */
static inline rotor free_attitude(const struct free_body *f, double t)
{
    static const double e1[3] = {1, 0, 0}, e3[3] = {0, 0, 1};
    double w[3], phi = 0, error = 0;
    gsl_function speed = {free_precession, (void *)f};
    gsl_integration_workspace *work = gsl_integration_workspace_alloc(1000);
    if (t > 0)
        assert_int_equal(gsl_integration_qag(&speed, 0, t, 0, 1e-13, 1000, GSL_INTEG_GAUSS61, work, &phi, &error), 0);
    gsl_integration_workspace_free(work);
    free_omega(f, t, w);
    const double across = hypot(f->I[0] * w[0], f->I[1] * w[1]);
    const rotor nod = quat_turn(e1, atan2(across, f->I[2] * w[2])),
                own = quat_turn(e3, atan2(f->I[0] * w[0], f->I[1] * w[1]));
    return quat_times(quat_times(quat_turn(e3, phi), nod), own);
}

#endif
