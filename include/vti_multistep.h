/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Multistep methods: one force evaluation a step, of any order up to 11, where trajectories count. */
#ifndef VTI_MULTISTEP_H
#define VTI_MULTISTEP_H

#include "vti_contact.h"
#include "vti_wall.h"

#ifdef __cplusplus
extern "C" {
#endif

/** AN(K, c): Adams' and Stoermer's formulas on the accelerations, which are vectors of space, with the exact turning
 *  under the Omega that they integrate to (EQUATIONS 8.1). Order K + 1, or K where u is not 0, down to rounding: the
 *  turn is of order 8 itself, with a factor so small that nothing shows it. Linear momentum is kept to rounding,
 *  angular momentum and energy to the order only: the error of the energy grows with time. For smooth forces, and with
 *  vti_multistep_touch for contacts; for long times the steppers of vti_step.h.
 *
 *  Forces may depend on v and Omega, which are then read between predict and correct, at the same order, while h times
 *  the rate of damping or gyration stays below 0.17, 0.024 and 0.0075 for an4, an7 and an9, and 0.0033 for the two
 *  of K = 10: so either weak damping, or steps as short as it demands. The first K - 1 steps are up to the host,
 *  since lists of kicks lose their order on such forces. Effects that flow (vti_drag, vti_dashpots ...) are not forces,
 *  and these calls do not apply them. */
typedef struct vti_multistep {
    const char *name;  /**< what vti_multistep_find knows it by */
    int64_t depth;     /**< K, accelerations that it remembers, 1 to 10 */
    double c;          /**< of the corrector of x: accurate at 3/4, steady at larger steps where it is negative; x stays
                          where it was predicted at 0 */
    double u;          /**< added to g_K, the weight of v's correction; if not 0, the order is K and the reach larger */
    double reach;      /**< oscillations of frequency f are stable while h f < reach, which is rounded to 1e-3:
                          none grows by more than 1e-3 h f a step */
    const char *about; /**< what it is, in a line */
} vti_multistep;

/** "an4", "an7", "an9", "an10-mid", "an10-fine" by their K and how small their steps have to be; NULL if there is none
 *  of that name. The objects are constants of the library. */
VTI_API const vti_multistep *vti_multistep_find(const char *name);
/** How many there are. */
VTI_API int64_t vti_multistep_count(void);
/** Each of them by number; NULL outside 0 <= index < vti_multistep_count(). */
VTI_API const vti_multistep *vti_multistep_at(int64_t index);

/** Past accelerations, in memory of the caller's: backward differences of F/m and RM/J. Copied with the bodies, a
 *  run goes on with its bits. Slices that are stepped apart each have one of their own, on the same memory. */
typedef struct vti_past {
    double *memory; /**< [count of bodies][depth][6], from body 0 of the views, not of the slice */
    int64_t depth;  /**< differences that it holds; at least the K of the method */
    int64_t known;  /**< accelerations recorded so far, at most depth. 0 begins anew: after any jump of forces or h */
} vti_past;

/** Remembers the accelerations by the force and moment of now. At the start, and after any jump, once before each of
 *  K - 1 steps of h by another method, and once after the last: then known = K. They are few, and need
 *  not be as good as K promises: four by srkn6, after which vti_multistep objects of the depths 5, 6 ... with c = 1,
 *  which record by themselves, take one evaluation each; or, for errors below 1e-10, six by srkn11 and then of the
 *  depths 7, 8 ... A step of srkn14 ends with a drift: forces have to be computed again before they are recorded, or
 *  all that follows is of order 2.
 *
 *  Where forces are of positions alone, fewer evaluations do: vti_step_keep, turn v and Omega round, take these steps
 *  (four by chin4, without its probe even; for an10-mid and an10-fine six by srkn6) and put by the loads after each;
 *  set known to 0, record what was put by, the last first; vti_step_undo, and record the loads of now. What these steps
 *  err by is no error of the run then. */
VTI_API int vti_multistep_record(vti_past *past, const vti_bodies *bodies);

/* The loop of a host, once past->known >= K:
 *
 *      vti_multistep_predict(method, h, past, &bodies, &fault);
 *      forces and moments at the new positions (and velocities, where they depend on them)
 *      vti_multistep_correct(method, h, past, &bodies);
 *
 * Between the two nothing but force and moment may be written. After the second the forces stay as they are: they are
 * those of the predicted state.
 *
 * All calls return VTI_OK or, and then nothing has been written, a status of vti_bodies_check; VTI_E_STEPPER for a
 * method that is NULL or of no order; VTI_E_TIME for an h that is not positive and finite; VTI_E_PAST where past has no
 * memory, or knows less than the method's K; VTI_E_VIEW for views of rounding errors; VTI_E_MOMENTS for bodies of three
 * moments; VTI_E_NULL where a result has no place. */

/** Moves the bodies to where they will be but for the correction. VTI_E_PAST, and nothing is written, while known is
 *  less than K, or where there is no memory. Views of rounding errors (x_low ...) are refused with VTI_E_VIEW. */
VTI_API int vti_multistep_predict(const vti_multistep *method, double h, const vti_past *past, const vti_bodies *bodies,
                                  vti_fault *fault);
/** Between the forces and vti_multistep_correct, for hosts that want to know: the largest |h g D| of a body of the
 *  slice, by which v (*velocity) and Omega (*omega) are about to be corrected; 0 where there are none, NaN if any of
 *  them is. That is an estimate of the step's error, of order h^(K+1), on the safe side. A growth by ten in a step is
 *  a touch or a jump. Changes nothing. */
VTI_API int vti_multistep_error(const vti_multistep *method, double h, const vti_past *past, const vti_bodies *bodies,
                                double *velocity, double *omega);
/** Corrects by the difference D of the new accelerations from the predicted ones, and records the new ones. */
VTI_API int vti_multistep_correct(const vti_multistep *method, double h, vti_past *past, const vti_bodies *bodies);

/** After vti_multistep_correct, where there are Hertzian contacts or walls: corrects v and x for the error that the
 *  step's sums make where a contact begins or ends within it. For a force that grows as the power 3/2 of the overlap it
 *  is of order h^{5/2}, whatever K; what is left is of order h^{9/2}. No force is evaluated.
 *
 *  before is x at the start of the step, [n][3] in any layout; contacts and walls are those that the forces are of, the
 *  list of contacts that of the new positions; NULL where there are none. Linear momentum is kept. One call for all
 *  bodies, by one thread: it reads of others what it moves. A past that is recorded while something begins or ends to
 *  touch does not know of it: a run that starts so takes its K - 1 steps back in time (v and Omega turned round, forces
 *  recorded from the last to the first, the bodies put back), without the forces of what does not touch at the start:
 *  bodies that have just parted would meet there. VTI_E_NEEDS where there is a list, but not x, v or mass; what before
 *  is refused for is what a view of these bodies would be, VTI_E_ALIAS for x itself or a part of it; views of rounding
 *  errors and moments are refused as by the other calls. */
VTI_API int vti_multistep_touch(double h, const vti_view *before, const vti_contacts *contacts, const vti_walls *walls,
                                const vti_bodies *bodies);

#ifdef __cplusplus
}
#endif

#endif
