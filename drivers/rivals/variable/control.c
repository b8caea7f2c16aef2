/* SPDX-License-Identifier: BSD-3-Clause
 *
 * M. Galassi et al., GNU Scientific Library Reference Manual, 3rd ed. (2009), "Adaptive Step-size Control": with
 * E_i/D_i the estimated over the desired error of component i, D_i = epsilon u_i + epsilon |y_i|, u_i = 1 unless units
 * are given, r the largest of them, q = 8 the order,
 *
 *     h <- 0.9 r^(-1/q) h         if r > 1.1,  at least h/5 (and the step is made again)
 *     h <- 0.9 r^(-1/(q+1)) h     if r < 0.5,  between h and 5 h
 *
 * With a floor (control_floor) D_i is no less than h noise_i. Where GSL's own is content with NaN, it is an infinite
 * error here: a step that meets it is made again. */
#include "control.h"

#include <math.h>
#include <stdlib.h>

static const double safety = 0.9, most = 5.0;

struct settings {
    double epsilon;
    const double *unit;          /* NULL: 1 */
    struct control_floor *floor; /* NULL: none */
};

static void *create(void)
{
    return calloc(1, sizeof(struct settings));
}

static int init(void *state, double absolute, double relative, double a_y, double a_dydt)
{
    (void)relative, (void)a_y, (void)a_dydt;
    ((struct settings *)state)->epsilon = absolute;
    return 0;
}

static double unit_of(const struct settings *s, size_t i)
{
    return s->unit != NULL ? s->unit[i] : 1.0;
}

static double desired(const struct settings *s, size_t i, double y)
{
    return s->epsilon * fabs(y) + s->epsilon * unit_of(s, i);
}

/** The least error that can be had of component i by a step h. */
static double least(const struct settings *s, size_t i, double h)
{
    return s->floor != NULL ? fabs(h) * s->floor->noise[i] : 0.0;
}

/** A step h is taken. */
static void note_floor(const struct settings *s, size_t n, const double y[], double h)
{
    double largest = 0.0;
    for (size_t i = 0; i < n && s->floor != NULL; ++i)
        if (least(s, i, h) > desired(s, i, y[i])) {
            largest = fmax(largest, least(s, i, h));
            s->floor->highest = fmax(s->floor->highest, least(s, i, h) / unit_of(s, i));
        }
    if (largest > 0.0)
        s->floor->squares += largest * largest;
}

static double eighth_root(double r)
{
    return sqrt(sqrt(sqrt(r)));
}

/** Of 1e-8 < r < 1: Newton's method for y^9 = r comes down to it from 1, until rounding stops it. */
static double ninth_root(double r)
{
    double y = 2.0, next = 1.0;
    while (next < y) {
        y = next;
        const double y2 = y * y, y4 = y2 * y2;
        next = y - (y - r / (y4 * y4)) / 9.0;
    }
    return y;
}

/** The larger one; a share that is NaN is larger than all. */
static double worst_of(double r, double share)
{
    return isnan(share) ? INFINITY : fmax(r, share);
}

static int adjust(void *state, size_t n, unsigned int order, const double y[], const double error[],
                  const double rate[], double *h)
{
    const struct settings *s = state;
    double r = 0.0;
    (void)order, (void)rate;
    for (size_t i = 0; i < n; ++i)
        r = worst_of(r, fabs(error[i]) / fmax(desired(s, i, y[i]), least(s, i, *h)));
    if (r > 1.1) {
        *h *= fmax(safety / eighth_root(r), 1.0 / most);
        return GSL_ODEIV_HADJ_DEC;
    }
    note_floor(s, n, y, *h);
    if (r < 0.5) {
        *h *= r < 1e-8 ? most : fmin(fmax(safety / ninth_root(r), 1.0), most);
        return GSL_ODEIV_HADJ_INC;
    }
    return GSL_ODEIV_HADJ_NIL;
}

static int level(void *state, const double y, const double rate, const double h, const size_t i, double *found)
{
    (void)rate, (void)h;
    *found = desired(state, i, y);
    return 0;
}

static int set_driver(void *state, const gsl_odeiv2_driver *driver)
{
    (void)state, (void)driver;
    return 0;
}

void control_in_units(gsl_odeiv2_control *control, const double *unit)
{
    ((struct settings *)control->state)->unit = unit;
}

void control_stop_at(gsl_odeiv2_control *control, struct control_floor *floor)
{
    ((struct settings *)control->state)->floor = floor;
}

gsl_odeiv2_control *control_new(double epsilon)
{
    static const gsl_odeiv2_control_type plain = {"plain", create, init, adjust, level, set_driver, free};
    gsl_odeiv2_control *control = gsl_odeiv2_control_alloc(&plain);
    if (control != NULL)
        gsl_odeiv2_control_init(control, epsilon, epsilon, 1.0, 0.0);
    return control;
}
