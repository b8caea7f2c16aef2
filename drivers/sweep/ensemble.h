/* SPDX-License-Identifier: BSD-3-Clause
 * Mean and spread of a number over an ensemble, taken in one after the other. NaN is none of its numbers. */
#ifndef VTI_ENSEMBLE_H
#define VTI_ENSEMBLE_H

#include <stdint.h>

/** Of all numbers that came in. Zeros are an empty one. */
struct ensemble {
    int64_t count, infinite; /* numbers; those that are infinite, which leave neither mean nor spread */
    double mean, squares;    /* of the others; sum of (x - mean)^2 */
};

void ensemble_add(struct ensemble *ensemble, double x);
/** NaN of none, infinite if one is. */
double ensemble_mean(const struct ensemble *ensemble);
/** The standard deviation [sum (x - mean)^2/(n - 1)]^(1/2); NaN of fewer than two, or if one is infinite. */
double ensemble_spread(const struct ensemble *ensemble);

#endif
