/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Energies, momenta, and the norms of the errors. A measure has no status: of bodies that vti_bodies_check refuses, or
 * that cannot be compared, it is not a number. */
#ifndef VTI_MEASURE_H
#define VTI_MEASURE_H

#include "vti_effect.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- measures (EQUATIONS 4) ----------------------------------------------------------------------------------- */

/** Sum with its rounding error carried along (Neumaier). Start from {0, 0}. */
typedef struct vti_sum {
    double high; /**< the sum as far as it goes */
    double low;  /**< what it leaves out */
} vti_sum;

/** Adds x. */
static inline void vti_sum_add(vti_sum *s, double x)
{
    const double t = s->high + x;
    s->low += fabs(s->high) >= fabs(x) ? (s->high - t) + x : (x - t) + s->high;
    s->high = t;
}

/** The sum, rounded once. */
static inline double vti_sum_value(const vti_sum *s)
{
    return isinf(s->high) ? s->high : s->high + s->low; /* the error of an infinite sum is not a number */
}

/** Integral over time by the trapezoid rule at the steps, fed one value per step. Start from {{0, 0}, 0, 0}. */
typedef struct vti_integral {
    vti_sum sum;    /**< the integral so far */
    double last;    /**< the value at the last step */
    int64_t values; /**< how many there have been */
} vti_integral;

/** The value at the next step, h after the one before (h is not used for the first). */
static inline void vti_integral_add(vti_integral *q, double h, double value)
{
    if (q->values++ > 0)
        vti_sum_add(&q->sum, 0.5 * h * (q->last + value));
    q->last = value;
}

/** The integral up to the last step. */
static inline double vti_integral_value(const vti_integral *q)
{
    return vti_sum_value(&q->sum);
}

/** Sum of m|v|^2/2; 0 if nothing translates. */
VTI_API double vti_kinetic_translation(const vti_bodies *bodies);
/** Sum of J|Omega|^2/2; 0 if nothing turns. */
VTI_API double vti_kinetic_rotation(const vti_bodies *bodies);
/** Kinetic energies and all energies of the effects; NaN if an effect has more than VTI_TERMS terms, or is
 *  none. */
VTI_API double vti_energy(const vti_effect *effects, int64_t n, const vti_bodies *bodies);
/** Sum of m v. */
VTI_API void vti_momentum(const vti_bodies *bodies, double p[3]);
/** Sum of J Omega. */
VTI_API void vti_spin(const vti_bodies *bodies, double s[3]);
/** Sum of (x - about) x m v + J Omega. */
VTI_API void vti_angular_momentum(const vti_bodies *bodies, const double about[3], double l[3]);
/** Largest h|Omega|: the rotation per step. */
VTI_API double vti_max_turn(double h, const vti_bodies *bodies);
/** Integrand of ||q||^2_{H1}: sum over bodies of |x|^2 + |v|^2 + theta^2 + |Omega|^2, of the views that are present. */
VTI_API double vti_h1_density(const vti_bodies *bodies);
/** Integrand of ||q_h - q||^2_{H1}: the same of the differences, attitudes by |log(R_h R^T)|. Both slices must present the
 *  same views and have equal counts. */
VTI_API double vti_h1_distance(const vti_bodies *bodies, const vti_bodies *reference);
/** Largest attitude distance |log(R_h R^T)| over the slice, radians; 0 if nothing turns. */
VTI_API double vti_attitude_distance(const vti_bodies *bodies, const vti_bodies *reference);

#ifdef __cplusplus
}
#endif

#endif
