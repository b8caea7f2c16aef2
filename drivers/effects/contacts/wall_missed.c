/* SPDX-License-Identifier: BSD-3-Clause
 * Touches of walls that a step has passed by, between two evaluations of its forces: a field, say, turns a body back
 * just inside of a wall.
 *
 * The gap over the step, 0 < s < 1, is the cubic with the gaps g0 and g1 > 0 and the rates r0 and r1 (times h) of both
 * ends,
 *     g(s) = g0 + r0 s + b s^2 + a s^3,      b = 3 (g1 - g0) - 2 r0 - r1,      a = r0 + r1 - 2 (g1 - g0),
 * exact for free flight in a field. It is least at s = -r0/(b + c), c = sqrt(b^2 - 3 a r0), where g'' = 2 c. Where that
 * is -delta < 0, the touch lasts T = 2 h sqrt(delta/c), and changes the velocity by hertz_impulse/m. */
#include "hertz.h"
#include "wall.h"

/** Gap between the surface of body i and wall w, of an x where the wall is now, and its rate. */
static double gap_at(const vti_walls *walls, int64_t w, double radius, const double x[3], const double v[3],
                     double *rate)
{
    double n[3] = {0.0, 0.0, 0.0};
    const double gap = vti_walls_gap(walls, w, x, n);
    *rate = vti_dot(n, v);
    return gap - radius;
}

static double missed_by(const vti_walls *walls, int64_t w, int64_t i, const struct effect_way *way)
{
    static const double at_rest[3] = {0.0, 0.0, 0.0};
    const double *const V = walls->motion != NULL ? walls->motion[w].velocity : at_rest;
    const double *const before = way->before + i * way->width;
    const double radius = 0.5 * walls->diameter.p[i * walls->diameter.stride], h = way->h;
    const vti_bodies *const now = way->now;
    double x0[3], v0[3], x1[3], v1[3], r0, r1;
    for (int k = 0; k < 3; ++k) { /* as seen from the wall */
        x0[k] = before[k] + h * V[k];
        v0[k] = h * (before[3 + k] - V[k]);
        x1[k] = now->x.c[k][i * now->x.stride];
        v1[k] = h * (now->v.c[k][i * now->v.stride] - V[k]);
    }
    const double g0 = gap_at(walls, w, radius, x0, v0, &r0), g1 = gap_at(walls, w, radius, x1, v1, &r1);
    if (!(g0 > 0.0 && g1 > 0.0 && r0 < 0.0 && r1 > 0.0))
        return 0.0;
    const double b = 3.0 * (g1 - g0) - 2.0 * r0 - r1, a = r0 + r1 - 2.0 * (g1 - g0), c = sqrt(b * b - 3.0 * a * r0);
    const double s = -r0 / (b + c), depth = -(g0 + s * (r0 + s * (b + s * a)));
    const double time = 2.0 * h * sqrt(depth / c);
    if (!(depth > 0.0 && time < way->gap * h)) /* none, or forces have been taken within it */
        return 0.0;
    return hertz_impulse(vti_walls_stiffness(walls, w, i), radius, depth / radius, time) /
           now->mass.p[i * now->mass.stride];
}

double wall_missed(const vti_walls *walls, const struct effect_way *way)
{
    double most = 0.0;
    for (int64_t w = 0; w < wall_count(walls); ++w)
        for (int64_t i = 0; i < way->now->count; ++i)
            most = fmax(most, missed_by(walls, w, i, way));
    return most;
}
