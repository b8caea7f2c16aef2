/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Contacts as most codes step them, for comparison with the library: velocity Verlet, forces of dashpots and
 * friction from the velocities of half a step, what they take booked as F.v h, the spring of friction turned into
 * the plane of contact by projection and returned to mu F_n along itself. Spheres against each other and against
 * planes at rest. Bonds, which have no dashpots, act and break as the library's. */
#ifndef VTI_TESTS_USUAL_H
#define VTI_TESTS_USUAL_H

#include "impact.h"

typedef struct usual {
    impact *m;
    double mu, stiffness, zeta, ratio; /* of the spring, of the dashpots */
    double g[3];
    double spring[WEB_MAX][3]; /* lengths; pairs, then body by body its planes */
    double lost;               /* what dashpots, sliding and springs have taken */
    vti_effect bonds[2];       /* and their rupture */
    int64_t bonds_count;       /* 0: there are none */
} usual;

/** One touch: body j < 0 is a plane; n from it to i, overlap delta of length, arms along n. */
static inline void usual_touch(usual *u, int i, int j, const double n[3], double delta, double length, double r,
                               double spring[3], double h)
{
    crowd *const c = &u->m->c;
    double rel[3], spin[3], across[3], force[3], sliding[3];
    if (!(delta > 0)) {
        memset(spring, 0, 3 * sizeof *spring);
        return;
    }
    const double si = j < 0 ? 1 : u->m->diameter[i] / (u->m->diameter[i] + u->m->diameter[j]);
    const double mass = j < 0 ? c->mass[i] : 1 / (1 / c->mass[i] + 1 / c->mass[j]);
    const double k_h = (j < 0 ? u->m->walls.stiffness : u->m->contacts.stiffness) / pow(length, 2.5);
    const double elastic = k_h * delta * sqrt(delta);
    const double damping = sqrt(5.0) * u->zeta * sqrt(mass * k_h) * sqrt(sqrt(delta));
    for (int k = 0; k < 3; ++k) {
        rel[k] = c->v[i][k] - (j < 0 ? 0 : c->v[j][k]);
        spin[k] = (si * c->omega[i][k] + (j < 0 ? 0 : (1 - si) * c->omega[j][k])) * r;
    }
    vti_cross(spin, n, across);
    for (int k = 0; k < 3; ++k)
        rel[k] -= across[k];
    const double along = vti_dot(rel, n), off = vti_dot(spring, n), pull = fmin(damping * along, elastic);
    for (int k = 0; k < 3; ++k) {
        rel[k] -= along * n[k];
        spring[k] += h * rel[k] - off * n[k];
        sliding[k] = -u->stiffness * spring[k] - u->ratio * damping * rel[k];
    }
    const double size = vti_norm(sliding);
    if (size > u->mu * elastic)
        for (int k = 0; k < 3; ++k) {
            sliding[k] *= u->mu * elastic / size;
            spring[k] = -(sliding[k] + u->ratio * damping * rel[k]) / u->stiffness;
        }
    u->lost += h * (pull * along - vti_dot(sliding, rel)); /* what springs hold is a part of it */
    for (int k = 0; k < 3; ++k) {
        force[k] = (elastic - pull) * n[k] + sliding[k];
        c->force[i][k] += force[k];
        c->force[j < 0 ? i : j][k] -= j < 0 ? 0 : force[k];
    }
    vti_cross(n, sliding, across);
    for (int k = 0; k < 3; ++k) {
        c->moment[i][k] -= si * r * across[k];
        c->moment[j < 0 ? i : j][k] -= j < 0 ? 0 : (1 - si) * r * across[k];
    }
}

/** Forces of all touches and bonds; the springs move by h. */
static inline void usual_forces(usual *u, double h)
{
    impact *const m = u->m;
    crowd *const c = &m->c;
    int at = 0;
    for (int i = 0; i < c->n; ++i)
        for (int k = 0; k < 3; ++k) {
            c->force[i][k] = c->mass[i] * u->g[k];
            c->moment[i][k] = 0;
        }
    for (int64_t p = 0; p < m->contacts.count; ++p, ++at) {
        const int i = (int)m->pair[p][0], j = (int)m->pair[p][1];
        double n[3];
        for (int k = 0; k < 3; ++k)
            n[k] = c->x[i][k] - c->x[j][k];
        const double r = vti_norm(n), length = 0.5 * (m->diameter[i] + m->diameter[j]);
        for (int k = 0; k < 3; ++k)
            n[k] /= r;
        usual_touch(u, i, j, n, length - r, length, r, u->spring[at], h);
    }
    for (int i = 0; i < c->n; ++i)
        for (int w = 0; w < m->walls.count; ++w, ++at) {
            const double r = vti_dot(c->x[i], m->plane[w]) - m->plane[w][3];
            usual_touch(u, i, -1, m->plane[w], 0.5 * m->diameter[i] - r, 0.5 * m->diameter[i], r, u->spring[at], h);
        }
    if (u->bonds_count > 0)
        u->bonds[0].apply(u->bonds[0].self, &m->b);
}

static inline void usual_kick(usual *u, double t)
{
    crowd *const c = &u->m->c;
    for (int i = 0; i < c->n; ++i)
        for (int k = 0; k < 3; ++k) {
            c->v[i][k] += t / c->mass[i] * c->force[i][k];
            c->omega[i][k] += t / c->inertia[i] * c->moment[i][k];
        }
}

/** So many steps. */
static inline void usual_go(usual *u, double h, int64_t steps)
{
    usual_forces(u, 0);
    for (int64_t step = 0; step < steps; ++step) {
        usual_kick(u, 0.5 * h);
        assert_int_equal(vti_drift(VTI_LAW_EXACT, VTI_FRAME_SPACE, h, &u->m->b, NULL), VTI_OK);
        usual_forces(u, h);
        usual_kick(u, 0.5 * h);
        int64_t broken = 0;
        if (u->bonds_count > 0)
            assert_int_equal(vti_effects_rupture(u->bonds, u->bonds_count, &u->m->b, &broken), VTI_OK);
        if (broken > 0)
            usual_forces(u, 0);
    }
}

#endif
