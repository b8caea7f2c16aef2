/* SPDX-License-Identifier: BSD-3-Clause */
#include "units.h"

#include <math.h>

/** The longest vector of that place in all bodies; 0 where there is none. */
static double longest(const struct model *model, int64_t stride, int64_t place, const double *state)
{
    double most = 0.0;
    for (int64_t i = 0; i < model->bodies.count; ++i)
        most = fmax(most, vti_norm(state + i * stride + place));
    return most;
}

/** How far the centres are apart along an axis; of one how far it is from the origin. */
static double extent(const struct model *model, int64_t stride, const double *state)
{
    double most = 0.0;
    for (int c = 0; c < 3; ++c) {
        double low = INFINITY, high = -INFINITY;
        for (int64_t i = 0; i < model->bodies.count; ++i) {
            low = fmin(low, state[i * stride + c]);
            high = fmax(high, state[i * stride + c]);
        }
        most = fmax(most, high - low);
    }
    return most > 0.0 ? most : longest(model, stride, 0, state);
}

static double length_of(const struct model *model, int64_t stride, const double *state)
{
    const vti_scalars *d = &model->diameter;
    double most = 0.0;
    for (int64_t i = 0; d->p != NULL && i < model->bodies.count; ++i)
        most = fmax(most, d->p[i * d->stride]);
    return most > 0.0 ? most : extent(model, stride, state);
}

static double near(double size)
{
    static const double far = 64.0;
    if (!(size > 0.0 && isfinite(size)) || (size >= 1.0 / far && size <= far))
        return 1.0;
    return scalbn(1.0, ilogb(size));
}

void units_of(const struct model *model, int64_t width, const double *state, const double *rate, double *unit)
{
    const int64_t stride = (width - 1) / model->bodies.count, q = model->translates ? 6 : 0, w = q + 4;
    double length = 1.0, speed = 1.0, spin = 0.0, square = model->turns ? 1.0 : 0.0;
    if (model->translates) {
        const double size = length_of(model, stride, state);
        const double fastest = fmax(longest(model, stride, 3, state), sqrt(longest(model, stride, 3, rate) * size));
        length = near(size);
        speed = near(fastest);
        spin = size > 0.0 ? fastest / size : 0.0;
        square = fmax(square, fmax(length * length, speed * speed));
    }
    if (model->turns) {
        spin = fmax(spin, fmax(longest(model, stride, w, state), sqrt(longest(model, stride, w, rate))));
        spin = near(spin);
        square = fmax(square, spin * spin);
    }
    for (int64_t i = 0; i < model->bodies.count; ++i)
        for (int64_t k = 0; k < stride; ++k)
            unit[i * stride + k] = k < 3 && model->translates ? length : k < q ? speed : k < w ? 1.0 : spin;
    unit[width - 1] = square;
}
