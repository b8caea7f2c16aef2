/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Tables of bodies, and of what effects want to know body by body or pair by pair: columns of numbers, a row for each.
 * Files are read into them by table_csv.h here, and by io/table_hdf5.h. */
#ifndef VTI_TABLE_H
#define VTI_TABLE_H

#include <stddef.h>
#include <stdint.h>

#include "message.h"

struct table;

/** Of the path of a file, the ending 0 included. */
enum { TABLE_PATH_SIZE = 512 };

/** No table has more rows: beyond, memory ends anyway, and products of counts stay far from their ends. */
enum { TABLE_ROWS_MAX = 100000000 };

/** What numbers a column may hold; TABLE_INDEX: bodies, whole ones from 0; TABLE_COUNT: other whole ones from 0. */
enum table_range { TABLE_ANY, TABLE_POSITIVE, TABLE_NOT_NEGATIVE, TABLE_INDEX, TABLE_COUNT };

struct table_column {
    const char *name;
    enum table_range range;
};

/** What a table is of. */
struct table_kind {
    const char *rows; /* what they are, "bodies"; also the group in an HDF5 file */
    const char *file; /* what the file is, "the scene's table of bodies" */
    const struct table_column *column;
    int columns; /* at most TABLE_COLUMNS */
    /** Whether the columns that there are go together. Returns 0, or -1 with one line in *message. */
    int (*check)(const struct table *table, struct message *message);
};

extern const struct table_kind table_bodies;

/** Columns of bodies: x y z, vx vy vz, alpha_x alpha_y alpha_z, omega_x omega_y omega_z, moment_a
 *  moment_b moment_c, principal_x principal_y principal_z, mass, inertia, diameter, young poisson, clump. */
enum {
    BODY_X = 0,
    BODY_V = 3,
    BODY_ALPHA = 6,
    BODY_OMEGA = 9,
    BODY_MOMENTS = 12,
    BODY_PRINCIPAL = 15,
    BODY_VECTORS = 18, /* columns that belong together by threes end here */
    BODY_MASS = 18,
    BODY_INERTIA,
    BODY_DIAMETER,
    BODY_YOUNG,
    BODY_POISSON,
    BODY_CLUMP /* its template */
};

/** No table has more columns. */
enum { TABLE_COLUMNS = 24 };

struct table {
    const struct table_kind *kind;
    char path[TABLE_PATH_SIZE];
    int has_lines; /* row k stands on line k + 2, behind a line of names */
    int64_t rows, capacity;
    double *column[TABLE_COLUMNS]; /* [rows]; NULL if the table lacks it */
};

/** Reads one table from a file: table_csv_read and the like. */
typedef int table_reader(const char *path, const struct table_kind *kind, struct table *table, struct message *message);

/** The name of column k, NULL behind the last. */
const char *table_column(const struct table_kind *kind, int k);
/** Which column has the name, -1 if there is none. */
int table_find(const struct table_kind *kind, const char *name);
/** "x, y, z, ...", cut off at size. Returns out. */
char *table_list(const struct table_kind *kind, char *out, size_t size);

/** The file's name says that it is HDF5, by .h5 or .hdf5; any other is CSV. */
int table_is_hdf5(const char *path);

/** An empty table without columns. */
void table_start(struct table *table, const struct table_kind *kind, const char *path);
/** Gives the table column k. Returns 0, or -1 without memory. */
int table_add(struct table *table, int k);
/** Makes room for at least that many rows in every column there is. Returns likewise. */
int table_reserve(struct table *table, int64_t rows);
void table_destroy(struct table *table);

/** Why value cannot stand in column k, as one clause with its remedy; NULL if it can. */
const char *table_refusal(const struct table_kind *kind, int k, double value);
/** Whether the columns that there are go together and hold any row. Returns 0, or -1 with one line in *message. */
int table_check(const struct table *table, struct message *message);

/** Writes the line "FILE: TEXT" about the table as a whole and returns -1. */
int table_fail_whole(const struct table *table, struct message *message, const char *text);
/** The same about its columns: "FILE:1: TEXT" where names have a line. */
int table_fail_columns(const struct table *table, struct message *message, const char *text);
/** Writes the line "FILE:LINE: TEXT" (or "FILE: row K: TEXT") about a row and returns -1. */
int table_fail(const struct table *table, int64_t row, struct message *message, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/** The table has column k. */
static inline int table_has(const struct table *table, int k)
{
    return table->column[k] != NULL;
}

#endif
