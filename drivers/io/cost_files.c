/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "study_files.h"

#include <math.h>
#include <string.h>
#include <sys/utsname.h>
#include <unistd.h>

#include "folder.h"
#include "number.h"

/** The model's name as Linux tells it, or that of the architecture. */
static void write_cpu(const char *otherwise, FILE *file)
{
    char line[512];
    FILE *info = fopen("/proc/cpuinfo", "r");
    const char *name = NULL;
    while (info != NULL && name == NULL && fgets(line, sizeof line, info) != NULL)
        if (strncmp(line, "model name", 10) == 0 && strchr(line, ':') != NULL) {
            name = strchr(line, ':') + 1;
            line[strcspn(line, "\n")] = '\0';
            name += strspn(name, " \t");
        }
    fprintf(file, "cpu: %s\n", name != NULL ? name : otherwise);
    if (info != NULL)
        fclose(info);
}

/** Lines "key: value" of the machine and the build that times were taken with. */
static void machine_write(FILE *file)
{
    struct utsname system;
    if (uname(&system) != 0)
        memset(&system, 0, sizeof system);
    write_cpu(system.machine, file);
    fprintf(file, "cores: %ld\n", sysconf(_SC_NPROCESSORS_ONLN));
    fprintf(file, "system: %s %s %s\n", system.sysname, system.release, system.machine);
#if defined(__clang__)
    fprintf(file, "compiler: %s\n", __VERSION__);
#else
    fprintf(file, "compiler: gcc %s\n", __VERSION__);
#endif
    fprintf(file, "flags: %s\n", VTI_FLAGS);
}

static void write_runs(const struct cost *cost, int with_times, FILE *file)
{
    const struct cost_plan *plan = cost->plan;
    fprintf(file,
            "scene,stepper,kind,h,steps,force_evals,%sattitude_error,position_error,velocity_error,energy_error,"
            "momentum_error\n",
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
            fprintf(file, "%s,%s,%s,%s,%s\n", NUMBER(run->attitude_error), NUMBER(run->position_error),
                    NUMBER(run->velocity_error), NUMBER(run->energy_error), NUMBER(run->momentum_error));
        }
    }
}

/** Every run with its times. */
static void cost_csv_write(const void *cost, FILE *file)
{
    write_runs(cost, 1, file);
}

/** Every run without them: nothing in it depends on clocks or ranks. */
static void errors_csv_write(const void *cost, FILE *file)
{
    write_runs(cost, 0, file);
}

/** What each error by one measure costs with method m on case c; empty where it is not reached. */
static void write_prices(const struct cost *cost, int64_t c, int64_t m, int measure, FILE *file)
{
    const struct cost_case *it = &cost->plan->cases[c];
    const vti_stepper *method = cost->plan->methods[m];
    for (int e = 0; e < COST_TARGETS; ++e) {
        const struct cost_price *price = &cost->prices[c * cost->plan->methods_count + m][measure][e];
        fprintf(file, "%s,%s,%s,%s,%s,%s,%.0e,", it->name, NUMBER(it->t_end), NUMBER(it->scene->t_end), method->name,
                method_kind(method), cost_measures[measure], cost_targets[e]);
        if (isnan(price->force_evals))
            fputs(",\n", file);
        else
            fprintf(file, "%s,%s\n", NUMBER(price->force_evals), NUMBER(price->seconds));
    }
}

static void prices_csv_write(const void *what, FILE *file)
{
    const struct cost *cost = what;
    fputs("scene,t_end,scene_t_end,stepper,kind,measure,error,force_evals,seconds\n", file);
    for (int64_t c = 0; c < cost->plan->cases_count; ++c)
        for (int measure = 0; measure < COST_MEASURES; ++measure)
            for (int64_t m = 0; m < cost->plan->methods_count && cost->facts[c].has[measure]; ++m)
                write_prices(cost, c, m, measure, file);
}

static void write_machine(const void *what, FILE *file)
{
    const struct cost *cost = what;
    machine_write(file);
    fprintf(file, "ranks: %d\n", cost->ranks);
    fprintf(file,
            "times: one run per rank at a time, the least of %d samples; spread is how far their median lies above "
            "it, as a share\n",
            cost->plan->repeats);
}

const struct output cost_outputs[COST_FILES] = {
    {"cost.csv", {"scene,stepper,kind,h,steps,force_evals,seconds", NULL, NULL}},
    {"errors.csv", {"scene,stepper,kind,h,steps,force_evals,", NULL, NULL}},
    {"prices.csv", {"scene,t_end,scene_t_end,stepper,kind,measure,", NULL, NULL}},
    {"machine.txt", {"cpu: ", "\nranks: ", NULL}}};

int cost_files_write(const struct cost *cost, const char *folder, struct message *message)
{
    static folder_writer *const writers[COST_FILES] = {cost_csv_write, errors_csv_write, prices_csv_write,
                                                       write_machine};
    const char *names[COST_FILES];
    int failed = 0;
    for (int k = 0; k < COST_FILES; ++k) {
        names[k] = cost_outputs[k].name;
        failed = failed != 0 ? failed : folder_write(folder, names[k], writers[k], cost, message);
    }
    return folder_finish(folder, names, COST_FILES, failed, message);
}
