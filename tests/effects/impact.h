/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Two spheres, or one and a plane, that meet: what the tests of dissipation share. */
#ifndef VTI_TESTS_IMPACT_H
#define VTI_TESTS_IMPACT_H

#include "crowd.h"

typedef struct impact {
    crowd c;
    double diameter[CROWD_MAX];
    int64_t pair[WEB_MAX][2];
    double plane[6][4];
    vti_contacts contacts;
    vti_walls walls;
    vti_sum lost[4];
    vti_bodies b;
    vti_effect effects[8];
    int64_t count; /* effects */
} impact;

/** n spheres that may all touch each other, and so many planes, without an effect yet. Not to be copied. */
static inline void impact_clear(impact *m, int n, int planes, double stiffness)
{
    memset(m, 0, sizeof *m);
    crowd_clear(&m->c, n, CROWD_ALPHA);
    int64_t pairs = 0;
    for (int i = 0; i < n; ++i) {
        m->diameter[i] = 1;
        m->c.inertia[i] = 0.1;
        for (int j = i + 1; j < n; ++j, ++pairs) {
            m->pair[pairs][0] = i;
            m->pair[pairs][1] = j;
        }
    }
    m->contacts = (vti_contacts){
        .count = pairs, .pair = m->pair[0], .diameter = vti_scalars_array(m->diameter), .stiffness = stiffness};
    m->walls = (vti_walls){
        .count = planes, .plane = m->plane[0], .diameter = vti_scalars_array(m->diameter), .stiffness = stiffness};
    m->b = crowd_bodies(&m->c);
}

/** A random state of two spheres, or one and a plane, that overlap by a share o of their mean diameter. */
static inline void impact_touch(impact *m, rng *g, int plane, double o)
{
    double n[3];
    impact_clear(m, 2, plane, 1e4);
    random_unit(g, 3, n);
    for (int i = 0; i < 2; ++i) {
        m->diameter[i] = uniform(g, 0.4, 2);
        m->c.mass[i] = pow(10, uniform(g, -1.5, 1.5)) * pow(m->diameter[i], 3);
        m->c.inertia[i] = uniform(g, 0.05, 0.17) * m->c.mass[i] * m->diameter[i] * m->diameter[i];
        random_vector(g, 2, m->c.v[i]);
        random_vector(g, 4, m->c.omega[i]);
        random_vector(g, 1, m->c.x[i]);
    }
    const double length = plane ? 0.5 * m->diameter[0] : 0.5 * (m->diameter[0] + m->diameter[1]);
    for (int k = 0; k < 3; ++k) {
        m->plane[0][k] = n[k];
        m->c.x[1][k] += plane ? 40 * n[k] : 0; /* out of the way */
        m->c.x[0][k] = (plane ? 0 : m->c.x[1][k]) + length * (1 - o) * n[k];
    }
}

/** u of the contact point and w, of body 0 against body 1 or the plane, as EQUATIONS 6.2 has them, and their masses. */
static inline void impact_relative(const impact *m, int plane, double u[3], double w[3], double masses[3])
{
    const double si = plane ? 1 : m->diameter[0] / (m->diameter[0] + m->diameter[1]), sj = 1 - si;
    double d[3], spin[3], cross[3], r = 0;
    for (int k = 0; k < 3; ++k) {
        d[k] = m->c.x[0][k] - (plane ? 0 : m->c.x[1][k]);
        spin[k] = si * m->c.omega[0][k] + (plane ? 0 : sj * m->c.omega[1][k]);
        w[k] = m->c.omega[0][k] - (plane ? 0 : m->c.omega[1][k]);
        r += d[k] * d[k];
    }
    vti_cross(spin, d, cross);
    for (int k = 0; k < 3; ++k)
        u[k] = m->c.v[0][k] - (plane ? 0 : m->c.v[1][k]) - cross[k];
    const double other = plane ? 0 : 1;
    masses[0] = 1 / (1 / m->c.mass[0] + other / m->c.mass[1]);
    masses[1] = 1 / (1 / masses[0] + r * (si * si / m->c.inertia[0] + other * sj * sj / m->c.inertia[1]));
    masses[2] = 1 / (1 / m->c.inertia[0] + other / m->c.inertia[1]);
}

/** Adds an effect. */
static inline void impact_add(impact *m, vti_effect effect)
{
    m->effects[m->count++] = effect;
}

/** So many steps, at whose end bonds may break. */
static inline void impact_go(impact *m, const vti_stepper *method, double h, int64_t steps)
{
    assert_int_equal(vti_apply(m->effects, m->count, &m->b), VTI_OK);
    for (int64_t step = 0; step < steps; ++step) {
        assert_int_equal(vti_effects_begin(method, h, m->effects, m->count, &m->b, NULL), VTI_OK);
        assert_int_equal(vti_apply(m->effects, m->count, &m->b), VTI_OK);
        assert_int_equal(vti_effects_finish(method, h, m->effects, m->count, &m->b), VTI_OK);
        int64_t broken = 0;
        assert_int_equal(vti_effects_rupture(m->effects, m->count, &m->b, &broken), VTI_OK);
        if (broken > 0)
            assert_int_equal(vti_apply(m->effects, m->count, &m->b), VTI_OK);
    }
}

/** T + U + what is booked. */
static inline double impact_ledger(const impact *m)
{
    return vti_energy(m->effects, m->count, &m->b) + vti_booked(m->effects, m->count);
}

/** Of a Hertzian contact of F = k_h delta^{3/2} that reduced mass m meets at the speed v: 2.943 (5 m/(4 k_h))^{2/5}
 *  v^{-1/5} (Hertz), how long it lasts without damping. */
static inline double impact_duration(double m, double k_h, double v)
{
    return 2.9432751 * pow(1.25 * m / k_h, 0.4) * pow(v, -0.2);
}

/** 2/omega at the deepest overlap without damping, (5 m v^2/(4 k_h))^{2/5}. */
static inline double impact_stable(double m, double k_h, double v)
{
    return 2 / sqrt(1.5 * k_h * sqrt(pow(1.25 * m * v * v / k_h, 0.4)) / m);
}

#endif
