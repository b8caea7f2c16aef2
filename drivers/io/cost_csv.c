/* SPDX-License-Identifier: BSD-3-Clause */
#include "cost_csv.h"

#include <math.h>

#include "number.h"

static void write_runs(const struct cost *cost, int with_times, FILE *file)
{
    const struct cost_plan *plan = cost->plan;
    fprintf(file,
            "scene,stepper,kind,h,steps,force_evals,%sattitude_error,velocity_error,energy_error,momentum_error\n",
            with_times ? "seconds,seconds_spread," : "");
    for (int64_t k = 0; k < plan->cases_count * plan->methods_count; ++k) {
        const struct cost_ladder *ladder = &cost->ladders[k];
        const vti_stepper *method = plan->methods[k % plan->methods_count];
        for (int64_t r = 0; r < ladder->count; ++r) {
            const struct race_result *run = &ladder->runs[r];
            fprintf(file, "%s,%s,%s,%s,%lld,%lld,", plan->cases[k / plan->methods_count].name, method->name,
                    method_kind(method), NUMBER(ladder->h[r]), (long long)run->steps, (long long)run->force_evals);
            if (with_times)
                fprintf(file, "%s,%s,", NUMBER(run->seconds), NUMBER(run->seconds_spread));
            fprintf(file, "%s,%s,%s,%s\n", NUMBER(run->attitude_error), NUMBER(run->velocity_error),
                    NUMBER(run->energy_error), NUMBER(run->momentum_error));
        }
    }
}

void cost_csv_write(const struct cost *cost, FILE *file)
{
    write_runs(cost, 1, file);
}

void errors_csv_write(const struct cost *cost, FILE *file)
{
    write_runs(cost, 0, file);
}

void prices_csv_write(const struct cost *cost, FILE *file)
{
    const struct cost_plan *plan = cost->plan;
    fputs("scene,stepper,kind,error,force_evals,seconds\n", file);
    for (int64_t k = 0; k < plan->cases_count * plan->methods_count; ++k)
        for (int e = 0; e < COST_TARGETS; ++e) {
            const vti_stepper *method = plan->methods[k % plan->methods_count];
            const struct cost_price *price = &cost->prices[k][e];
            fprintf(file, "%s,%s,%s,%.0e,", plan->cases[k / plan->methods_count].name, method->name,
                    method_kind(method), cost_targets[e]);
            if (isnan(price->force_evals))
                fputs(",\n", file);
            else
                fprintf(file, "%s,%s\n", NUMBER(price->force_evals), NUMBER(price->seconds));
        }
}
