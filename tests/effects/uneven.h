/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bodies that are not spheres where they touch, for the tests of dissipation: bodies with moments that have a diameter,
 * clumps of bodies with moments, and clumps of bodies with one inertia. */
#ifndef VTI_TESTS_UNEVEN_H
#define VTI_TESTS_UNEVEN_H

#include "troop.h"

enum uneven_kind { UNEVEN_BODIES, UNEVEN_CLUMPS, UNEVEN_SPHERICAL, UNEVEN_KINDS };
enum uneven_state { UNEVEN_SPIN, UNEVEN_BOTH, UNEVEN_OMEGA, UNEVEN_STATES };
enum { UNEVEN_EFFECTS = 6, UNEVEN_SLOTS = 256 };

typedef struct uneven {
    enum uneven_kind kind;
    troop t; /* without clumps its spheres are not there, and contacts are the bodies' */
    double moments[CROWD_MAX][3], spin[CROWD_MAX][3], principal[CROWD_MAX][4];
    double plane[3][4];
    vti_walls walls;
    vti_bodies b;
    vti_sum lost[4], rubbed[3];
    vti_held entries[UNEVEN_SLOTS];
    int64_t slot[UNEVEN_SLOTS];
    vti_history history;
    int64_t count;
    vti_effect inner[UNEVEN_EFFECTS], effects[UNEVEN_EFFECTS];
    vti_clumped clumped[UNEVEN_EFFECTS];
} uneven;

/** n bodies at rest; spheres are to be added. Not to be copied. */
static inline void uneven_clear(uneven *m, enum uneven_kind kind, enum crowd_storage storage, int n)
{
    memset(m, 0, sizeof *m);
    m->kind = kind;
    crowd_clear(&m->t.c, n, storage);
    crowd_clear(&m->t.s, 0, CROWD_ALPHA);
    m->history = (vti_history){UNEVEN_SLOTS, 0, 0, m->entries, m->slot};
    for (int i = 0; i < n; ++i)
        m->principal[i][3] = m->moments[i][0] = m->moments[i][1] = m->moments[i][2] = 1;
}

/** A sphere of body i; without clumps it is the body, and sits at its centre. */
static inline void uneven_sphere(uneven *m, int i, const double offset[3], double diameter)
{
    const int s = m->kind == UNEVEN_BODIES ? i : m->t.s.n;
    m->t.body[s] = i;
    m->t.diameter[s] = diameter;
    memcpy(m->t.offset[s], offset, sizeof m->t.offset[s]);
    ++m->t.s.n;
}

/** Views, once all spheres are there: contacts of all pairs but those of one body, walls of so many planes. */
static inline void uneven_link(uneven *m, enum uneven_state state, int planes, double stiffness)
{
    const int n = m->t.s.n;
    for (int s = 0; s < n; ++s) {
        m->t.s.quat[s][3] = 1;
        m->t.s.mass[s] = m->t.s.inertia[s] = 1;
    }
    troop_link(&m->t);
    troop_touch(&m->t, stiffness);
    m->walls = (vti_walls){
        .count = planes, .plane = m->plane[0], .diameter = vti_scalars_array(m->t.diameter), .stiffness = stiffness};
    m->b = crowd_bodies(&m->t.c);
    m->count = 0;
    if (m->kind == UNEVEN_SPHERICAL)
        return;
    m->b.inertia.p = NULL;
    m->b.moments = vti_view_packed(m->moments[0]);
    m->b.principal = quats_packed(m->principal[0]);
    if (state != UNEVEN_OMEGA)
        m->b.spin = vti_view_packed(m->spin[0]);
    if (state == UNEVEN_SPIN && m->kind == UNEVEN_CLUMPS)
        m->b.omega = vti_view_none();
}

static inline rotor uneven_axes(const uneven *m, int i)
{
    const rotor q = crowd_attitude(&m->t.c, i);
    return m->kind == UNEVEN_SPHERICAL ? q : quat_times(q, quat_of_xyzw(m->principal[i]));
}

/** The moment k of body i. */
static inline double uneven_moment(const uneven *m, int i, int k)
{
    return m->kind == UNEVEN_SPHERICAL ? m->t.c.inertia[i] : m->moments[i][k];
}

/** r = J a, or for per of -1 J^-1 a, in long double. */
static inline void uneven_times(const uneven *m, int i, int per, const double a[3], double r[3])
{
    const rotor q = uneven_axes(m, i);
    quat_rotate(quat_conj(q), a, r);
    for (int k = 0; k < 3; ++k)
        r[k] = per > 0 ? r[k] * uneven_moment(m, i, k) : r[k] / uneven_moment(m, i, k);
    quat_rotate(q, r, r);
}

/** L of Omega. */
static inline void uneven_spin_up(uneven *m)
{
    for (int i = 0; i < m->t.c.n; ++i)
        uneven_times(m, i, 1, m->t.c.omega[i], m->spin[i]);
}

/** Omega as the state has it. */
static inline void uneven_omega(const uneven *m, int i, double w[3])
{
    if (m->b.spin.c[0] != NULL)
        uneven_times(m, i, -1, m->spin[i], w);
    else
        memcpy(w, m->t.c.omega[i], 3 * sizeof *w);
}

/** Adds an effect, on the spheres where there are clumps. */
static inline void uneven_add(uneven *m, vti_effect effect)
{
    const int64_t k = m->count++;
    m->inner[k] = effect;
    m->clumped[k] = (vti_clumped){&m->t.clumps, &m->inner[k]};
    m->effects[k] = m->kind == UNEVEN_BODIES ? effect : vti_clumped_effect(&m->clumped[k]);
}

/** So many steps. */
static inline void uneven_go(uneven *m, const vti_stepper *method, double h, int64_t steps)
{
    assert_int_equal(vti_apply(m->effects, m->count, &m->b), VTI_OK);
    for (int64_t step = 0; step < steps; ++step) {
        assert_int_equal(vti_effects_begin(method, h, m->effects, m->count, &m->b, NULL), VTI_OK);
        assert_int_equal(vti_apply(m->effects, m->count, &m->b), VTI_OK);
        assert_int_equal(vti_effects_finish(method, h, m->effects, m->count, &m->b), VTI_OK);
    }
}

/** T + U + what is booked. */
static inline double uneven_ledger(const uneven *m)
{
    return vti_energy(m->effects, m->count, &m->b) + vti_booked(m->effects, m->count);
}

/** Total momentum, and angular momentum about 0. */
static inline void uneven_momenta(const uneven *m, double momenta[6])
{
    const double origin[3] = {0, 0, 0};
    vti_momentum(&m->b, momenta);
    vti_angular_momentum(&m->b, origin, momenta + 3);
}

#endif
