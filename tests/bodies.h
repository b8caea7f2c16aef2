/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Views on bodies that a test keeps in packed arrays, and a stepper that is a drift alone. No test library: digest.h
 * has to build wherever the core does. */
#ifndef VTI_TESTS_BODIES_H
#define VTI_TESTS_BODIES_H

#include <stddef.h>

#include "vti.h"

/** q[n][4], w last. */
static inline vti_quat_view quats_packed(double *q)
{
    const vti_quat_view view = {{q, q + 1, q + 2, q + 3}, 4, 0};
    return view;
}

/** The attitude is quat, or alpha where quat is NULL. */
static inline vti_bodies bodies_packed(int64_t n, double *x, double *v, double *force, double *alpha, double *quat,
                                       double *omega, double *moment, const double *mass, const double *inertia)
{
    vti_bodies b = vti_bodies_none(n);
    b.x = vti_view_packed(x);
    b.v = vti_view_packed(v);
    b.force = vti_view_packed(force);
    if (quat != NULL)
        b.quat = quats_packed(quat);
    else
        b.alpha = vti_view_packed(alpha);
    b.omega = vti_view_packed(omega);
    b.moment = vti_view_packed(moment);
    b.mass = vti_scalars_array(mass);
    b.inertia = vti_scalars_array(inertia);
    return b;
}

/** The n bodies of a struct *s whose arrays have these names. A macro, because their lengths are the struct's own. */
#define bodies_of(s, n, by_quat)                                                                                       \
    bodies_packed(n, (s)->x[0], (s)->v[0], (s)->force[0], (s)->alpha[0], (by_quat) ? (s)->quat[0] : NULL,              \
                  (s)->omega[0], (s)->moment[0], (s)->mass, (s)->inertia)

/** A drift of that law and rotor, of -h where it goes back, as a stepper that has nothing else. */
static inline vti_stepper drift_alone(int64_t law, int64_t rotor_order, int back)
{
    static const double none[] = {0, 0}, ahead[] = {1, 0}, behind[] = {-1, 0};
    const vti_stepper own = {.name = "drift",
                             .law = law,
                             .frame = VTI_FRAME_SPACE,
                             .stages = 1,
                             .evals = 1,
                             .kick = none,
                             .drift = back ? behind : ahead,
                             .rotor = rotor_order};
    return own;
}

#endif
