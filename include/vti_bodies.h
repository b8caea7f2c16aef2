/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Bodies as views of the caller's memory, and one table of what they consist of. */
#ifndef VTI_BODIES_H
#define VTI_BODIES_H

#include "vti_rrv.h"
#include "vti_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What bodies consist of: ROW(constant, number, member, type, role) in the order of the members of vti_bodies. STATE
 *  is what a step moves, LOAD what it moves it by, CONSTANT what that is divided by, LOW the rounding error of a state.
 *  A new view stands here, in vti_bodies and in fortran/vti_types.f90. */
/* clang-format off */
#define VTI_QUANTITIES(ROW)                                                                                            \
    ROW(VTI_QUANTITY_X, 1, x, vti_view, STATE)                                                                         \
    ROW(VTI_QUANTITY_V, 2, v, vti_view, STATE)                                                                         \
    ROW(VTI_QUANTITY_FORCE, 3, force, vti_view, LOAD)                                                                  \
    ROW(VTI_QUANTITY_ALPHA, 4, alpha, vti_view, STATE)                                                                 \
    ROW(VTI_QUANTITY_QUAT, 5, quat, vti_quat_view, STATE)                                                              \
    ROW(VTI_QUANTITY_OMEGA, 6, omega, vti_view, STATE)                                                                 \
    ROW(VTI_QUANTITY_MOMENT, 7, moment, vti_view, LOAD)                                                                \
    ROW(VTI_QUANTITY_MASS, 8, mass, vti_scalars, CONSTANT)                                                             \
    ROW(VTI_QUANTITY_INERTIA, 9, inertia, vti_scalars, CONSTANT)                                                       \
    ROW(VTI_QUANTITY_X_LOW, 10, x_low, vti_view, LOW)                                                                  \
    ROW(VTI_QUANTITY_V_LOW, 11, v_low, vti_view, LOW)                                                                  \
    ROW(VTI_QUANTITY_ALPHA_LOW, 12, alpha_low, vti_view, LOW)                                                          \
    ROW(VTI_QUANTITY_OMEGA_LOW, 13, omega_low, vti_view, LOW)                                                          \
    ROW(VTI_QUANTITY_MOMENTS, 14, moments, vti_view, CONSTANT)                                                         \
    ROW(VTI_QUANTITY_SPIN, 15, spin, vti_view, STATE)                                                                  \
    ROW(VTI_QUANTITY_PRINCIPAL, 16, principal, vti_quat_view, CONSTANT)                                                \
    ROW(VTI_QUANTITY_SPIN_LOW, 17, spin_low, vti_view, LOW)
/* clang-format on */

/** A member of vti_bodies, as vti_fault names it. */
enum vti_quantity {
    VTI_QUANTITY_NONE = 0 /**< none of them */
/** @cond */
#define VTI_QUANTITY_CONSTANT(constant, number, member, type, role) , constant = (number)
    VTI_QUANTITIES(VTI_QUANTITY_CONSTANT)
#undef VTI_QUANTITY_CONSTANT
    /** @endcond */
};

/** The member of vti_bodies that a vti_quantity is, by its name: "x", "alpha_low"; "value", which reads well in its
 *  place, for VTI_QUANTITY_NONE and for any other number. Never NULL. */
VTI_API const char *vti_quantity_text(int64_t quantity);

/** Where and why a call failed: the body (index into the views, from 0), the value and the quantity. If it is not about
 *  one body, body is -1, and value the time step for VTI_E_TIME, what is one for all for VTI_E_MASS, VTI_E_INERTIA and
 *  VTI_E_MOMENTS, the steps that are known for VTI_E_PAST, else 0. quantity is what VTI_E_VIEW, VTI_E_STRIDE,
 *  VTI_E_ALIAS, VTI_E_MASS, VTI_E_INERTIA, VTI_E_MOMENTS, VTI_E_NEEDS, VTI_E_TOO_LARGE and VTI_E_STATE are about, and
 *  VTI_E_FRAME where it is moments, the first that was found; of two views that share memory, or that cannot go
 *  together, the one that vti_quantity has later. For VTI_E_COUNT it is the view that is too short, and value how many
 *  that shows, if one is. For all else, bonds and contacts too, it is VTI_QUANTITY_NONE. */
typedef struct vti_fault {
    int64_t body;     /**< index of the body, from 0; -1 if it is not about one */
    double value;     /**< what is wrong about it */
    int64_t quantity; /**< vti_quantity: what of the body is wrong, or of all bodies; vti_quantity_text names it */
} vti_fault;

/* ---- bodies as views ----------------------------------------------------------------------------------------- */

/** n three-vectors in the caller's memory: component k of vector i is c[k][i*stride] (stride in doubles).
 *  c = {NULL, NULL, NULL} means that the quantity, and all physics that needs it, is absent. */
typedef struct vti_view {
    double *c[3];   /**< the components of vector 0 */
    int64_t stride; /**< from one vector to the next, in doubles; negative is backwards */
    int64_t count;  /**< how many vectors there are, so that more bodies are refused; 0 if that is not known */
} vti_view;

/** n quaternions; component k (x, y, z, w) of quaternion i is xyzw[k][i*stride]. */
typedef struct vti_quat_view {
    double *xyzw[4]; /**< the components of quaternion 0; w is the real part */
    int64_t stride;  /**< from one quaternion to the next, in doubles */
    int64_t count;   /**< how many there are; 0 if that is not known */
} vti_quat_view;

/** n positive numbers p[i*stride]; stride 0 is one value for all. */
typedef struct vti_scalars {
    const double *p; /**< number 0; NULL is absent */
    int64_t stride;  /**< from one number to the next, in doubles */
    int64_t count;   /**< how many there are; 0 if that is not known, or one for all */
} vti_scalars;

/** A slice of the caller's bodies. Absent views are absent physics: without x or v nothing translates, without an
 *  attitude or omega nothing turns, without force or moment nothing is kicked, and nothing is spent on it. Effects that
 *  read what is absent are refused. mass is needed for a force and for momenta, inertia for a moment and for spin. Give
 *  the attitude as alpha or as a quaternion, never as both. Mass and inertia are finite: a body that is held is one
 *  outside the slice that is stepped, as effects act across slices. Flows (dashpots) change both bodies of a pair:
 *  where they act on it, it has a mass and an inertia of 1e300, too. Start from vti_bodies_none().
 *
 *  With moments a body has the inertia R_p diag(A, B, C) R_p^T, R_p = R(attitude) R(principal), in the place of J, and
 *  turns by spin, L: kicks are L += t RM, drifts leave L as it is, to the bit. Where omega is shown beside spin, steps,
 *  kicks and drifts write Omega = R_p diag(1/A, 1/B, 1/C) R_p^T L there, and read it nowhere. Where it is shown alone,
 *  with an attitude, the same map is done on Omega. inertia and omega_low do not go with moments; where there is
 *  spin, there are moments. */
typedef struct vti_bodies {
    int64_t abi;         /**< VTI_ABI */
    int64_t sealed;      /**< 0, or what vti_bodies_seal has put here, good in this object only, not in a copy */
    int64_t first;       /**< index of the first body of the slice, 0-based */
    int64_t count;       /**< bodies in the slice, >= 0 */
    vti_view x;          /**< position of the centre */
    vti_view v;          /**< velocity of the centre */
    vti_view force;      /**< F */
    vti_view alpha;      /**< attitude, rescaled Rodrigues vector */
    vti_quat_view quat;  /**< or attitude, unit quaternion */
    vti_view omega;      /**< Omega, spatial angular velocity */
    vti_view moment;     /**< RM, spatial moment about the centre */
    vti_scalars mass;    /**< m */
    vti_scalars inertia; /**< J, of spheres */
    /* Rounding errors carried along (compensated sums): what x, v, alpha and omega leave out, starting from 0. Each is
     * absent, or goes with its quantity; then its additions are exact to second order in eps. */
    vti_view x_low;     /**< what x leaves out */
    vti_view v_low;     /**< what v leaves out */
    vti_view alpha_low; /**< what alpha leaves out */
    vti_view omega_low; /**< what omega leaves out */
    /* General inertia (EQUATIONS 7): bodies of three principal moments, which need not be spheres. */
    vti_view moments;        /**< A, B, C about the principal axes; absent: spheres; stride 0: one body's for all */
    vti_view spin;           /**< L, spatial angular momentum about the centre of mass */
    vti_quat_view principal; /**< takes the principal axes to the body's; absent: they are; stride 0: one for all */
    vti_view spin_low;       /**< what spin leaves out */
} vti_bodies;

/** No view: what it would show is absent. */
static inline vti_view vti_view_none(void)
{
    vti_view view = {{0, 0, 0}, 0, 0};
    return view;
}

/** x[n][3] in C, x(3,n) in Fortran. */
static inline vti_view vti_view_packed(double *p)
{
    vti_view view = {{p, p + 1, p + 2}, 3, 0};
    return view;
}

/** Three arrays of n; x(n,3) in Fortran is {x, x + n, x + 2n}. */
static inline vti_view vti_view_separate(double *x, double *y, double *z)
{
    vti_view view = {{x, y, z}, 1, 0};
    return view;
}

/** A double[3] member of an array of structs: p is the member in element 0, bytes the size of a struct. That must be
 *  a multiple of sizeof(double); otherwise the view is of stride 0, which is refused for more than one body. */
static inline vti_view vti_view_member(double *p, int64_t bytes)
{
    const int64_t size = sizeof(double);
    vti_view view = {{p, p + 1, p + 2}, bytes % size == 0 ? bytes / size : 0, 0};
    return view;
}

/** One value for all. */
static inline vti_scalars vti_scalars_one(const double *value)
{
    vti_scalars s = {value, 0, 0};
    return s;
}

/** One value for each body. */
static inline vti_scalars vti_scalars_array(const double *values)
{
    vti_scalars s = {values, 1, 0};
    return s;
}

/** A double member of an array of structs: p is the member in element 0, bytes the size of a struct. That must be a
 *  multiple of sizeof(double); otherwise the values are absent, which is refused where they are needed; a term of bonds
 *  is off without. */
static inline vti_scalars vti_scalars_member(const double *p, int64_t bytes)
{
    const int64_t size = sizeof(double);
    vti_scalars s = {bytes % size == 0 && bytes != 0 ? p : 0, bytes / size, 0};
    return s;
}

/** n bodies, all views absent. */
static inline vti_bodies vti_bodies_none(int64_t n)
{
    const vti_view no_vti_view = {{0, 0, 0}, 0, 0};
    const vti_quat_view no_vti_quat_view = {{0, 0, 0, 0}, 0, 0};
    const vti_scalars no_vti_scalars = {0, 0, 0};
    /** @cond */
#define VTI_NO_VIEW(constant, number, member, type, role) , no_##type
    const vti_bodies b = {VTI_ABI, 0, 0, n VTI_QUANTITIES(VTI_NO_VIEW)};
#undef VTI_NO_VIEW
    /** @endcond */
    return b;
}

/** The same bodies, restricted to count of them from first. */
static inline vti_bodies vti_bodies_slice(vti_bodies b, int64_t first, int64_t count)
{
    b.first = first;
    b.count = count;
    b.sealed = 0;
    return b;
}

/** What can be seen without looking at a body: ABI, counts, views that are half given or too short, strides of 0 or by
 *  which components meet, views that share memory, mass or inertia missing or, where there is one for all, not finite
 *  or not positive. Every call that moves bodies checks this first. Views share memory if one number of the slice
 *  belongs to both: members of structs lie between each other and do not; masses, inertias and what is one for all are
 *  only read, and not looked for. That is decided exactly from addresses, strides and count, in a time that does not
 *  depend on count; but for views of different strides of which one is 2^31 doubles or more, which pass. VTI_E_NULL,
 *  VTI_E_ABI, VTI_E_COUNT (negative, or a view is too short), VTI_E_VIEW (half given), VTI_E_STRIDE, VTI_E_ALIAS,
 *  VTI_E_MASS, VTI_E_INERTIA, VTI_E_MOMENTS. */
VTI_API int vti_bodies_check(const vti_bodies *bodies);

/** vti_bodies_check once and for all: if it passes, this object is marked, and later calls with it do not check again.
 *  For hosts that step few bodies very often. A copy, as a slice is, is another object: it is looked at again, unless
 *  it is sealed itself. Seal again after changing a view. A library that is built with -Dchecked=true heeds no seal:
 *  every call looks at all that vti_bodies_check_values looks at, and vti_apply, vti_bonds_loads and vti_bonds_measure
 *  at their lists, whose bodies are those that all views of what is read have by their counts; where none of these
 *  says, those of x or the attitude; where these do not either, those up to the end of the slice. Meant for debugging;
 *  a library without the option spends no instruction on it. */
VTI_API int vti_bodies_seal(vti_bodies *bodies);

/** All of vti_bodies_check, and of the slice every mass, inertia and moment finite and > 0, no moment more than the sum
 *  of the two others (by more than 2^-20 of it, as single precision has it), every position, velocity, attitude and
 *  spin finite, no quaternion zero (as zeroed memory is) or so short or long that |q|^2 is no normal number: below
 *  1.5e-154 or above 1.3e154. Else its length does not matter. For once before the first step. fault, which says what
 *  is wrong with which body, may be NULL. */
VTI_API int vti_bodies_check_values(const vti_bodies *bodies, vti_fault *fault);

#ifdef __cplusplus
}
#endif

#endif
