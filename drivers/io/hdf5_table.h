/* SPDX-License-Identifier: BSD-3-Clause
 * A group of datasets of one length, a dataset for each member of a struct, which is written row by row. */
#ifndef VTI_HDF5_TABLE_H
#define VTI_HDF5_TABLE_H

#include <stddef.h>

#include "hdf5_sink.h"

/** A member of the struct: number of 8 bytes, or text. */
struct hdf5_column {
    const char *name;
    size_t offset;
    int is_integer;
    size_t text; /* its size, or 0 for a number */
};

struct hdf5_table {
    struct hdf5_sink group;
    const struct hdf5_column *columns;
    int columns_count;
    size_t size;   /* of the struct */
    char *rows;    /* those that wait */
    int64_t first; /* of them */
    int waiting;
};

/** Makes the group and its datasets of so many rows, which must all come. What fails is seen at the end. */
struct hdf5_table hdf5_table_begin(struct hdf5_sink *parent, const char *name, const struct hdf5_column *columns,
                                   int columns_count, size_t size, int64_t rows);
void hdf5_table_add(struct hdf5_table *table, const void *row);
void hdf5_table_end(struct hdf5_sink *parent, struct hdf5_table *table);

/** A group with the dataset "name" of n texts of up to 63 letters: at(self, 0), at(self, 1), ... */
void hdf5_names(struct hdf5_sink *parent, const char *name, int64_t n, const char *(*at)(const void *self, int64_t k),
                const void *self);

#endif
