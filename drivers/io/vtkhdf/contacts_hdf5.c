/* SPDX-License-Identifier: BSD-3-Clause
 * What touches as lines over time: from the centre of a sphere to that of the other one, or to the wall. Their number
 * is another one in each frame, so that each frame is a part of its own. */
#include "run_formats.h"

#include <stdlib.h>

#include "vtkhdf_parts.h"

/* ---- numbers of the lines ---------------------------------------------------------------------------------------- */

/** A dataset of cell data. */
struct quantity {
    const char *name;
    int place; /* enum touch_column */
    int components;
    enum { NUMBER, INDEX, BODY } kind; /* BODY: of a sphere of clumps the body that it is of */
    int of_clumps;                     /* 1: of clumps alone */
};

static const struct quantity quantities[] = {{"i", TOUCH_I, 1, BODY, 0},
                                             {"j", TOUCH_J, 1, BODY, 0},
                                             {"sphere_i", TOUCH_I, 1, INDEX, 1},
                                             {"sphere_j", TOUCH_J, 1, INDEX, 1},
                                             {"force", TOUCH_FORCE, 3, NUMBER, 0},
                                             {"normal_force", TOUCH_NORMAL, 1, NUMBER, 0},
                                             {"tangential_force", TOUCH_TANGENTIAL, 1, NUMBER, 0},
                                             {"overlap", TOUCH_OVERLAP, 1, NUMBER, 0}};

enum { QUANTITIES = sizeof quantities / sizeof quantities[0] };

/** Whether the run has it. */
static int is_written(const struct record *record, const struct quantity *q)
{
    return !q->of_clumps || record->model->clumps.list.count > 0;
}

/* ---- writing ----------------------------------------------------------------------------------------------------- */

struct writer {
    const struct record *record;
    struct hdf5_sink *root, *data;
    int64_t frames, touches;
    int64_t *count; /* [frames] touches in each */
    double *times;  /* [frames] */
};

/** So many numbers of each row from a column on, side by side. */
static double *gather(int64_t count, const double *rows, int place, int components)
{
    double *values = malloc(sizeof *values * (size_t)(count * components + 1));
    for (int64_t k = 0; values != NULL && k < count * components; ++k)
        values[k] = rows[k / components * TOUCH_DOUBLES + place + k % components];
    return values;
}

static void put_numbers(struct hdf5_sink *s, const char *name, int64_t first, int64_t count, const double *values)
{
    s->failed |= values == NULL;
    if (values != NULL)
        hdf5_rows(s, name, (hsize_t)first, (hsize_t)count, values);
}

static void put_indices(struct writer *w, const struct quantity *q, int64_t first, int64_t count, const double *rows)
{
    const struct clumps *clumps = &w->record->model->clumps;
    int64_t *values = malloc(sizeof *values * (size_t)(count + 1));
    w->data->failed |= values == NULL;
    for (int64_t k = 0; values != NULL && k < count; ++k) {
        values[k] = (int64_t)rows[k * TOUCH_DOUBLES + q->place];
        if (q->kind == BODY && clumps->list.count > 0 && values[k] >= 0)
            values[k] = clumps->list.body[values[k]];
    }
    if (values != NULL)
        hdf5_rows(w->data, q->name, (hsize_t)first, (hsize_t)count, values);
    free(values);
}

static int take_touches(void *self, int64_t first, int64_t count, const double *rows)
{
    struct writer *w = self;
    double *values = gather(count, rows, TOUCH_FROM, 6);
    put_numbers(w->root, "Points", 2 * first, 2 * count, values);
    free(values);
    for (int n = 0; n < QUANTITIES; ++n) {
        const struct quantity *q = &quantities[n];
        if (is_written(w->record, q) && q->kind != NUMBER)
            put_indices(w, q, first, count, rows);
        if (q->kind != NUMBER)
            continue;
        values = gather(count, rows, q->place, q->components);
        put_numbers(w->data, q->name, first, count, values);
        free(values);
    }
    for (int64_t k = 0; k < count; ++k)
        ++w->count[(int64_t)rows[k * TOUCH_DOUBLES + TOUCH_FRAME]];
    return w->root->failed || w->data->failed ? -1 : 0;
}

static int take_time(void *self, int64_t k, const double *frame)
{
    const struct writer *w = self;
    w->times[k] = frame[1];
    return 0;
}

/** Room for what touches. */
static void begin(const struct writer *w)
{
    const hsize_t touches = (hsize_t)w->touches;
    hdf5_text(w->root, "Type", "PolyData");
    hdf5_attribute(w->root, "Version", H5T_NATIVE_INT64, 2, (const int64_t[]){2, 0});
    hdf5_dataset(w->root, "Points", H5T_NATIVE_DOUBLE, 2, (const hsize_t[]){2 * touches, 3}, NULL);
    for (int n = 0; n < QUANTITIES; ++n) {
        const struct quantity *q = &quantities[n];
        if (is_written(w->record, q))
            hdf5_dataset(w->data, q->name, q->kind == NUMBER ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64,
                         q->components > 1 ? 2 : 1, (const hsize_t[]){touches, (hsize_t)q->components}, NULL);
    }
}

/* ---- frames ------------------------------------------------------------------------------------------------------ */

/** Of each frame times its touches, or, as a sum, times those of all frames before it. */
static void per_frame(const struct writer *w, struct hdf5_sink *s, const char *name, int64_t times, int sums)
{
    int64_t *values = malloc(sizeof *values * (size_t)(w->frames + 1)), sum = 0;
    s->failed |= values == NULL;
    for (int64_t k = 0; values != NULL && k < w->frames; ++k) {
        values[k] = times * (sums ? sum : w->count[k]);
        sum += w->count[k];
    }
    if (values != NULL)
        vtkhdf_integers(s, name, w->frames, values);
    free(values);
}

/** In each frame 0, step, 2 step, ...: times as many as it has touches, and so many more. */
static void from_zero(const struct writer *w, struct hdf5_sink *s, const char *name, int64_t step, int64_t times,
                      int64_t more)
{
    const int64_t length = times * w->touches + more * w->frames;
    const hsize_t all = (hsize_t)length;
    int64_t most = 0, first = 0;
    for (int64_t k = 0; k < w->frames; ++k)
        most = w->count[k] > most ? w->count[k] : most;
    int64_t *values = malloc(sizeof *values * (size_t)(times * most + more + 1));
    s->failed |= values == NULL;
    hdf5_dataset(s, name, H5T_NATIVE_INT64, 1, &all, NULL);
    for (int64_t k = 0; values != NULL && k <= times * most + more; ++k)
        values[k] = step * k;
    for (int64_t k = 0, rows; values != NULL && k < w->frames; ++k, first += rows) {
        rows = times * w->count[k] + more;
        if (rows > 0)
            hdf5_rows(s, name, (hsize_t)first, (hsize_t)rows, values);
    }
    free(values);
}

static void write_cells(const struct writer *w)
{
    static const char *const empty[] = {"Vertices", "Polygons", "Strips"};
    per_frame(w, w->root, "NumberOfPoints", 2, 0);
    struct hdf5_sink s = hdf5_group(w->root, "Lines");
    per_frame(w, &s, "NumberOfCells", 1, 0);
    per_frame(w, &s, "NumberOfConnectivityIds", 2, 0);
    from_zero(w, &s, "Offsets", 2, 1, 1);
    from_zero(w, &s, "Connectivity", 1, 2, 0);
    hdf5_close(w->root, &s);
    for (int n = 0; n < 3; ++n) {
        s = hdf5_group(w->root, empty[n]);
        per_frame(w, &s, "NumberOfCells", 0, 0);
        per_frame(w, &s, "NumberOfConnectivityIds", 0, 0);
        per_frame(w, &s, "Offsets", 0, 0);
        vtkhdf_sequence(&s, "Connectivity", 0, 1, 0, 1);
        hdf5_close(w->root, &s);
    }
}

/** Where each frame begins among the vertices, lines, polygons and strips; times: of a line. */
static void write_offsets(const struct writer *w, struct hdf5_sink *steps, const char *name, int64_t times)
{
    enum { KINDS = 4, LINES = 1 };
    const hsize_t dims[2] = {(hsize_t)w->frames, KINDS};
    int64_t *values = calloc((size_t)(KINDS * w->frames + 1), sizeof *values), sum = 0;
    steps->failed |= values == NULL;
    for (int64_t k = 0; values != NULL && k < w->frames; ++k) {
        values[KINDS * k + LINES] = times * sum;
        sum += w->count[k];
    }
    if (values != NULL)
        hdf5_dataset(steps, name, H5T_NATIVE_INT64, 2, dims, values);
    free(values);
}

static void write_steps(const struct writer *w)
{
    const hsize_t frames = (hsize_t)w->frames;
    struct hdf5_sink s = hdf5_group(w->root, "Steps");
    hdf5_attribute(&s, "NSteps", H5T_NATIVE_INT64, 1, &w->frames);
    hdf5_dataset(&s, "Values", H5T_NATIVE_DOUBLE, 1, &frames, w->times);
    vtkhdf_sequence(&s, "PartOffsets", w->frames, 1, 0, 1);
    vtkhdf_sequence(&s, "NumberOfParts", w->frames, 1, 1, 0);
    per_frame(w, &s, "PointOffsets", 2, 1);
    write_offsets(w, &s, "CellOffsets", 1);
    write_offsets(w, &s, "ConnectivityIdOffsets", 2);
    struct hdf5_sink offsets = hdf5_group(&s, "CellDataOffsets");
    for (int n = 0; n < QUANTITIES; ++n)
        if (is_written(w->record, &quantities[n]))
            per_frame(w, &offsets, quantities[n].name, 1, 1);
    hdf5_close(&s, &offsets);
    hdf5_close(w->root, &s);
}

/* ---- the file ---------------------------------------------------------------------------------------------------- */

static void write_contacts(const struct record *record, struct hdf5_sink *file, struct message *message)
{
    struct hdf5_sink root = hdf5_group(file, "VTKHDF"), data = hdf5_group(&root, "CellData");
    struct writer w = {record, &root, &data, record->journal->frames.mark.count, record->journal->touches.mark.count,
                       NULL,   NULL};
    w.count = calloc((size_t)(w.frames + 1), sizeof *w.count);
    w.times = calloc((size_t)(w.frames + 1), sizeof *w.times);
    begin(&w);
    if (w.count == NULL || w.times == NULL || root.failed || data.failed ||
        record_touches(record, take_touches, &w, message) != 0 || record_frames(record, take_time, &w, message) != 0) {
        root.failed = 1;
    } else {
        write_cells(&w);
        write_steps(&w);
    }
    free(w.count);
    free(w.times);
    hdf5_close(&root, &data);
    hdf5_close(file, &root);
}

double contacts_hdf5_bytes(double frames, double touches)
{
    enum { FRAME = 28, TOUCH = 17 }; /* 8 bytes: two places, force, six other numbers, two points and an offset */
    return 8.0 * (FRAME * frames + TOUCH * touches);
}

int contacts_hdf5_write(const struct record *record, const char *path, struct message *message)
{
    return vtkhdf_beside(record, "contacts_of", path, write_contacts, message);
}
