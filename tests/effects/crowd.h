/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A crowd of bodies and a web of bonds between them, for the tests of the effects. */
#ifndef VTI_TESTS_CROWD_H
#define VTI_TESTS_CROWD_H

#include "bodies.h"
#include "support.h"

enum { CROWD_MAX = 80, WEB_MAX = 240 };
enum crowd_storage { CROWD_ALPHA, CROWD_QUAT };
enum { MOMENT = 1, AXIAL = 2, SHEAR = 4 };

typedef struct crowd {
    int n;
    enum crowd_storage storage;
    double x[CROWD_MAX][3], v[CROWD_MAX][3], force[CROWD_MAX][3];
    double alpha[CROWD_MAX][3], quat[CROWD_MAX][4], omega[CROWD_MAX][3], moment[CROWD_MAX][3];
    double mass[CROWD_MAX], inertia[CROWD_MAX];
} crowd;

/** Bonds with stiffnesses of their own; bonds points into the web, which therefore is not to be copied. */
typedef struct web {
    int64_t pair[WEB_MAX][2];
    double rest[WEB_MAX][4], moment[WEB_MAX], axial[WEB_MAX], shear[WEB_MAX];
    vti_bonds bonds;
} web;

/* ---- crowds ------------------------------------------------------------------------------------------------------ */

static inline vti_bodies crowd_bodies(crowd *c)
{
    return bodies_of(c, c->n, c->storage == CROWD_QUAT);
}

static inline rotor crowd_attitude(const crowd *c, int i)
{
    return c->storage == CROWD_QUAT ? quat_of_xyzw(c->quat[i]) : quat_of_alpha(c->alpha[i]);
}

static inline void crowd_set_attitude(crowd *c, int i, rotor q)
{
    q = quat_unit(q);
    const long double w = q.w, r[3] = {q.x, q.y, q.z};
    for (int k = 0; k < 3; ++k) {
        c->quat[i][k] = (double)r[k];
        c->alpha[i][k] = (double)(2 * r[k] / w);
    }
    c->quat[i][3] = (double)w;
}

/** R_i <- exp S(angle axis/|axis|) R_i */
static inline void crowd_turn(crowd *c, int i, const double axis[3], long double angle)
{
    crowd_set_attitude(c, i, quat_times(quat_turn(axis, angle), crowd_attitude(c, i)));
}

/** n bodies at rest in the reference configuration: R = I, m = J = 1. */
static inline void crowd_clear(crowd *c, int n, enum crowd_storage storage)
{
    memset(c, 0, sizeof *c);
    c->n = n;
    c->storage = storage;
    for (int i = 0; i < n; ++i)
        c->quat[i][3] = c->mass[i] = c->inertia[i] = 1.0;
}

/** Positions in a box of half the side `size`, at least `apart` from each other. */
static inline void crowd_scatter(crowd *c, rng *g, double size, double apart)
{
    for (int i = 0; i < c->n; ++i)
        for (int clear = 0; !clear;) {
            random_vector(g, size, c->x[i]);
            clear = 1;
            for (int j = 0; j < i; ++j) {
                const double d[3] = {c->x[i][0] - c->x[j][0], c->x[i][1] - c->x[j][1], c->x[i][2] - c->x[j][2]};
                clear &= vti_norm(d) >= apart;
            }
        }
}

/** Attitudes uniform on the three-sphere, so that half of the quaternions have turned past pi. */
static inline void crowd_tumble(crowd *c, rng *g)
{
    for (int i = 0; i < c->n; ++i) {
        double q[4];
        do
            random_unit(g, 4, q);
        while (fabs(q[3]) < 1e-6);
        const rotor r = {q[0], q[1], q[2], q[3]};
        crowd_set_attitude(c, i, r);
    }
}

/** Forces at the present state, steps, and no complaint. */
static inline void crowd_steps(crowd *c, const vti_stepper *method, double h, long steps, const vti_effect *effects,
                               int64_t n)
{
    const vti_bodies b = crowd_bodies(c);
    vti_apply(effects, n, &b);
    for (long k = 0; k < steps; ++k) {
        if (vti_step_begin(method, h, &b, NULL) != VTI_OK)
            fail_msg("step %ld refused", k);
        vti_apply(effects, n, &b);
        vti_step_finish(method, h, &b);
    }
}

/** Linear momentum, angular momentum about 0, sum of J Omega: in the order of the bits of vti_effect.breaks. */
static inline void crowd_momenta(crowd *c, double momenta[9])
{
    const double origin[3] = {0, 0, 0};
    const vti_bodies b = crowd_bodies(c);
    vti_momentum(&b, momenta);
    vti_angular_momentum(&b, origin, momenta + 3);
    vti_spin(&b, momenta + 6);
}

/** vti_stable_step of bonds at rest and contacts as deep as overlap, and no complaint. */
static inline double crowd_stable(crowd *c, const vti_effect *effects, int64_t n, double overlap)
{
    double scratch[CROWD_MAX];
    const vti_bodies b = crowd_bodies(c);
    const vti_deformation at = {overlap, 0, 0};
    vti_stable stable = {NAN, 0, 0, 0, 0};
    assert_int_equal(vti_stable_step(effects, n, &b, &at, scratch, &stable), VTI_OK);
    return stable.h;
}

/* ---- webs -------------------------------------------------------------------------------------------------------- */

/** The first `count` bonds of the web with the terms of the mask. */
static inline void web_terms(web *w, int64_t count, int terms, int form)
{
    memset(&w->bonds, 0, sizeof w->bonds);
    w->bonds.count = count;
    w->bonds.pair = w->pair[0];
    w->bonds.rest = w->rest[0];
    w->bonds.shear_form = form;
    if (terms & MOMENT)
        w->bonds.moment = vti_scalars_array(w->moment);
    if (terms & AXIAL)
        w->bonds.axial = vti_scalars_array(w->axial);
    if (terms & SHEAR)
        w->bonds.shear = vti_scalars_array(w->shear);
}

/** The same bonds, their bodies counted from base. */
static inline void web_base(web *w, int64_t base)
{
    for (int64_t k = 0; k < w->bonds.count; ++k)
        for (int side = 0; side < 2; ++side)
            w->pair[k][side] += base - w->bonds.base;
    w->bonds.base = base;
}

/** A random tree over the bodies and `extra` more bonds, at rest in the present positions, stiffnesses in [low,
 *  high]. */
static inline int64_t web_grow(web *w, rng *g, const crowd *c, int extra, double low, double high)
{
    int64_t count = 0;
    const vti_view x = {{(double *)c->x[0], (double *)c->x[0] + 1, (double *)c->x[0] + 2}, 3, 0};
    for (int k = 1; k < c->n + extra; ++k, ++count) {
        const int i = k < c->n ? k : rng_below(g, c->n);
        int j = rng_below(g, k < c->n ? k : c->n);
        while (j == i)
            j = rng_below(g, c->n);
        w->pair[count][k % 2] = i;
        w->pair[count][1 - k % 2] = j;
        w->moment[count] = uniform(g, low, high);
        w->axial[count] = uniform(g, low, high);
        w->shear[count] = uniform(g, low, high);
    }
    assert_int_equal(vti_bonds_rest(count, w->pair[0], 0, &x, w->rest[0], NULL), VTI_OK);
    return count;
}

/** The 15 combinations of terms: index 0-14 to mask and form; the form is 0 without shear. */
static inline void web_combination(int index, int *terms, int *form)
{
    *terms = index < 3 ? index + 1 : SHEAR | (index - 3) % 4;
    *form = index < 3 ? 0 : VTI_SHEAR_OBJECTIVE + (index - 3) / 4;
}

#endif
