/* SPDX-License-Identifier: BSD-3-Clause */
#include "hdf5_table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK = 4096, NUMBER = 8 };

static size_t width(const struct hdf5_column *column)
{
    return column->text > 0 ? column->text : NUMBER;
}

/** To be closed if it is a text's. */
static hid_t type_of(const struct hdf5_column *column)
{
    if (column->text == 0)
        return column->is_integer ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE;
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, column->text);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    return type;
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
        const hid_t type = type_of(column);
        char *values = malloc((size_t)table->waiting * w);
        table->group.failed |= values == NULL;
        for (int r = 0; values != NULL && r < table->waiting; ++r)
            memcpy(values + (size_t)r * w, table->rows + (size_t)r * table->size + column->offset, w);
        if (values != NULL)
            hdf5_rows(&table->group, column->name, type, (hsize_t)table->first, (hsize_t)table->waiting, values);
        free(values);
        if (column->text > 0)
            H5Tclose(type);
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
