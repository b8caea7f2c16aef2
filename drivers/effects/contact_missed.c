/* SPDX-License-Identifier: BSD-3-Clause
 * Touches that a step has passed by, between two evaluations of its forces.
 *
 * On the straight way d(s) = d0 + s (d1 - d0), 0 < s < 1, two spheres that begin to touch at the distance L are nearest
 * at s = -d0.(d1 - d0)/|d1 - d0|^2, at the distance r, and overlap for the time T = 2 h sqrt(L^2 - r^2)/|d1 - d0|. The
 * force there is at most F = K/L (1 - r/L)^{3/2}. With the overlap going as 1 - tau^2, tau from -1 to 1 over T, its mean is
 * (3 pi/16) F, and changes the relative velocity by 0.589 F T/m, m being the reduced mass. */
#include <math.h>

#include "contact.h"

/** Of pair k of the list. */
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
    const double force = vti_contacts_stiffness(list, k) / length * overlap * sqrt(overlap);
    return 0.589 * force * time * (1.0 / m->p[i * m->stride] + 1.0 / m->p[j * m->stride]);
}

double contact_missed(const struct effect *e, const struct effect_way *way)
{
    const vti_contacts *const list = &((const struct contact_self *)e->self)->contacts;
    double most = 0.0;
    for (int64_t k = 0; k < list->count; ++k)
        most = fmax(most, missed_by(list, k, way));
    return most;
}
