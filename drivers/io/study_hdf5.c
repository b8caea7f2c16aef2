/* SPDX-License-Identifier: BSD-3-Clause */
#include "study_files.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hdf5_sink.h"

enum { NAME = 64 };

static void dataset(struct hdf5_sink *s, const char *name, hid_t type, int64_t n, const void *data)
{
    const hsize_t count = (hsize_t)n;
    hdf5_dataset(s, name, type, 1, &count, data);
}

/* ---- columns: one member of every struct of an array ------------------------------------------------------------- */

/** Dataset of the column, from n structs of the given size. */
static void write_column(struct hdf5_sink *s, const struct hdf5_column *column, const void *structs, size_t size,
                         int64_t n)
{
    char *values = calloc((size_t)n + 1, 8);
    for (int64_t r = 0; values != NULL && r < n; ++r)
        memcpy(values + 8 * r, (const char *)structs + (size_t)r * size + column->offset, 8);
    s->failed |= values == NULL;
    dataset(s, column->name, column->is_integer ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE, n, values);
    free(values);
}

/** Of texts in a dataset: NAME, or more where one is longer. */
static size_t room_of(const char *const *texts, int64_t n)
{
    size_t room = NAME;
    for (int64_t r = 0; r < n; ++r)
        room = strlen(texts[r]) < room ? room : strlen(texts[r]) + 1;
    return room;
}

/** Dataset of n texts. */
static void write_texts(struct hdf5_sink *s, const char *name, const char *const *texts, int64_t n)
{
    const size_t room = room_of(texts, n);
    char *column = calloc((size_t)n + 1, room);
    const hid_t type = hdf5_text_type(room);
    for (int64_t r = 0; column != NULL && r < n; ++r)
        memcpy(column + (size_t)r * room, texts[r], strlen(texts[r]));
    s->failed |= column == NULL;
    dataset(s, name, type, n, column);
    H5Tclose(type);
    free(column);
}

#define COUNT(ARRAY) (sizeof(ARRAY) / sizeof(ARRAY)[0])

/** The judgement of each run, verdict as 0, 1, 2 for good, doubtful, bad. */
static void write_verdicts(struct hdf5_sink *s, const struct study *study)
{
    for (int k = 0; k < VERDICT_NUMBERS; ++k) {
        const struct hdf5_column column = {verdict_numbers[k].name,
                                           offsetof(struct outcome, judgement) + verdict_numbers[k].offset,
                                           verdict_numbers[k].is_integer, 0};
        write_column(s, &column, study->outcomes, sizeof *study->outcomes, study->runs);
    }
}

static void write_runs(struct hdf5_sink *file, const struct study *study)
{
    static const struct hdf5_column of_trial[] = {{"h", offsetof(struct trial, h), 0, 0},
                                                  {"t_end", offsetof(struct trial, t_end), 0, 0},
                                                  {"steps", offsetof(struct trial, steps), 1, 0}};
    static const struct hdf5_column of_outcome[] = {{"force_evals", offsetof(struct outcome, force_evals), 1, 0}};
    struct hdf5_sink s = hdf5_group(file, "runs");
    const int64_t runs = study->runs;
    const char **texts = calloc((size_t)(3 * runs), sizeof *texts);
    s.failed |= texts == NULL;
    for (int64_t r = 0; texts != NULL && r < runs; ++r) {
        texts[r] = study->plan->scene->name;
        texts[runs + r] = study->trials[r].stepper->name;
        texts[2 * runs + r] = study->outcomes[r].failed ? study->outcomes[r].message.text : "";
    }
    if (texts != NULL) {
        write_texts(&s, "scene", texts, runs);
        write_texts(&s, "stepper", texts + runs, runs);
        write_texts(&s, "failure", texts + 2 * runs, runs);
    }
    for (size_t k = 0; k < COUNT(of_trial); ++k)
        write_column(&s, &of_trial[k], study->trials, sizeof *study->trials, runs);
    for (size_t k = 0; k < COUNT(of_outcome); ++k)
        write_column(&s, &of_outcome[k], study->outcomes, sizeof *study->outcomes, runs);
    for (int m = 0; m < OUTCOME_ERRORS; ++m) {
        const struct hdf5_column column = {outcome_errors[m],
                                           offsetof(struct outcome, error) + (size_t)m * sizeof(double), 0, 0};
        write_column(&s, &column, study->outcomes, sizeof *study->outcomes, runs);
    }
    write_verdicts(&s, study);
    free(texts);
    hdf5_close(file, &s);
}

/** Rows: stepper by stepper, every measure. */
static void write_orders(struct hdf5_sink *file, const struct study *study)
{
    static const struct hdf5_column of_order[] = {{"order", offsetof(struct order, order), 0, 0},
                                                  {"interval", offsetof(struct order, interval), 0, 0},
                                                  {"h_min", offsetof(struct order, h_min), 0, 0},
                                                  {"h_max", offsetof(struct order, h_max), 0, 0},
                                                  {"points", offsetof(struct order, points), 1, 0},
                                                  {"log2_constant", offsetof(struct order, log2_constant), 0, 0}};
    const char *steppers[STUDY_STEPPERS * STUDY_MEASURES], *measures[STUDY_STEPPERS * STUDY_MEASURES];
    struct hdf5_sink s = hdf5_group(file, "orders");
    const int64_t n = study->plan->steppers_count * STUDY_MEASURES;
    for (int64_t r = 0; r < n; ++r) {
        steppers[r] = study->plan->steppers[r / STUDY_MEASURES]->name;
        measures[r] = outcome_errors[r % STUDY_MEASURES];
    }
    write_texts(&s, "stepper", steppers, n);
    write_texts(&s, "measure", measures, n);
    for (size_t k = 0; k < COUNT(of_order); ++k)
        write_column(&s, &of_order[k], study->orders, sizeof(struct order), n);
    hdf5_close(file, &s);
}

/* ---- /series ----------------------------------------------------------------------------------------------------- */

static void series_column(struct hdf5_sink *s, const char *name, const char *label, const struct outcome *o, int column)
{
    double values[OUTCOME_SAMPLES];
    for (int64_t k = 0; k < o->samples; ++k)
        values[k] = o->series[k][column];
    dataset(s, name, H5T_NATIVE_DOUBLE, o->samples, values);
    struct hdf5_sink set = {H5Dopen2(s->place, name, H5P_DEFAULT), 0, NULL};
    hdf5_text(&set, "label", label);
    s->failed |= set.failed | (H5Dclose(set.place) < 0);
}

static void write_series(struct hdf5_sink *file, const struct study *study)
{
    struct hdf5_sink all = hdf5_group(file, "series");
    struct invariant invariants[MODEL_INVARIANTS];
    const int64_t n = model_invariants(&study->model, invariants);
    for (int64_t r = 0; r < study->runs; ++r) {
        char name[NAME];
        if (study->outcomes[r].failed)
            continue;
        snprintf(name, sizeof name, "%06lld", (long long)r);
        struct hdf5_sink s = hdf5_group(&all, name);
        hdf5_text(&s, "stepper", study->trials[r].stepper->name);
        hdf5_attribute(&s, "h", H5T_NATIVE_DOUBLE, 1, &study->trials[r].h);
        series_column(&s, "t", "$t$", &study->outcomes[r], 0);
        series_column(&s, "energy_error", "$E_h - E_0$", &study->outcomes[r], 1);
        for (int64_t k = 0; k < n; ++k)
            series_column(&s, invariants[k].name, invariants[k].label, &study->outcomes[r], 2 + (int)k);
        hdf5_close(&all, &s);
    }
    hdf5_close(file, &all);
}

/* ---- the file ---------------------------------------------------------------------------------------------------- */

int study_hdf5_write(const struct study *study, const char *path, struct message *message)
{
    hdf5_start();
    struct hdf5_sink file = hdf5_file(path, message);
    if (file.failed)
        return -1;
    hdf5_text(&file, "scene", study->plan->scene->name);
    hdf5_text(&file, "vti_version", vti_version());
    hdf5_attribute(&file, "t_end", H5T_NATIVE_DOUBLE, 1, &study->t_end);
    hdf5_attribute(&file, "energy0", H5T_NATIVE_DOUBLE, 1, &study->energy0);
    hdf5_attribute(&file, "norm_squared", H5T_NATIVE_DOUBLE, 1, &study->norm_squared);
    hdf5_attribute(&file, "reference_energy_error", H5T_NATIVE_DOUBLE, 1, &study->reference_energy_error);
    hdf5_attribute(&file, "reference_uncertainty", H5T_NATIVE_DOUBLE, 1, &study->reference_uncertainty);
    write_runs(&file, study);
    write_orders(&file, study);
    write_series(&file, study);
    if (hdf5_close_file(&file) != 0)
        return message_set(message, "%s: cannot be written; the disk may be full", path);
    return 0;
}
