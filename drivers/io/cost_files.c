/* SPDX-License-Identifier: BSD-3-Clause */
#include "cost_files.h"

#include <stdio.h>

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

static const struct {
    const char *name;
    void (*write)(const struct cost *, FILE *);
} files[] = {{"cost.csv", cost_csv_write},
             {"errors.csv", errors_csv_write},
             {"prices.csv", prices_csv_write},
             {"machine.txt", write_machine}};

static int write_one(const struct cost *cost, const char *folder, size_t k, struct message *message)
{
    char path[FOLDER_PATH];
    if (folder_path(folder, files[k].name, 1, path, message) != 0)
        return -1;
    FILE *file = fopen(path, "wb");
    if (file != NULL)
        files[k].write(cost, file);
    const int failed = file == NULL || ferror(file) != 0;
    if ((file != NULL && fclose(file) != 0) || failed)
        return message_set(message, "%s: writing failed; free some space or choose another folder with -o", path);
    return 0;
}

int cost_files_write(const struct cost *cost, const char *folder, struct message *message)
{
    const size_t n = sizeof files / sizeof files[0];
    int failed = 0;
    for (size_t k = 0; k < n && failed == 0; ++k)
        failed = write_one(cost, folder, k, message);
    for (size_t k = 0; k < n; ++k) {
        if (failed == 0)
            failed = folder_keep(folder, files[k].name, message);
        else
            folder_drop(folder, files[k].name);
    }
    return failed;
}
