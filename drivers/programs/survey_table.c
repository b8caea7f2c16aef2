/* SPDX-License-Identifier: BSD-3-Clause
 * Prints the tables of a sweep at the terminal: means and spreads of errors and orders over the ensemble. */
#include "study_go.h"

enum { GROUPS = 8 }; /* that are printed */

struct printer {
    const struct survey_plan *plan;
    FILE *file;
    struct survey_group group;
    int width;
};

/** "pendulum, bodies.random.seed 1 to 1000 (1000 values), binder.axial = 100:" */
static void say_group(const struct printer *p)
{
    const struct sweep *sweep = p->plan->sweep;
    const int64_t first = p->group.first;
    char from[SWEEP_VALUE], to[SWEEP_VALUE];
    fprintf(p->file, "\n%s", p->plan->first[survey_scene(p->plan, first)].name);
    if (sweep->count > 0)
        fprintf(p->file, ", %s from %s to %s (%lld values)", sweep->axis[0].key,
                sweep_value(&sweep->axis[0], 0, from, sizeof from),
                sweep_value(&sweep->axis[0], sweep->axis[0].count - 1, to, sizeof to), (long long)sweep->axis[0].count);
    for (int k = 1; k < sweep->count; ++k)
        fprintf(p->file, ", %s = %s", sweep->axis[k].key, survey_value(p->plan, first, k, from, sizeof from));
    fputs(": mean +- spread\n", p->file);
}

/** "1.234e-05 +- 1.0e-06", without the spread where there is none. */
static void say_mean(const struct ensemble *e, FILE *file)
{
    if (e->count > 1 && e->infinite == 0)
        fprintf(file, "  %9.3e +-%7.1e", ensemble_mean(e), ensemble_spread(e));
    else
        fprintf(file, "  %9.3e %9s", ensemble_mean(e), "");
}

static void say_errors(const struct printer *p, const struct plan *plan)
{
    fprintf(p->file, "%-*s %9s %7s  %20s %20s %20s %20s\n", p->width, "stepper", "h", "runs", "E-error", "q-error",
            "H1-error", "attitude");
    for (int64_t r = 0; r < plan->steppers_count * plan->h_count; ++r) {
        fprintf(p->file, "%-*s ", p->width, plan->steppers[r / plan->h_count]->name);
        study_print_h(plan->h[r % plan->h_count], p->file);
        fprintf(p->file, " %7lld ", (long long)p->group.runs[r]);
        for (int m = 0; m < STUDY_MEASURES; ++m)
            say_mean(&p->group.error[r][m], p->file);
        if (p->group.failed[r] > 0)
            fprintf(p->file, "  %lld failed", (long long)p->group.failed[r]);
        if (p->group.infinite[r] > 0)
            fprintf(p->file, "  %lld with infinite errors", (long long)p->group.infinite[r]);
        fputc('\n', p->file);
    }
}

static void say_orders(const struct printer *p, const struct plan *plan)
{
    fprintf(p->file, "%-*s  %18s  %18s  %18s  %18s\n", p->width, "fitted order", "E-error", "q-error", "H1-error",
            "attitude");
    for (int64_t s = 0; s < plan->steppers_count; ++s) {
        fprintf(p->file, "%-*s", p->width, plan->steppers[s]->name);
        for (int m = 0; m < STUDY_MEASURES; ++m) {
            const struct ensemble *e = &p->group.order[s][m];
            study_print_order(ensemble_mean(e), ensemble_spread(e), p->file);
        }
        fputc('\n', p->file);
    }
}

static int print_point(void *self, int64_t p, int rank, const struct survey_point *point)
{
    struct printer *printer = self;
    const struct plan *plan = survey_plan_of(printer->plan, p);
    (void)rank;
    if (!survey_group_add(printer->plan, &printer->group, p, point))
        return 0;
    say_group(printer);
    say_errors(printer, plan);
    say_orders(printer, plan);
    return printer->group.number + 1 == GROUPS; /* more would not be read */
}

int survey_table_write(const struct survey *survey, FILE *file, struct message *message)
{
    static struct printer printer;
    const struct plan *plan = &survey->plan->each[0];
    const int64_t groups = survey_groups(survey->plan);
    printer.plan = survey->plan;
    printer.file = file;
    printer.width = methods_width(plan->steppers, plan->steppers_count);
    message->text[0] = '\0';
    if (survey_each(survey, print_point, &printer, message) != 0 && message->text[0] != '\0')
        return -1;
    if (groups > GROUPS)
        fprintf(file, "\n%lld more such tables are in study.h5, /ensemble and /ensemble_orders\n",
                (long long)(groups - GROUPS));
    return 0;
}
