/* SPDX-License-Identifier: BSD-3-Clause */
#include "study_files.h"

#include "folder.h"

static int write_hdf5(const struct study *study, const char *folder, const char *name, struct message *message)
{
    char path[FOLDER_PATH];
    return folder_output(folder, name, 1, path, message) != 0 ? -1 : study_hdf5_write(study, path, message);
}

const struct output study_outputs[STUDY_FILES] = {{"study.h5", {NULL, NULL, NULL}},
                                                  {"study.csv", {"scene,stepper,h,t_end,", NULL, NULL}},
                                                  {"timing.csv", {"scene,stepper,h,seconds,", NULL, NULL}}};

int study_files_write(const struct study *study, const char *folder, struct message *message)
{
    const char *names[STUDY_FILES];
    for (int k = 0; k < STUDY_FILES; ++k)
        names[k] = study_outputs[k].name;
    int failed = write_hdf5(study, folder, names[0], message);
    if (failed == 0)
        failed = folder_write(folder, names[1], study_csv_write, study, message);
    if (failed == 0)
        failed = folder_write(folder, names[2], study_csv_timing_write, study, message);
    return folder_finish(folder, names, STUDY_FILES, failed, message);
}
