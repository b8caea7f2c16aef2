/* SPDX-License-Identifier: BSD-3-Clause */
#include "table_hdf5.h"

#include <errno.h>
#include <hdf5.h>
#include <stdio.h>
#include <string.h>

#include "held.h"
#include "number.h"
#include "quote.h"
#include "scene.h"
#include "table_csv.h"

/** Writes "FILE: GROUP/COLUMN: TEXT". */
static int fail_column(const struct table *table, const char *column, const char *problem, struct message *message)
{
    char shown[QUOTE_SIZE], text[512];
    snprintf(text, sizeof text, "/%s/%s: %s", table->kind->rows, quote(shown, sizeof shown, column), problem);
    return table_fail_whole(table, message, text);
}

/* ---- one column -------------------------------------------------------------------------------------------------- */

/** Its length if it is a list of numbers, else -1. */
static int64_t length_of(hid_t set)
{
    hsize_t length = 0;
    const hid_t type = H5Dget_type(set), space = H5Dget_space(set);
    const H5T_class_t class = H5Tget_class(type);
    const int is_list = (class == H5T_FLOAT || class == H5T_INTEGER) && H5Sget_simple_extent_ndims(space) == 1 &&
                        H5Sget_simple_extent_dims(space, &length, NULL) == 1;
    H5Sclose(space);
    H5Tclose(type);
    return is_list ? (int64_t)length : -1;
}

static int check_values(const struct table *table, int k, struct message *message)
{
    for (int64_t r = 0; r < table->rows; ++r) {
        const double value = table->column[k][r];
        const char *refusal = table_refusal(table->kind, k, value);
        if (refusal != NULL)
            return table_fail(table, r, message, "%s: '%s' %s", table_column(table->kind, k), NUMBER(value), refusal);
    }
    return 0;
}

/** first is the column that said how many rows there are, NULL if this is the first. */
static int read_set(struct table *table, hid_t set, const char *name, const char *first, struct message *message)
{
    char text[352], list[256];
    const int k = table_find(table->kind, name);
    const int64_t rows = length_of(set);
    if (k < 0) {
        snprintf(text, sizeof text, "unknown column; known are %s", table_list(table->kind, list, sizeof list));
        return fail_column(table, name, text, message);
    }
    if (rows < 0)
        return fail_column(table, name, "is not a list of numbers; give a dataset of numbers, of one dimension",
                           message);
    if (first != NULL && rows != table->rows) {
        snprintf(text, sizeof text, "%lld rows, and %s has %lld; give all columns the same number", (long long)rows,
                 first, (long long)table->rows);
        return fail_column(table, name, text, message);
    }
    H5D_space_status_t written = H5D_SPACE_STATUS_ALLOCATED;
    if (rows > 0 && (H5Dget_space_status(set, &written) < 0 || written == H5D_SPACE_STATUS_NOT_ALLOCATED))
        return fail_column(table, name,
                           "holds no values, nothing has been written to it here; write them into this file", message);
    if (rows > TABLE_ROWS_MAX || table_reserve(table, rows) != 0 || table_add(table, k) != 0)
        return fail_column(table, name, "out of memory; give fewer rows", message);
    table->rows = rows;
    if (rows > 0 && H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, table->column[k]) < 0)
        return fail_column(table, name, "cannot be read; the file is damaged, make it anew", message);
    return check_values(table, k, message);
}

/* ---- the group --------------------------------------------------------------------------------------------------- */

/** All members, in the order of their names. */
static int read_group(struct table *table, hid_t group, struct message *message)
{
    char first[QUOTE_SIZE] = "";
    H5G_info_t info;
    if (H5Gget_info(group, &info) < 0)
        return table_fail_whole(table, message, "is damaged; make it anew");
    for (hsize_t k = 0; k < info.nlinks; ++k) {
        char name[QUOTE_SIZE] = "";
        if (H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, k, name, sizeof name, H5P_DEFAULT) < 0)
            return table_fail_whole(table, message, "is damaged; make it anew");
        const hid_t set = H5Dopen2(group, name, H5P_DEFAULT);
        if (set < 0)
            return fail_column(table, name, "is not a list of numbers; give a dataset of numbers, of one dimension",
                               message);
        const int result = read_set(table, set, name, k > 0 ? first : NULL, message);
        H5Dclose(set);
        if (result != 0)
            return -1;
        if (k == 0)
            memcpy(first, name, sizeof first);
    }
    return table_check(table, message);
}

static int read_file(struct table *table, hid_t file, struct message *message)
{
    char text[96];
    if (file < 0)
        return table_fail_whole(table, message,
                                held_is(table->path) ? HELD_TEXT ", make it anew, or give a table in CSV"
                                                     : "is not a whole HDF5 file; give one, or a table in CSV");
    const hid_t group = H5Gopen2(file, table->kind->rows, H5P_DEFAULT);
    if (group < 0) {
        snprintf(text, sizeof text, "no group /%s; put a dataset for each column into it", table->kind->rows);
        return table_fail_whole(table, message, text);
    }
    const int result = read_group(table, group, message);
    H5Gclose(group);
    return result;
}

int table_hdf5_read(const char *path, const struct table_kind *kind, struct table *table, struct message *message)
{
    char text[128];
    int result;
    table_start(table, kind, path);
    FILE *probe = fopen(path, "rb"); /* HDF5 does not say why it cannot open a file */
    if (probe == NULL) {
        snprintf(text, sizeof text, "cannot be read: %s; give the path of a table", strerror(errno));
        return table_fail_whole(table, message, text);
    }
    fclose(probe);
    H5E_BEGIN_TRY /* we have words of our own */
    {
        const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
        result = read_file(table, file, message);
        if (file >= 0)
            H5Fclose(file);
    }
    H5E_END_TRY;
    if (result != 0)
        table_destroy(table);
    return result;
}

/* ---- the tables of a scene --------------------------------------------------------------------------------------- */

static int read_either(const char *path, const struct table_kind *kind, struct table *table, struct message *message)
{
    return (table_is_hdf5(path) ? table_hdf5_read : table_csv_read)(path, kind, table, message);
}

int tables_read(struct scene *scene, struct tables *tables, struct message *message)
{
    const int result = tables_read_by(read_either, scene, tables, message);
    if (result != 0)
        tables_destroy(tables);
    scene->tables = result == 0 ? tables : NULL;
    return result;
}
