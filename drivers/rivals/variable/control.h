/* SPDX-License-Identifier: BSD-3-Clause
 *
 * GSL's choice of steps for rk8pd in plain arithmetic: GSL's own calls pow, whose last bit depends on the
 * processor's vector units, and with it every step after. */
#ifndef VTI_RIVALS_CONTROL_H
#define VTI_RIVALS_CONTROL_H

#include <gsl/gsl_odeiv2.h>

/** As gsl_odeiv2_control_y_new(epsilon, epsilon), for a stepper of order 8. NULL if there is no memory. */
gsl_odeiv2_control *control_new(double epsilon);

#endif
