/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "hdf5_sink.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "message.h"

static void check(struct hdf5_sink *s, herr_t status)
{
    s->failed |= status < 0;
}

/* ---- rows -------------------------------------------------------------------------------------------------------- */

enum { WAIT = 1 << 16 };

/** Short rows wait until there are WAIT bytes of them: a write of HDF5 takes longer than it takes to gather a frame. */
struct hdf5_rows {
    struct hdf5_rows *next;
    hid_t set, space, type;
    hsize_t columns;
    size_t size;            /* of a row */
    hsize_t first, waiting; /* rows */
    char *data;             /* of those that wait */
    char name[];
};

/** Opens a dataset of any rank <= 2. */
static struct hdf5_rows *rows_open(struct hdf5_sink *s, const char *name)
{
    struct hdf5_rows *rows = calloc(1, sizeof *rows + strlen(name) + 1);
    hsize_t dims[2] = {0, 1};
    s->failed |= rows == NULL;
    if (rows == NULL)
        return NULL;
    memcpy(rows->name, name, strlen(name) + 1);
    rows->set = H5Dopen2(s->place, name, H5P_DEFAULT);
    rows->space = H5Dget_space(rows->set);
    rows->type = H5Dget_type(rows->set);
    const int rank = H5Sget_simple_extent_ndims(rows->space);
    check(s, rank == 1 || rank == 2 ? H5Sget_simple_extent_dims(rows->space, dims, NULL) : -1);
    rows->columns = dims[1];
    rows->size = (size_t)dims[1] * H5Tget_size(rows->type);
    rows->next = s->rows;
    s->rows = rows;
    return rows;
}

static struct hdf5_rows *rows_called(struct hdf5_sink *s, const char *name)
{
    struct hdf5_rows *rows = s->rows;
    while (rows != NULL && strcmp(rows->name, name) != 0)
        rows = rows->next;
    return rows != NULL ? rows : rows_open(s, name);
}

static void rows_write(struct hdf5_sink *s, const struct hdf5_rows *rows, hsize_t first, hsize_t count,
                       const void *data)
{
    const hsize_t start[2] = {first, 0}, block[2] = {count, rows->columns};
    check(s, H5Sselect_hyperslab(rows->space, H5S_SELECT_SET, start, NULL, block, NULL));
    const hid_t memory = H5Screate_simple(2, block, NULL);
    check(s, H5Dwrite(rows->set, rows->type, memory, rows->space, H5P_DEFAULT, data));
    H5Sclose(memory);
}

static void rows_flush(struct hdf5_sink *s, struct hdf5_rows *rows)
{
    if (rows->waiting > 0)
        rows_write(s, rows, rows->first, rows->waiting, rows->data);
    rows->waiting = 0;
}

static void rows_close(struct hdf5_sink *s)
{
    for (struct hdf5_rows *rows = s->rows, *next; rows != NULL; rows = next) {
        next = rows->next;
        rows_flush(s, rows);
        H5Tclose(rows->type);
        H5Sclose(rows->space);
        check(s, H5Dclose(rows->set));
        free(rows->data);
        free(rows);
    }
    s->rows = NULL;
}

void hdf5_rows(struct hdf5_sink *s, const char *name, hsize_t first, hsize_t count, const void *data)
{
    struct hdf5_rows *rows = rows_called(s, name);
    if (rows == NULL)
        return;
    if (first != rows->first + rows->waiting || (rows->waiting + count) * rows->size > WAIT)
        rows_flush(s, rows);
    if (rows->data == NULL && count * rows->size <= WAIT)
        rows->data = malloc(WAIT);
    if (rows->data == NULL || count * rows->size > WAIT) {
        rows_write(s, rows, first, count, data);
        return;
    }
    memcpy(rows->data + rows->waiting * rows->size, data, count * rows->size);
    rows->first = rows->waiting == 0 ? first : rows->first;
    rows->waiting += count;
}

/* ---- files and groups -------------------------------------------------------------------------------------------- */

void hdf5_start(void)
{
    H5dont_atexit();                       /* after a failed write it would try again at exit, and crash */
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL); /* one line of ours instead of HDF5's stack */
}

struct hdf5_sink hdf5_file(const char *path, struct message *message)
{
    const hid_t properties = H5Pcreate(H5P_FILE_CREATE), access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_obj_track_times(properties, 0);
    H5Pset_sieve_buf_size(access, 0); /* rows are gathered here: no 64 kB to clear for each dataset */
    unlink(path);
    struct hdf5_sink s = {H5Fcreate(path, H5F_ACC_EXCL, properties, access), 0, NULL}; /* O_EXCL */
    const int reason = errno;
    H5Pclose(access);
    H5Pclose(properties);
    s.failed = s.place < 0;
    if (s.failed)
        message_set(message, "%s: cannot be made: %s", path, strerror(reason));
    return s;
}

struct hdf5_sink hdf5_group(struct hdf5_sink *parent, const char *name)
{
    const hid_t properties = H5Pcreate(H5P_GROUP_CREATE);
    H5Pset_obj_track_times(properties, 0);
    struct hdf5_sink s = {H5Gcreate2(parent->place, name, H5P_DEFAULT, properties, H5P_DEFAULT), 0, NULL};
    H5Pclose(properties);
    s.failed = s.place < 0;
    return s;
}

void hdf5_close(struct hdf5_sink *parent, struct hdf5_sink *s)
{
    rows_close(s);
    check(s, H5Gclose(s->place));
    parent->failed |= s->failed;
}

int hdf5_close_file(struct hdf5_sink *s)
{
    rows_close(s);
    check(s, H5Fclose(s->place));
    return s->failed ? -1 : 0;
}

/* ---- datasets ---------------------------------------------------------------------------------------------------- */

void hdf5_dataset(struct hdf5_sink *s, const char *name, hid_t type, int rank, const hsize_t *dims, const void *data)
{
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    const hid_t space = rank > 0 ? H5Screate_simple(rank, dims, NULL) : H5Screate(H5S_SCALAR);
    H5Pset_obj_track_times(properties, 0);
    H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER); /* every number is written */
    const hid_t set = H5Dcreate2(s->place, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    if (data != NULL)
        check(s, H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
    check(s, H5Dclose(set));
    H5Sclose(space);
    H5Pclose(properties);
}

/* ---- attributes -------------------------------------------------------------------------------------------------- */

void hdf5_attribute(struct hdf5_sink *s, const char *name, hid_t type, hsize_t count, const void *values)
{
    const hid_t space = count > 1 ? H5Screate_simple(1, &count, NULL) : H5Screate(H5S_SCALAR);
    const hid_t set = H5Acreate2(s->place, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    check(s, H5Awrite(set, type, values));
    check(s, H5Aclose(set));
    H5Sclose(space);
}

hid_t hdf5_text_type(size_t length)
{
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, length > 0 ? length : 1);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    return type;
}

void hdf5_text(struct hdf5_sink *s, const char *name, const char *text)
{
    const hid_t type = hdf5_text_type(strlen(text));
    hdf5_attribute(s, name, type, 1, text);
    H5Tclose(type);
}

/* ---- tables ------------------------------------------------------------------------------------------------------ */

enum { BLOCK = 4096, NUMBER = 8 };

static size_t width(const struct hdf5_column *column)
{
    return column->text > 0 ? column->text : NUMBER;
}

/** To be closed if it is a text's. */
static hid_t type_of(const struct hdf5_column *column)
{
    return column->text > 0 ? hdf5_text_type(column->text) : column->is_integer ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE;
}

struct hdf5_table hdf5_table_begin(struct hdf5_sink *parent, const char *name, const struct hdf5_column *columns,
                                   int columns_count, size_t size, int64_t rows)
{
    const hsize_t count = (hsize_t)rows;
    struct hdf5_table table = {hdf5_group(parent, name), columns, columns_count, size, malloc(BLOCK * size), 0, 0};
    table.group.failed |= table.rows == NULL;
    for (int k = 0; k < columns_count; ++k) {
        const hid_t type = type_of(&columns[k]);
        hdf5_dataset(&table.group, columns[k].name, type, 1, &count, NULL);
        if (columns[k].text > 0)
            H5Tclose(type);
    }
    return table;
}

static void flush(struct hdf5_table *table)
{
    for (int k = 0; k < table->columns_count && table->waiting > 0; ++k) {
        const struct hdf5_column *column = &table->columns[k];
        const size_t w = width(column);
        char *values = malloc((size_t)table->waiting * w);
        table->group.failed |= values == NULL;
        for (int r = 0; values != NULL && r < table->waiting; ++r)
            memcpy(values + (size_t)r * w, table->rows + (size_t)r * table->size + column->offset, w);
        if (values != NULL)
            hdf5_rows(&table->group, column->name, (hsize_t)table->first, (hsize_t)table->waiting, values);
        free(values);
    }
    table->first += table->waiting;
    table->waiting = 0;
}

void hdf5_table_add(struct hdf5_table *table, const void *row)
{
    if (table->rows == NULL)
        return;
    memcpy(table->rows + (size_t)table->waiting++ * table->size, row, table->size);
    if (table->waiting == BLOCK)
        flush(table);
}

void hdf5_table_end(struct hdf5_sink *parent, struct hdf5_table *table)
{
    flush(table);
    free(table->rows);
    table->rows = NULL;
    hdf5_close(parent, &table->group);
}

void hdf5_names(struct hdf5_sink *parent, const char *name, int64_t n, const char *(*at)(const void *self, int64_t k),
                const void *self)
{
    enum { LETTERS = 64 };
    static const struct hdf5_column column = {"name", 0, 0, LETTERS};
    struct hdf5_table table = hdf5_table_begin(parent, name, &column, 1, LETTERS, n);
    for (int64_t k = 0; k < n; ++k) {
        char row[LETTERS] = "";
        snprintf(row, sizeof row, "%s", at(self, k));
        hdf5_table_add(&table, row);
    }
    hdf5_table_end(parent, &table);
}
