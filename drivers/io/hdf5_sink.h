/* SPDX-License-Identifier: BSD-3-Clause
 * Writing HDF5 whose bytes depend on the content only: no clocks, fixed sizes. */
#ifndef VTI_HDF5_SINK_H
#define VTI_HDF5_SINK_H

#include <hdf5.h>
#include <stddef.h>
#include <stdint.h>

struct message;
struct hdf5_rows; /* a dataset that is written row by row */

/** A group or file, and whether anything has failed in it: HDF5 ids below 0 fall through every later call. */
struct hdf5_sink {
    hid_t place;
    int failed;
    struct hdf5_rows *rows; /* a list of those that are open, which a name is looked up for once */
};

/** Before anything else is done with HDF5. */
void hdf5_start(void);

/** Makes a new file, in the place of one that a killed program has left; never through a link. If it
 *  cannot be made *message gets one line that says why. */
struct hdf5_sink hdf5_file(const char *path, struct message *message);
struct hdf5_sink hdf5_group(struct hdf5_sink *parent, const char *name);
/** Closes a group and hands its failure on. */
void hdf5_close(struct hdf5_sink *parent, struct hdf5_sink *s);
/** Closes a file. Returns 0, or -1 if anything has failed. */
int hdf5_close_file(struct hdf5_sink *s);

/** A number, or dims[rank] of them with rank <= 2; data == NULL leaves them for hdf5_rows. */
void hdf5_dataset(struct hdf5_sink *s, const char *name, hid_t type, int rank, const hsize_t *dims, const void *data);
/** Writes count rows, from row first on, of a dataset of any rank <= 2; data are of the dataset's type. Short rows may
 *  wait until the group or file is closed. */
void hdf5_rows(struct hdf5_sink *s, const char *name, hsize_t first, hsize_t count, const void *data);

void hdf5_attribute(struct hdf5_sink *s, const char *name, hid_t type, hsize_t count, const void *values);
/** Texts of a fixed length, padded by zeros; to be closed by H5Tclose. */
hid_t hdf5_text_type(size_t length);
/** ASCII, of the text's own length. */
void hdf5_text(struct hdf5_sink *s, const char *name, const char *text);

/* ---- tables ------------------------------------------------------------------------------------------------------ */

/* A group of datasets of one length, a dataset for each member of a struct, which is written row by row. */

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
