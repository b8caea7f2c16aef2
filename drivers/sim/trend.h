/* SPDX-License-Identifier: BSD-3-Clause
 * The slope of a long series in little memory: means over blocks that grow with the series, and a line through them. */
#ifndef VTI_TREND_H
#define VTI_TREND_H

#include <stdint.h>

enum { TREND_BLOCKS = 64 };

/** All doubles, so that it can be kept as a row of numbers. Start from zeros. */
struct trend {
    double blocks, width, filled;            /* whole blocks, values in each, values in the one that is being filled */
    double t[TREND_BLOCKS], y[TREND_BLOCKS]; /* means */
    double t_sum, y_sum;                     /* of the block that is being filled */
};

void trend_add(struct trend *s, double t, double y);

/** Least squares over the whole blocks: y per t, and its standard error by what the line leaves. Values that lie near each
 *  other in time are not independent; means over the 32 to 64 blocks of a long series nearly are. NaN below four blocks. */
void trend_slope(const struct trend *s, double *slope, double *error);

#endif
