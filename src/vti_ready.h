/* SPDX-License-Identifier: BSD-3-Clause
 * Whether bodies, lists, effects and steppers may be worked on, and what is said of those that may not. */
#ifndef VTI_READY_H
#define VTI_READY_H

#include "vti_views.h"

/** Says in fault, unless it is NULL, which body is refused, for which value of which quantity. Returns the status. */
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

/** Marks sealed bodies: a number that memory does not hold by chance, and that is another one for a copy. */
static inline int64_t vti_seal_of(const vti_bodies *b)
{
    return INT64_C(0x7674692d7365616c) ^ (int64_t)(intptr_t)b;
}

/** 1 if the library was built with -Dchecked=true: every call then looks at all bodies and lists, sealed or not. */
#ifdef VTI_CHECKED
enum { VTI_LOOKS = 1 };
#else
enum { VTI_LOOKS = 0 };
#endif

/** vti_bodies_check that says in fault, where there is one, which quantity is wrong; where none is, fault stays as it
 *  was. */
int vti_bodies_fault(const vti_bodies *b, vti_fault *fault);

/** vti_bodies_check_values, but where nothing is wrong fault stays as it was. */
int vti_bodies_values_fault(const vti_bodies *b, vti_fault *fault);

/** VTI_E_STRIDE if components of one view meet, VTI_E_ALIAS if two views share memory. Each view is whole or absent. */
int vti_alias_check(const vti_bodies *b, vti_fault *fault);

/** vti_bodies_fault, unless the bodies are sealed. */
static inline int vti_bodies_ready_or(const vti_bodies *b, vti_fault *fault)
{
    if (b == NULL)
        return VTI_E_NULL;
    if (VTI_LOOKS)
        return vti_bodies_values_fault(b, fault);
    return b->sealed == vti_seal_of(b) ? VTI_OK : vti_bodies_fault(b, fault);
}

static inline int vti_bodies_ready(const vti_bodies *b)
{
    return vti_bodies_ready_or(b, NULL);
}

/** How many bodies lists may name, as far as is known: the fewest that views of what is read show; where these do not
 *  say, those of x or the attitude; else those up to the end of the slice. reads has bits 1 << vti_quantity, alpha or
 *  quat for an attitude in either form. */
int64_t vti_bodies_named(const vti_bodies *b, int64_t reads);

/** Whether a list that counts from base names one of n bodies so, whatever numbers these are. */
static inline int vti_is_body(int64_t named, int64_t base, int64_t n)
{
    return named >= base && (uint64_t)named - (uint64_t)base < (uint64_t)n;
}

/** VTI_OK if both bodies of a pair are in the slice. */
static inline int vti_pair_check(const vti_bodies *b, int64_t i, int64_t j)
{
    return vti_owns(b, i) && vti_owns(b, j) ? VTI_OK : VTI_E_BOND;
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

/** What an effect of nothing is: vti_effects_check refuses it. */
static inline vti_effect vti_effect_none(void)
{
    const vti_effect none = {.name = NULL};
    return none;
}

/** Momenta that forces along n break: the linear one along it, and the angular one across it. */
static inline int64_t vti_broken_along(const double n[3])
{
    int64_t breaks = 0;
    for (int k = 0; k < 3; ++k)
        if (n[k] != 0.0)
            breaks |= 1 << k | 8 << (k + 1) % 3 | 8 << (k + 2) % 3;
    return breaks;
}

/** vti_effects_check, but where nothing is wrong fault stays as it was. */
int vti_effects_fault(const vti_effect *effects, int64_t n, const vti_bodies *b, vti_fault *fault);

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

/** VTI_E_MOMENTS where bodies have moments, VTI_E_VIEW where they have views of rounding errors: multistep methods go
 *  with neither. */
static inline int vti_multistep_suits(const vti_bodies *b, vti_fault *fault)
{
    const vti_view *const low[] = {&b->x_low, &b->v_low, &b->alpha_low, &b->omega_low, &b->spin_low};
    static const int64_t named[] = {VTI_QUANTITY_X_LOW, VTI_QUANTITY_V_LOW, VTI_QUANTITY_ALPHA_LOW,
                                    VTI_QUANTITY_OMEGA_LOW, VTI_QUANTITY_SPIN_LOW};
    if (vti_has(&b->moments))
        return vti_refuse(VTI_E_MOMENTS, -1, 0.0, VTI_QUANTITY_MOMENTS, fault);
    for (int k = 0; k < 5; ++k)
        if (vti_has(low[k]))
            return vti_refuse(VTI_E_VIEW, -1, 0.0, named[k], fault);
    return VTI_OK;
}

#endif
