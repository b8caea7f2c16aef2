/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Velocity Verlet of bodies of three moments, around a law by which others turn an attitude while L is kept:
 *
 *     v += h/2 F/m,  L += h/2 RM,  x += h v,  the law,  forces,  v += h/2 F/m,  L += h/2 RM
 *
 * A law is inlined whole into the loop of each rival that names it, as in verlet.h. */
#ifndef VTI_GENERAL_H
#define VTI_GENERAL_H

#include "euler.h"
#include "quaternion.h"
#include "verlet.h"

/** Numbers of a body that a rival keeps beside its quaternion, and one of a course: whether principal axes are turned
 *  against the body's. */
enum { GENERAL_I = 0, GENERAL_K = 3, GENERAL_P = 6, GENERAL_WIDTH = 10, GENERAL_TURNED = 0 };

/** Turns q, which takes the principal axes into space, over a time h with the moments I, k = 1/I and the angular
 *  momentum L in space. Returns 0, or -1 if there is no such turn. */
typedef int general_law(double h, const double I[3], const double k[3], const double L[3], double q[4]);

/** Takes moments and principal axes over from the model. */
int general_prepare(struct course *course, struct message *message);
/** Shows Omega = R_p diag(k) R_p^T L. */
void general_show(struct course *course);
/** Body i's quaternion from principal axes into space; and back from that. */
void general_axes(const struct course *course, int64_t i, double q[4]);
void general_set_axes(struct course *course, int64_t i, const double q[4]);

/** w = diag(k) R_p^T L, along the principal axes. */
VTI_INLINE void general_body_omega(const double k[3], const double L[3], const double q[4], double w[3])
{
    vti_pair_rotate(q, -1.0, L, w);
    for (int n = 0; n < 3; ++n)
        w[n] *= k[n];
}

/** r = q (u, c): the attitude q turned about axes of the body. r is not q. */
VTI_INLINE void general_turned(double c, const double u[3], const double q[4], double r[4])
{
    r[0] = c * q[0] + q[3] * u[0] + (q[1] * u[2] - q[2] * u[1]);
    r[1] = c * q[1] + q[3] * u[1] + (q[2] * u[0] - q[0] * u[2]);
    r[2] = c * q[2] + q[3] * u[2] + (q[0] * u[1] - q[1] * u[0]);
    r[3] = c * q[3] - (q[0] * u[0] + q[1] * u[1] + q[2] * u[2]);
}

/** A body whose law has no solution; its value is |J^-1 h p|, the turn that a sphere would make of it. */
static inline int general_refused(struct course *c, int64_t i, const double k[3], const double L[3], const double q[4])
{
    double w[3];
    general_body_omega(k, L, q, w);
    c->fault.body = i;
    c->fault.value = c->h * vti_norm(w);
    return VTI_E_TOO_LARGE;
}

/** The law on all bodies. */
VTI_INLINE int general_turn(struct course *c, general_law *law)
{
    const double h = c->h;
    const int turned = c->number[GENERAL_TURNED] != 0.0;
    double *restrict q = c->q;
    const double *restrict L = c->L;
    const double *restrict own = c->own;
    for (int64_t i = 0; i < c->n; ++i, own += GENERAL_WIDTH) {
        double axes[4], *const p = turned ? axes : q + 4 * i;
        if (turned)
            general_axes(c, i, axes);
        if (law(h, own + GENERAL_I, own + GENERAL_K, L + 3 * i, p) != 0)
            return general_refused(c, i, own + GENERAL_K, L + 3 * i, p);
        if (turned)
            general_set_axes(c, i, axes);
    }
    return VTI_OK;
}

/** v += t F/m, L += t RM. */
VTI_INLINE void general_kick(const struct course *c, double t)
{
    static const double one = 1.0;
    const vti_scalars per_one = vti_scalars_one(&one);
    rival_kick(t, c->v, c->f, &c->per_mass, 0, c->n);
    rival_kick(t, c->L, c->m, &per_one, 0, c->n);
}

VTI_INLINE int general_verlet(struct course *c, int64_t steps, general_law *law)
{
    const double h = c->h;
    for (int64_t k = 0; k < steps; ++k) {
        general_kick(c, 0.5 * h);
        rival_translate(h, c->x, c->v, 0, c->n);
        int status = general_turn(c, law);
        if (status == VTI_OK)
            status = course_forces(c);
        if (status != VTI_OK)
            return status;
        general_kick(c, 0.5 * h);
        ++c->steps;
    }
    return VTI_OK;
}

/** A rival by a law: its function go, and the row. */
#define GENERAL_RIVAL(NAME, LAW, ORDER, STEPPER, ABOUT)                                                                \
    static int LAW##_go(struct course *c, int64_t steps)                                                               \
    {                                                                                                                  \
        return general_verlet(c, steps, LAW);                                                                          \
    }                                                                                                                  \
    const struct rival NAME = {                                                                                        \
        .stepper = RIVAL_STEPPER(STEPPER, ORDER, 0.0, 1, 2.0, ABOUT),                                                  \
        .own_width = GENERAL_WIDTH,                                                                                    \
        .prepare = general_prepare,                                                                                    \
        .go = LAW##_go,                                                                                                \
        .show = general_show,                                                                                          \
        .takes_forces = 1,                                                                                             \
        .general = RIVAL_OF_MOMENTS,                                                                                   \
    };

#endif
