/* SPDX-License-Identifier: BSD-3-Clause */
#include "fit.h"

#include <gsl/gsl_fit.h>
#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>

#include "plain.h"
#include "vti_rrv.h"

/** P(|T| < t) for f degrees of freedom (M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 26.7.3 and 4):
 *  with theta = atan(t/sqrt f), s and c its sine and cosine,
 *
 *      f even:  s (1 + 1/2 c^2 + (1 3)/(2 4) c^4 + ... up to c^(f-2))
 *      f odd:   2/pi [theta + s (c + 2/3 c^3 + (2 4)/(3 5) c^5 + ... up to c^(f-2))] */
static double student(double t, int64_t f)
{
    static const double two_over_pi = 0.63661977236758134;
    const double freedom = (double)f, hypotenuse = sqrt(freedom + t * t), s = t / hypotenuse,
                 c = sqrt(freedom) / hypotenuse;
    const int odd = (int)(f % 2);
    double term = odd ? c : 1.0, sum = 0.0;
    for (int64_t power = odd; power <= f - 2; power += 2) {
        sum += term;
        term *= c * c * (double)(power + 1) / (double)(power + 2);
    }
    return odd ? two_over_pi * (vti_arc(t, sqrt(freedom)) + s * sum) : s * sum;
}

double fit_student(int64_t freedom)
{
    double low = 1.0, high = 16.0, middle = 4.0;
    while (middle > low && middle < high) {
        if (student(middle, freedom) < 0.95)
            low = middle;
        else
            high = middle;
        middle = 0.5 * (low + high);
    }
    return middle;
}

struct line {
    double slope, constant, interval;
};

/** Least squares over n >= 3 points with the 95 % interval of the slope. */
static struct line fit_line(const double *x, const double *y, size_t n)
{
    double c0, c1, cov00, cov01, cov11, sum_of_squares;
    gsl_fit_linear(x, 1, y, 1, n, &c0, &c1, &cov00, &cov01, &cov11, &sum_of_squares);
    const struct line line = {c1, c0, fit_student((int64_t)n - 2) * sqrt(cov11)};
    return line;
}

static size_t at_least_three(int64_t n)
{
    return (size_t)(n > 3 ? n : 3);
}

struct order fit_order(const double *h, const double *error, const double *floor, int64_t n)
{
    struct order result = {NAN, NAN, NAN, NAN, NAN, 0};
    double *const x = calloc((size_t)(2 * n + 1), sizeof *x), *const y = x != NULL ? x + n : NULL;
    int64_t usable = 0;
    for (int64_t i = 0; x != NULL && i < n; ++i)
        if (isfinite(error[i]) && error[i] > floor[i]) {
            x[usable] = plain_log2(h[i]);
            y[usable++] = plain_log2(error[i]);
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
        result.h_min = plain_exp2(x[0]);
        result.h_max = plain_exp2(x[most - 1]);
        result.points = (int64_t)most;
    }
    free(x);
    return result;
}
