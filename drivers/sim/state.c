/* SPDX-License-Identifier: BSD-3-Clause */
#include "state.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"

enum { VIEWS = 10 };

static const char *const names[VIEWS] = {"position",          "velocity",
                                         "attitude",          "angular velocity",
                                         "position residual", "velocity residual",
                                         "attitude residual", "angular residual",
                                         "angular momentum",  "residual of the angular momentum"};

/** The views of the state that are present; missing ones are NULL. */
static void views_of(const vti_bodies *b, const vti_view *view[VIEWS])
{
    const vti_view *const all[VIEWS] = {&b->x,     &b->v,         &b->alpha,     &b->omega, &b->x_low,
                                        &b->v_low, &b->alpha_low, &b->omega_low, &b->spin,  &b->spin_low};
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

void state_give(const vti_bodies *bodies, struct sink *sink)
{
    enum { SOME = 256 }; /* bodies */
    const vti_view *view[VIEWS];
    double numbers[3 * SOME];
    views_of(bodies, view);
    for (int q = 0; q < VIEWS; ++q)
        for (int64_t i = 0, n; view[q] != NULL && i < bodies->count; i += n) {
            n = bodies->count - i < SOME ? bodies->count - i : SOME;
            for (int64_t j = 0; j < 3 * n; ++j)
                numbers[j] = view[q]->c[j % 3][(i + j / 3) * view[q]->stride];
            sink->add(sink, numbers, 3 * n);
        }
}

static void add_to_memory(struct sink *sink, const double *numbers, int64_t count)
{
    double **next = sink->context;
    memcpy(*next, numbers, (size_t)count * sizeof *numbers);
    *next += count;
}

void state_get(const vti_bodies *bodies, double *state)
{
    struct sink memory = {add_to_memory, &state};
    state_give(bodies, &memory);
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
                    return message_set(message, "body %lld has %s %g", (long long)i, names[q], number_plain(value));
            }
    return 0;
}

/* ---- bodies that share all but some views with others ------------------------------------------------------------ */

enum { OWNED = 7, WITH_RESIDUAL = 5 };

/** In the order of the bits of OWN_; residuals are of the first WITH_RESIDUAL. */
static void owned(vti_bodies *b, vti_view *view[OWNED], vti_view *residual[WITH_RESIDUAL])
{
    vti_view *const views[OWNED] = {&b->x, &b->v, &b->alpha, &b->omega, &b->spin, &b->force, &b->moment};
    vti_view *const low[WITH_RESIDUAL] = {&b->x_low, &b->v_low, &b->alpha_low, &b->omega_low, &b->spin_low};
    for (int k = 0; k < OWNED; ++k)
        view[k] = views[k];
    for (int k = 0; k < WITH_RESIDUAL; ++k)
        residual[k] = low[k];
}

int state_fork_create(struct fork *fork, const vti_bodies *of, int own)
{
    vti_view *view[OWNED], *residual[WITH_RESIDUAL];
    int64_t there = 0;
    *fork = (struct fork){*of, own, NULL};
    if (own == 0)
        return 0;
    owned(&fork->bodies, view, residual);
    for (int k = 0; k < OWNED; ++k)
        there += (own >> k & 1) != 0 && view[k]->c[0] != NULL;
    fork->memory = calloc((size_t)(3 * there * of->count + 1), sizeof *fork->memory);
    if (fork->memory == NULL)
        return -1;
    double *next = fork->memory;
    for (int k = 0; k < OWNED; ++k) {
        if ((own >> k & 1) != 0 && view[k]->c[0] != NULL) {
            *view[k] = vti_view_packed(next);
            next += 3 * of->count;
        }
        if ((own >> k & 1) != 0 && k < WITH_RESIDUAL)
            *residual[k] = vti_view_none();
    }
    return vti_bodies_seal(&fork->bodies) == VTI_OK ? 0 : -1;
}

void state_fork_take(struct fork *fork, vti_bodies from)
{
    vti_view *source[OWNED], *target[OWNED], *residual[WITH_RESIDUAL];
    owned(&from, source, residual);
    owned(&fork->bodies, target, residual);
    for (int v = 0; v < OWNED; ++v)
        for (int64_t i = 0; (fork->own >> v & 1) != 0 && target[v]->c[0] != NULL && i < from.count; ++i)
            for (int k = 0; k < 3; ++k)
                target[v]->c[k][i * target[v]->stride] = source[v]->c[k][i * source[v]->stride];
}
