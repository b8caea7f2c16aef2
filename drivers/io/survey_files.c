/* SPDX-License-Identifier: BSD-3-Clause */
#include "study_files.h"

#include <string.h>

#include "folder.h"

/* ---- csv --------------------------------------------------------------------------------------------------------- */

struct csv {
    const struct survey_plan *plan;
    FILE *runs, *times;
    struct survey_counts *counts;
};

static void write_values(const struct csv *csv, int64_t p, FILE *file)
{
    char value[SWEEP_VALUE];
    for (int k = 0; k < csv->plan->sweep->count; ++k)
        study_csv_text(survey_value(csv->plan, p, k, value, sizeof value), file);
}

static int write_point(void *self, int64_t p, int rank, const struct survey_point *point)
{
    const struct csv *csv = self;
    const struct plan *plan = survey_plan_of(csv->plan, p);
    const char *scene = csv->plan->first[survey_scene(csv->plan, p)].name;
    csv->counts->parted += point->facts.reference_uncertainty > REFERENCE_PARTED;
    for (int64_t r = 0; r < plan->steppers_count * plan->h_count; ++r) {
        const struct survey_run *run = &point->run[r];
        const struct trial trial = {plan->steppers[r / plan->h_count], plan->h[r % plan->h_count], run->steps,
                                    run->t_end};
        study_csv_row(scene, &trial, run->force_evals, run->error, &run->judgement, csv->runs);
        write_values(csv, p, csv->runs);
        study_csv_text(run->reason, csv->runs);
        fputc('\n', csv->runs);
        study_csv_timing_row(scene, &trial, run->seconds, rank, csv->times);
        write_values(csv, p, csv->times);
        fputc('\n', csv->times);
        csv->counts->failed += run->failed;
        if (!run->failed)
            ++csv->counts->verdict[run->judgement.verdict];
    }
    return ferror(csv->runs) || ferror(csv->times);
}

static void write_header(const struct csv *csv)
{
    study_csv_header(csv->runs);
    study_csv_timing_header(csv->times);
    for (int k = 0; k < csv->plan->sweep->count; ++k) {
        fprintf(csv->runs, ",%s", csv->plan->sweep->axis[k].key);
        fprintf(csv->times, ",%s", csv->plan->sweep->axis[k].key);
    }
    fputs(",failure\n", csv->runs);
    fputc('\n', csv->times);
}

static int write_csv(const struct survey *survey, const char *folder, const char *const *names,
                     struct survey_counts *counts, struct message *message)
{
    struct csv csv = {survey->plan, folder_open(folder, names[1], message), NULL, counts};
    struct message later; /* of what fails after the first */
    if (csv.runs == NULL)
        return -1;
    csv.times = folder_open(folder, names[2], message);
    message->text[0] = '\0';
    int failed = csv.times == NULL ? -1 : 0;
    if (failed == 0) {
        write_header(&csv);
        failed = survey_each(survey, write_point, &csv, message);
    }
    /* what could not be written is said when a file is closed */
    const int unread = failed != 0 && message->text[0] != '\0';
    failed |= folder_close(csv.runs, folder, names[1], unread ? &later : message);
    if (csv.times != NULL)
        failed |= folder_close(csv.times, folder, names[2], failed ? &later : message);
    return failed ? -1 : 0;
}

/* ---- all --------------------------------------------------------------------------------------------------------- */

int survey_files_write(const struct survey *survey, const char *folder, struct survey_counts *counts,
                       struct message *message)
{
    char path[FOLDER_PATH];
    const char *names[STUDY_FILES];
    for (int k = 0; k < STUDY_FILES; ++k)
        names[k] = study_outputs[k].name;
    memset(counts, 0, sizeof *counts);
    int failed = write_csv(survey, folder, names, counts, message);
    if (failed == 0 && (folder_output(folder, names[0], 1, path, message) != 0 ||
                        survey_hdf5_write(survey, path, counts->failed, message) != 0))
        failed = -1;
    return folder_finish(folder, names, STUDY_FILES, failed, message);
}
