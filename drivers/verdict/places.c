/* SPDX-License-Identifier: BSD-3-Clause
 * How far bodies come in a step, beside their diameters, which a touch may be missed by, and beside the spacing of
 * doubles where they are, to which x += h v is rounded. */
#include <float.h>
#include <math.h>

#include "number.h"
#include "verdict_parts.h"

/* ---- beside diameters -------------------------------------------------------------------------------------------- */

static void vector_of(const vti_view *view, int64_t i, double r[3])
{
    for (int k = 0; k < 3; ++k)
        r[k] = view->c[k][i * view->stride];
}

/** |Omega| of the body of sphere s of a clump, times how far the sphere is from its centre. */
static double swing(const vti_clumps *clumps, const vti_bodies *bodies, int64_t s)
{
    double omega[3];
    vector_of(&bodies->omega, clumps->body[s], omega);
    return vti_norm(omega) * vti_norm(clumps->offset + 3 * s);
}

/** The largest speed of a body at x along the normals of the planes of all effects. */
static double approach(const struct model *model, const double x[3], const double v[3])
{
    double most = 0.0;
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        if (e->kind->planes != NULL)
            most = number_larger(most, e->kind->planes->approach(e, x, v));
    }
    return most;
}

double places_travel(const struct verdict *v, const vti_bodies *bodies)
{
    const vti_clumps *clumps = &v->model->clumps.list;
    const vti_bodies *spheres = clumps->count > 0 ? &clumps->spheres : bodies;
    double sum[3], own[3], from[3], x[3], most = 0.0;
    vti_momentum(bodies, sum);
    for (int64_t s = 0; s < spheres->count; ++s) {
        const int64_t i = clumps->count > 0 ? clumps->body[s] : s;
        vector_of(&bodies->v, i, own);
        vector_of(&spheres->x, s, x);
        for (int k = 0; k < 3; ++k)
            from[k] = own[k] - sum[k] / v->mass;
        const double apart = v->meet ? vti_norm(from) : 0.0, to_planes = approach(v->model, x, own);
        most =
            number_larger(most, number_larger(apart, to_planes) + (clumps->count > 0 ? swing(clumps, bodies, s) : 0.0));
    }
    return most * v->h / v->diameter;
}

/* ---- beside rounding --------------------------------------------------------------------------------------------- */

/** Slower ones, such as bodies where they turn back, stand for nothing. */
static const double slow = 0.01; /* of the fastest of the run */

static double largest_of(const vti_view *view, int64_t i)
{
    const int64_t at = i * view->stride;
    return fmax(fmax(fabs(view->c[0][at]), fabs(view->c[1][at])), fabs(view->c[2][at]));
}

double places_rounding(const struct verdict *v, const vti_bodies *bodies, double idle, double *fastest)
{
    double most = 0.0;
    for (int64_t i = 0; i < bodies->count; ++i)
        *fastest = fmax(*fastest, largest_of(&bodies->v, i));
    for (int64_t i = 0; i < bodies->count; ++i) {
        const double speed = largest_of(&bodies->v, i), mass = bodies->mass.p[i * bodies->mass.stride];
        const int moves = speed > slow * *fastest && 0.5 * mass * speed * speed > idle;
        if (moves && v->h > 0.0) /* where steps vary, it is not known of the first row */
            most = fmax(most, 0.5 * DBL_EPSILON * largest_of(&bodies->x, i) / (v->h * speed));
    }
    return most;
}
