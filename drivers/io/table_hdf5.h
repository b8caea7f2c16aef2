/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Tables in HDF5: a group, /bodies say, with a dataset of one dimension for each column, of any type of numbers and all
 * of the same length. Several groups may be in one file. */
#ifndef VTI_TABLE_HDF5_H
#define VTI_TABLE_HDF5_H

#include "tables.h"

/** Reads a group of the file at path, table_check included. Returns 0, or -1 with one line in *message and *table
 *  destroyed. */
int table_hdf5_read(const char *path, const struct table_kind *kind, struct table *table, struct message *message);

/** Reads the tables that *scene names, CSV or HDF5, and gives them to it: scene->tables becomes tables, which must then
 *  outlive the scene's models. Returns 0, or -1 with one line in *message and nothing to be destroyed. */
int tables_read(struct scene *scene, struct tables *tables, struct message *message);

#endif
