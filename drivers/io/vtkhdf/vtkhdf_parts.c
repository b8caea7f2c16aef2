/* SPDX-License-Identifier: BSD-3-Clause */
#include "vtkhdf_parts.h"

#include <stdlib.h>

void vtkhdf_sequence(struct hdf5_sink *s, const char *name, int64_t count, int64_t columns, int64_t start, int64_t step)
{
    const hsize_t dims[2] = {(hsize_t)count, (hsize_t)columns};
    int64_t *values = malloc(sizeof *values * (size_t)(count * columns + 1));
    s->failed |= values == NULL;
    for (int64_t k = 0; values != NULL && k < count * columns; ++k)
        values[k] = start + k / columns * step;
    if (values != NULL)
        hdf5_dataset(s, name, H5T_NATIVE_INT64, columns > 1 ? 2 : 1, dims, values);
    free(values);
}

void vtkhdf_integers(struct hdf5_sink *s, const char *name, int64_t count, const int64_t *values)
{
    const hsize_t n = (hsize_t)count;
    hdf5_dataset(s, name, H5T_NATIVE_INT64, 1, &n, values);
}

/* ---- cells ------------------------------------------------------------------------------------------------------- */

/** One of the four kinds of cells, each of size points. */
static void cells(struct hdf5_sink *root, const char *name, int64_t count, int64_t size, const int64_t *points)
{
    struct hdf5_sink s = hdf5_group(root, name);
    vtkhdf_sequence(&s, "NumberOfCells", 1, 1, count, 0);
    vtkhdf_sequence(&s, "NumberOfConnectivityIds", 1, 1, count * size, 0);
    vtkhdf_sequence(&s, "Offsets", count + 1, 1, 0, size);
    if (points != NULL)
        vtkhdf_integers(&s, "Connectivity", count * size, points);
    else
        vtkhdf_sequence(&s, "Connectivity", count * size, 1, 0, 1);
    hdf5_close(root, &s);
}

void vtkhdf_poly(struct hdf5_sink *root, int64_t points, int64_t lines, const int64_t *pairs)
{
    hdf5_text(root, "Type", "PolyData");
    hdf5_attribute(root, "Version", H5T_NATIVE_INT64, 2, (const int64_t[]){2, 0});
    vtkhdf_sequence(root, "NumberOfPoints", 1, 1, points, 0);
    cells(root, "Vertices", points, 1, NULL);
    cells(root, "Lines", lines, 2, pairs);
    cells(root, "Polygons", 0, 1, NULL);
    cells(root, "Strips", 0, 1, NULL);
}

struct hdf5_sink vtkhdf_steps(struct hdf5_sink *root, int64_t frames, int64_t points, const double *times)
{
    const hsize_t count = (hsize_t)frames;
    struct hdf5_sink s = hdf5_group(root, "Steps");
    hdf5_attribute(&s, "NSteps", H5T_NATIVE_INT64, 1, &frames);
    hdf5_dataset(&s, "Values", H5T_NATIVE_DOUBLE, 1, &count, times);
    /* all frames share part 0, so that counts and cells are written once; readers before VTK 9.4 would not find the
     * cells of part 1 at the offset of part 0 */
    vtkhdf_sequence(&s, "PartOffsets", frames, 1, 0, 0);
    vtkhdf_sequence(&s, "NumberOfParts", frames, 1, 1, 0);
    vtkhdf_sequence(&s, "PointOffsets", frames, 1, 0, points);
    vtkhdf_sequence(&s, "CellOffsets", frames, 4, 0, 0);
    vtkhdf_sequence(&s, "ConnectivityIdOffsets", frames, 4, 0, 0);
    return s;
}

int vtkhdf_beside(const struct record *record, const char *of, const char *path,
                  void (*write)(const struct record *record, struct hdf5_sink *file, struct message *message),
                  struct message *message)
{
    struct hdf5_sink file = hdf5_file(path, message);
    if (file.failed)
        return -1;
    message->text[0] = '\0';
    hdf5_text(&file, of, record->model->scene->name);
    hdf5_text(&file, "vti_version", vti_version());
    write(record, &file, message);
    if (hdf5_close_file(&file) == 0)
        return 0;
    return message->text[0] != '\0' ? -1 : message_set(message, "%s: cannot be written; the disk may be full", path);
}
