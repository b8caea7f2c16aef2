/* SPDX-License-Identifier: BSD-3-Clause
 * Mean and spread of a number over an ensemble, taken in one after the other. */
#ifndef VTI_ENSEMBLE_H
#define VTI_ENSEMBLE_H

#include <stdint.h>

/** Of all numbers that came in and are finite. Zeros are an empty one. */
struct ensemble {
    int64_t count;
    double mean, squares; /* sum of (x - mean)^2 */
};

void ensemble_add(struct ensemble *ensemble, double x);
/** NaN of none. */
double ensemble_mean(const struct ensemble *ensemble);
/** The standard deviation [sum (x - mean)^2/(n - 1)]^(1/2); NaN of fewer than two. */
double ensemble_spread(const struct ensemble *ensemble);

#endif
