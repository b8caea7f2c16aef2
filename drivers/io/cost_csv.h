/* SPDX-License-Identifier: BSD-3-Clause
 * cost.csv, errors.csv and prices.csv of a cost study. Rows are ordered by case, method and falling h; numbers have 17 digits.
 * Runs that failed have no row. */
#ifndef VTI_COST_CSV_H
#define VTI_COST_CSV_H

#include <stdio.h>

#include "cost.h"

/** Every run with its times. */
void cost_csv_write(const struct cost *cost, FILE *file);
/** Every run without them: nothing in it depends on clocks or ranks. */
void errors_csv_write(const struct cost *cost, FILE *file);
/** What each error costs with each method; empty where it is not reached. */
void prices_csv_write(const struct cost *cost, FILE *file);

#endif
