/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Status codes: one table, from which the constants and their texts come. */
#ifndef VTI_STATUS_H
#define VTI_STATUS_H

#include <stdint.h>

/** Layout of the structs of the interface; vti_bodies.abi must hold it, so that a stale header is refused. */
#define VTI_ABI 1

/** Marks what the shared library exports. */
#if defined(__GNUC__)
#define VTI_API __attribute__((visibility("default")))
#else
#define VTI_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** All that a call may return but VTI_OK: ROW(constant, value, text), where a text says what is wrong and, after a
 *  semicolon, the remedy. VTI_STEPPER_NAMES is put in where the texts are compiled. fortran/vti_types.f90 has the same
 *  constants. */
/* clang-format off */
#define VTI_STATUSES(ROW)                                                                                              \
    ROW(VTI_E_NULL, -1, "a required argument is NULL; pass bodies, lists and effects that exist")                      \
    ROW(VTI_E_ABI, -2,                                                                                                 \
        "the bodies were made with another version of vti.h than this library; recompile against its header")          \
    ROW(VTI_E_COUNT, -3,                                                                                               \
        "a number of bodies, effects or values is negative, neither 1 nor n, or more than a view shows, or one of an " \
        "effect's terms or books is more than VTI_TERMS; correct it")                                                  \
    ROW(VTI_E_VIEW, -4,                                                                                                \
        "a view is given in part, or the attitude both as alpha and as a quaternion; give all components or none")     \
    ROW(VTI_E_STRIDE, -5,                                                                                              \
        "a view of more than one body has stride 0, or one by which its components meet; give the distance of "        \
        "consecutive bodies in doubles")                                                                               \
    ROW(VTI_E_ALIAS, -6, "two views, or two components of one, share memory; give each quantity its own")              \
    ROW(VTI_E_TIME, -7, "the time step is not finite, or not positive where it must be; pass a finite h > 0")          \
    ROW(VTI_E_MASS, -8,                                                                                                \
        "mass is missing, not finite or not positive; give one value or one for each body, > 0")                       \
    ROW(VTI_E_INERTIA, -9,                                                                                             \
        "inertia is missing, not finite or not positive; give one value or one for each body, > 0")                    \
    ROW(VTI_E_TOO_LARGE, -10,                                                                                          \
        "a body turns too far for the closed form: h|Omega| < 1 is needed; reduce h, or use vti2, which has no limit") \
    ROW(VTI_E_STAGE, -11, "the stepper has no such stage; use 0 <= k < stages")                                        \
    ROW(VTI_E_STEPPER, -12,                                                                                            \
        "there is no such stepper or drift law, or it has more stages than the packed calls can play, or no "          \
        "estimates of its error; known steppers are " VTI_STEPPER_NAMES "as vti_stepper_at lists them")                \
    ROW(VTI_E_FRAME, -13,                                                                                              \
        "there is no such frame, or not for bodies with moments of inertia; use VTI_FRAME_SPACE or, of spheres, "      \
        "VTI_FRAME_BODY")                                                                                              \
    ROW(VTI_E_BOND, -14,                                                                                               \
        "a bond is not between two different bodies that exist at different places, or a stiffness of it is "          \
        "negative or not finite, or there is no such form of shear; mend that bond")                                   \
    ROW(VTI_E_DISSIPATES, -15,                                                                                         \
        "the stepper steps back in time, which turns dissipation into gain; use one without negative "                 \
        "coefficients: vti2, exact or chin4")                                                                          \
    ROW(VTI_E_CONTACT, -16,                                                                                            \
        "a contact is not between two different bodies that exist, or the normal or axis of a wall is not of length "  \
        "1, or a diameter, radius or modulus is not positive and finite, or a stiffness is negative, not finite or "   \
        "beside a modulus, or a place or motion of a wall is not finite; mend that pair or wall")                      \
    ROW(VTI_E_STATE, -17,                                                                                              \
        "a position, velocity, attitude or spin is not finite, or a quaternion is zero or of no normal length; set "   \
        "all of them before the first step, an unturned quaternion to real part 1")                                    \
    ROW(VTI_E_SPRINGS, -18,                                                                                            \
        "an effect does not report its springs, so that the stable step has no bound; give it springs, "               \
        "vti_springs_none if its force does not change with position, or leave it out to bound the others")            \
    ROW(VTI_E_NEEDS, -19,                                                                                              \
        "an effect needs a view that the bodies lack (x, v, an attitude, omega, mass or inertia), or its needs have "  \
        "an unknown bit; give the bodies that view, or leave the effect out")                                          \
    ROW(VTI_E_DAMPING, -20,                                                                                            \
        "a coefficient of drag, damping or friction is negative or not finite, or the velocity of a medium is not "    \
        "finite, or friction has no stiffness, or two, or a reach is not positive; give finite numbers >= 0, one "     \
        "stiffness for each motion, and a reach: INFINITY where lists have all pairs")                                 \
    ROW(VTI_E_HISTORY, -21,                                                                                            \
        "the table of what touches hold is full, or its slots are no power of 2, or what is put into it names no two " \
        "different bodies and no wall, or is not finite, or its slots do not lead to what is held; give it twice as "  \
        "many slots as bodies touch, and begin anew, or put what a restart holds in by vti_history_add")               \
    ROW(VTI_E_PAST, -22,                                                                                               \
        "a multistep method remembers too little, or has no memory; record the accelerations before each of K - 1 "    \
        "steps of another method, and after them")                                                                     \
    ROW(VTI_E_CONTROL, -23,                                                                                            \
        "a tolerance, a scale or a limit of step control is not positive and finite, or its shortest step is too "     \
        "long for the tolerance; ask for less accuracy, or allow shorter steps")                                       \
    ROW(VTI_E_MOMENTS, -24,                                                                                            \
        "a principal moment of inertia is not positive and finite, or more than the sum of the two others, or a spin " \
        "has no moments, or they stand beside inertia, omega_low or a multistep method, or omega alone without an "    \
        "attitude; give spin and three moments for each body, or three for all")                                       \
    ROW(VTI_E_CLUMP, -25,                                                                                              \
        "a sphere of a clump belongs to no body that exists or to one before that of the last sphere, or its place is "\
        "not finite or its diameter not positive, or their moments are beyond the range of numbers, or an effect on "  \
        "the spheres has a flow, but none for clumps; sort the spheres by body, or give that effect flow_clumps")
/* clang-format on */

/** What calls return; vti_status_text says what to do about it. */
enum vti_status {
    VTI_OK = 0 /**< done */
/** @cond */
#define VTI_STATUS_CONSTANT(constant, value, text) , constant = (value)
    VTI_STATUSES(VTI_STATUS_CONSTANT)
#undef VTI_STATUS_CONSTANT
    /** @endcond */
};

/** One English sentence for a status, remedy included, of at most 400 characters; never NULL. */
VTI_API const char *vti_status_text(int status);

#ifdef __cplusplus
}
#endif

#endif
