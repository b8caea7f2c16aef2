/* SPDX-License-Identifier: BSD-3-Clause
 * The spheres of clumps as points over time. */
#include "run_formats.h"

#include <stdlib.h>

#include "vtkhdf_parts.h"

struct writer {
    const struct record *record;
    struct hdf5_sink *root, *data;
    double *x, *v, *times; /* of the spheres in one frame; of all frames */
};

static int take_frame(void *self, int64_t k, const double *frame)
{
    struct writer *w = self;
    const int64_t n = w->record->model->clumps.list.count;
    const hsize_t first = (hsize_t)n * (hsize_t)k;
    for (int64_t s = 0; s < n; ++s)
        frame_sphere(&w->record->frames, frame, s, w->x + 3 * s, w->v + 3 * s);
    w->times[k] = frame[1];
    hdf5_rows(w->root, "Points", first, (hsize_t)n, w->x);
    hdf5_rows(w->data, "velocity", first, (hsize_t)n, w->v);
    return w->root->failed || w->data->failed ? -1 : 0;
}

/** What stays, and room for what changes. */
static void begin(struct hdf5_sink *root, struct hdf5_sink *data, const struct clumps *clumps, int64_t frames)
{
    const int64_t n = clumps->list.count;
    const hsize_t count = (hsize_t)n, rows[2] = {count * (hsize_t)frames, 3};
    vtkhdf_poly(root, n, 0, NULL);
    hdf5_dataset(root, "Points", H5T_NATIVE_DOUBLE, 2, rows, NULL);
    hdf5_dataset(data, "velocity", H5T_NATIVE_DOUBLE, 2, rows, NULL);
    hdf5_dataset(data, "diameter", H5T_NATIVE_DOUBLE, 1, &count, clumps->diameter.p);
    vtkhdf_integers(data, "body", n, clumps->list.body);
}

static void end(struct hdf5_sink *root, int64_t n, int64_t frames, const double *times)
{
    struct hdf5_sink steps = vtkhdf_steps(root, frames, n, times), offsets = hdf5_group(&steps, "PointDataOffsets");
    vtkhdf_sequence(&offsets, "velocity", frames, 1, 0, n);
    vtkhdf_sequence(&offsets, "diameter", frames, 1, 0, 0);
    vtkhdf_sequence(&offsets, "body", frames, 1, 0, 0);
    hdf5_close(&steps, &offsets);
    hdf5_close(root, &steps);
}

static void write_spheres(const struct record *record, struct hdf5_sink *file, struct message *message)
{
    const int64_t n = record->model->clumps.list.count, frames = record->journal->frames.mark.count;
    struct hdf5_sink root = hdf5_group(file, "VTKHDF"), data = hdf5_group(&root, "PointData");
    double *const memory = malloc(sizeof *memory * (size_t)(6 * n + frames + 1));
    struct writer w = {record, &root, &data, memory, NULL, NULL};
    if (memory != NULL) {
        w.v = memory + 3 * n;
        w.times = memory + 6 * n;
    }
    begin(&root, &data, &record->model->clumps, frames);
    if (memory != NULL && !root.failed && !data.failed && record_frames(record, take_frame, &w, message) == 0)
        end(&root, n, frames, w.times);
    else
        root.failed = 1;
    free(memory);
    hdf5_close(&root, &data);
    hdf5_close(file, &root);
}

double spheres_hdf5_bytes(const struct record *record, int64_t frames)
{
    enum { FRAME = 6, ONCE = 4 }; /* 8 bytes of a sphere: place and velocity; diameter, body and its vertex */
    return 8.0 * (double)record->model->clumps.list.count * (FRAME * (double)frames + ONCE);
}

int spheres_hdf5_write(const struct record *record, const char *path, struct message *message)
{
    return vtkhdf_beside(record, "spheres_of", path, write_spheres, message);
}
