/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Hertz's law (EQUATIONS 3, E4), for contacts and walls. With o = [1 - gap/L]_+ the overlap as a share of L:
 *
 *     U = 2/5 K o^{5/2},     |F| = (K/L) o^{3/2}
 *
 * and of a material (EQUATIONS 6.6)
 *
 *     K = k_H L^{5/2},  k_H = (4/3) E* sqrt(R*),  1/E* = 1/M_i + 1/M_j,  1/R* = 1/R_i + 1/R_j,  M = E/(1 - nu^2). */
#ifndef VTI_HERTZ_H
#define VTI_HERTZ_H

#include "../vti_views.h"

/** |F| of the overlap o > 0 on the length L. V is double, or a vector of them. */
#define VTI_HERTZ_FORCE(NAME, V, SQRT)                                                                                 \
    VTI_INLINE V NAME(V stiffness, V length, V o)                                                                      \
    {                                                                                                                  \
        return stiffness / length * o * SQRT(o);                                                                       \
    }
VTI_HERTZ_FORCE(vti_hertz_force, double, sqrt)

static inline double vti_hertz_energy(double stiffness, double o)
{
    return 0.4 * stiffness * o * o * sqrt(o);
}

/** d^2U/do^2 = (3/2) K o^{1/2} */
static inline double vti_hertz_stiffness(double stiffness, double o)
{
    return 1.5 * stiffness * sqrt(o >= 0.0 ? o : NAN);
}

/** K = (4/3) E* sqrt(R*) L^{5/2} */
static inline double vti_hertz_material(double modulus, double radius, double length)
{
    return 4.0 / 3.0 * modulus * length * length * sqrt(radius * length);
}

/** 1/(1/a + 1/b): E* and R* of two. */
static inline double vti_hertz_reduced(double a, double b)
{
    return 1.0 / (1.0 / a + 1.0 / b);
}

/* ---- pairs of a list --------------------------------------------------------------------------------------------- */

/** Whether there is a list, and diameters. */
static inline int vti_contacts_list_check(const vti_contacts *p)
{
    if (p->diameter.p == NULL || (p->count > 0 && p->pair == NULL))
        return VTI_E_NULL;
    return p->count < 0 ? VTI_E_COUNT : VTI_OK;
}

/** L: at which distance pair k begins to touch, which is that of bodies i and j. */
static inline double vti_contact_length(const vti_contacts *p, int64_t k, int64_t i, int64_t j)
{
    return p->length.p != NULL ? vti_scalar(&p->length, k)
                               : 0.5 * vti_scalar(&p->diameter, i) + 0.5 * vti_scalar(&p->diameter, j);
}

/** Body of pair k, from 0, on side 0 or 1. */
static inline int64_t vti_contact_body(const vti_contacts *p, int64_t k, int side)
{
    return p->pair[2 * k + side] - p->base;
}

/** K of bodies i and j, which begin to touch at that length. */
static inline double vti_contact_stiffness(const vti_contacts *p, int64_t i, int64_t j, double length)
{
    if (p->modulus.p == NULL)
        return p->stiffness;
    return vti_hertz_material(vti_hertz_reduced(vti_scalar(&p->modulus, i), vti_scalar(&p->modulus, j)),
                              vti_hertz_reduced(0.5 * vti_scalar(&p->diameter, i), 0.5 * vti_scalar(&p->diameter, j)),
                              length);
}

#endif
