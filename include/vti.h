/* SPDX-License-Identifier: BSD-3-Clause
 *
 * vti.h -- explicit variational time integration of rigid spheres with rotation (Baker and Gonzalez).
 *
 * The caller owns all memory. The library allocates nothing, prints nothing, starts no threads and keeps no state: every
 * function may be called from any thread on bodies that no other thread touches.
 *
 * Frame: everything is in the inertial (space) frame unless a name says "body". Omega (omega) is the spatial angular
 * velocity, the moment the spatial torque about the body's centre, alpha the rescaled Rodrigues vector of the attitude
 * (vti_rrv.h). Units: any consistent set; angles in radians.
 *
 * Every function that can fail returns VTI_OK or a negative vti_status, and then has changed nothing.
 */
#ifndef VTI_H
#define VTI_H

#include <stdint.h>

#include "vti_rrv.h"

#define VTI_VERSION_STRING "0.1.0"
/** Layout of the structs below; vti_bodies.abi must hold it, so that a stale header is refused. */
#define VTI_ABI 1

#if defined(__GNUC__)
#define VTI_API __attribute__((visibility("default")))
#else
#define VTI_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- status -------------------------------------------------------------------------------------------------- */

enum vti_status {
    VTI_OK = 0,
    VTI_E_NULL = -1,
    VTI_E_ABI = -2,
    VTI_E_COUNT = -3,
    VTI_E_VIEW = -4,
    VTI_E_STRIDE = -5,
    VTI_E_ALIAS = -6,
    VTI_E_TIME = -7,
    VTI_E_MASS = -8,
    VTI_E_INERTIA = -9,
    VTI_E_TOO_LARGE = -10,
    VTI_E_STAGE = -11,
    VTI_E_STEPPER = -12,
    VTI_E_FRAME = -13
};

/** One English sentence for a status, remedy included; never NULL. */
VTI_API const char *vti_status_text(int status);

/** VTI_VERSION_STRING of the library that is running. */
VTI_API const char *vti_version(void);

/** Where and why a call failed: the body (0-based index into the views, -1 if no body is to blame) and the value. */
typedef struct vti_fault {
    int64_t body;
    double value;
} vti_fault;

/* ---- bodies as views ----------------------------------------------------------------------------------------- */

/** n three-vectors in the caller's memory: component k of vector i is c[k][i*stride] (stride in doubles).
 *  c = {NULL, NULL, NULL} means that the quantity, and all physics that needs it, is absent. */
typedef struct vti_view {
    double *c[3];
    int64_t stride;
} vti_view;

/** n quaternions; component k (x, y, z, w) of quaternion i is xyzw[k][i*stride]. */
typedef struct vti_quat_view {
    double *xyzw[4];
    int64_t stride;
} vti_quat_view;

/** n positive numbers p[i*stride]; stride 0 is one value for all. */
typedef struct vti_scalars {
    const double *p;
    int64_t stride;
} vti_scalars;

/** A slice of the caller's bodies. Absent views are absent physics: without x or v nothing translates, without an
 *  attitude or omega nothing turns, without force or moment nothing is kicked, and nothing is spent on it. mass is
 *  needed for a force and for momenta, inertia for a moment and for spin. Give the attitude as alpha or as a quaternion,
 *  never as both. Start from vti_bodies_none(). */
typedef struct vti_bodies {
    int64_t abi;        /* VTI_ABI */
    int64_t first;      /* index of the first body of the slice, 0-based */
    int64_t count;      /* bodies in the slice, >= 0 */
    vti_view x;         /* position of the centre */
    vti_view v;         /* velocity of the centre */
    vti_view force;     /* F */
    vti_view alpha;     /* attitude, rescaled Rodrigues vector */
    vti_quat_view quat; /* or attitude, unit quaternion */
    vti_view omega;     /* Omega, spatial angular velocity */
    vti_view moment;    /* RM, spatial moment about the centre */
    vti_scalars mass;
    vti_scalars inertia; /* J */
    /* Rounding errors carried along (compensated sums): what x, v, alpha and omega leave out, starting from 0. Each is
     * absent, or goes with its quantity; then its additions are exact to second order in eps. */
    vti_view x_low;
    vti_view v_low;
    vti_view alpha_low;
    vti_view omega_low;
} vti_bodies;

static inline vti_view vti_view_none(void)
{
    vti_view view = {{0, 0, 0}, 0};
    return view;
}

/** x[n][3] in C, x(3,n) in Fortran. */
static inline vti_view vti_view_packed(double *p)
{
    vti_view view = {{p, p + 1, p + 2}, 3};
    return view;
}

/** Three arrays of n; x(n,3) in Fortran is {x, x + n, x + 2n}. */
static inline vti_view vti_view_separate(double *x, double *y, double *z)
{
    vti_view view = {{x, y, z}, 1};
    return view;
}

/** A double[3] member of an array of structs: p is the member in element 0, bytes the size of a struct (a multiple of
 *  sizeof(double)). */
static inline vti_view vti_view_member(double *p, int64_t bytes)
{
    vti_view view = {{p, p + 1, p + 2}, bytes / (int64_t)sizeof(double)};
    return view;
}

static inline vti_scalars vti_scalars_one(const double *value)
{
    vti_scalars s = {value, 0};
    return s;
}

static inline vti_scalars vti_scalars_array(const double *values)
{
    vti_scalars s = {values, 1};
    return s;
}

/** n bodies of which nothing is known yet. */
static inline vti_bodies vti_bodies_none(int64_t n)
{
    const vti_view none = {{0, 0, 0}, 0};
    const vti_quat_view no_quat = {{0, 0, 0, 0}, 0};
    const vti_scalars no_scalars = {0, 0};
    const vti_bodies b = {VTI_ABI, 0,    n,          none,       none, none, none, no_quat,
                          none,    none, no_scalars, no_scalars, none, none, none, none};
    return b;
}

/** The same bodies, restricted to count of them from first. */
static inline vti_bodies vti_bodies_slice(vti_bodies b, int64_t first, int64_t count)
{
    b.first = first;
    b.count = count;
    return b;
}

/** The checks that cost nothing per body: ABI, counts, half-given views, zero strides, two quantities on one memory, mass
 *  or inertia missing. Every call that moves bodies makes them. */
VTI_API int vti_bodies_check(const vti_bodies *bodies);

/** All of vti_bodies_check, and every mass and inertia of the slice finite and > 0. fault may be NULL. */
VTI_API int vti_bodies_check_values(const vti_bodies *bodies, vti_fault *fault);

/* ---- the two primitives (EQUATIONS 2) ------------------------------------------------------------------------- */

/** How a drift turns a body by its angular velocity w; s = t|w|. */
enum vti_law {
    VTI_LAW_CLOSED = 1, /* dalpha = 2 t w/(1 + sqrt(1 - s^2)), turns by asin s, needs s < 1 */
    VTI_LAW_CAYLEY = 2  /* dalpha = t w, turns by 2 atan(s/2) */
};

/** Frame in which omega and moment are given, and in which the increment therefore acts. */
enum vti_frame { VTI_FRAME_SPACE = 1, VTI_FRAME_BODY = -1 };

/** v += t F/m, Omega += t RM/J. t finite, of either sign. */
VTI_API int vti_kick(double t, const vti_bodies *bodies);

/** x += t v, alpha <- alpha (+) dalpha(t Omega) by the law and frame. t finite, of either sign. All or nothing: if any
 *  body breaks the closed form's bound t|Omega| < 1 (NaN included), VTI_E_TOO_LARGE and nothing is written. */
VTI_API int vti_drift(int law, int frame, double t, const vti_bodies *bodies, vti_fault *fault);

/* ---- steppers as data ----------------------------------------------------------------------------------------- */

/** One step: for k = 0 ... stages-1: kick(kick[k] h), drift(drift[k] h), forces; then kick(kick[stages] h). */
typedef struct vti_stepper {
    const char *name;
    int64_t law;
    int64_t frame;
    int64_t order;       /* of energy and trajectory */
    int64_t reversible;  /* 1 if time-reversible */
    int64_t stages;      /* drifts, and force evaluations, of one step */
    double lag;          /* velocities live at t - lag h between steps (start/sync); 0 for all but the leapfrog */
    const double *kick;  /* [stages + 1] */
    const double *drift; /* [stages] */
    const char *about;
} vti_stepper;

/** "vti1", "vti2", "vti3" (the paper's maps), "vti3-leapfrog" (VTI-3 started and read with half kicks), "vti1-body"
 *  (VTI-1 in the body's frame). NULL if there is none of that name. The objects are constants of the library. */
VTI_API const vti_stepper *vti_stepper_find(const char *name);
VTI_API int64_t vti_stepper_count(void);
/** NULL outside 0 <= index < vti_stepper_count(). */
VTI_API const vti_stepper *vti_stepper_at(int64_t index);

/*  The loop of a host:
 *
 *      forces and moments at t = 0                         (once; the first kick needs them)
 *      vti_step_start(method, h, &bodies);                 (does nothing but for "vti3-leapfrog")
 *      for every step {
 *          vti_step_begin(method, h, &bodies, &fault);
 *          forces and moments at the new positions
 *          vti_step_finish(method, h, &bodies);
 *      }
 *
 *  Between begin and finish nothing but force and moment may be written. Methods with more than one stage call
 *  vti_step_stage for stages 1 ... stages-1, each followed by forces, before finish. h is finite and > 0. */

/** Stage 0: kick(kick[0] h), then drift(drift[0] h), of all bodies or, on failure, of none. fault may be NULL; on
 *  VTI_E_TOO_LARGE it names the body with the largest h|Omega| (or the first that is not a number) and that value. */
VTI_API int vti_step_begin(const vti_stepper *method, double h, const vti_bodies *bodies, vti_fault *fault);
/** Stage k; vti_step_begin is stage 0. */
VTI_API int vti_step_stage(const vti_stepper *method, int64_t k, double h, const vti_bodies *bodies, vti_fault *fault);
/** The last kick. */
VTI_API int vti_step_finish(const vti_stepper *method, double h, const vti_bodies *bodies);

/** Moves velocities from t to t - lag h, where the method keeps them: kick(-lag h). */
VTI_API int vti_step_start(const vti_stepper *method, double h, const vti_bodies *bodies);
/** Moves velocities back to t: kick(lag h). To read without disturbing the run, call it on bodies whose v and omega are
 *  copies. */
VTI_API int vti_step_sync(const vti_stepper *method, double h, const vti_bodies *bodies);

/* ---- effects (EQUATIONS 3) ------------------------------------------------------------------------------------ */

/** One line of physics. A scene holds an array of those that it calls for; what is not in the array does not exist. The
 *  object behind self stays the caller's. */
typedef struct vti_effect {
    const char *name;
    /** Adds this effect's force and moment to the bodies' (views that are absent are left out). */
    void (*apply)(const void *self, const vti_bodies *bodies);
    /** Writes the effect's energies, one per term. */
    void (*energy)(const void *self, const vti_bodies *bodies, double *energies);
    const void *self;
    int64_t terms;
    const char *const *term; /* names of the terms, one each */
    int64_t breaks;          /* momenta that the effect does not conserve: bits 0-2 linear, 3-5 angular about 0 */
} vti_effect;

/** force = moment = 0 on the slice, then every effect in order. */
VTI_API int vti_apply(const vti_effect *effects, int64_t n, const vti_bodies *bodies);

/** Three-dimensional pendulum: bodies hang by their body-fixed arm rho0 from pivots in a field g along +e3 (E2).
 *  U = -m g e3 . R rho0, RM = m g (R rho0) x e3 (E1). Rotation only. */
typedef struct vti_pendulum {
    double weight;  /* m g */
    double rho0[3]; /* arm in the body's frame */
} vti_pendulum;

/** The effect of *pendulum, which must outlive it. Energy term: "pendulum". */
VTI_API vti_effect vti_pendulum_effect(const vti_pendulum *pendulum);
/** R rho0 of body i in the inertial frame. */
VTI_API void vti_pendulum_arm(const vti_pendulum *pendulum, const vti_bodies *bodies, int64_t i, double arm[3]);

/* ---- measures (EQUATIONS 4) ----------------------------------------------------------------------------------- */

/** Sum with its rounding error carried along (Neumaier). Start from {0, 0}. */
typedef struct vti_sum {
    double high, low;
} vti_sum;

static inline void vti_sum_add(vti_sum *s, double x)
{
    const double t = s->high + x;
    s->low += fabs(s->high) >= fabs(x) ? (s->high - t) + x : (x - t) + s->high;
    s->high = t;
}

static inline double vti_sum_value(const vti_sum *s)
{
    return s->high + s->low;
}

/** Integral over time by the trapezoid rule at the steps, fed one value per step. Start from {{0, 0}, 0, 0}. */
typedef struct vti_integral {
    vti_sum sum;
    double last;
    int64_t values;
} vti_integral;

/** The value at the next step, h after the one before (h is not used for the first). */
static inline void vti_integral_add(vti_integral *q, double h, double value)
{
    if (q->values++ > 0)
        vti_sum_add(&q->sum, 0.5 * h * (q->last + value));
    q->last = value;
}

static inline double vti_integral_value(const vti_integral *q)
{
    return vti_sum_value(&q->sum);
}

/** Sum of m|v|^2/2; 0 if nothing translates. */
VTI_API double vti_kinetic_translation(const vti_bodies *bodies);
/** Sum of J|Omega|^2/2; 0 if nothing turns. */
VTI_API double vti_kinetic_rotation(const vti_bodies *bodies);
/** Kinetic energies and all energies of the effects. */
VTI_API double vti_energy(const vti_effect *effects, int64_t n, const vti_bodies *bodies);
/** Sum of m v. */
VTI_API void vti_momentum(const vti_bodies *bodies, double p[3]);
/** Sum of J Omega. */
VTI_API void vti_spin(const vti_bodies *bodies, double s[3]);
/** Sum of (x - about) x m v + J Omega. */
VTI_API void vti_angular_momentum(const vti_bodies *bodies, const double about[3], double l[3]);
/** Largest h|Omega|: the rotation per step. */
VTI_API double vti_max_turn(double h, const vti_bodies *bodies);
/** Integrand of ||q||^2_{H1}: sum over bodies of |x|^2 + |v|^2 + theta^2 + |Omega|^2, of the views that are present. */
VTI_API double vti_h1_density(const vti_bodies *bodies);
/** Integrand of ||q_h - q||^2_{H1}: the same of the differences, attitudes by |log(R_h R^T)|. Both slices must present the
 *  same views and have equal counts. */
VTI_API double vti_h1_distance(const vti_bodies *bodies, const vti_bodies *reference);
/** Largest attitude distance |log(R_h R^T)| over the slice, radians; 0 if nothing turns. */
VTI_API double vti_attitude_distance(const vti_bodies *bodies, const vti_bodies *reference);

/* ---- the packed door ------------------------------------------------------------------------------------------- */

/** For codes whose arrays are x[n][3] (Fortran x(3,n)) and that want no structs. stepper is an index for
 *  vti_stepper_at: 0 is vti1, 1 vti2, 2 vti3. NULL arrays are absent physics as above. masses and inertias: 1 (one value
 *  for all) or n. Same arithmetic, same bits as through views. On failure body receives the 0-based culprit (or -1) and
 *  value its h|Omega|; both may be NULL. */
VTI_API int vti_packed_begin(int64_t stepper, double h, int64_t n, double *x, double *v, const double *force,
                             double *alpha, double *omega, const double *moment, int64_t masses, const double *mass,
                             int64_t inertias, const double *inertia, int64_t *body, double *value);
VTI_API int vti_packed_finish(int64_t stepper, double h, int64_t n, double *v, const double *force, double *omega,
                              const double *moment, int64_t masses, const double *mass, int64_t inertias,
                              const double *inertia);

#ifdef __cplusplus
}
#endif

#endif
