/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Rigid planes (EQUATIONS 3, E4): Hertzian contact with a particle of radius zero at the foot point, o = [1 -
 * g/(D/2)]_+. */
#include "vti_hertz.h"

/** Overlap with a plane of a body of radius D/2: positive if they touch; NaN if a number is, which must show. */
static inline double overlap(const vti_walls *p, const vti_bodies *b, const double *plane, int64_t i, double *radius)
{
    double x[3];
    vti_load(&b->x, i, x);
    *radius = 0.5 * vti_scalar(&p->diameter, i);
    return 1.0 - (vti_dot(plane, x) - plane[3]) / *radius;
}

/** VTI_E_CONTACT unless normals are of length 1, offsets and stiffness finite, and diameters positive. */
static int check(const void *self, const vti_bodies *b)
{
    const vti_walls *p = self;
    if (p->count > 0 && (p->plane == NULL || p->diameter.p == NULL))
        return VTI_E_NULL;
    int good = p->count <= 0 || (isfinite(p->stiffness) && p->stiffness >= 0.0);
    for (int64_t w = 0; w < p->count; ++w)
        good &= fabs(vti_dot(p->plane + 4 * w, p->plane + 4 * w) - 1.0) < 1e-12 && isfinite(p->plane[4 * w + 3]);
    for (int64_t i = b->first; p->count > 0 && i < b->first + b->count; ++i)
        good &= isfinite(vti_scalar(&p->diameter, i)) && vti_scalar(&p->diameter, i) > 0.0;
    return good ? VTI_OK : VTI_E_CONTACT;
}

/** F = (K/(D/2)) o^{3/2} along the normal */
static void apply(const void *self, const vti_bodies *b)
{
    const vti_walls *p = self;
    for (int64_t w = 0; vti_has(&b->force) && w < p->count; ++w) {
        const double *plane = p->plane + 4 * w;
        for (int64_t i = b->first; i < b->first + b->count; ++i) {
            double radius;
            const double o = overlap(p, b, plane, i, &radius);
            if (o <= 0.0)
                continue;
            const double f = vti_hertz_force(p->stiffness, radius, o),
                         force[3] = {f * plane[0], f * plane[1], f * plane[2]};
            vti_add(&b->force, i, force);
        }
    }
}

static void energy(const void *self, const vti_bodies *b, double *energies)
{
    const vti_walls *p = self;
    vti_sum sum = {0.0, 0.0};
    for (int64_t w = 0; w < p->count; ++w)
        for (int64_t i = b->first; i < b->first + b->count; ++i) {
            double radius;
            const double o = overlap(p, b, p->plane + 4 * w, i, &radius);
            if (!(o <= 0.0))
                vti_sum_add(&sum, vti_hertz_energy(p->stiffness, o));
        }
    energies[0] = vti_sum_value(&sum);
}

/** Every body at every plane, or those that touch one, as they do. */
static int springs(const void *self, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    const vti_walls *p = self;
    for (int64_t w = 0; w < p->count; ++w)
        for (int64_t i = b->first; i < b->first + b->count; ++i) {
            double radius = 0.5 * vti_scalar(&p->diameter, i);
            const double o = at != NULL ? at->overlap : overlap(p, b, p->plane + 4 * w, i, &radius);
            const vti_spring s = {
                .element = w, .i = i, .j = -1, .length = radius, .axial = vti_hertz_stiffness(p->stiffness, o)};
            if (at != NULL || !(o <= 0.0))
                visit(context, &s);
        }
    return p->count < 0 ? VTI_E_COUNT : VTI_OK;
}

vti_effect vti_walls_effect(const vti_walls *walls)
{
    static const char *const term[] = {"wall"};
    if (walls == NULL || (walls->count > 0 && (walls->diameter.p == NULL || walls->plane == NULL)))
        return vti_effect_none();
    int64_t breaks = 0;
    for (int64_t w = 0; w < walls->count; ++w)
        for (int k = 0; k < 3; ++k)
            if (walls->plane[4 * w + k] != 0.0) /* momentum along the normal, and angular momentum across it */
                breaks |= 1 << k | 8 << (k + 1) % 3 | 8 << (k + 2) % 3;
    const vti_effect effect = {.name = "wall",
                               .apply = apply,
                               .energy = energy,
                               .check = VTI_LOOKS ? check : NULL,
                               .springs = springs,
                               .self = walls,
                               .needs = 1 << VTI_QUANTITY_X,
                               .gives = 1 << VTI_QUANTITY_FORCE,
                               .terms = 1,
                               .term = term,
                               .breaks = breaks};
    return effect;
}
