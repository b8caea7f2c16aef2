/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Steps of variable length: chosen by an estimate of their error, or by a function of the state, without drift. */
#ifndef VTI_CONTROL_H
#define VTI_CONTROL_H

#include "vti_step.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- steps that keep an error (EQUATIONS 8.3) ------------------------------------------------------------------- */

/* The estimate of a step (vti_step_error) goes with h^(q+1), so that of a step with the error err the next one is
 *
 *     h min(4, max(0.2, 0.85 (tolerance/err)^(1/(q+1)))),   err = max(velocity/speed, omega/turning)
 *
 * where err is above the tolerance, or NaN, the bodies are put back and the step is made again. The loop of a
 * host with a method that has estimates, "srkn6", "srkn11" or "srkn14":
 *
 *      vti_control_start(method, tolerance, h, &control);
 *      forces and moments at t
 *      while (t < t_end) {
 *          const double step = control.h < t_end - t ? control.h : t_end - t;
 *          vti_step_keep(&bodies, &kept);
 *          vti_step_watch(method, 0, step, &bodies, &errors), vti_step_begin, forces, ..., vti_step_finish
 *          vti_step_error(method, &bodies, &errors, &velocity, &omega);
 *          vti_control_judge(&control, step, velocity, omega, &accepted);
 *          if (accepted)
 *              t += step;
 *          else
 *              vti_step_undo(&bodies, &kept);
 *      }
 *
 * Every step keeps linear and angular momentum as the method does. Its energy is no longer bounded for all times, as
 * that of equal steps is: the tolerance bounds what a step adds. The estimate is of lower order than the step, and so
 * far above its true error; errors at the end go with about tolerance^0.9, by a factor that the motion decides. What is
 * put back is bodies and forces: effects that remember (friction, rupture) are the host's to put back.
 *
 * Between touches the error tells of none, and a step in which forces are taken too seldom may pass one by. With
 * contacts or walls set most to 1.5 h/d, h being that of vti_stable_step and d the largest part of a step in which the
 * method takes no forces: 0.172 of "srkn11", 0.158 of "srkn14", 0.255 of "srkn6". That is enough for touches that are
 * head-on. A grazing one may be shorter: where pairs are apart at both ends of a step and overlap on the straight way
 * between, judge the step by the velocity that such a touch would change, too, if that is larger. */

/** Parameters and state of step control: plain data, to be copied with a checkpoint. vti_control_start sets all
 *  members; those up to least may then be changed. */
typedef struct vti_control {
    double tolerance; /**< of the error of one step, > 0 */
    double speed;     /**< the error of v is taken in units of it: 1, or a speed of the scene */
    double turning;   /**< the error of Omega is taken in units of it: 1, or an angular velocity of the scene */
    double most;      /**< the longest step that is proposed; INFINITY at first (contacts: see above) */
    double least;     /**< steps are not made shorter than that, vti_control_judge fails instead; 0 at first */
    double power;     /**< q + 1, with which h the estimate goes: a whole number, 2 to 16 */
    double h;         /**< the step to be tried next; a shorter one may be, such as the last */
    double error;     /**< of the step judged last, as above; may be NaN */
    int64_t held;     /**< 1 after a step that was not accepted: the next one that is may not lengthen h */
    int64_t accepted; /**< steps so far */
    int64_t rejected; /**< steps that were undone */
} vti_control;

/** For a method with estimates, and first h to be tried. VTI_E_STEPPER for one without; VTI_E_CONTROL for a tolerance
 *  that is not positive and finite; VTI_E_TIME for such an h. */
VTI_API int vti_control_start(const vti_stepper *method, double tolerance, double h, vti_control *control);

/** Whether the step of h with these errors (vti_step_error; NaN if it could not be made at all) is accepted, 1 or 0 in
 *  *accepted, and what to try next, in control->h. An accepted step that was shorter than control->h leaves that as it
 *  was. VTI_E_CONTROL, and nothing changes, if a step of control->least is not short enough, or if a member of
 *  *control is out of range or an error negative; the bodies are still to be put back then. VTI_E_TIME for an h that
 *  is not positive and finite. */
VTI_API int vti_control_judge(vti_control *control, double h, double velocity, double omega, int64_t *accepted);

/** Bodies as they stood, in memory of the caller's. Slices that are stepped apart may share it. */
typedef struct vti_kept {
    double *memory; /**< [count of bodies][width], from body 0 of the views, not of the slice */
    int64_t width;  /**< at least vti_step_keeps */
} vti_kept;

/** Numbers that vti_step_keep copies of each body: positions, velocities, attitudes, spins, what rounding left out of
 *  them, forces and moments, of those that are there; at most 36. A negative status for bodies that are refused. */
VTI_API int64_t vti_step_keeps(const vti_bodies *bodies);
/** Copies the slice. VTI_E_COUNT where the memory is too narrow. */
VTI_API int vti_step_keep(const vti_bodies *bodies, const vti_kept *kept);
/** Puts the slice back as it was at vti_step_keep, bit by bit, forces too, so that no evaluation is made again.
 *  VTI_E_COUNT where the memory is too narrow for these bodies; VTI_E_NULL without any. */
VTI_API int vti_step_undo(const vti_bodies *bodies, const vti_kept *kept);

/* ---- variable steps without drift (EQUATIONS 8.4) ---------------------------------------------------------------- */

/** The integrating controller of E. Hairer and G. Soederlind, Explicit, time reversible, adaptive step size control,
 *  SIAM J. Sci. Comput. 26, 1838 (2005). The step that is wished for, s(y) > 0, depends on the state y alone; with its
 *  rate along the motion G = -(1/s) ds/dt, which an even s of the velocities makes odd,
 *
 *      rho_1/2 = 1/s(y_0) + epsilon G(y_0)/2,   rho_n+1/2 = rho_n-1/2 + epsilon G(y_n),   h_n = epsilon/rho_n+1/2
 *
 *  is reversible with any reversible stepper, which therefore keeps its energies without drift, as equal steps do and
 *  h = epsilon s(y_n) does not. Plain data, to be copied with a checkpoint. */
typedef struct vti_density {
    double epsilon; /**< h is about epsilon s */
    double rho;     /**< steps per epsilon of time: the density of steps */
    double h;       /**< the step to be made next */
} vti_density;

/** At the start, from s and G there. VTI_E_TIME if a step that is not positive and finite comes out: a smaller epsilon
 *  helps. */
VTI_API int vti_density_start(double epsilon, double wish, double rate, vti_density *density);
/** After each step, from G at its end: the h of the next. VTI_E_TIME as above; then nothing has changed. */
VTI_API int vti_density_next(vti_density *density, double rate);

#ifdef __cplusplus
}
#endif

#endif
