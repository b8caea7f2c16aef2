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
