/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Tables of bodies and of bonds: columns of numbers with the names below, one row per body or bond. Files are read into
 * them by table_csv.h here, and by io/table_hdf5.h. */
#ifndef VTI_TABLE_H
#define VTI_TABLE_H

#include <stddef.h>
#include <stdint.h>

#include "scene.h"

enum table_kind { TABLE_BODIES, TABLE_BONDS };

/** Columns of bodies: x y z, vx vy vz, alpha_x alpha_y alpha_z, omega_x omega_y omega_z, mass, inertia, diameter. */
enum {
    BODY_X = 0,
    BODY_V = 3,
    BODY_ALPHA = 6,
    BODY_OMEGA = 9,
    BODY_VECTORS = 12, /* columns that belong together by threes end here */
    BODY_MASS = 12,
    BODY_INERTIA,
    BODY_DIAMETER,
    TABLE_COLUMNS
};

/** Columns of bonds: i j (bodies, from 0), and moment axial shear (stiffnesses). */
enum { BOND_I, BOND_J, BOND_MOMENT, BOND_AXIAL, BOND_SHEAR };

struct table {
    enum table_kind kind;
    char path[SCENE_PATH_SIZE];
    int has_lines; /* row k stands on line k + 2, behind a line of names */
    int64_t rows, capacity;
    double *column[TABLE_COLUMNS]; /* [rows]; NULL if the table lacks it */
};

/** The tables that a scene names; a table that it does not name has no rows and no columns. */
struct tables {
    struct table bodies, bonds;
};

/** The name of column k, NULL behind the last. */
const char *table_column(enum table_kind kind, int k);
/** Which column has the name, -1 if there is none. */
int table_find(enum table_kind kind, const char *name);
/** "x, y, z, ...", cut off at size. Returns out. */
char *table_list(enum table_kind kind, char *out, size_t size);

/** The file's name says that it is HDF5, by .h5 or .hdf5; any other is CSV. */
int table_is_hdf5(const char *path);

/** An empty table without columns. */
void table_start(struct table *table, enum table_kind kind, const char *path);
/** Gives the table column k. Returns 0, or -1 without memory. */
int table_add(struct table *table, int k);
/** Makes room for at least that many rows in every column there is. Returns likewise. */
int table_reserve(struct table *table, int64_t rows);
void table_destroy(struct table *table);

/** Why value cannot stand in column k, as one clause with its remedy; NULL if it can. */
const char *table_refusal(enum table_kind kind, int k, double value);
/** Whether the columns that there are go together and hold any row. Returns 0, or -1 with one line in *message. */
int table_check(const struct table *table, struct message *message);

/** Writes the line "FILE:LINE: TEXT" (or "FILE: row K: TEXT") about a row and returns -1. */
int table_fail(const struct table *table, int64_t row, struct message *message, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

static inline int table_has(const struct table *table, int k)
{
    return table->column[k] != NULL;
}

#endif
