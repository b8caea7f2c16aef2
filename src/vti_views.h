/* SPDX-License-Identifier: BSD-3-Clause
 * Loads and stores through views, and numbers. */
#ifndef VTI_VIEWS_H
#define VTI_VIEWS_H

#include <stddef.h>

#include "vti.h"

static inline int vti_has(const vti_view *view)
{
    return view->c[0] != NULL;
}

/** x[n][3]: all vectors are one piece of memory. */
static inline int vti_is_packed(const vti_view *view)
{
    return view->stride == 3 && view->c[1] == view->c[0] + 1 && view->c[2] == view->c[0] + 2;
}

static inline int vti_has_attitude(const vti_bodies *b)
{
    return b->alpha.c[0] != NULL || b->quat.xyzw[0] != NULL;
}

static inline void vti_load(const vti_view *view, int64_t i, double r[3])
{
    for (int k = 0; k < 3; ++k)
        r[k] = view->c[k][i * view->stride];
}

/** r = a_i - a_j. Returns its square. */
static inline double vti_difference(const vti_view *view, int64_t i, int64_t j, double r[3])
{
    double of_j[3];
    vti_load(view, i, r);
    vti_load(view, j, of_j);
    for (int k = 0; k < 3; ++k)
        r[k] -= of_j[k];
    return vti_dot(r, r);
}

static inline void vti_store(const vti_view *view, int64_t i, const double r[3])
{
    for (int k = 0; k < 3; ++k)
        view->c[k][i * view->stride] = r[k];
}

static inline void vti_add(const vti_view *view, int64_t i, const double r[3])
{
    for (int k = 0; k < 3; ++k)
        view->c[k][i * view->stride] += r[k];
}

/** The attitude of body i as a quaternion (x, y, z, w) up to a positive factor, whichever way the caller stores it. */
static inline void vti_load_pair(const vti_bodies *b, int64_t i, double q[4])
{
    if (vti_has(&b->alpha)) {
        double a[3];
        vti_load(&b->alpha, i, a);
        vti_rrv_to_pair(a, q);
    } else {
        for (int k = 0; k < 4; ++k)
            q[k] = b->quat.xyzw[k][i * b->quat.stride];
    }
}

static inline double vti_scalar(const vti_scalars *s, int64_t i)
{
    return s->p[i * s->stride];
}

/** Whether s is known to have no value of body i. */
static inline int vti_ends_before(const vti_scalars *s, int64_t i)
{
    return s->count != 0 && i >= s->count;
}

/** Whether the slice has body i: loads are added to its own bodies only, so that slices may be done at once. */
static inline int vti_owns(const vti_bodies *b, int64_t i)
{
    return (uint64_t)i - (uint64_t)b->first < (uint64_t)b->count;
}

/** Centres nearer than this have no direction: the squares of their distance begin to vanish. 2^-500. */
#define VTI_COINCIDENT 3.0549363634996047e-151

/** What has decayed to less than this, in units of the caller's, is 0: the squares of it begin to vanish. 2^-500. */
#define VTI_STILL VTI_COINCIDENT

static inline double vti_settled(double a)
{
    return fabs(a) < VTI_STILL ? 0.0 * a : a;
}

static inline int vti_is_positive(double a)
{
    return isfinite(a) && a > 0.0;
}

/** The larger one; NaN if either is. */
static inline double vti_larger(double most, double x)
{
    return isnan(most) || x <= most ? most : x;
}

/** Which of the bits, of which some are 1, is the lowest of those. */
VTI_INLINE int64_t vti_first_bit(uint64_t bits)
{
#ifdef __GNUC__
    return __builtin_ctzll(bits);
#else
    int64_t n = 0;
    for (; !(bits & 1); bits >>= 1)
        ++n;
    return n;
#endif
}

/** Bodies or bonds that are gathered into arrays of their numbers and done together. */
enum { VTI_LANES = 64 };

/** Bodies that are done one number at a time: a wide load of numbers that have just been stored one by one, as forces
 *  are, has to wait until they are in the cache, which only the bodies that follow can hide. */
enum { VTI_FEW = 4 };

#endif
