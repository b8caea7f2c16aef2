/* SPDX-License-Identifier: BSD-3-Clause */
#include "cost_files.h"

#include "cost_csv.h"
#include "folder.h"
#include "machine.h"

static void write_machine(const struct cost *cost, FILE *file)
{
    machine_write(file);
    fprintf(file, "ranks: %d\n", cost->ranks);
    fprintf(file,
            "times: one run per rank at a time, the least of %d samples; spread is how far their median lies above "
            "it, as a share\n",
            cost->plan->repeats);
}

static int write_one(const struct cost *cost, const char *folder, const char *name,
                     void (*write)(const struct cost *, FILE *), struct message *message)
{
    FILE *file = folder_open(folder, name, message);
    if (file == NULL)
        return -1;
    write(cost, file);
    return folder_close(file, folder, name, message);
}

static const char *const names[COST_FILES] = {"cost.csv", "errors.csv", "prices.csv", "machine.txt"};

void cost_files_list(const char *folder, struct output files[COST_FILES])
{
    static const struct mark marks[COST_FILES] = {{"scene,stepper,kind,h,steps,force_evals,seconds", NULL, NULL},
                                                  {"scene,stepper,kind,h,steps,force_evals,", NULL, NULL},
                                                  {"scene,stepper,kind,error,force_evals,", NULL, NULL},
                                                  {"cpu: ", "\nranks: ", NULL}};
    for (int k = 0; k < COST_FILES; ++k) {
        const struct output file = {folder, names[k], &marks[k]};
        files[k] = file;
    }
}

int cost_files_write(const struct cost *cost, const char *folder, struct message *message)
{
    static void (*const writers[COST_FILES])(const struct cost *, FILE *) = {cost_csv_write, errors_csv_write,
                                                                             prices_csv_write, write_machine};
    int failed = 0;
    for (int k = 0; k < COST_FILES && failed == 0; ++k)
        failed = write_one(cost, folder, names[k], writers[k], message);
    return folder_finish(folder, names, COST_FILES, failed, message);
}
