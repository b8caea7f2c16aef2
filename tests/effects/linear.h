/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What damps two bodies of any inertia where they act on each other, in long double: dy/dt = A y of the velocities and
 * L of both, by the equations of motion. */
#ifndef VTI_TESTS_LINEAR_H
#define VTI_TESTS_LINEAR_H

#include "matrix.h"
#include "uneven.h"

/** Of one place: arms from the centres, and the coefficients of the four motions; plane: body[0] against what stands
 *  still. */
struct linear {
    int plane, body[2];
    vec n, arm[2];
    long double c[4];
};

static inline vec linear_over(const uneven *m, int i, vec a, int per)
{
    const double once[3] = {(double)a.c[0], (double)a.c[1], (double)a.c[2]};
    double low[3], r[3], s[3];
    vec sum;
    /* what double leaves out, so that the system is known to more digits than the library */
    for (int k = 0; k < 3; ++k)
        low[k] = (double)(a.c[k] - once[k]);
    uneven_times(m, i, per, once, r);
    uneven_times(m, i, per, low, s);
    for (int k = 0; k < 3; ++k)
        sum.c[k] = (long double)r[k] + s[k];
    return sum;
}

static inline vec vec_across(vec a, vec n)
{
    return vec_add(a, -vec_dot(a, n), n);
}

/** Adds dv/dt and dL/dt of both sides. */
static inline void linear_rate(const uneven *m, const struct linear *at, const vec y[4], vec f[4])
{
    const vec zero = {{0, 0, 0}};
    vec u = zero, w = zero;
    for (int j = 0; j < (at->plane ? 1 : 2); ++j) {
        const vec omega = linear_over(m, at->body[j], y[2 * j + 1], -1);
        u = vec_add(u, j ? -1 : 1, vec_add(y[2 * j], 1, vec_cross(omega, at->arm[j])));
        w = vec_add(w, j ? -1 : 1, omega);
    }
    vec force = vec_add(zero, -at->c[0] * vec_dot(u, at->n), at->n),
        moment = vec_add(zero, -at->c[3] * vec_dot(w, at->n), at->n);
    force = vec_add(force, -at->c[1], vec_across(u, at->n));
    moment = vec_add(moment, -at->c[2], vec_across(w, at->n));
    for (int j = 0; j < 2; ++j) {
        const long double sign = j ? -1 : 1;
        if (j && at->plane)
            continue;
        f[2 * j] = vec_add(f[2 * j], sign / m->t.c.mass[at->body[j]], force);
        f[2 * j + 1] = vec_add(vec_add(f[2 * j + 1], sign, vec_cross(at->arm[j], force)), sign, moment);
    }
}

/** y(t) of n places between the same bodies, by Taylor series of A t/parts. */
static inline void linear_flow(const uneven *m, const struct linear *at, int n, double t, int parts, vec y[4])
{
    for (int part = 0; part < parts; ++part) {
        vec term[4];
        memcpy(term, y, sizeof term);
        for (int k = 1; k < 30; ++k) {
            vec next[4] = {{{0, 0, 0}}};
            for (int place = 0; place < n; ++place)
                linear_rate(m, &at[place], term, next);
            for (int q = 0; q < 4; ++q) {
                for (int c = 0; c < 3; ++c)
                    term[q].c[c] = next[q].c[c] * (long double)t / parts / k;
                y[q] = vec_add(y[q], 1, term[q]);
            }
        }
    }
}

/** Moments of a real body, scale times 0.2 ... 2. */
static inline void linear_moments(rng *g, double scale, double moments[3])
{
    const double a = uniform(g, 0.1, 1), b = uniform(g, 0.1, 1), c = uniform(g, 0.1, 1);
    moments[0] = scale * (a + b);
    moments[1] = scale * (b + c);
    moments[2] = scale * (c + a);
}

/** Bodies anyhow, each with so many spheres. */
static inline void linear_bodies(uneven *m, rng *g, int kind, int state, int n, int spheres)
{
    uneven_clear(m, (enum uneven_kind)kind, rng_below(g, 2) ? CROWD_ALPHA : CROWD_QUAT, n);
    crowd_tumble(&m->t.c, g);
    for (int i = 0; i < n; ++i) {
        m->t.c.mass[i] = uniform(g, 0.5, 2);
        m->t.c.inertia[i] = uniform(g, 0.1, 0.5);
        linear_moments(g, 0.3, m->moments[i]);
        random_unit(g, 4, m->principal[i]);
        random_vector(g, 1, m->t.c.v[i]);
        random_vector(g, 2, m->t.c.omega[i]);
        for (int s = 0; s < spheres; ++s) {
            double offset[3] = {0, 0, 0};
            if (kind != UNEVEN_BODIES)
                random_vector(g, 0.6, offset);
            uneven_sphere(m, i, offset, uniform(g, 0.4, 1));
        }
    }
    uneven_link(m, (enum uneven_state)state, 1, 1e4);
    uneven_spin_up(m);
}

static inline vec linear_lever(uneven *m, int s)
{
    double r[3];
    quat_rotate(crowd_attitude(&m->t.c, (int)m->t.body[s]), m->t.offset[s], r);
    return vec_of(r);
}

/** v and L of the first two bodies, 0 where there is one. */
static inline void linear_state(const uneven *m, vec y[4])
{
    memset(y, 0, 4 * sizeof *y);
    for (int i = 0; i < 2 && i < m->t.c.n; ++i) {
        double w[3], spin[3];
        uneven_omega(m, i, w);
        uneven_times(m, i, 1, w, spin);
        y[2 * i] = vec_of(m->t.c.v[i]);
        y[2 * i + 1] = vec_of(spin);
    }
}

/** The flow of the one effect of two bodies, of which at says the same: the exponential of the whole system, whose
 *  rates are below 2 (1/m + a^2/J) < 200, so that terms fall from the first on. P and L stay, and what kinetic energy
 *  goes is booked. */
static inline void linear_assert_flow(uneven *m, const struct linear *at, double t, double drift)
{
    double before[6], after[6];
    vec y[4], is[4];
    const double energy = vti_energy(m->effects, 1, &m->b);
    uneven_momenta(m, before);
    linear_state(m, y);
    linear_flow(m, at, 1, t, 64, y);
    assert_int_equal(vti_effects_flow(m->effects, 1, t, drift, &m->b), VTI_OK);
    linear_state(m, is);
    for (int q = 0; q < 4; ++q) /* some 200 operations on numbers below 5 */
        for (int k = 0; k < 3; ++k)
            assert_close(is[q].c[k], y[q].c[k], 1000 * EPS);
    if (m->b.omega.c[0] != NULL) { /* the read-out follows */
        double w[3];
        uneven_omega(m, 0, w);
        assert_close3(m->t.c.omega[0], w, 200 * EPS);
    }
    uneven_momenta(m, after);
    for (int k = 0; k < 6 && !at->plane; ++k)
        assert_close(after[k], before[k], 200 * EPS);
    const double left = vti_energy(m->effects, 1, &m->b);
    assert_close(left + vti_booked(m->effects, 1), energy, 100 * EPS * energy);
    assert_true(left <= energy * (1 + 4 * EPS) && vti_booked(m->effects, 1) > 0);
}

#endif
