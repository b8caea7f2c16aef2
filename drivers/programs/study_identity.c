/* SPDX-License-Identifier: BSD-3-Clause
 * Writes what identifies a study, a sweep or a study of cost, by which --resume knows that it is the same. */
#include "study_go.h"

#include "cost.h"
#include "identity.h"
#include "number.h"
#include "survey.h"

static const double megabyte = 1e6; /* bytes; what --memory counts in */

/** How it runs one of its scenes. */
static void identify_scene(FILE *text, const char *before, const struct scene *scene, const double *h, int64_t h_count,
                           double t_end)
{
    static const char *const without[] = {"stepper", "h", "t_end", NULL};
    identity_scene(text, before, scene, without);
    fprintf(text, "%s--h:", before);
    for (int64_t k = 0; k < h_count; ++k)
        fprintf(text, " %s", NUMBER(h[k]));
    fprintf(text, "\n%s--t-end: %s\n", before, NUMBER(t_end));
}

static void identify_steppers(FILE *text, const vti_stepper *const *steppers, int64_t count, double memory)
{
    fputs("--steppers:", text);
    for (int64_t k = 0; k < count; ++k)
        fprintf(text, " %s", steppers[k]->name);
    fprintf(text, "\n--memory: %s\n", NUMBER(memory / megabyte));
}

void study_identify(FILE *text, const void *self)
{
    const struct plan *plan = self;
    identify_scene(text, "", plan->scene, plan->h, plan->h_count, plan->t_end);
    identify_steppers(text, plan->steppers, plan->steppers_count, plan->memory);
}

/** "scene 2, " */
static const char *before_scene(int64_t k, char text[32])
{
    snprintf(text, 32, "scene %lld, ", (long long)k + 1);
    return text;
}

/** Of the scenes at their first points, of what is swept, and of the tables of all points. */
void study_identify_survey(FILE *text, const void *self)
{
    const struct survey_plan *plan = self;
    const struct plan *each = plan->each;
    char before[32];
    for (int k = 0; k < plan->scenes_count; ++k)
        identify_scene(text, before_scene(k, before), &plan->first[k], each[k].h, each[k].h_count, each[k].t_end);
    identify_steppers(text, each->steppers, each->steppers_count, each->memory);
    for (int k = 0; k < plan->sweep->count; ++k) {
        const struct sweep_axis *axis = &plan->sweep->axis[k];
        fprintf(text, "--sweep %d: %s=%s %s %s %lld\n", k + 1, axis->key, axis->list != NULL ? axis->list : "",
                NUMBER(axis->from), NUMBER(axis->step), (long long)axis->count);
    }
    for (int64_t k = 0; k < plan->files->tables_count; ++k)
        fprintf(text, "table %lld of the points, of %s: digest %016llx\n", (long long)k + 1,
                tables_kind(plan->files->tables[k].kind)->rows, (unsigned long long)plan->files->tables[k].digest);
}

/** How often times are taken is no part of it. */
void study_identify_cost(FILE *text, const void *self)
{
    const struct cost_plan *plan = self;
    const struct cost_case *c = plan->cases;
    char before[32];
    for (int64_t k = 0; k < plan->cases_count; ++k)
        identify_scene(text, before_scene(k, before), c[k].scene, plan->h, plan->h_count, c[k].t_end);
    identify_steppers(text, plan->methods, plan->methods_count, plan->memory);
    fprintf(text, "--evals: %lld\n", (long long)plan->most_evals);
}
