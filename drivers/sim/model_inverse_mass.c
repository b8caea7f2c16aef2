/* SPDX-License-Identifier: BSD-3-Clause
 * Inverse effective masses of bodies, which say how fast dashpots slow them. */
#include <math.h>

#include "model.h"

static double inverse_mass(const vti_bodies *b, int64_t i)
{
    return b->mass.p != NULL ? 1.0 / b->mass.p[i * b->mass.stride] : 0.0;
}

/** 1/A, 1/B, 1/C, or 1/J each; 0 of a body that does not turn. */
static void inverse_moments(const vti_bodies *b, int64_t i, double inverse[3])
{
    const double one = b->inertia.p != NULL ? 1.0 / b->inertia.p[i * b->inertia.stride] : 0.0;
    for (int k = 0; k < 3; ++k)
        inverse[k] = b->moments.c[0] != NULL ? 1.0 / b->moments.c[k][i * b->moments.stride] : one;
}

/** Of a place o from the centre, in the principal axes, the most along a unit vector n of (o x n).J^-1 (o x n) = n.M n.
 *  M o = 0, so that with the trace and M's sum of principal minors, |o|^2 o.J o/(A B C), the largest eigenvalue is that
 *  of a quadratic equation. */
static double most_by_turning(const double o[3], const double inverse[3])
{
    const double k[3] = {inverse[1] * inverse[2], inverse[2] * inverse[0], inverse[0] * inverse[1]};
    double trace = 0.0, minors = 0.0;
    for (int c = 0; c < 3; ++c) {
        trace += inverse[c] * (vti_dot(o, o) - o[c] * o[c]);
        minors += vti_dot(o, o) * o[c] * o[c] * k[c];
    }
    return 0.5 * (trace + sqrt(fmax(trace * trace - 4.0 * minors, 0.0)));
}

struct model_inverse_mass model_inverse_mass_of(const struct model *model, int of_spheres, int64_t k)
{
    const vti_bodies *b = &model->bodies;
    const vti_quat_view *axes = &b->principal;
    const int clumps = of_spheres && model_has_clumps(model);
    const int64_t i = clumps ? model->clumps.list.body[k] : k;
    double inverse[3], offset[3] = {0.0, 0.0, 0.0};
    inverse_moments(b, i, inverse);
    for (int c = 0; clumps && c < 3; ++c)
        offset[c] = model->clumps.list.offset[3 * k + c];
    if (axes->xyzw[0] != NULL) {
        double q[4], body[3] = {offset[0], offset[1], offset[2]};
        for (int c = 0; c < 4; ++c)
            q[c] = axes->xyzw[c][i * axes->stride];
        vti_pair_rotate(q, -1.0, body, offset);
    }
    const struct model_inverse_mass made = {inverse_mass(b, i), fmax(fmax(inverse[0], inverse[1]), inverse[2]),
                                            most_by_turning(offset, inverse)};
    return made;
}

double model_inverse_mass_at(const struct model_inverse_mass *inverse, double arm)
{
    const double at = sqrt(inverse->by_turning) + arm * sqrt(inverse->per_inertia);
    return inverse->per_mass + at * at;
}
