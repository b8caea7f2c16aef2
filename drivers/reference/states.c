/* SPDX-License-Identifier: BSD-3-Clause */
#include "states_parts.h"

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

/* ---- kicks that are owed ----------------------------------------------------------------------------------------- */

int64_t states_loads(const struct states *s)
{
    return (s->translates ? 3 : 0) + (s->turns ? 3 : 0);
}

void states_put_loads(const struct states *s, const vti_bodies *b, int owe, int64_t k, double *load)
{
    static const double none[3] = {0.0, 0.0, 0.0};
    double *p = load + k;
    for (int64_t i = 0; i < s->bodies; ++i) {
        if (s->translates)
            p = owe && b->force.c[0] != NULL ? put_vector(p, &b->force, i) : put(p, none, 3);
        if (s->turns)
            p = owe && b->moment.c[0] != NULL ? put_vector(p, &b->moment, i) : put(p, none, 3);
    }
}

/** Three rows from p on. */
static vti_view rows(double *p)
{
    const vti_view view = {{p, p + PANELS_BLOCK, p + 2 * PANELS_BLOCK}, 1, 0};
    return view;
}

vti_bodies states_of_body(const struct states *s, int64_t i, double *state, double *load)
{
    vti_bodies b = vti_bodies_none(PANELS_BLOCK);
    double *p = state + i * states_width(s) * PANELS_BLOCK, *l = load + i * states_loads(s) * PANELS_BLOCK;
    if (s->translates) {
        b.x = rows(p);
        b.v = rows(p + 3 * PANELS_BLOCK);
        b.force = rows(l);
        b.mass.p = s->mass.p + i * s->mass.stride;
        p += 6 * PANELS_BLOCK;
        l += 3 * PANELS_BLOCK;
    }
    if (s->turns) {
        for (int c = 0; c < 4; ++c)
            b.quat.xyzw[c] = p + c * PANELS_BLOCK;
        b.quat.stride = 1;
        b.omega = rows(p + 4 * PANELS_BLOCK);
        b.moment = rows(l);
        b.inertia.p = s->inertia.p + i * s->inertia.stride;
    }
    return b;
}

/* ---- integrands -------------------------------------------------------------------------------------------------- */

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

VTI_INLINE void states_densities_loops(const struct states *s, const double *state, int64_t n, double *out)
{
    const struct places at = places_of(s);
    const int64_t all = filled(n);
    struct sums total;
    double x[PANELS_BLOCK];
    total.count = 0;
    for (int64_t v = 0; v < at.vectors; ++v) {
        struct sums sums;
        sums.count = 0;
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
    total.count = 0;
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
