/* SPDX-License-Identifier: BSD-3-Clause */
#include "shape.h"

#include <math.h>
#include <stddef.h>

void shape_centre(const struct model *model, const vti_bodies *bodies, int64_t i, double x[3])
{
    for (int k = 0; k < 3; ++k)
        x[k] = model->translates ? bodies->x.c[k][i * bodies->x.stride] : 0.0;
    for (int64_t k = 0; k < model->instances_count && !model->translates; ++k)
        if (model->instances[k].kind->centre != NULL)
            model->instances[k].kind->centre(&model->instances[k], bodies, i, x);
}

static int64_t lines_of(const struct effect *e)
{
    return e->kind->lines != NULL ? e->kind->lines->count(e) : 0;
}

int shape_groups(const struct model *model, struct shape_group list[MODEL_EFFECTS])
{
    int n = 0;
    int64_t first = 0;
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        const int64_t count = lines_of(e);
        const struct shape_group group = {e, first, count};
        if (count > 0)
            list[n++] = group;
        first += count;
    }
    return n;
}

int64_t shape_lines(const struct model *model)
{
    int64_t count = 0;
    for (int64_t r = 0; r < model->instances_count; ++r)
        count += lines_of(&model->instances[r]);
    return count;
}

int shape_quantities(const struct effect *effect)
{
    const struct effect_lines *lines = effect->kind->lines;
    return lines->told != NULL ? lines->told(effect) : lines->quantities;
}

const struct effect *shape_breaking(const struct model *model)
{
    for (int64_t r = 0; r < model->instances_count; ++r) {
        const struct effect *e = &model->instances[r];
        if (e->kind->breaks != NULL && e->kind->breaks->may(e))
            return e;
    }
    return NULL;
}

int shape_on_spheres(const struct model *model, const struct effect *effect)
{
    return model->on_spheres[effect - model->instances];
}

int shape_lines_join_spheres(const struct model *model)
{
    int all = 1;
    for (int64_t r = 0; r < model->instances_count; ++r)
        all &= lines_of(&model->instances[r]) == 0 || model->on_spheres[r];
    return all;
}

void shape_ends(const struct model *model, int64_t k, int64_t pair[2])
{
    const struct effect *e = model->instances;
    for (; k >= lines_of(e); ++e)
        k -= lines_of(e);
    e->kind->lines->ends(e, k, pair);
}

void shape_line(const struct model *model, int64_t k, int64_t pair[2])
{
    const struct effect *e = model->instances;
    shape_ends(model, k, pair);
    for (; k >= lines_of(e); ++e)
        k -= lines_of(e);
    for (int c = 0; c < 2 && shape_on_spheres(model, e); ++c)
        pair[c] = model->clumps.list.body[pair[c]];
}

int shape_has_diameters(const struct model *model)
{
    return model->diameter.p != NULL && !model_has_clumps(model);
}

double shape_diameter(const struct model *model, int64_t i)
{
    return shape_has_diameters(model) ? model->diameter.p[i * model->diameter.stride] : 0.0;
}

int shape_has_axes(const struct model *model)
{
    return model->bodies.moments.c[0] != NULL && model->bodies.mass.p != NULL &&
           (model_has_clumps(model) || scene_first_with(model->scene, EFFECT_SPHERES) == NULL);
}

void shape_axes(const struct model *model, int64_t i, double axes[3])
{
    const vti_view *m = &model->bodies.moments;
    const double mass = model->bodies.mass.p[i * model->bodies.mass.stride];
    for (int k = 0; k < 3; ++k) {
        const double others = m->c[(k + 1) % 3][i * m->stride] + m->c[(k + 2) % 3][i * m->stride];
        /* of a plate, which has no thickness, the difference may round to less than 0 */
        axes[k] = sqrt(fmax(0.0, 10.0 * (others - m->c[k][i * m->stride]) / mass));
    }
}
