/* SPDX-License-Identifier: BSD-3-Clause */
#include "study_hdf5.h"

#include <hdf5.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAME = 64 };

/** Where we write, and whether anything has failed: HDF5 ids below 0 fall through every later call. */
struct sink {
    hid_t place;
    int failed;
};

static void check(struct sink *s, herr_t status)
{
    s->failed |= status < 0;
}

/* ---- datasets and attributes ---------------------------------------------------------------------------------------- */

static void dataset(struct sink *s, const char *name, hid_t type, hsize_t n, const void *data)
{
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(1, &n, NULL);
    H5Pset_obj_track_times(properties, 0); /* no clock in the file */
    const hid_t set = H5Dcreate2(s->place, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    check(s, H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
    check(s, H5Dclose(set));
    H5Sclose(space);
    H5Pclose(properties);
}

static void attribute(hid_t object, struct sink *s, const char *name, hid_t type, const void *value)
{
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t set = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    check(s, H5Awrite(set, type, value));
    check(s, H5Aclose(set));
    H5Sclose(space);
}

/** Fixed-length, null-padded. */
static hid_t text_type(size_t length)
{
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, length);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    return type;
}

static void text_attribute(hid_t object, struct sink *s, const char *name, const char *value)
{
    char text[NAME] = "";
    const hid_t type = text_type(sizeof text);
    strncpy(text, value, sizeof text - 1);
    attribute(object, s, name, type, text);
    H5Tclose(type);
}

static struct sink group(struct sink *parent, const char *name)
{
    const struct sink s = {H5Gcreate2(parent->place, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), 0};
    parent->failed |= s.place < 0;
    return s;
}

static void close_group(struct sink *parent, struct sink *s)
{
    check(s, H5Gclose(s->place));
    parent->failed |= s->failed;
}

/* ---- columns: one member of every struct of an array ------------------------------------------------------------------- */

/** A member of 8 bytes: where it is in its struct, and what. */
struct column {
    const char *name;
    size_t offset;
    int is_integer;
};

/** Dataset of the column, from n structs of the given size. */
static void write_column(struct sink *s, const struct column *column, const void *structs, size_t size, int64_t n)
{
    char *values = calloc((size_t)n + 1, 8);
    for (int64_t r = 0; values != NULL && r < n; ++r)
        memcpy(values + 8 * r, (const char *)structs + (size_t)r * size + column->offset, 8);
    s->failed |= values == NULL;
    dataset(s, column->name, column->is_integer ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE, (hsize_t)n, values);
    free(values);
}

/** Dataset of n texts. */
static void write_texts(struct sink *s, const char *name, const char *const *texts, int64_t n)
{
    char(*column)[NAME] = calloc((size_t)n + 1, sizeof *column);
    const hid_t type = text_type(NAME);
    for (int64_t r = 0; column != NULL && r < n; ++r)
        strncpy(column[r], texts[r], NAME - 1);
    s->failed |= column == NULL;
    dataset(s, name, type, (hsize_t)n, column);
    H5Tclose(type);
    free(column);
}

#define COUNT(ARRAY) (sizeof(ARRAY) / sizeof(ARRAY)[0])

static void write_runs(struct sink *file, const struct study *study)
{
    static const struct column of_trial[] = {{"h", offsetof(struct trial, h), 0},
                                             {"t_end", offsetof(struct trial, t_end), 0},
                                             {"steps", offsetof(struct trial, steps), 1}};
    static const struct column of_outcome[] = {{"force_evals", offsetof(struct outcome, force_evals), 1},
                                               {"e_error", offsetof(struct outcome, e_error), 0},
                                               {"q_error", offsetof(struct outcome, q_error), 0},
                                               {"h1_error", offsetof(struct outcome, h1_error), 0},
                                               {"attitude_error", offsetof(struct outcome, attitude_error), 0},
                                               {"momentum_error", offsetof(struct outcome, momentum_error), 0}};
    struct sink s = group(file, "runs");
    const char **texts = calloc((size_t)(2 * study->runs), sizeof *texts);
    s.failed |= texts == NULL;
    for (int64_t r = 0; texts != NULL && r < study->runs; ++r) {
        texts[r] = study->plan->scene->name;
        texts[study->runs + r] = study->trials[r].stepper->name;
    }
    if (texts != NULL) {
        write_texts(&s, "scene", texts, study->runs);
        write_texts(&s, "stepper", texts + study->runs, study->runs);
    }
    for (size_t k = 0; k < COUNT(of_trial); ++k)
        write_column(&s, &of_trial[k], study->trials, sizeof *study->trials, study->runs);
    for (size_t k = 0; k < COUNT(of_outcome); ++k)
        write_column(&s, &of_outcome[k], study->outcomes, sizeof *study->outcomes, study->runs);
    free(texts);
    close_group(file, &s);
}

/** Rows: stepper by stepper, every measure. */
static void write_orders(struct sink *file, const struct study *study)
{
    static const struct column of_order[] = {
        {"order", offsetof(struct order, order), 0},   {"interval", offsetof(struct order, interval), 0},
        {"h_min", offsetof(struct order, h_min), 0},   {"h_max", offsetof(struct order, h_max), 0},
        {"points", offsetof(struct order, points), 1}, {"log2_constant", offsetof(struct order, log2_constant), 0}};
    const char *steppers[STUDY_STEPPERS * STUDY_MEASURES], *measures[STUDY_STEPPERS * STUDY_MEASURES];
    struct sink s = group(file, "orders");
    const int64_t n = study->plan->steppers_count * STUDY_MEASURES;
    for (int64_t r = 0; r < n; ++r) {
        steppers[r] = study->plan->steppers[r / STUDY_MEASURES]->name;
        measures[r] = study_measures[r % STUDY_MEASURES];
    }
    write_texts(&s, "stepper", steppers, n);
    write_texts(&s, "measure", measures, n);
    for (size_t k = 0; k < COUNT(of_order); ++k)
        write_column(&s, &of_order[k], study->orders, sizeof(struct order), n);
    close_group(file, &s);
}

/* ---- /series ------------------------------------------------------------------------------------------------------------- */

static void series_column(struct sink *s, const char *name, const char *label, const struct outcome *o, int column)
{
    double values[TRIAL_SAMPLES];
    for (int64_t k = 0; k < o->samples; ++k)
        values[k] = o->series[k][column];
    dataset(s, name, H5T_NATIVE_DOUBLE, (hsize_t)o->samples, values);
    const hid_t set = H5Dopen2(s->place, name, H5P_DEFAULT);
    text_attribute(set, s, "label", label);
    check(s, H5Dclose(set));
}

static void write_series(struct sink *file, const struct study *study)
{
    struct sink all = group(file, "series");
    struct invariant invariants[MODEL_INVARIANTS];
    const int64_t n = model_invariants(&study->model, invariants);
    for (int64_t r = 0; r < study->runs; ++r) {
        char name[NAME];
        snprintf(name, sizeof name, "%06lld", (long long)r);
        struct sink s = group(&all, name);
        text_attribute(s.place, &s, "stepper", study->trials[r].stepper->name);
        attribute(s.place, &s, "h", H5T_NATIVE_DOUBLE, &study->trials[r].h);
        series_column(&s, "t", "$t$", &study->outcomes[r], 0);
        series_column(&s, "energy_error", "$E_h - E_0$", &study->outcomes[r], 1);
        for (int64_t k = 0; k < n; ++k)
            series_column(&s, invariants[k].name, invariants[k].label, &study->outcomes[r], 2 + (int)k);
        close_group(&all, &s);
    }
    close_group(file, &all);
}

/* ---- the file ------------------------------------------------------------------------------------------------------------ */

int study_hdf5_write(const struct study *study, const char *path, struct message *message)
{
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL); /* one line of ours instead of HDF5's stack */
    struct sink file = {H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), 0};
    if (file.place < 0)
        return message_set(message,
                           "%s: cannot be made; check the folder's rights and space, or choose another with -o", path);
    text_attribute(file.place, &file, "scene", study->plan->scene->name);
    text_attribute(file.place, &file, "vti_version", vti_version());
    attribute(file.place, &file, "t_end", H5T_NATIVE_DOUBLE, &study->t_end);
    attribute(file.place, &file, "energy0", H5T_NATIVE_DOUBLE, &study->energy0);
    attribute(file.place, &file, "norm_squared", H5T_NATIVE_DOUBLE, &study->norm_squared);
    attribute(file.place, &file, "reference_energy_error", H5T_NATIVE_DOUBLE, &study->reference_energy_error);
    attribute(file.place, &file, "reference_uncertainty", H5T_NATIVE_DOUBLE, &study->reference_uncertainty);
    write_runs(&file, study);
    write_orders(&file, study);
    write_series(&file, study);
    check(&file, H5Fclose(file.place));
    if (file.failed)
        return message_set(message, "%s: writing failed; free some space or choose another folder with -o", path);
    return 0;
}
