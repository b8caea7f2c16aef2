/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Tables as text: names on the first line, then a row a line, all separated by commas. Blanks around numbers and names
 * are passed over; quotes, comments and empty lines are refused. */
#ifndef VTI_TABLE_CSV_H
#define VTI_TABLE_CSV_H

#include "table.h"

/** Reads the file at path, table_check included. Returns 0, or -1 with one line in *message such as "bodies.csv:7:12:
 *  mass: 'nan' is not a number; ..." and *table destroyed. */
int table_csv_read(const char *path, const struct table_kind *kind, struct table *table, struct message *message);

#endif
