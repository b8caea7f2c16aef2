/* SPDX-License-Identifier: BSD-3-Clause */
#include "fit.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>

struct line {
    double slope, constant, interval;
};

/** Least squares over n >= 3 points with the 95 % interval of the slope. */
static struct line fit_line(const double *x, const double *y, size_t n)
{
    double c0, c1, cov00, cov01, cov11, sum_of_squares;
    gsl_fit_linear(x, 1, y, 1, n, &c0, &c1, &cov00, &cov01, &cov11, &sum_of_squares);
    const struct line line = {c1, c0, gsl_cdf_tdist_Pinv(0.975, (double)(n - 2)) * sqrt(cov11)};
    return line;
}

static size_t at_least_three(int64_t n)
{
    return (size_t)(n > 3 ? n : 3);
}

struct order fit_order(const double *h, const double *error, const double *floor, int64_t n)
{
    struct order result = {NAN, NAN, NAN, NAN, NAN, 0};
    double *x = calloc((size_t)(2 * n + 1), sizeof *x), *y = x + n;
    int64_t usable = 0;
    for (int64_t i = 0; x != NULL && i < n; ++i)
        if (isfinite(error[i]) && error[i] > floor[i]) {
            x[usable] = log2(h[i]);
            y[usable++] = log2(error[i]);
        }
    result.points = usable;
    if (usable >= 3) {
        gsl_sort2(x, 1, y, 1, (size_t)usable); /* finest first */
        const size_t most = at_least_three((2 * usable + 2) / 3), half = at_least_three(((int64_t)most + 1) / 2);
        const struct line line = fit_line(x, y, most);
        const struct line fine = fit_line(x, y, half), coarse = fit_line(x + most - half, y + most - half, half);
        result.order = line.slope;
        result.interval = line.interval + fmax(fabs(line.slope - fine.slope), fabs(line.slope - coarse.slope));
        result.log2_constant = line.constant;
        result.h_min = exp2(x[0]);
        result.h_max = exp2(x[most - 1]);
        result.points = (int64_t)most;
    }
    free(x);
    return result;
}
