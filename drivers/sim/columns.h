/* SPDX-License-Identifier: BSD-3-Clause
 * What is recorded of a run over time: energies and momenta, a column each. What a scene lacks has no column. */
#ifndef VTI_COLUMNS_H
#define VTI_COLUMNS_H

#include "model.h"

enum { COLUMNS = 48 };

struct columns {
    const struct model *model; /* must outlive the columns */
    int count;
    const char *name[COLUMNS];
    int source[COLUMNS]; /* where columns_values finds it */
    int total;           /* the column "total" */
};

/** The model's columns: t, kinetic_translation, kinetic_rotation, a column per energy term of its effects, total,
 *  and momentum_, spin_ and angular_ x, y, z. Without translation there is no kinetic_translation and no momentum,
 *  without rotation no kinetic_rotation and no spin. */
void columns_of(const struct model *model, struct columns *columns);

/** Their values for the bodies at time t. */
void columns_values(const struct columns *columns, double t, const vti_bodies *bodies, double row[COLUMNS]);

#endif
