/* SPDX-License-Identifier: BSD-3-Clause
 * What a cost study is asked for: scenes with the times at which they end, methods, and steps. */
#ifndef VTI_COST_PLAN_H
#define VTI_COST_PLAN_H

#include "ladder.h"
#include "travel.h"

enum { COST_CASES = 32, COST_METHODS = 64, COST_REPEATS = 64 };

/** A scene to one of its ends. */
struct cost_case {
    char name[96]; /* the scene's, and "-100" where it has several ends */
    const struct scene *scene;
    double t_end;
};

struct cost_plan {
    struct cost_case cases[COST_CASES];
    int64_t cases_count;
    const vti_stepper *methods[COST_METHODS];
    int64_t methods_count;
    double h[LADDER_MOST]; /* h_count = 0: every method finds its own ladder (cost_ladder.h) */
    int64_t h_count;
    int64_t most_evals; /* of one run; 0: COST_WORK over the number of bodies, COST_EVALS at most */
    int repeats;        /* of the timing */
    double memory;      /* bytes that the reference of a case may take on every rank (reference.h) */
};

/** Lists "exact,rk4" in plan->methods, or for NULL all that can take some of its scenes, so call it after
 *  cost_plan_add. Returns 0, or -1 with one line in *message that names the known ones. */
int cost_plan_methods(struct cost_plan *plan, const char *list, struct message *message);

/** Adds the scene, which must outlive the plan, with the ends "10,100" or, for NULL, its own. what is where the ends
 *  come from, for messages. Returns 0, or -1 with one line in *message. */
int cost_plan_add(struct cost_plan *plan, const struct scene *scene, const char *ends, const char *what,
                  struct message *message);

/** Reads steps as ladder_read does; all must divide all ends, so call it last. Returns 0, or -1 with one line in
 *  *message. */
int cost_plan_steps(struct cost_plan *plan, const char *list, struct message *message);

#endif
