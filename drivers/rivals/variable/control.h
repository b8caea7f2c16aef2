/* SPDX-License-Identifier: BSD-3-Clause
 *
 * GSL's choice of steps for rk8pd in plain arithmetic: GSL's own calls pow, whose last bit depends on the
 * processor's vector units, and with it every step after. */
#ifndef VTI_RIVALS_CONTROL_H
#define VTI_RIVALS_CONTROL_H

#include <gsl/gsl_odeiv2.h>

/** As gsl_odeiv2_control_y_new(epsilon, epsilon), for a stepper of order 8. NULL if there is no memory. */
gsl_odeiv2_control *control_new(double epsilon);

/** From now on the absolute part of what is desired of component i is epsilon unit[i]. */
void control_in_units(gsl_odeiv2_control *control, const double *unit);

/** What rounding leaves of a smaller error: a step h cannot know component i better than h noise[i], noise[i] being
 *  what the last bits of a state change in its rate. */
struct control_floor {
    const double *noise; /* [components] */
    double highest;      /* largest h noise[i]/unit[i] above the error that was asked for; 0: there was none */
    double squares;      /* the sum of the squares of the largest of each such step: they add up by chance */
};

/** From now on no step is asked for less, and *floor, which must outlive the control, notes where that mattered. */
void control_stop_at(gsl_odeiv2_control *control, struct control_floor *floor);

#endif
