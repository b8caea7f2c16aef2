/* SPDX-License-Identifier: BSD-3-Clause */
#include "shape.h"

#include <stddef.h>

void shape_centre(const struct model *model, const vti_bodies *bodies, int64_t i, double x[3])
{
    for (int k = 0; k < 3; ++k)
        x[k] = model->translates ? bodies->x.c[k][i * bodies->x.stride] : 0.0;
    for (int64_t k = 0; k < model->rooms_count && !model->translates; ++k)
        if (model->rooms[k].kind->centre != NULL)
            model->rooms[k].kind->centre(&model->rooms[k], bodies, i, x);
}

int shape_groups(const struct model *model, struct shape_group list[MODEL_EFFECTS])
{
    int n = 0;
    int64_t first = 0;
    for (int64_t k = 0; k < model->rooms_count; ++k) {
        const struct effect *e = &model->rooms[k];
        const int64_t count = e->kind->lines != NULL ? e->kind->lines->count(e) : 0;
        const struct shape_group group = {e, first, count};
        if (count > 0)
            list[n++] = group;
        first += count;
    }
    return n;
}

int64_t shape_lines(const struct model *model)
{
    struct shape_group list[MODEL_EFFECTS];
    const int n = shape_groups(model, list);
    return n > 0 ? list[n - 1].first + list[n - 1].count : 0;
}

void shape_line(const struct model *model, int64_t k, int64_t pair[2])
{
    struct shape_group list[MODEL_EFFECTS];
    int g = shape_groups(model, list) - 1;
    while (k < list[g].first)
        --g;
    list[g].effect->kind->lines->ends(list[g].effect, k - list[g].first, pair);
}

int shape_has_diameters(const struct model *model)
{
    return model->diameter.p != NULL;
}

double shape_diameter(const struct model *model, int64_t i)
{
    return model->diameter.p != NULL ? model->diameter.p[i * model->diameter.stride] : 0.0;
}
