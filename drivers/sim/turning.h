/* SPDX-License-Identifier: BSD-3-Clause
 * By what angle a step turns a body, and how far that is from h|Omega| (EQUATIONS 2). Nothing here calls libm but for
 * square roots, so that what is reported has the same bits everywhere. */
#ifndef VTI_TURNING_H
#define VTI_TURNING_H

#include "vti.h"

/** The angle, from 0 on and not folded at full turns, by which a drift of the law (vti_law) turns a body of t|Omega| = s >= 0:
 *  asin s (closed; s <= 1 is taken for more), 2 atan(s/2) (Cayley), 2 atan2(v, c) of the pair (c, v) of the exact laws. */
double turning_angle(int64_t law, double s);

/** Sum over the stepper's drifts a_k h of | turning_angle(a_k s) - a_k s |, as a share of s = h|Omega|. 0 for s = 0, and for a
 *  stepper that is not made of drifts. */
double turning_error(const vti_stepper *stepper, double s);

/** The largest turning_error that is no cause for a remark. Exact laws are meant to turn by h|Omega|: 1e-3. The angles of
 *  the others err as s^2/12 and s^2/6, which their order says already: 0.1, at h|Omega| = 1.2 (Cayley) and 0.7 (closed). */
double turning_tolerance(const vti_stepper *stepper);

#endif
