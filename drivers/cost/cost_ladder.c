/* SPDX-License-Identifier: BSD-3-Clause */
#include "cost_ladder.h"

#include <math.h>
#include <string.h>

#include "plain.h"

const char *const cost_measures[COST_MEASURES] = {"attitude", "position", "velocity", "energy"};

double cost_error(const struct race_result *run, int measure)
{
    const double of[COST_MEASURES] = {run->attitude_error, run->position_error, run->velocity_error, run->energy_error};
    return of[measure];
}

/** One run. It is kept, or counted as failed, or it is a first one without meaning. Returns its force evaluations. */
static int64_t one_rung(const struct cost_descent *d, double h, double worst, int measure, struct cost_ladder *ladder)
{
    struct race_result *run = &ladder->runs[ladder->count];
    race_measure(d->c->scene, d->method, h, d->c->t_end, d->reference, run);
    const int64_t evals = run->force_evals;
    if (run->failed) {
        ++ladder->failures;
        ladder->failure = run->message;
    } else if (ladder->count > 0 || cost_error(run, measure) <= worst) {
        ladder->h[ladder->count++] = h;
        return evals;
    }
    memset(run, 0, sizeof *run);
    return evals;
}

/** Whether to go on to run k. */
static int goes_on(const struct cost_descent *d, int64_t k)
{
    return d->poll == NULL || d->poll(d->poll_self, k) == 0;
}

static void given_steps(const struct cost_descent *d, int measure, struct cost_ladder *ladder)
{
    for (int64_t k = 0; k < d->plan->h_count && goes_on(d, k); ++k)
        one_rung(d, d->plan->h[k], INFINITY, measure, ladder);
}

/** 1 if run k is no better than half of what run k - 4 was, which took a quarter of its steps. */
static int stands_still(const struct cost_ladder *ladder, int64_t k, int measure)
{
    enum { BACK = 4 };
    const struct race_result *run = ladder->runs + k;
    return k >= BACK && cost_error(run, measure) > 0.5 * cost_error(run - BACK, measure);
}

static int is_finished(const struct cost_ladder *ladder, int measure)
{
    static const double good_enough = 3e-11, perhaps_rounding = 1e-6;
    const int64_t last = ladder->count - 1;
    if (last < 0)
        return 0;
    const double error = cost_error(&ladder->runs[last], measure);
    return error < good_enough ||
           (error < perhaps_rounding && stands_still(ladder, last, measure) && stands_still(ladder, last - 1, measure));
}

double cost_first_steps(const struct cost_case *c, struct model *model)
{
    static const double fewest = 2.0, coarser = 4.0;
    vti_stable stable;
    struct message message;
    vti_deformation at = model_deformation(model, &model->bodies);
    at.strain = 0.0;
    at.meet = 0; /* a ladder begins above what is stable */
    if (model_find_pairs(model, &model->bodies) != VTI_OK ||
        model_stable_step(model, &model->bodies, &at, &stable, &message) != 0)
        stable.h = c->scene->h;
    return fmax(fewest, ceil(c->t_end / (coarser * stable.h)));
}

void cost_ladder_run(const struct cost_descent *d, struct cost_ladder *ladder)
{
    const int measure = cost_main_measure(d->model);
    const int64_t of_bodies = COST_WORK / d->model->bodies.count;
    const int64_t affordable = of_bodies < COST_EVALS ? of_bodies : COST_EVALS;
    const int64_t most = d->plan->most_evals > 0 ? d->plan->most_evals : affordable;
    memset(ladder, 0, sizeof *ladder);
    if (d->plan->h_count > 0) {
        given_steps(d, measure, ladder);
        return;
    }
    double evals_per_step = 1.0;
    for (int k = 0; ladder->count < COST_RUNGS && !is_finished(ladder, measure); ++k) {
        const double steps = rint(d->first * plain_exp2(0.5 * k));
        if (steps * fmax(evals_per_step, 1.0) > (double)most || !goes_on(d, k))
            break;
        evals_per_step = (double)one_rung(d, d->c->t_end / steps, 1.0, measure, ladder) / steps;
    }
}
