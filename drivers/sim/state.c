/* SPDX-License-Identifier: BSD-3-Clause */
#include "state.h"

#include <math.h>
#include <stddef.h>

enum { VIEWS = 8 };

static const char *const names[VIEWS] = {"position",          "velocity",          "attitude",
                                         "angular velocity",  "position residual", "velocity residual",
                                         "attitude residual", "angular residual"};

/** The views of the state that are present; missing ones are NULL. */
static void views_of(const vti_bodies *b, const vti_view *view[VIEWS])
{
    const vti_view *const all[VIEWS] = {&b->x,     &b->v,     &b->alpha,     &b->omega,
                                        &b->x_low, &b->v_low, &b->alpha_low, &b->omega_low};
    for (int q = 0; q < VIEWS; ++q)
        view[q] = all[q]->c[0] != NULL ? all[q] : NULL;
}

int64_t state_size(const vti_bodies *bodies)
{
    const vti_view *view[VIEWS];
    int64_t size = 0;
    views_of(bodies, view);
    for (int q = 0; q < VIEWS; ++q)
        size += view[q] != NULL ? 3 * bodies->count : 0;
    return size;
}

void state_get(const vti_bodies *bodies, double *state)
{
    const vti_view *view[VIEWS];
    views_of(bodies, view);
    for (int q = 0; q < VIEWS; ++q)
        for (int64_t i = 0; view[q] != NULL && i < bodies->count; ++i)
            for (int k = 0; k < 3; ++k)
                *state++ = view[q]->c[k][i * view[q]->stride];
}

void state_put(const double *state, const vti_bodies *bodies)
{
    const vti_view *view[VIEWS];
    views_of(bodies, view);
    for (int q = 0; q < VIEWS; ++q)
        for (int64_t i = 0; view[q] != NULL && i < bodies->count; ++i)
            for (int k = 0; k < 3; ++k)
                view[q]->c[k][i * view[q]->stride] = *state++;
}

int state_watch(const vti_bodies *bodies, double most, struct message *message)
{
    const vti_view *view[VIEWS];
    views_of(bodies, view);
    for (int64_t i = 0; i < bodies->count; ++i)
        for (int q = 0; q < VIEWS; ++q)
            for (int k = 0; view[q] != NULL && k < 3; ++k) {
                const double value = view[q]->c[k][i * view[q]->stride];
                if (!isfinite(value) || fabs(value) > most)
                    return message_set(message, "body %lld has %s %g", (long long)i, names[q], value);
            }
    return 0;
}
