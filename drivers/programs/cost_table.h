/* SPDX-License-Identifier: BSD-3-Clause
 * A cost study for people: the price list of every case, and what the next digit costs. */
#ifndef VTI_COST_TABLE_H
#define VTI_COST_TABLE_H

#include <stdio.h>

#include "cost.h"

void cost_table_write(const struct cost *cost, FILE *file);

#endif
