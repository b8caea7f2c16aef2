/* SPDX-License-Identifier: BSD-3-Clause
 *
 * One pendulum with its state, for the tests that follow a motion. */
#ifndef VTI_TESTS_RIG_H
#define VTI_TESTS_RIG_H

#include "bodies.h"
#include "play.h"

enum rig_storage { RIG_ALPHA, RIG_QUAT, RIG_RESIDUALS };

typedef struct rig {
    double alpha[3], quat[4], omega[3], moment[3], alpha_low[3], omega_low[3], inertia;
    vti_pendulum pendulum;
    enum rig_storage storage;
    int frame; /* in which omega and moment are */
} rig;

static inline vti_bodies rig_bodies(rig *p)
{
    vti_bodies b = vti_bodies_none(1);
    b.omega = vti_view_packed(p->omega);
    b.moment = vti_view_packed(p->moment);
    b.inertia = vti_scalars_one(&p->inertia);
    if (p->storage == RIG_QUAT)
        b.quat = quats_packed(p->quat);
    else
        b.alpha = vti_view_packed(p->alpha);
    if (p->storage == RIG_RESIDUALS) {
        b.alpha_low = vti_view_packed(p->alpha_low);
        b.omega_low = vti_view_packed(p->omega_low);
    }
    return b;
}

/** The attitude as a reference quaternion. */
static inline rotor rig_attitude(const rig *p)
{
    return p->storage == RIG_QUAT ? quat_of_xyzw(p->quat) : quat_of_alpha(p->alpha);
}

static inline void rig_set_attitude(rig *p, rotor q)
{
    quat_store(q, p->quat, p->alpha);
}

/** A random pendulum of moderate numbers, |Omega| <= sqrt 3. */
static inline rig rig_random(rng *g, enum rig_storage storage)
{
    rig p;
    memset(&p, 0, sizeof p);
    double q[4];
    random_unit(g, 4, q);
    const rotor attitude = {q[0], q[1], q[2], q[3]};
    rig_set_attitude(&p, attitude);
    random_vector(g, 1, p.omega);
    random_vector(g, 0.5, p.pendulum.rho0);
    p.pendulum.rho0[2] += 1;
    p.pendulum.weight = uniform(g, 0.5, 1.5);
    p.inertia = uniform(g, 0.5, 2);
    p.storage = storage;
    p.frame = VTI_FRAME_SPACE;
    return p;
}

/** The pendulum of the paper's section 3: m = g = J = 1, E0 = 0.04 + 1/sqrt 2. */
static inline rig rig_of_the_paper(enum rig_storage storage)
{
    rig p;
    memset(&p, 0, sizeof p);
    const double e2[3] = {0, 1, 0};
    rig_set_attitude(&p, quat_turn(e2, 0.75L * PI_L));
    p.omega[0] = p.omega[2] = 0.2;
    p.pendulum.weight = p.pendulum.rho0[2] = p.inertia = 1;
    p.storage = storage;
    p.frame = VTI_FRAME_SPACE;
    return p;
}

/** The moment at the attitude of b, in the frame of the rig's omega. */
static inline void rig_load(void *self, const vti_bodies *b)
{
    const rig *p = self;
    const vti_effect effect = vti_pendulum_effect(&p->pendulum);
    vti_apply(&effect, 1, b);
    if (p->frame == VTI_FRAME_BODY) {
        double a[3], *const m = b->moment.c[0];
        if (p->storage == RIG_QUAT)
            vti_rrv_from_quat_xyzw(b->quat.xyzw[0], a);
        else
            memcpy(a, b->alpha.c[0], sizeof a);
        vti_rrv_rotate_back(a, m, m);
    }
}

static inline void rig_moment(rig *p)
{
    const vti_bodies b = rig_bodies(p);
    rig_load(p, &b);
}

/** N steps; the moment at the start is made here. */
static inline void rig_steps(rig *p, const vti_stepper *method, double h, int64_t steps)
{
    rig elsewhere = *p;
    const vti_bodies b = rig_bodies(p);
    vti_bodies probed = rig_bodies(&elsewhere);
    probed.moment = b.moment;
    rig_moment(p);
    for (int64_t i = 0; i < steps; ++i)
        play_step(method, h, &b, &probed, rig_load, p);
}

/** N steps of a method as a user runs it: started before them and read out after them. */
static inline void rig_run(rig *p, const vti_stepper *method, double h, int64_t steps)
{
    const vti_bodies b = rig_bodies(p);
    rig_moment(p);
    vti_step_start(method, h, &b);
    rig_steps(p, method, h, steps);
    vti_step_sync(method, h, &b);
}

static inline double rig_energy(rig *p)
{
    const vti_effect effect = vti_pendulum_effect(&p->pendulum);
    const vti_bodies b = rig_bodies(p);
    return vti_energy(&effect, 1, &b);
}

/** The largest difference of two states: of attitudes as an angle, of Omega by components. */
static inline double rig_difference(const rig *p, const rig *q)
{
    double d = quat_distance(rig_attitude(p), rig_attitude(q));
    for (int k = 0; k < 3; ++k)
        d = fmax(d, fabs(p->omega[k] - q->omega[k]));
    return d;
}

#endif
