/* SPDX-License-Identifier: BSD-3-Clause
 * Bodies of three moments, and clumps, as all effects and measures see them; what they do is in inertia/. */
#ifndef VTI_MOMENTS_H
#define VTI_MOMENTS_H

#include "vti_views.h"

/** Whether bodies have moments and their angular momentum is known, from spin or, with an attitude, from omega. */
static inline int vti_spins_generally(const vti_bodies *b)
{
    return vti_has(&b->moments) && (vti_has(&b->spin) || vti_has(&b->omega));
}

/** L of body i with moments and a spin or, with an attitude, an Omega. */
void vti_rotor_spin(const vti_bodies *b, int64_t i, double L[3]);

/** With an attitude: the largest of |Omega|, k_r |L|, |d_x p_x| and |d_y p_y| (EQUATIONS 7.2), by which a drift turns,
 *  and the kinetic energy of rotation. */
struct vti_rotor_rates {
    double most, energy;
};
struct vti_rotor_rates vti_rotor_rates_of(const vti_bodies *b, int64_t i);

/** w = R_p diag(1/A, 1/B, 1/C) R_p^T L of body i with moments and an attitude, where L is what the view shows of it. */
void vti_rotor_over(const vti_bodies *b, int64_t i, const vti_view *L, double w[3]);

/** Of such a body, which need not have an attitude: 1/A, 1/B, 1/C and the principal axes in space. */
void vti_rotor_axes(const vti_bodies *b, int64_t i, double per[3], double axis[3][3]);

/** The turn of such a body, with an attitude, over a drift that has just been done: the rescaled Rodrigues vector of
 *  its increment, from the turn back by the same L; steady: the time and the mean of Omega before and after it, which
 *  of a sphere is constant. */
void vti_rotor_turned(const vti_bodies *b, int64_t i, const vti_drifted *drifted, int steady, double a[3]);

/** The bodies that have turned in a drift: those of an effect, or the clumps of which they are the spheres. */
static inline const vti_bodies *vti_drifted_bodies(const vti_drifted *drifted, const vti_bodies *b)
{
    return drifted->clumps != NULL ? drifted->bodies : b;
}

/** Which of them body i of the effect is, or belongs to. */
static inline int64_t vti_drifted_body(const vti_drifted *drifted, int64_t i)
{
    return drifted->clumps != NULL ? drifted->clumps->body[i] - drifted->clumps->base : i;
}

/** r = R rho of sphere s, which belongs to body i (EQUATIONS 7.5). */
static inline void vti_clump_lever(const vti_clumps *clumps, const vti_bodies *b, int64_t s, int64_t i, double r[3])
{
    double q[4];
    vti_load_pair(b, i, q);
    vti_pair_rotate(q, 1.0, clumps->offset + 3 * s, r);
}

/** F/m and RM/J of body i; 0 where there is no load, or nothing that it changes. */
static inline void vti_accelerations(const vti_bodies *b, int64_t i, double f[6])
{
    double load[3] = {0.0, 0.0, 0.0};
    for (int k = 0; k < 6; ++k)
        f[k] = 0.0;
    if (vti_has(&b->force) && vti_has(&b->v)) {
        vti_load(&b->force, i, load);
        for (int k = 0; k < 3; ++k)
            f[k] = load[k] / vti_scalar(&b->mass, i);
    }
    if (vti_has(&b->moment) && vti_spins_generally(b) && vti_has_attitude(b))
        vti_rotor_over(b, i, &b->moment, f + 3);
    else if (vti_has(&b->moment) && vti_has(&b->omega) && !vti_has(&b->moments)) {
        vti_load(&b->moment, i, load);
        for (int k = 0; k < 3; ++k)
            f[3 + k] = load[k] / vti_scalar(&b->inertia, i);
    }
}

#endif
