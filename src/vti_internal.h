/* SPDX-License-Identifier: BSD-3-Clause
 * What the files of the core share: loads and stores through views, and the primitives without their checks. */
#ifndef VTI_INTERNAL_H
#define VTI_INTERNAL_H

#include <stddef.h>

#include "vti.h"

/** Says in fault, where there is one, which body is refused, for which value and of which quantity. Returns the status.
 *  */
static inline int vti_refuse(int status, int64_t body, double value, int64_t quantity, vti_fault *fault)
{
    if (fault != NULL) {
        fault->body = body;
        fault->value = value;
        fault->quantity = quantity;
    }
    return status;
}

/** The same where it is not about the bodies. */
static inline int vti_refuse_none(int status, vti_fault *fault)
{
    return vti_refuse(status, -1, 0.0, VTI_QUANTITY_NONE, fault);
}

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

static inline double vti_scalar(const vti_scalars *s, int64_t i)
{
    return s->p[i * s->stride];
}

/** Whether s is known to have no value of body i. */
static inline int vti_ends_before(const vti_scalars *s, int64_t i)
{
    return s->count != 0 && i >= s->count;
}

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

/** The turn of such a body, with an attitude, over a drift that has just been done: the rescaled Rodrigues vector of its
 *  increment, from the turn back by the same L; steady: the time and the mean of Omega before and after it, which of a
 *  sphere is constant. */
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

/** The larger one; NaN if either is. */
static inline double vti_larger(double most, double x)
{
    return isnan(most) || x <= most ? most : x;
}

/** Whether the slice has body i: loads are added to its own bodies only, so that slices may be done at once. */
static inline int vti_owns(const vti_bodies *b, int64_t i)
{
    return (uint64_t)i - (uint64_t)b->first < (uint64_t)b->count;
}

/** VTI_OK if both bodies of a pair are in the slice. */
static inline int vti_pair_check(const vti_bodies *b, int64_t i, int64_t j)
{
    return vti_owns(b, i) && vti_owns(b, j) ? VTI_OK : VTI_E_BOND;
}

/** Marks sealed bodies: a number that memory does not hold by chance, and that is another one for a copy. */
static inline int64_t vti_seal_of(const vti_bodies *b)
{
    return INT64_C(0x7674692d7365616c) ^ (int64_t)(intptr_t)b;
}

/** vti_bodies_check that says in fault, where there is one, which quantity is wrong; where none is, fault stays as it
 *  was. */
int vti_bodies_fault(const vti_bodies *b, vti_fault *fault);

/** VTI_E_STRIDE if components of one view meet, VTI_E_ALIAS if two views share memory. Each view is whole or absent. */
int vti_alias_check(const vti_bodies *b, vti_fault *fault);

/** vti_bodies_check_values, but where nothing is wrong fault stays as it was. */
int vti_bodies_values_fault(const vti_bodies *b, vti_fault *fault);

/** 1 if the library was built with -Dchecked=true: every call then looks at all of its bodies and lists, sealed or not.
 *  */
#ifdef VTI_CHECKED
enum { VTI_LOOKS = 1 };
#else
enum { VTI_LOOKS = 0 };
#endif

/** vti_bodies_fault, unless the bodies are sealed. */
static inline int vti_bodies_ready_or(const vti_bodies *b, vti_fault *fault)
{
    if (b == NULL)
        return VTI_E_NULL;
    if (VTI_LOOKS)
        return vti_bodies_values_fault(b, fault);
    return b->sealed == vti_seal_of(b) ? VTI_OK : vti_bodies_fault(b, fault);
}

/** How many bodies lists may name, as far as is known: the fewest that views of what is read show; where these do not say,
 *  those of x or the attitude; else those up to the end of the slice. reads has bits 1 << vti_quantity, alpha or quat for
 *  an attitude in either form. */
int64_t vti_bodies_named(const vti_bodies *b, int64_t reads);

static inline int vti_bodies_ready(const vti_bodies *b)
{
    return vti_bodies_ready_or(b, NULL);
}

/** What an effect of nothing is: vti_effects_check refuses it. */
static inline vti_effect vti_effect_none(void)
{
    const vti_effect none = {.name = NULL};
    return none;
}

VTI_INLINE int vti_bonds_has_list(const vti_bonds *bonds)
{
    return bonds->count <= 0 || (bonds->pair != NULL && bonds->rest != NULL);
}

/** VTI_E_INERTIA where spheres turn and their inertia is not known. */
static inline int vti_inertia_check(const vti_bodies *b)
{
    return vti_has(&b->omega) && !vti_has(&b->moments) && b->inertia.p == NULL ? VTI_E_INERTIA : VTI_OK;
}

/** Whether contacts, walls and bonds may be worked on: what can be seen at once, or everything where the library was
 *  built to look. reads: what is read of the bodies of pairs, as in vti_bodies_named;
 *  of bonds beside what their terms read. */
int vti_contacts_ready(const vti_contacts *contacts, const vti_bodies *b, int64_t reads);
int vti_walls_ready(const vti_walls *p, const vti_bodies *b);
int vti_bonds_ready(const vti_bonds *p, const vti_bodies *b, int64_t reads);

/** The same of what touches, of which either may be NULL. */
static inline int vti_touches_ready(const vti_contacts *contacts, const vti_walls *walls, const vti_bodies *b,
                                    int64_t reads)
{
    const int status = contacts != NULL ? vti_contacts_ready(contacts, b, reads) : VTI_OK;
    return status == VTI_OK && walls != NULL ? vti_walls_ready(walls, b) : status;
}

/** VTI_OK if the library has such a law and frame. */
static inline int vti_law_check(int64_t law, int64_t frame)
{
    if (law < VTI_LAW_CLOSED || law > VTI_LAW_EXACT9)
        return VTI_E_STEPPER;
    return frame == VTI_FRAME_SPACE || frame == VTI_FRAME_BODY ? VTI_OK : VTI_E_FRAME;
}

/** Whether a free body's turn may be of that order; 0 stands for 2. */
static inline int vti_is_rotor(int64_t order)
{
    return order >= 0 && order <= 6 && order % 2 == 0;
}

/** Whether it is a list of kicks and drifts. */
static inline int vti_stepper_check(const vti_stepper *method)
{
    if (method == NULL || method->kick == NULL || method->drift == NULL)
        return VTI_E_STEPPER;
    if (method->stages < 1)
        return VTI_E_STAGE;
    const int status = vti_law_check(method->law, method->frame);
    return status == VTI_OK && !vti_is_rotor(method->rotor) ? VTI_E_STEPPER : status;
}

/** VTI_E_FRAME where it is of the body's frame, and bodies have moments. */
static inline int vti_stepper_suits(const vti_stepper *method, const vti_bodies *b, vti_fault *fault)
{
    return method->frame != VTI_FRAME_SPACE && vti_has(&b->moments)
               ? vti_refuse(VTI_E_FRAME, -1, 0.0, VTI_QUANTITY_MOMENTS, fault)
               : VTI_OK;
}

/** vti_effects_check, but where nothing is wrong fault stays as it was. */
int vti_effects_fault(const vti_effect *effects, int64_t n, const vti_bodies *b, vti_fault *fault);

/** Whether the kernels for these vector units were compiled, and serve here. */
static inline int vti_serves_avx2(void)
{
#ifdef VTI_HAS_AVX2
    return __builtin_cpu_supports("avx2") != 0;
#else
    return 0;
#endif
}

static inline int vti_serves_avx512(void)
{
#ifdef VTI_HAS_AVX512
    return __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
#else
    return 0;
#endif
}

/** Whether the processor is AMD's, for what costs time only. */
static inline int vti_is_amd(void)
{
#if (defined(__x86_64__) || defined(__i386__)) && defined(__GNUC__)
    return __builtin_cpu_is("amd") != 0;
#else
    return 0;
#endif
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

/** Whether a list that counts from base names one of n bodies so, whatever numbers these are. */
static inline int vti_is_body(int64_t named, int64_t base, int64_t n)
{
    return named >= base && (uint64_t)named - (uint64_t)base < (uint64_t)n;
}

/** Bodies or bonds that are gathered into arrays of their numbers and done together. */
enum { VTI_LANES = 64 };

/** Bodies that are done one number at a time: a wide load of numbers that have just been stored one by one, as forces
 *  are, has to wait until they are in the cache, which only the bodies that follow can hide. */
enum { VTI_FEW = 4 };

#endif
