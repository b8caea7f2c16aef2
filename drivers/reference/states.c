/* SPDX-License-Identifier: BSD-3-Clause */
#include "states.h"

#include <string.h>

#include "wide.h"

struct states states_of(const struct model *model)
{
    const struct states states = {model->bodies.count, model->translates, model->turns, model->bodies.mass,
                                  model->bodies.inertia};
    return states;
}

int64_t states_width(const struct states *s)
{
    return (s->translates ? 6 : 0) + (s->turns ? 7 : 0);
}

static double *put(double *p, const double *values, int n)
{
    for (int c = 0; c < n; ++c, p += PANELS_BLOCK)
        *p = values[c];
    return p;
}

static double *put_vector(double *p, const vti_view *view, int64_t i)
{
    const double values[3] = {view->c[0][i * view->stride], view->c[1][i * view->stride], view->c[2][i * view->stride]};
    return put(p, values, 3);
}

void states_put(const struct states *s, const vti_bodies *b, int64_t k, double *state)
{
    double *p = state + k;
    for (int64_t i = 0; i < s->bodies; ++i) {
        if (s->translates)
            p = put_vector(put_vector(p, &b->x, i), &b->v, i);
        if (s->turns) {
            const vti_view *alpha = &b->alpha;
            const double a[3] = {alpha->c[0][i * alpha->stride], alpha->c[1][i * alpha->stride],
                                 alpha->c[2][i * alpha->stride]};
            double q[4];
            vti_rrv_to_pair(a, q);
            p = put_vector(put(p, q, 4), &b->omega, i);
        }
    }
}

/* ---- sums side by side ------------------------------------------------------------------------------------------- */

struct sums {
    double high[PANELS_BLOCK], low[PANELS_BLOCK];
};

VTI_INLINE void sums_add(struct sums *restrict sums, const double *restrict x, int64_t n)
{
    for (int64_t k = 0; k < n; ++k) {
        vti_sum sum = {sums->high[k], sums->low[k]};
        vti_sum_add(&sum, x[k]);
        sums->high[k] = sum.high;
        sums->low[k] = sum.low;
    }
}

VTI_INLINE void sums_value(const struct sums *restrict sums, double *restrict x, int64_t n)
{
    for (int64_t k = 0; k < n; ++k) {
        const vti_sum sum = {sums->high[k], sums->low[k]};
        x[k] = vti_sum_value(&sum);
    }
}

/* ---- integrands -------------------------------------------------------------------------------------------------- */

VTI_INLINE void squares(const double *restrict a, double *restrict out, int64_t n)
{
    for (int64_t k = 0; k < n; ++k) {
        const double v[3] = {a[k], a[PANELS_BLOCK + k], a[2 * PANELS_BLOCK + k]};
        out[k] = vti_dot(v, v);
    }
}

VTI_INLINE void squared_differences(const double *restrict a, const double *restrict b, double *restrict out, int64_t n)
{
    for (int64_t k = 0; k < n; ++k) {
        const double v[3] = {a[k] - b[k], a[PANELS_BLOCK + k] - b[PANELS_BLOCK + k],
                             a[2 * PANELS_BLOCK + k] - b[2 * PANELS_BLOCK + k]};
        out[k] = vti_dot(v, v);
    }
}

VTI_INLINE void squared_angles(const double *restrict q, double *restrict out, int64_t n)
{
    for (int64_t k = 0; k < n; ++k) {
        const double a[4] = {q[k], q[PANELS_BLOCK + k], q[2 * PANELS_BLOCK + k], q[3 * PANELS_BLOCK + k]};
        const double theta = vti_pair_angle(a);
        out[k] = theta * theta;
    }
}

VTI_INLINE void squared_distances(const double *restrict p, const double *restrict q, double *restrict out, int64_t n)
{
    for (int64_t k = 0; k < n; ++k) {
        const double a[4] = {p[k], p[PANELS_BLOCK + k], p[2 * PANELS_BLOCK + k], p[3 * PANELS_BLOCK + k]};
        const double b[4] = {q[k], q[PANELS_BLOCK + k], q[2 * PANELS_BLOCK + k], q[3 * PANELS_BLOCK + k]};
        const double theta = vti_pair_distance(a, b);
        out[k] = theta * theta;
    }
}

/** Places of the vectors and of the attitude in a body's numbers. */
struct places {
    int64_t vector[3], vectors, attitude, width;
};

VTI_INLINE struct places places_of(const struct states *s)
{
    struct places places = {{0, 0, 0}, 0, 0, 0};
    if (s->translates) {
        places.vector[places.vectors++] = 0;
        places.vector[places.vectors++] = 3;
        places.width = 6;
    }
    if (s->turns) {
        places.attitude = places.width;
        places.vector[places.vectors++] = places.width + 4;
        places.width += 7;
    }
    return places;
}

/** A few states more than n fill the vectors up. */
VTI_INLINE int64_t filled(int64_t n)
{
    return (n + 7) & ~INT64_C(7);
}

VTI_INLINE void states_densities_loops(const struct states *s, const double *state, int64_t n, double *out)
{
    const struct places at = places_of(s);
    const int64_t all = filled(n);
    struct sums total;
    double x[PANELS_BLOCK];
    memset(&total, 0, sizeof total);
    for (int64_t v = 0; v < at.vectors; ++v) {
        struct sums sums;
        memset(&sums, 0, sizeof sums);
        for (int64_t i = 0; i < s->bodies; ++i) {
            squares(state + (i * at.width + at.vector[v]) * PANELS_BLOCK, x, all);
            sums_add(&sums, x, all);
        }
        sums_value(&sums, x, all);
        sums_add(&total, x, all);
    }
    for (int64_t i = 0; s->turns && i < s->bodies; ++i) {
        squared_angles(state + (i * at.width + at.attitude) * PANELS_BLOCK, x, all);
        sums_add(&total, x, all);
    }
    sums_value(&total, out, all);
}

VTI_INLINE void states_distances_loops(const struct states *s, const double *state, const double *other, int64_t n,
                                       double *out)
{
    const struct places at = places_of(s);
    const int64_t all = filled(n);
    struct sums total;
    double x[PANELS_BLOCK];
    memset(&total, 0, sizeof total);
    for (int64_t i = 0; i < s->bodies; ++i) {
        const double *a = state + i * at.width * PANELS_BLOCK, *b = other + i * at.width * PANELS_BLOCK;
        for (int64_t v = 0; v < at.vectors; ++v) {
            squared_differences(a + at.vector[v] * PANELS_BLOCK, b + at.vector[v] * PANELS_BLOCK, x, all);
            sums_add(&total, x, all);
        }
        if (s->turns) {
            squared_distances(a + at.attitude * PANELS_BLOCK, b + at.attitude * PANELS_BLOCK, x, all);
            sums_add(&total, x, all);
        }
    }
    sums_value(&total, out, all);
}

WIDE(states_densities, (const struct states *s, const double *state, int64_t n, double out[PANELS_BLOCK]),
     (s, state, n, out))
WIDE(states_distances,
     (const struct states *s, const double *state, const double *other, int64_t n, double out[PANELS_BLOCK]),
     (s, state, other, n, out))

/* ---- energies and momenta ---------------------------------------------------------------------------------------- */

VTI_INLINE double of_body(const vti_scalars *s, int64_t i)
{
    return s->p[i * s->stride];
}

/** m |v|^2 of the vectors at v. */
VTI_INLINE void weighted_squares(double weight, const double *restrict v, double *restrict out, int64_t n)
{
    squares(v, out, n);
    for (int64_t k = 0; k < n; ++k)
        out[k] = weight * out[k];
}

/** Adds sum m |v|^2/2 over bodies, of the vectors at place v of a body's numbers. */
VTI_INLINE void add_kinetic(const struct states *s, const vti_scalars *weight, int64_t width, const double *v,
                            int64_t n, struct sums *total)
{
    struct sums sums;
    double x[PANELS_BLOCK];
    memset(&sums, 0, sizeof sums);
    for (int64_t i = 0; i < s->bodies; ++i) {
        weighted_squares(of_body(weight, i), v + i * width * PANELS_BLOCK, x, n);
        sums_add(&sums, x, n);
    }
    sums_value(&sums, x, n);
    for (int64_t k = 0; k < n; ++k)
        x[k] *= 0.5;
    sums_add(total, x, n);
}

VTI_INLINE void states_energies_loops(const struct states *s, const double *state, const double *terms, int64_t count,
                                      int64_t n, double *out)
{
    const struct places at = places_of(s);
    const int64_t all = filled(n);
    struct sums total;
    memset(&total, 0, sizeof total);
    if (s->translates)
        add_kinetic(s, &s->mass, at.width, state + 3 * PANELS_BLOCK, all, &total);
    if (s->turns)
        add_kinetic(s, &s->inertia, at.width, state + (at.attitude + 4) * PANELS_BLOCK, all, &total);
    for (int64_t j = 0; j < count; ++j)
        sums_add(&total, terms + j * PANELS_BLOCK, all);
    sums_value(&total, out, all);
}

/** m v, or with x m x cross v. */
VTI_INLINE void add_orbits(double m, const double *restrict x, const double *restrict v, int64_t n, struct sums sum[3])
{
    double p[3][PANELS_BLOCK];
    for (int64_t k = 0; k < n; ++k) {
        double c[3] = {v[k], v[PANELS_BLOCK + k], v[2 * PANELS_BLOCK + k]};
        if (x != NULL) {
            const double a[3] = {x[k], x[PANELS_BLOCK + k], x[2 * PANELS_BLOCK + k]}, b[3] = {c[0], c[1], c[2]};
            vti_cross(a, b, c);
        }
        p[0][k] = m * c[0];
        p[1][k] = m * c[1];
        p[2][k] = m * c[2];
    }
    for (int c = 0; c < 3; ++c)
        sums_add(&sum[c], p[c], n);
}

VTI_INLINE void states_momenta_loops(const struct states *s, enum states_momentum which, const double *state, int64_t n,
                                     double *out)
{
    const struct places at = places_of(s);
    const int64_t all = filled(n);
    struct sums sum[3];
    memset(sum, 0, sizeof sum);
    for (int64_t i = 0; i < s->bodies; ++i) {
        const double *const a = state + i * at.width * PANELS_BLOCK;
        if (s->translates && which != STATES_SPIN)
            add_orbits(of_body(&s->mass, i), which == STATES_ANGULAR ? a : NULL, a + 3 * PANELS_BLOCK, all, sum);
        if (s->turns && which != STATES_LINEAR)
            add_orbits(of_body(&s->inertia, i), NULL, a + (at.attitude + 4) * PANELS_BLOCK, all, sum);
    }
    for (int c = 0; c < 3; ++c)
        sums_value(&sum[c], out + c * PANELS_BLOCK, all);
}

WIDE(states_energies,
     (const struct states *s, const double *state, const double *terms, int64_t count, int64_t n,
      double out[PANELS_BLOCK]),
     (s, state, terms, count, n, out))
WIDE(states_momenta, (const struct states *s, enum states_momentum which, const double *state, int64_t n, double *out),
     (s, which, state, n, out))
