/* SPDX-License-Identifier: BSD-3-Clause
 * Touches that a step has passed by, between two evaluations of its forces.
 *
 * On the straight way d(s) = d0 + s (d1 - d0), 0 < s < 1, two spheres that begin to touch at the distance L are nearest
 * at s = -d0.(d1 - d0)/|d1 - d0|^2, at the distance r, and overlap for the time T = 2 h sqrt(L^2 - r^2)/|d1 - d0|, by
 * at most 1 - r/L of L. That changes the relative velocity by hertz_impulse/m, m being the reduced mass. */
#include <math.h>
#include <stdlib.h>

#include "contact.h"
#include "hertz.h"

/** Of pair k of a list. */
static double missed_by(const vti_contacts *list, int64_t k, const struct effect_way *w)
{
    const int64_t i = list->pair[2 * k] - list->base, j = list->pair[2 * k + 1] - list->base;
    const vti_scalars *const m = &w->now->mass;
    const double length = contact_length(list, k);
    const vti_view *const x = &w->now->x;
    double d0[3], d1[3], way[3];
    for (int c = 0; c < 3; ++c) {
        d0[c] = w->before[i * w->width + c] - w->before[j * w->width + c];
        d1[c] = x->c[c][i * x->stride] - x->c[c][j * x->stride];
        way[c] = d1[c] - d0[c];
    }
    const double way2 = vti_dot(way, way), ahead = -vti_dot(d0, way), L2 = length * length;
    if (!(ahead > 0.0 && ahead < way2) || vti_dot(d0, d0) <= L2 || vti_dot(d1, d1) <= L2)
        return 0.0;
    const double r2 = fmax(vti_dot(d0, d0) - ahead * ahead / way2, 0.0);
    const double time = 2.0 * w->h * sqrt(fmax(L2 - r2, 0.0) / way2);
    if (r2 >= L2 || !(time < w->gap * w->h)) /* none, or forces have been taken within it */
        return 0.0;
    const double overlap = 1.0 - sqrt(r2) / length;
    return hertz_impulse(vti_contacts_stiffness(list, k), length, overlap, time) *
           (1.0 / m->p[i * m->stride] + 1.0 / m->p[j * m->stride]);
}

/* ---- pairs that come from far and go far ------------------------------------------------------------------------- */

/** What a body covers of an axis on its way. */
struct span {
    double low, high;
    int64_t body;
};

static int by_low(const void *a, const void *b)
{
    const struct span *const s = a, *const t = b;
    if (s->low != t->low)
        return s->low < t->low ? -1 : 1;
    return s->body < t->body ? -1 : 1;
}

static struct span span_of(const vti_scalars *diameter, const struct effect_way *w, int axis, int64_t i)
{
    const double from = w->before[i * w->width + axis], to = w->now->x.c[axis][i * w->now->x.stride];
    const double radius = 0.5 * diameter->p[i * diameter->stride];
    const struct span span = {fmin(from, to) - radius, fmax(from, to) + radius, i};
    return span;
}

/** The axis along which bodies are spread most. */
static int longest_axis(const vti_scalars *diameter, const struct effect_way *w)
{
    double most = -1.0;
    int longest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        double low = INFINITY, high = -INFINITY;
        for (int64_t i = 0; i < w->now->count; ++i) {
            const struct span span = span_of(diameter, w, axis, i);
            low = fmin(low, span.low);
            high = fmax(high, span.high);
        }
        longest = high - low > most ? axis : longest;
        most = fmax(most, high - low);
    }
    return longest;
}

/** Of a pair that need not be in the list, and touches at the mean diameter: one that has broken apart and touches at
 *  another distance is near, and in the list. */
static double missed_by_pair(const struct contact_self *self, int64_t i, int64_t j, const struct effect_way *w)
{
    const int64_t pair[2] = {i < j ? i : j, i < j ? j : i};
    vti_contacts one = self->contacts;
    one.count = 1;
    one.pair = pair;
    one.length.p = NULL;
    const double missed = missed_by(&one, 0, w);
    return missed > 0.0 && neighbours_exclude(&self->neighbours, pair[0], pair[1]) ? 0.0 : missed;
}

/** Of all pairs whose ways overlap along one axis; infinite if there is no memory. */
static double missed_far(const struct contact_self *self, const struct effect_way *w)
{
    const vti_scalars *const diameter = &self->contacts.diameter;
    const int64_t n = w->now->count;
    struct span *const span = malloc((size_t)n * sizeof *span);
    double most = 0.0;
    if (span == NULL)
        return INFINITY;
    const int axis = longest_axis(diameter, w);
    for (int64_t i = 0; i < n; ++i)
        span[i] = span_of(diameter, w, axis, i);
    qsort(span, (size_t)n, sizeof *span, by_low);
    for (int64_t k = 0; k < n; ++k)
        for (int64_t l = k + 1; l < n && span[l].low <= span[k].high; ++l)
            most = fmax(most, missed_by_pair(self, span[k].body, span[l].body, w));
    free(span);
    return most;
}

/** The list has all pairs that may touch on the way if it has them at both of its ends. */
static int list_has_way(struct contact_self *self, const struct effect_way *w)
{
    double *const x = (double *)w->before; /* which is read alone */
    const vti_view before = {{x, x + 1, x + 2}, w->width, w->now->count};
    return neighbours_hold(&self->neighbours, &w->now->x) && neighbours_hold(&self->neighbours, &before);
}

double contact_missed(const struct effect *e, const struct effect_way *way)
{
    struct contact_self *const self = e->self;
    double most = 0.0;
    if (!list_has_way(self, way))
        return missed_far(self, way);
    for (int64_t k = 0; k < self->contacts.count; ++k)
        most = fmax(most, missed_by(&self->contacts, k, way));
    return most;
}
