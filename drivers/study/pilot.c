/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "pilot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { LOOKS = 64 }; /* at the bodies of a run */

/** Time of this thread: what a core of its own would take by the clock, whatever else runs here. */
static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int look(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct pilot *pilot = self;
    (void)step;
    (void)t;
    pilot->max_omega = fmax(pilot->max_omega, vti_max_turn(1.0, bodies));
    return 0;
}

static void keep(const vti_view *from, double *to, int64_t n, int *finite)
{
    for (int64_t i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k) {
            to[3 * i + k] = from->c[k][i * from->stride];
            *finite &= isfinite(to[3 * i + k]) != 0;
        }
}

static void keep_end(struct pilot *pilot, const vti_bodies *bodies)
{
    const int64_t n = bodies->count;
    int finite = 1;
    pilot->end = vti_bodies_none(n);
    if (bodies->v.c[0] != NULL) {
        pilot->end.v = vti_view_packed(pilot->memory);
        keep(&bodies->v, pilot->memory, n, &finite);
    }
    if (bodies->alpha.c[0] != NULL) {
        pilot->end.alpha = vti_view_packed(pilot->memory + 3 * n);
        keep(&bodies->alpha, pilot->memory + 3 * n, n, &finite);
    }
    if (!finite && !pilot->failed)
        message_set(&pilot->message, "the bodies leave the range of numbers");
    pilot->failed |= !finite;
}

int pilot_run(const struct scene *scene, const vti_stepper *stepper, int64_t steps, double t_end, struct pilot *pilot,
              struct message *message)
{
    struct model model;
    memset(pilot, 0, sizeof *pilot);
    pilot->steps = steps;
    if (model_create(scene, &model, message) != 0)
        return -1;
    pilot->memory = calloc((size_t)(6 * model.bodies.count), sizeof *pilot->memory);
    if (pilot->memory == NULL) {
        model_destroy(&model);
        return message_set(message, "%s: out of memory; use fewer bodies", scene->name);
    }
    const struct observer observer = {look, pilot, (steps + LOOKS - 1) / LOOKS, 0};
    const double start = now();
    pilot->failed = loop_run(&model, stepper, t_end / (double)steps, 0, steps, &observer, 1, &pilot->message) != 0;
    pilot->seconds = now() - start;
    keep_end(pilot, &model.bodies);
    model_destroy(&model);
    return 0;
}

void pilot_destroy(struct pilot *pilot)
{
    free(pilot->memory);
    pilot->memory = NULL;
}

double pilot_error(const struct pilot *pilot, const struct pilot *solution)
{
    if (pilot->failed || solution->failed)
        return INFINITY;
    if (solution->end.alpha.c[0] != NULL)
        return vti_attitude_distance(&pilot->end, &solution->end);
    const double size = vti_h1_density(&solution->end);
    return size > 0.0 ? sqrt(vti_h1_distance(&pilot->end, &solution->end) / size) : 0.0;
}
