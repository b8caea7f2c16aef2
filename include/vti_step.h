/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 * Kick and drift, and the steppers that are lists of them. */
#ifndef VTI_STEP_H
#define VTI_STEP_H

#include "vti_bodies.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the two primitives (EQUATIONS 2) ------------------------------------------------------------------------- */

/** How a drift turns a body by its angular velocity w; s = t|w|. */
enum vti_law {
    VTI_LAW_CLOSED = 1, /**< dalpha = 2 t w/(1 + sqrt(1 - s^2)), turns by asin s, needs s < 1 */
    VTI_LAW_CAYLEY = 2, /**< dalpha = t w, turns by 2 atan(s/2) */
    VTI_LAW_EXACT = 3,  /**< dalpha = t w (60 - s^2)/(60 - 6 s^2), turns by s + O(s^7); a half turn from s = 2^30 on */
    VTI_LAW_EXACT9 = 4  /**< dalpha = t w (1 - s^2/42)/(1 - 3 s^2/28 + s^4/1680), turns by s + O(s^9); the same */
};

/** Frame in which omega and moment are given, and in which the increment therefore acts. */
enum vti_frame {
    VTI_FRAME_SPACE = 1, /**< the inertial one */
    VTI_FRAME_BODY = -1  /**< each body's own */
};

/** v += t F/m, Omega += t RM/J. t finite, of either sign. */
VTI_API int vti_kick(double t, const vti_bodies *bodies);

/** dalpha of the turn by omega for the time t, in the frame in which omega is: what a drift composes with an attitude.
 *  t and omega finite; NaN if there is no such law or no omega. Where the closed form has none, h|Omega| > 1, as of a
 *  body that no step turns, 2 t Omega, its limit. Of half a turn, which has no dalpha, the largest |component| is
 *  VTI_RRV_LARGE. */
VTI_API void vti_drift_increment(int law, double t, const double omega[3], double dalpha[3]);

/** x += t v, alpha <- alpha (+) dalpha(t Omega) by the law and frame. t finite, of either sign. All or nothing: if any
 *  body breaks the closed form's bound t|Omega| < 1 (NaN included), VTI_E_TOO_LARGE and nothing is written. */
VTI_API int vti_drift(int law, int frame, double t, const vti_bodies *bodies, vti_fault *fault);

/* ---- steppers as data ----------------------------------------------------------------------------------------- */

/** One step: for k = 0 ... stages-1: kick(kick[k] h), drift(drift[k] h), forces; then kick(kick[stages] h) and
 *  drift(drift[stages] h). With a probe, the forces of kick k are those at the displaced bodies of vti_step_probe. */
typedef struct vti_stepper {
    const char *name;       /**< what vti_stepper_find knows it by */
    int64_t law;            /**< vti_law */
    int64_t frame;          /**< vti_frame */
    int64_t order;          /**< of energy and trajectory */
    int64_t reversible;     /**< 1 if time-reversible */
    int64_t symplectic;     /**< 1 if exactly so */
    int64_t stages;         /**< drifts that forces follow */
    int64_t evals;          /**< force evaluations of one step: stages and probes */
    double lag;             /**< velocities live at t - lag h between steps (start/sync); 0 for all but the leapfrog */
    double reach;           /**< oscillations of frequency f are stable while h f < reach; 2 for the paper's maps */
    const double *kick;     /**< [stages + 1] */
    const double *drift;    /**< [stages + 1]; the last is 0 but where a step begins with a drift */
    const double *probe;    /**< [stages + 1], in units of h^2, or NULL */
    const char *about;      /**< what it is, in a line */
    int64_t estimate_order; /**< what vti_step_watch sums is of order h^(estimate_order + 1) */
    int64_t estimates;      /**< how many sums it makes of a body; 0 where there is nothing to watch */
    const double *estimate; /**< [estimates][stages + 1], weights of the forces of the kicks, or NULL */
    int64_t rotor;          /**< of bodies with moments, the order of a free one's turn: 2, 4 or 6; 0 is 2 */
} vti_stepper;

/** The paper's maps: "vti1", "vti2", "vti3", "vti3-leapfrog" (VTI-3 started and read with half kicks), "vti1-body"
 *  (VTI-1 in the body's frame). On the exact drift: "exact" (Verlet), "suzuki4", "kl6", "kl8" (compositions of it),
 *  "srkn6" (order 4), "srkn11", "srkn14" (order 6; Runge-Kutta-Nystroem splittings), "chin4" (order 4, no coefficient
 *  negative). NULL if there is none of that name, which every call with a stepper refuses with VTI_E_STEPPER. The
 *  objects are constants of the library. */
VTI_API const vti_stepper *vti_stepper_find(const char *name);
/** How many there are. */
VTI_API int64_t vti_stepper_count(void);
/** Each of them by number; NULL outside 0 <= index < vti_stepper_count(). */
VTI_API const vti_stepper *vti_stepper_at(int64_t index);

/* The loop of a host:
 *
 *      forces and moments at t = 0                         (once; the first kick needs them)
 *      vti_step_start(method, h, &bodies);                 (does nothing but for "vti3-leapfrog")
 *      for every step {
 *          vti_step_begin(method, h, &bodies, &fault);
 *          forces and moments at the new positions
 *          vti_step_finish(method, h, &bodies);
 *      }
 *
 * Between begin and finish nothing but force and moment may be written. Methods with more than one stage call
 * vti_step_stage for stages 1 ... stages-1, each followed by forces, before finish; where method->probe is not NULL,
 * each kick k with probe[k] != 0 comes after vti_step_probe and the forces at what it has filled in.
 *
 * All calls of this file return VTI_OK or, and then nothing has been written, a status of vti_bodies_check;
 * VTI_E_STEPPER for a method that is NULL or no list, or of a law or rotor that there is not; VTI_E_STAGE for a stage
 * that it does not have; VTI_E_TIME for an h that is not positive and finite; VTI_E_FRAME for a frame that there is
 * not, or the body's with moments; and those that move bodies by the closed law VTI_E_TOO_LARGE if h|Omega| >= 1. What
 * a call returns besides is said at it. */

/** Stage 0: kick(kick[0] h), then drift(drift[0] h), of all bodies or, on failure, of none. fault may be NULL; on
 *  VTI_E_TOO_LARGE it names the body with the largest h|Omega| (or the first that is NaN) and that value. */
VTI_API int vti_step_begin(const vti_stepper *method, double h, const vti_bodies *bodies, vti_fault *fault);
/** Stage k; vti_step_begin is stage 0. */
VTI_API int vti_step_stage(const vti_stepper *method, int64_t k, double h, const vti_bodies *bodies, vti_fault *fault);
/** The last kick, and the last drift where there is one. */
VTI_API int vti_step_finish(const vti_stepper *method, double h, const vti_bodies *bodies);

/** vti_step_finish and the vti_step_begin of the next step in one pass over the bodies, for steps after which nobody
 *  looks at velocities: the same bits. VTI_E_STAGE, and nothing is written, for methods whose step ends with a drift.
 *  On VTI_E_TOO_LARGE nothing is written either: the step is not finished. */
VTI_API int vti_step_next(const vti_stepper *method, double h, const vti_bodies *bodies, vti_fault *fault);

/** Where the forces of kick k are to be taken: writes x + probe[k] h^2 F/m and the attitude turned by probe[k] h^2 RM/J
 *  into probed, whose x and attitude are memory of their own and whose force and moment may be those of bodies. */
VTI_API int vti_step_probe(const vti_stepper *method, int64_t k, double h, const vti_bodies *bodies,
                           const vti_bodies *probed);

/** Moves velocities from t to t - lag h, where the method keeps them: kick(-lag h). */
VTI_API int vti_step_start(const vti_stepper *method, double h, const vti_bodies *bodies);
/** Moves velocities back to t: kick(lag h). To read without disturbing the run, call it on bodies whose v and omega are
 *  copies. */
VTI_API int vti_step_sync(const vti_stepper *method, double h, const vti_bodies *bodies);

/* ---- how far off a step is (EQUATIONS 8.2) ---------------------------------------------------------------------- */

/* "srkn6", "srkn11" and "srkn14" come with weights w_k on the forces F_j of their kicks that give 0 up to the order q =
 * estimate_order of smooth forces, and nothing more is evaluated:
 *
 *     e_k = h sum_j w_kj F_j/m,  h sum_j w_kj RM_j/J,  k = 0 ... estimates - 1,  which is O(h^(q+1))
 *
 * A host that wants to know calls vti_step_watch once before each kick, when its forces are there: with k = 0 before
 * vti_step_begin, with k before vti_step_stage, with k = stages before vti_step_finish, and vti_step_error after that.
 * These calls do not change the step, and without them nothing is spent.
 *
 * What comes out is the difference of two formulas, of which the step is the better one: it tells steps that are too
 * long from steps that are not, and falls by 2^(q+1) when h is halved. It is of one step: how the errors of a run add
 * up depends on the motion. */

/** Sums of a step, in memory of the caller's that need not be set before. Slices that are stepped apart may share
 *  it. */
typedef struct vti_errors {
    double *memory; /**< [count of bodies][rows][6], from body 0 of the views, not of the slice */
    int64_t rows;   /**< at least the estimates of the method */
} vti_errors;

/** Adds the forces and moments of kick k, 0 <= k <= stages, to the sums; k = 0 begins anew. VTI_E_STEPPER for one
 *  without estimates, VTI_E_COUNT where there are too few rows. */
VTI_API int vti_step_watch(const vti_stepper *method, int64_t k, double h, const vti_bodies *bodies,
                           const vti_errors *errors);
/** The largest (sum_k |e_k|^2)^(1/2) of a body of the slice: that of v, in *velocity, and of Omega, in *omega; 0 where
 *  nothing pushes or turns them. NaN if any of them is. VTI_E_NULL where a result has no place. */
VTI_API int vti_step_error(const vti_stepper *method, const vti_bodies *bodies, const vti_errors *errors,
                           double *velocity, double *omega);

/* ---- packed arrays ------------------------------------------------------------------------------------------- */

/** For codes whose arrays are x[n][3] (Fortran x(3,n)) and that want no structs. stepper is an index for
 *  vti_stepper_at: 0 is vti1, 1 vti2, 2 vti3. Steppers of more than one stage need more calls than these two and are
 *  refused with VTI_E_STEPPER; "exact" is of one. VTI_E_COUNT for masses or inertias that are neither. NULL arrays are
 *  absent physics as above. masses and inertias: 1 (one value for all) or n; or inertias = 3n for bodies that are not
 *  spheres: then inertia[n][3] are the three moments of each, about axes that are the body's own, and omega[n][3] is
 *  its angular momentum L (EQUATIONS 7.1). Same arithmetic, same bits as through views. On VTI_E_TOO_LARGE body
 *  receives the number of the body, from 0, and value its h|Omega|, the largest of its turns; VTI_E_STEPPER and
 *  VTI_E_COUNT leave -1 and h there. Both may be NULL. */
VTI_API int vti_packed_begin(int64_t stepper, double h, int64_t n, double *x, double *v, const double *force,
                             double *alpha, double *omega, const double *moment, int64_t masses, const double *mass,
                             int64_t inertias, const double *inertia, int64_t *body, double *value);
/** The second half of the step of vti_packed_begin; its arguments are those. */
VTI_API int vti_packed_finish(int64_t stepper, double h, int64_t n, double *v, const double *force, double *omega,
                              const double *moment, int64_t masses, const double *mass, int64_t inertias,
                              const double *inertia);

#ifdef __cplusplus
}
#endif

#endif
