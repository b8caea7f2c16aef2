/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Orders by a straight line through log(error) over log(h), with the interval in which its slope lies, and GSL's
 * Prince-Dormand 8(9) as the reference that the errors are measured against. */
#ifndef VTI_TESTS_FIT_H
#define VTI_TESTS_FIT_H

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_odeiv2.h>

#include "support.h"

enum { RUNGS = 5 };

/** Steps of rung k of a ladder that begins with `coarsest`: half octaves. */
static inline int fit_steps(int coarsest, int k)
{
    return (int)lround(coarsest * pow(2, 0.5 * k));
}

/** Quarter octaves, for orders of which half octaves leave no room above rounding. */
static inline int fit_short_steps(int coarsest, int k)
{
    return (int)lround(coarsest * pow(2, 0.25 * k));
}

/** For methods that remember K accelerations: above 9 steps that are stable leave few digits to fit. */
static inline double fit_slack(int K)
{
    return K < 9 ? 0.4 : 0.7;
}

/** The slope of log(e) over log(1/n) is the order, less what the next power of h adds to it on so coarse a ladder: that
 *  is seen as scatter about the line, whose 95 % interval is to hold the order within it or next to it by `slack`, and
 *  to be narrow itself. */
static inline void assert_order(const char *what, const int steps[RUNGS], const double error[RUNGS], double order,
                                double slack)
{
    double h[RUNGS], e[RUNGS], c0, c1, cov00, cov01, cov11, sum;
    for (int k = 0; k < RUNGS; ++k) {
        h[k] = -log(steps[k]);
        e[k] = log(error[k]);
    }
    gsl_fit_linear(h, 1, e, 1, RUNGS, &c0, &c1, &cov00, &cov01, &cov11, &sum);
    const double half = gsl_cdf_tdist_Pinv(0.975, RUNGS - 2) * sqrt(cov11);
    print_message("%-32s %.3f +- %.3f, errors %.1e ... %.1e\n", what, c1, half, error[0], error[RUNGS - 1]);
    assert_below(half, slack);
    assert_close(c1, order, slack + half);
}

/** A multistep method shows an order from `coarsest` steps on. square gives the square of the error of problem i after
 *  n steps: errors pass through zero here and there, mean squares over several problems do not. */
static inline void assert_multistep_order(const vti_multistep *method, int coarsest, double order, int problems,
                                          double (*square)(const vti_multistep *method, const void *all, int i, int n),
                                          const void *all)
{
    int n[RUNGS];
    double e[RUNGS];
    char what[64];
    for (int k = 0; k < RUNGS; ++k) {
        double sum = 0;
        n[k] = fit_short_steps(coarsest, k);
        for (int i = 0; i < problems; ++i)
            sum += square(method, all, i, n[k]);
        e[k] = sqrt(sum / problems);
    }
    snprintf(what, sizeof what, "AN(%d, %g), u = %g", (int)method->depth, method->c, method->u);
    assert_order(what, n, e, order, fit_slack((int)method->depth));
}

/** y(t) from y(0) by rk8pd; 1e-14 is as near to rounding as its control goes. */
static inline void fit_reference(gsl_odeiv2_system *system, double t_end, double *y)
{
    double t = 0;
    gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_y_new(system, gsl_odeiv2_step_rk8pd, 1e-2, 1e-14, 1e-14);
    assert_non_null(driver);
    const int status = gsl_odeiv2_driver_apply(driver, &t, t_end, y);
    gsl_odeiv2_driver_free(driver);
    assert_int_equal(status, GSL_SUCCESS);
}

#endif
