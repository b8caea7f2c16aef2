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
static int64_t one_rung(const struct cost_case *c, const vti_stepper *method, double h, double worst, int measure,
                        struct reference *reference, struct cost_ladder *ladder)
{
    struct race_result *run = &ladder->runs[ladder->count];
    race_measure(c->scene, method, h, c->t_end, reference, run);
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

static void given_steps(const struct cost_plan *plan, const struct cost_case *c, const vti_stepper *method, int measure,
                        struct reference *reference, int (*poll)(void *self, int64_t work), void *poll_self,
                        struct cost_ladder *ladder)
{
    for (int64_t k = 0; k < plan->h_count && (poll == NULL || poll(poll_self, k) == 0); ++k)
        one_rung(c, method, plan->h[k], INFINITY, measure, reference, ladder);
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

void cost_ladder_run(const struct cost_plan *plan, const struct cost_case *c, const vti_stepper *method,
                     const struct model *model, double first, struct reference *reference,
                     int (*poll)(void *self, int64_t work), void *poll_self, struct cost_ladder *ladder)
{
    const int measure = cost_main_measure(model);
    const int64_t affordable =
        COST_WORK / model->bodies.count < COST_EVALS ? COST_WORK / model->bodies.count : COST_EVALS;
    const int64_t most = plan->most_evals > 0 ? plan->most_evals : affordable;
    memset(ladder, 0, sizeof *ladder);
    if (plan->h_count > 0) {
        given_steps(plan, c, method, measure, reference, poll, poll_self, ladder);
        return;
    }
    double evals_per_step = 1.0;
    for (int k = 0; ladder->count < COST_RUNGS && !is_finished(ladder, measure); ++k) {
        const double steps = rint(first * plain_exp2(0.5 * k));
        if (steps * fmax(evals_per_step, 1.0) > (double)most || (poll != NULL && poll(poll_self, k) != 0))
            break;
        evals_per_step = (double)one_rung(c, method, c->t_end / steps, 1.0, measure, reference, ladder) / steps;
    }
}
