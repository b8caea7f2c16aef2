/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "run.h"

#include <hdf5.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "hdf5_sink.h"
#include "held.h"

/* ---- reading ----------------------------------------------------------------------------------------------------- */

/** Rows first ... first + count - 1 of a dataset with so many columns, or of one dimension with columns 1. */
static int read_rows(hid_t file, const char *name, int64_t first, int64_t count, int64_t columns, double *to)
{
    const hsize_t start[2] = {(hsize_t)first, 0}, block[2] = {(hsize_t)count, (hsize_t)columns};
    hsize_t dims[2] = {0, 1};
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
    const int rank = H5Sget_simple_extent_ndims(space);
    int ok = (rank == 1 || rank == 2) && H5Sget_simple_extent_dims(space, dims, NULL) == rank &&
             dims[0] >= start[0] + block[0] && dims[1] == block[1] &&
             H5Sselect_hyperslab(space, H5S_SELECT_SET, start, NULL, block, NULL) >= 0;
    const hid_t memory = H5Screate_simple(2, block, NULL);
    ok = ok && H5Dread(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, to) >= 0;
    H5Sclose(memory);
    H5Sclose(space);
    H5Dclose(set);
    return ok ? 0 : -1;
}

/** All bytes of a dataset of bytes, with a 0 behind them, from malloc; NULL if there are none. */
static unsigned char *read_bytes(hid_t file, const char *name, size_t *size)
{
    hsize_t length = 0;
    unsigned char *bytes = NULL;
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
    if (H5Sget_simple_extent_ndims(space) == 1 && H5Sget_simple_extent_dims(space, &length, NULL) == 1)
        bytes = calloc(1, (size_t)length + 1);
    *size = (size_t)length;
    if (bytes != NULL && H5Dread(set, H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes) < 0) {
        free(bytes);
        bytes = NULL;
    }
    H5Sclose(space);
    H5Dclose(set);
    return bytes;
}

/** The grade that an attribute of the file says in a word; bad if it says none. */
static int64_t read_verdict(hid_t file)
{
    char word[16] = "";
    int64_t grade = VERDICT_GOOD;
    const hid_t attribute = H5Aopen(file, "verdict", H5P_DEFAULT), type = hdf5_text_type(sizeof word - 1);
    H5Aread(attribute, type, word);
    H5Tclose(type);
    H5Aclose(attribute);
    while (grade < VERDICT_BAD && strcmp(verdict_word(grade), word) != 0)
        ++grade;
    return grade;
}

void run_restart_free(struct run_restart *restart)
{
    free(restart->identity);
    free(restart->bytes);
    memset(restart, 0, sizeof *restart);
}

int run_restart_find(const char *path, struct run_restart *restart, struct message *message)
{
    struct stat info;
    size_t size;
    memset(restart, 0, sizeof *restart);
    if (stat(path, &info) != 0 || info.st_size == 0)
        return 0;
    H5E_BEGIN_TRY
    {
        const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
        restart->identity = (char *)read_bytes(file, "restart/identity", &size);
        restart->bytes = read_bytes(file, "restart/checkpoint", &restart->size);
        restart->verdict = read_verdict(file);
        H5Fclose(file);
    }
    H5E_END_TRY;
    if (restart->identity != NULL && restart->bytes != NULL)
        return 1;
    if (held_is(path))
        return message_set(message,
                           "%.600s: " HELD_TEXT ", start anew without --resume, or choose another place with -o", path);
    return message_set(
        message,
        "%.600s: holds no run that came to its end, so that none can go on; start anew without --resume, "
        "or choose another place with -o",
        path);
}

/* ---- rows and frames --------------------------------------------------------------------------------------------- */

static int fill_rows(hid_t file, const struct record *record, int64_t rows, struct message *message)
{
    enum { BLOCK = 4096, NAME = 64 };
    const struct columns *columns = &record->columns;
    double(*values)[BLOCK] = malloc(sizeof *values * (size_t)columns->count);
    int failed = values == NULL;
    if (failed)
        scene_no_memory(record->model->scene, message);
    for (int64_t first = 0; !failed && first < rows; first += BLOCK) {
        const int64_t count = rows - first < BLOCK ? rows - first : BLOCK;
        for (int c = 0; !failed && c < columns->count; ++c) {
            char name[NAME];
            snprintf(name, sizeof name, "energies/%s", columns->name[c]);
            failed = read_rows(file, name, first, count, 1, values[c]);
        }
        for (int64_t k = 0; !failed && k < count; ++k) {
            double row[COLUMNS];
            for (int c = 0; c < columns->count; ++c)
                row[c] = values[c][k];
            failed = journal_add(record->journal, &record->journal->rows, row, message);
        }
    }
    free(values);
    return failed ? -1 : 0;
}

static int read_frame(hid_t file, const struct record *record, int64_t k, double *frame)
{
    const struct frame_layout *layout = &record->frames;
    struct frame_quantity list[FRAME_QUANTITIES];
    const int count = frame_quantities(record, list);
    double t = 0.0;
    int failed = read_rows(file, "VTKHDF/Steps/Values", k, 1, 1, &t);
    frame[0] = rint(t / record->h);
    frame[1] = t;
    failed = failed || read_rows(file, "VTKHDF/Points", layout->n * k, layout->n, 3, frame + layout->x);
    for (int q = 0; !failed && q < count; ++q) {
        char name[64];
        snprintf(name, sizeof name, "VTKHDF/PointData/%s", list[q].name);
        if (list[q].derive == NULL)
            failed = read_rows(file, name, layout->n * k, layout->n, list[q].components, frame + list[q].place);
    }
    return failed;
}

static int fill_frames(hid_t file, const struct record *record, int64_t frames, struct message *message)
{
    double *frame = malloc(sizeof *frame * (size_t)record->frames.doubles);
    int failed = frame == NULL;
    if (failed)
        scene_no_memory(record->model->scene, message);
    for (int64_t k = 0; !failed && k < frames; ++k)
        failed = read_frame(file, record, k, frame) != 0 ||
                 journal_add(record->journal, &record->journal->frames, frame, message) != 0;
    free(frame);
    return failed ? -1 : 0;
}

/* ---- touches ----------------------------------------------------------------------------------------------------- */

/** Touches from `first` on of one frame, rows of the record. */
static int read_touches(hid_t file, const struct record *record, int64_t frame, int64_t first, int64_t count,
                        double *rows, double *values)
{
    const int spheres = record->model->clumps.list.count > 0;
    const struct {
        const char *name;
        int place, lines, components; /* lines: rows of the dataset to a touch */
    } sets[] = {{"Points", TOUCH_FROM, 2, 3},
                {spheres ? "CellData/sphere_i" : "CellData/i", TOUCH_I, 1, 1},
                {spheres ? "CellData/sphere_j" : "CellData/j", TOUCH_J, 1, 1},
                {"CellData/force", TOUCH_FORCE, 1, 3},
                {"CellData/normal_force", TOUCH_NORMAL, 1, 1},
                {"CellData/tangential_force", TOUCH_TANGENTIAL, 1, 1},
                {"CellData/overlap", TOUCH_OVERLAP, 1, 1}};
    int failed = 0;
    for (size_t q = 0; q < sizeof sets / sizeof sets[0] && !failed; ++q) {
        const int width = sets[q].lines * sets[q].components;
        char name[64];
        snprintf(name, sizeof name, "VTKHDF/%s", sets[q].name);
        failed = read_rows(file, name, sets[q].lines * first, sets[q].lines * count, sets[q].components, values);
        for (int64_t k = 0; k < count * width && !failed; ++k)
            rows[k / width * TOUCH_DOUBLES + sets[q].place + k % width] = values[k];
    }
    for (int64_t k = 0; k < count; ++k)
        rows[k * TOUCH_DOUBLES + TOUCH_FRAME] = (double)frame;
    return failed;
}

/** Those of the frames that the journal has already. */
static int fill_touches(hid_t file, const struct record *record, const struct checkpoint *checkpoint,
                        struct message *message)
{
    enum { PLACES = 6 };
    struct journal_file *touches = &record->journal->touches;
    int failed = 0;
    int64_t first = 0;
    for (int64_t frame = 0; frame < record->journal->frames.mark.count && !failed; ++frame) {
        double lines = 0.0;
        failed = read_rows(file, "VTKHDF/Lines/NumberOfCells", frame, 1, 1, &lines);
        if (!(lines >= 0.0 && lines <= (double)(checkpoint->touches.count - first)))
            return -1;
        const int64_t count = (int64_t)lines;
        double *rows = malloc(sizeof *rows * (size_t)((TOUCH_DOUBLES + PLACES) * count + 1));
        if (rows == NULL)
            failed = scene_no_memory(record->model->scene, message);
        if (!failed && count > 0)
            failed = read_touches(file, record, frame, first, count, rows, rows + TOUCH_DOUBLES * count);
        for (int64_t k = 0; k < count && !failed; ++k)
            failed = journal_add(record->journal, touches, rows + TOUCH_DOUBLES * k, message);
        free(rows);
        first += count;
    }
    return failed;
}

static int is_mark(const struct journal_mark *have, const struct journal_mark *want)
{
    return have->doubles == want->doubles && have->count == want->count && have->digest == want->digest;
}

/** What of the file at path the journal takes. Returns 1, or 0 if the file has it not, or with one line in *message. */
static int fill_from(const char *path,
                     int (*fill)(hid_t file, const struct record *record, const struct checkpoint *checkpoint,
                                 struct message *message),
                     const struct record *record, const struct checkpoint *checkpoint, struct message *message)
{
    int filled = 0;
    H5E_BEGIN_TRY
    {
        const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
        filled = file >= 0 && fill(file, record, checkpoint, message) == 0;
        if (file >= 0)
            H5Fclose(file);
    }
    H5E_END_TRY;
    return filled;
}

static int fill_records(hid_t file, const struct record *record, const struct checkpoint *checkpoint,
                        struct message *message)
{
    return fill_rows(file, record, checkpoint->rows.count, message) != 0
               ? -1
               : fill_frames(file, record, checkpoint->frames.count, message);
}

/** One line in *message, which may have one that says more. */
static int refuse(const char *path, const char *why, struct message *message)
{
    if (message->text[0] != '\0')
        return -1;
    return message_set(
        message,
        "%.600s: %s are not those that the run had recorded; start anew without --resume, or choose another "
        "place with -o",
        path, why);
}

int run_restart_fill(const char *path, const char *contacts, const struct record *record,
                     const struct checkpoint *checkpoint, struct message *message)
{
    const struct journal *journal = record->journal;
    message->text[0] = '\0';
    if (!fill_from(path, fill_records, record, checkpoint, message) ||
        !is_mark(&journal->rows.mark, &checkpoint->rows) || !is_mark(&journal->frames.mark, &checkpoint->frames))
        return refuse(path, "its rows or frames", message);
    if (checkpoint->touches.doubles == 0 || (fill_from(contacts, fill_touches, record, checkpoint, message) &&
                                             is_mark(&journal->touches.mark, &checkpoint->touches)))
        return 0;
    return refuse(contacts, "is not there, or its contacts", message);
}
