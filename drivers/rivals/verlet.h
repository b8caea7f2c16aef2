/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Verlet's method in its two forms, around a law by which a quaternion is turned. A law is inlined whole into the
 * loop of each rival that names it: no call is left per body. */
#ifndef VTI_VERLET_H
#define VTI_VERLET_H

#include "rivals.h"

/** Turns q by the rotation vector u = h Omega, as a rival does it. */
typedef void turn_law(const double u[3], double q[4]);

/** a += (t/m) f; nothing if there is no f. */
VTI_INLINE void rival_kick(double t, double *restrict a, const double *restrict f, const vti_scalars *per,
                           int64_t begin, int64_t end)
{
    if (f == NULL)
        return;
    if (per->stride == 0) {
        const double k = t * *per->p;
        for (int64_t j = 3 * begin; j < 3 * end; ++j)
            a[j] += k * f[j];
        return;
    }
    const double *restrict p = per->p;
    for (int64_t i = begin; i < end; ++i) {
        const double k = t * p[i];
        a[3 * i] += k * f[3 * i];
        a[3 * i + 1] += k * f[3 * i + 1];
        a[3 * i + 2] += k * f[3 * i + 2];
    }
}

/** v += t F/m, Omega += t RM/J. */
VTI_INLINE void rival_kick_all(const struct course *c, double t, int64_t begin, int64_t end)
{
    rival_kick(t, c->v, c->f, &c->per_mass, begin, end);
    rival_kick(t, c->w, c->m, &c->per_inertia, begin, end);
}

/** x += h v */
VTI_INLINE void rival_translate(double h, double *restrict x, const double *restrict v, int64_t begin, int64_t end)
{
    if (x == NULL)
        return;
    for (int64_t j = 3 * begin; j < 3 * end; ++j)
        x[j] += h * v[j];
}

VTI_INLINE void rival_turn(double h, double *restrict q, const double *restrict w, turn_law *turn, int64_t begin,
                           int64_t end)
{
    if (q == NULL)
        return;
    for (int64_t i = begin; i < end; ++i) {
        const double u[3] = {h * w[3 * i], h * w[3 * i + 1], h * w[3 * i + 2]};
        turn(u, q + 4 * i);
    }
}

/** kick(t), drift(h). Bodies of one block stay in the first-level cache from the one to the other. */
VTI_INLINE void rival_kick_drift(const struct course *c, double t, double h, turn_law *turn)
{
    enum { BLOCK = 256 };
    for (int64_t first = 0; first < c->n; first += BLOCK) {
        const int64_t next = c->n - first < BLOCK ? c->n : first + BLOCK;
        rival_kick_all(c, t, first, next);
        rival_translate(h, c->x, c->v, first, next);
        rival_turn(h, c->q, c->w, turn, first, next);
    }
}

/** Velocity Verlet: kick(h/2) drift(h) forces kick(h/2). */
VTI_INLINE int rival_verlet(struct course *c, int64_t steps, turn_law *turn)
{
    const double h = c->h;
    for (int64_t k = 0; k < steps; ++k) {
        rival_kick_drift(c, 0.5 * h, h, turn);
        const int status = course_forces(c);
        if (status != VTI_OK)
            return status;
        rival_kick_all(c, 0.5 * h, 0, c->n);
        ++c->steps;
    }
    return VTI_OK;
}

/** Leapfrog, velocities at half steps: kick(h) drift(h) forces. */
VTI_INLINE int rival_leapfrog(struct course *c, int64_t steps, turn_law *turn)
{
    const double h = c->h;
    for (int64_t k = 0; k < steps; ++k) {
        rival_kick_drift(c, h, h, turn);
        const int status = course_forces(c);
        if (status != VTI_OK)
            return status;
        ++c->steps;
    }
    return VTI_OK;
}

#endif
