/* SPDX-License-Identifier: BSD-3-Clause
 * Energies and momenta of many states at once. */
#include "states_parts.h"

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
    sums.count = 0;
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
    total.count = 0;
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
    sum[0].count = sum[1].count = sum[2].count = 0;
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

void states_sum_each(const struct states *s, const struct effect *effect, const vti_bodies *body,
                     double out[PANELS_BLOCK])
{
    struct sums sums;
    sums.count = 0;
    for (int64_t i = 0; i < s->bodies; ++i) {
        double energy[PANELS_BLOCK];
        effect->kind->each(effect, &body[i], energy);
        sums_add(&sums, energy, PANELS_BLOCK);
    }
    sums_value(&sums, out, PANELS_BLOCK);
}

VTI_INLINE void states_farthest_loops(const double *value, double origin, int64_t n, double *most)
{
    enum { EIGHT = 8 }; /* values, each beside those that are eight further on */
    double largest[EIGHT], last = *most;
    int64_t any[EIGHT], k = 0;
    for (int i = 0; i < EIGHT; ++i) {
        largest[i] = 0.0;
        any[i] = 0;
    }
    for (; k + EIGHT <= n; k += EIGHT)
        for (int i = 0; i < EIGHT; ++i) {
            const double distance = fabs(value[k + i] - origin);
            largest[i] = distance > largest[i] ? distance : largest[i];
            any[i] |= isnan(distance);
        }
    for (; k < n; ++k)
        last = isnan(last) || fabs(value[k] - origin) <= last ? last : fabs(value[k] - origin);
    for (int i = 0; i < EIGHT; ++i) {
        last = largest[i] > last ? largest[i] : last;
        last = any[i] ? NAN : last;
    }
    *most = last;
}

WIDE(states_farthest, (const double *value, double origin, int64_t n, double *most), (value, origin, n, most))
