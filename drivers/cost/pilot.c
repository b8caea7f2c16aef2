/* SPDX-License-Identifier: BSD-3-Clause */
#include "advise.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LOOKS = 64 }; /* at the bodies of a run */

/** A copy at p of a view that is there. */
static void keep(vti_view *view, double *p, int64_t n, int *finite)
{
    for (int64_t i = 0; view->c[0] != NULL && i < n; ++i)
        for (int k = 0; k < 3; ++k) {
            p[3 * i + k] = view->c[k][i * view->stride];
            *finite &= isfinite(p[3 * i + k]) != 0;
        }
    *view = view->c[0] != NULL ? vti_view_packed(p) : vti_view_none();
}

static int keep_end(struct pilot *pilot, const vti_bodies *bodies)
{
    const int64_t n = bodies->count;
    int finite = 1;
    pilot->end = vti_bodies_none(n);
    pilot->end.v = bodies->v;
    pilot->end.alpha = bodies->alpha;
    keep(&pilot->end.v, pilot->memory, n, &finite);
    keep(&pilot->end.alpha, pilot->memory + 3 * n, n, &finite);
    return finite ? 0 : message_set(&pilot->message, "the bodies leave the range of numbers");
}

static int look(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct pilot *pilot = self;
    (void)t;
    pilot->max_omega = fmax(pilot->max_omega, vti_max_turn(1.0, bodies));
    return step == pilot->steps ? keep_end(pilot, bodies) : 0;
}

int pilot_run(const struct scene *scene, const struct trial *trial, struct pilot *pilot, struct message *message)
{
    struct trial_run run;
    const struct observer observer = {look, pilot, (trial->steps + LOOKS - 1) / LOOKS, 0};
    memset(pilot, 0, sizeof *pilot);
    pilot->steps = trial->steps;
    if (trial_begin(&run, scene, trial, message) != 0)
        return -1;
    pilot->memory = calloc((size_t)(6 * run.model.bodies.count), sizeof *pilot->memory);
    const int without = pilot->memory == NULL;
    if (!without) {
        pilot->failed = trial_go(&run, trial->steps, &observer, 1, &pilot->message) != 0;
        pilot->seconds = run.seconds;
        pilot->force_evals = travel_force_evals(&run.travel);
    }
    trial_end(&run);
    return without ? message_set(message, "%s: out of memory; use fewer bodies", scene->name) : 0;
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
