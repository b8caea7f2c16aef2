/* SPDX-License-Identifier: BSD-3-Clause */
#include "run_formats.h"

#include <stdlib.h>
#include <string.h>

#include "record.h"
#include "shape.h"
#include "vtkhdf_parts.h"

/* ---- cells ------------------------------------------------------------------------------------------------------- */

static void all_cells(struct hdf5_sink *root, const struct record *record)
{
    const int64_t lines = shape_lines(record->model);
    int64_t *pairs = calloc((size_t)(2 * lines + 1), sizeof *pairs);
    root->failed |= pairs == NULL;
    for (int64_t k = 0; pairs != NULL && k < lines; ++k)
        shape_line(record->model, k, pairs + 2 * k);
    vtkhdf_poly(root, record->frames.n, lines, pairs);
    free(pairs);
}

/* ---- point data -------------------------------------------------------------------------------------------------- */

enum { WIDEST = 9 }; /* components of a quantity */

static void fixed_data(struct hdf5_sink *s, const struct record *record)
{
    const int64_t n = record->frames.n;
    const hsize_t count = (hsize_t)n;
    double *values = malloc(sizeof *values * (size_t)(n + 1));
    s->failed |= values == NULL;
    for (int64_t i = 0; values != NULL && i < n; ++i)
        values[i] = shape_diameter(record->model, i);
    if (values != NULL && shape_has_diameters(record->model))
        hdf5_dataset(s, "diameter", H5T_NATIVE_DOUBLE, 1, &count, values);
    free(values);
    vtkhdf_sequence(s, "body", n, 1, 0, 1);
}

static void empty_data(struct hdf5_sink *root, struct hdf5_sink *data, const struct record *record)
{
    const hsize_t points = (hsize_t)record->frames.n * (hsize_t)record->journal->frames.mark.count;
    struct frame_quantity list[FRAME_QUANTITIES];
    const int count = frame_quantities(record, list);
    hdf5_dataset(root, "Points", H5T_NATIVE_DOUBLE, 2, (const hsize_t[]){points, 3}, NULL);
    for (int q = 0; q < count; ++q)
        hdf5_dataset(data, list[q].name, H5T_NATIVE_DOUBLE, list[q].components > 1 ? 2 : 1,
                     (const hsize_t[]){points, (hsize_t)list[q].components}, NULL);
}

/* ---- cell data: numbers of the lines of effects, group by group ------------------------------------------------- */

static int64_t cells_of(const struct record *record)
{
    return record->frames.n + shape_lines(record->model);
}

/** The index of each line of the group, -1 of all other cells. */
static void line_indices(struct hdf5_sink *data, const struct record *record, const struct shape_group *group)
{
    const int64_t first = record->frames.n + group->first, count = cells_of(record);
    int64_t *values = malloc(sizeof *values * (size_t)(count + 1));
    data->failed |= values == NULL;
    for (int64_t k = 0; values != NULL && k < count; ++k)
        values[k] = k < first || k >= first + group->count ? -1 : k - first;
    if (values != NULL)
        vtkhdf_integers(data, group->effect->kind->lines->name, count, values);
    free(values);
}

static void empty_cell_data(struct hdf5_sink *data, const struct record *record)
{
    const hsize_t values = (hsize_t)cells_of(record) * (hsize_t)record->journal->frames.mark.count;
    struct shape_group list[MODEL_EFFECTS];
    const int groups = shape_groups(record->model, list);
    for (int g = 0; g < groups; ++g) {
        const struct effect_lines *lines = list[g].effect->kind->lines;
        for (int q = 0; q < shape_quantities(list[g].effect); ++q)
            hdf5_dataset(data, lines->quantity[q], H5T_NATIVE_DOUBLE, 1, &values, NULL);
        line_indices(data, record, &list[g]);
    }
}

/* ---- its size ---------------------------------------------------------------------------------------------------- */

double vtkhdf_bytes(const struct record *record, int64_t frames)
{
    enum { STEP = 12, BODY = 6, LINE = 4 }; /* 8 bytes of each frame in Steps, and once of each body and line */
    const int64_t n = record->frames.n;
    struct frame_quantity list[FRAME_QUANTITIES];
    const int count = frame_quantities(record, list);
    struct shape_group groups[MODEL_EFFECTS];
    int64_t numbers = 3 * n + STEP;
    for (int q = 0; q < count; ++q)
        numbers += n * list[q].components + 1;
    for (int g = shape_groups(record->model, groups) - 1; g >= 0; --g)
        numbers += (cells_of(record) + 1) * shape_quantities(groups[g].effect);
    return 8.0 * ((double)numbers * (double)frames + (double)(BODY * n + LINE * shape_lines(record->model)));
}

/* ---- frames ------------------------------------------------------------------------------------------------------ */

struct writer {
    const struct record *record;
    struct hdf5_sink *root, *data, *cells;
    double *derived, *times;
    double *lines; /* the quantities of one group for its lines; NULL without lines */
};

/** So many zeros, from a row on. */
static void put_zeros(struct hdf5_sink *cells, const char *name, int64_t first, int64_t count)
{
    enum { SOME = 4096 };
    static const double zeros[SOME];
    for (int64_t n; count > 0; first += n, count -= n) {
        n = count < SOME ? count : SOME;
        hdf5_rows(cells, name, (hsize_t)first, (hsize_t)n, zeros);
    }
}

static void take_group(struct writer *w, const struct shape_group *group, int64_t k, const double *frame)
{
    const struct effect_lines *lines = group->effect->kind->lines;
    const vti_bodies bodies = frame_bodies(&w->record->frames, frame);
    const int64_t count = cells_of(w->record), first = k * count, own = first + w->record->frames.n + group->first;
    const int quantities = shape_quantities(group->effect);
    double *value[EFFECT_QUANTITIES];
    memset(w->lines, 0, sizeof *w->lines * (size_t)(quantities * group->count));
    for (int q = 0; q < quantities; ++q)
        value[q] = w->lines + q * group->count;
    const struct model *const model = w->record->model;
    const int on_spheres = shape_on_spheres(model, group->effect);
    if (on_spheres) /* which nothing else needs any more, now that the run is over */
        w->cells->failed |= vti_clumps_spread(&model->clumps.list, &bodies) != VTI_OK;
    w->cells->failed |=
        lines->values(group->effect, on_spheres ? model_spheres(model) : &bodies, (int64_t)frame[0], value) != VTI_OK;
    for (int q = 0; q < quantities; ++q) {
        put_zeros(w->cells, lines->quantity[q], first, own - first);
        if (group->count > 0)
            hdf5_rows(w->cells, lines->quantity[q], (hsize_t)own, (hsize_t)group->count, value[q]);
        put_zeros(w->cells, lines->quantity[q], own + group->count, first + count - own - group->count);
    }
}

static void take_lines(struct writer *w, int64_t k, const double *frame)
{
    struct shape_group list[MODEL_EFFECTS];
    const int groups = shape_groups(w->record->model, list);
    for (int g = 0; g < groups; ++g)
        take_group(w, &list[g], k, frame);
}

static const double *values_of(struct writer *w, const struct frame_quantity *q, const double *frame)
{
    if (q->derive == NULL)
        return frame + q->place;
    q->derive(&w->record->frames, frame, w->derived);
    return w->derived;
}

static int take_frame(void *self, int64_t k, const double *frame)
{
    struct writer *w = self;
    const struct frame_layout *layout = &w->record->frames;
    const hsize_t n = (hsize_t)layout->n, first = n * (hsize_t)k;
    struct frame_quantity list[FRAME_QUANTITIES];
    const int count = frame_quantities(w->record, list);
    w->times[k] = frame[1];
    hdf5_rows(w->root, "Points", first, n, frame + layout->x);
    for (int q = 0; q < count; ++q)
        hdf5_rows(w->data, list[q].name, first, n, values_of(w, &list[q], frame));
    take_lines(w, k, frame);
    return w->root->failed || w->data->failed || w->cells->failed ? -1 : 0;
}

static void write_steps(struct hdf5_sink *root, const struct record *record, const double *times)
{
    const int64_t frames = record->journal->frames.mark.count, n = record->frames.n;
    struct frame_quantity list[FRAME_QUANTITIES];
    const int count = frame_quantities(record, list);
    struct hdf5_sink s = vtkhdf_steps(root, frames, n, times);
    struct hdf5_sink offsets = hdf5_group(&s, "PointDataOffsets");
    for (int q = 0; q < count; ++q)
        vtkhdf_sequence(&offsets, list[q].name, frames, 1, 0, n);
    if (shape_has_diameters(record->model))
        vtkhdf_sequence(&offsets, "diameter", frames, 1, 0, 0);
    vtkhdf_sequence(&offsets, "body", frames, 1, 0, 0);
    hdf5_close(&s, &offsets);
    struct shape_group groups[MODEL_EFFECTS];
    const int count_of_groups = shape_groups(record->model, groups);
    if (count_of_groups > 0) {
        offsets = hdf5_group(&s, "CellDataOffsets");
        for (int g = 0; g < count_of_groups; ++g) {
            const struct effect_lines *lines = groups[g].effect->kind->lines;
            for (int q = 0; q < shape_quantities(groups[g].effect); ++q)
                vtkhdf_sequence(&offsets, lines->quantity[q], frames, 1, 0, cells_of(record));
            vtkhdf_sequence(&offsets, lines->name, frames, 1, 0, 0);
        }
        hdf5_close(&s, &offsets);
    }
    hdf5_close(root, &s);
}

int vtkhdf_write(const struct record *record, struct hdf5_sink *file, struct message *message)
{
    const int64_t frames = record->journal->frames.mark.count, n = record->frames.n;
    struct hdf5_sink root = hdf5_group(file, "VTKHDF"), data = hdf5_group(&root, "PointData"),
                     cell_data = hdf5_group(&root, "CellData");
    const int has_lines = shape_lines(record->model) > 0;
    struct writer w = {record,
                       &root,
                       &data,
                       &cell_data,
                       malloc(sizeof(double) * (size_t)(WIDEST * n + 1)),
                       calloc((size_t)(frames + 1), sizeof(double)),
                       has_lines ? calloc((size_t)(EFFECT_QUANTITIES * shape_lines(record->model)), sizeof(double))
                                 : NULL};
    root.failed |= w.derived == NULL || w.times == NULL || (has_lines && w.lines == NULL);
    all_cells(&root, record);
    empty_data(&root, &data, record);
    fixed_data(&data, record);
    if (has_lines)
        empty_cell_data(&cell_data, record);
    if (!root.failed && !data.failed && !cell_data.failed && record_frames(record, take_frame, &w, message) == 0)
        write_steps(&root, record, w.times);
    else
        root.failed = 1;
    free(w.derived);
    free(w.times);
    free(w.lines);
    hdf5_close(&root, &cell_data);
    hdf5_close(&root, &data);
    hdf5_close(file, &root);
    return file->failed ? -1 : 0;
}
