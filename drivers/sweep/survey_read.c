/* SPDX-License-Identifier: BSD-3-Clause
 * What a survey has found, point by point, and its means. */
#include "survey.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int survey_each(const struct survey *survey,
                int (*take)(void *self, int64_t p, int rank, const struct survey_point *point), void *self,
                struct message *message)
{
    struct survey_point *point = malloc((size_t)survey_bytes(survey->plan));
    int failed = point == NULL ? message_set(message, "out of memory; use fewer steppers and steps") : 0;
    for (int64_t p = 0; failed == 0 && p < survey->points; ++p) {
        int rank;
        if (!survey->store->recall(survey->store->self, p, &rank, point))
            failed = message_set(message, "the results of point %lld cannot be read again", (long long)p);
        else
            failed = take(self, p, rank, point) != 0 ? -1 : 0;
    }
    free(point);
    return failed;
}

/* ---- means ------------------------------------------------------------------------------------------------------- */

struct order survey_order(const struct plan *plan, const struct survey_point *point, int64_t stepper, int measure)
{
    const struct survey_facts *facts = &point->facts;
    const double energy_error = study_share(facts->reference_energy_error, facts->energy0);
    double error[LADDER_MOST], floor[LADDER_MOST];
    for (int64_t k = 0; k < plan->h_count; ++k) {
        const struct survey_run *run = &point->run[stepper * plan->h_count + k];
        error[k] = run->error[measure];
        floor[k] = study_floor(measure, run->steps, run->t_end, facts->reference_uncertainty, energy_error);
    }
    return study_order(plan, error, floor);
}

/** An error that is NaN of a run that did not fail is of one that blew up, as an infinite one is. */
static void add_run(struct survey_group *group, int64_t r, const struct survey_run *run)
{
    int infinite = 0;
    for (int m = 0; m < OUTCOME_ERRORS; ++m) {
        const int blew_up = !run->failed && !isfinite(run->error[m]);
        ensemble_add(&group->error[r][m], blew_up ? INFINITY : run->error[m]);
        infinite |= blew_up;
    }
    group->runs[r] += !run->failed;
    group->failed[r] += run->failed;
    group->infinite[r] += infinite;
}

int survey_group_add(const struct survey_plan *plan, struct survey_group *group, int64_t p,
                     const struct survey_point *point)
{
    const struct plan *each = survey_plan_of(plan, p);
    const int64_t size = survey_points(plan) / survey_groups(plan);
    if (p % size == 0) {
        memset(group, 0, sizeof *group);
        group->number = p / size;
        group->first = p;
    }
    for (int64_t r = 0; r < each->steppers_count * each->h_count; ++r)
        add_run(group, r, &point->run[r]);
    for (int64_t s = 0; s < each->steppers_count; ++s)
        for (int m = 0; m < STUDY_MEASURES; ++m)
            ensemble_add(&group->order[s][m], survey_order(each, point, s, m).order);
    return p % size == size - 1;
}
