/* SPDX-License-Identifier: BSD-3-Clause */
#include "shape.h"

#include <stddef.h>

void shape_centre(const struct model *model, const vti_bodies *bodies, int64_t i, double x[3])
{
    for (int k = 0; k < 3; ++k)
        x[k] = model->translates ? bodies->x.c[k][i * bodies->x.stride] : 0.0;
    if (!model->translates && model->scene->has_pendulum)
        vti_pendulum_arm(&model->scene->pendulum, bodies, i, x);
}

int64_t shape_bonds(const struct model *model)
{
    return model->bonds.count;
}

void shape_bond(const struct model *model, int64_t k, int64_t pair[2])
{
    pair[0] = model->bonds.pair[2 * k] - model->bonds.base;
    pair[1] = model->bonds.pair[2 * k + 1] - model->bonds.base;
}

int shape_has_diameters(const struct model *model)
{
    return model->diameter.p != NULL;
}

double shape_diameter(const struct model *model, int64_t i)
{
    return model->diameter.p != NULL ? model->diameter.p[i * model->diameter.stride] : 0.0;
}
