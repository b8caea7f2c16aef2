/* SPDX-License-Identifier: BSD-3-Clause
 * Orders of convergence, fitted. */
#ifndef VTI_FIT_H
#define VTI_FIT_H

#include <stdint.h>

/** log2(error) = log2_constant + order log2(h), over the finest two thirds of the usable points. */
struct order {
    double order;
    /** Half width: the 95 % interval of the slope (Student's t of the residuals) plus the larger change of the slope
     *  when only the finer or only the coarser half of the points is fitted, since residuals at finite h are
     *  curvature and rounding rather than noise. */
    double interval;
    double log2_constant;
    double h_min, h_max; /* of the points fitted */
    int64_t points;      /* that were fitted; with fewer than 3 usable ones order and interval are NaN */
};

/** Student's t of the 95 % interval with that many degrees of freedom, in plain arithmetic. */
double fit_student(int64_t freedom);

/** Fits n errors at n steps h, in any order. Not usable are errors that are not finite or not above floor[i]. */
struct order fit_order(const double *h, const double *error, const double *floor, int64_t n);

#endif
