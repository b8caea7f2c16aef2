/* SPDX-License-Identifier: BSD-3-Clause */
#include "study_files.h"

#include <stdio.h>

#include "folder.h"
#include "study_csv.h"
#include "study_hdf5.h"

static int write_csv(const struct study *study, const char *folder, const char *name,
                     void (*write)(const struct study *, FILE *), struct message *message)
{
    char path[FOLDER_PATH];
    if (folder_path(folder, name, 1, path, message) != 0)
        return -1;
    FILE *file = fopen(path, "wb");
    if (file != NULL)
        write(study, file);
    const int failed = file == NULL || ferror(file) != 0;
    if ((file != NULL && fclose(file) != 0) || failed)
        return message_set(message, "%s: writing failed; free some space or choose another folder with -o", path);
    return 0;
}

int study_files_write(const struct study *study, const char *folder, struct message *message)
{
    static const char *const names[] = {"study.h5", "study.csv", "timing.csv"};
    char path[FOLDER_PATH];
    int failed = folder_path(folder, names[0], 1, path, message);
    if (failed == 0)
        failed = study_hdf5_write(study, path, message);
    if (failed == 0)
        failed = write_csv(study, folder, names[1], study_csv_write, message);
    if (failed == 0)
        failed = write_csv(study, folder, names[2], timing_csv_write, message);
    for (size_t k = 0; k < sizeof names / sizeof names[0]; ++k) {
        if (failed == 0)
            failed = folder_keep(folder, names[k], message);
        else
            folder_drop(folder, names[k]);
    }
    return failed;
}
