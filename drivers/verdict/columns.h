/* SPDX-License-Identifier: BSD-3-Clause
 * What is recorded of a run over time: energies and momenta, a column each. What a scene lacks has no column. */
#ifndef VTI_COLUMNS_H
#define VTI_COLUMNS_H

#include "model.h"

enum { COLUMNS = 64 };

struct columns {
    const struct model *model; /* must outlive the columns */
    int count;
    const char *name[COLUMNS];
    const struct effect_term *term[COLUMNS]; /* in pictures, of energies; NULL where nobody says */
    int source[COLUMNS];                     /* where columns_values finds it */
    int effect[COLUMNS];                     /* whose energy it is; -1 for none */
    int held;     /* columns 1 ... held - 1 are energies that the bodies have, those from held
                                                to total what effects have booked */
    int total;    /* the column "total", of both */
    int modified; /* the column "energy_modified"; -1 if there is none */
};

/** The model's columns: t, kinetic_translation, kinetic_rotation, a column per energy term of its effects, one per
 *  entry that they book, total, energy_modified if the stepper has one (modified.h), momentum_, spin_ and angular_ x,
 *  y, z, of lines that may break how many hold, and fragments, and where the model's errors are asked for
 *  error_velocity and error_omega. Without translation there is no kinetic_translation, no momentum and no
 *  error_velocity, without rotation no kinetic_rotation, no spin and no error_omega. */
void columns_of(const struct model *model, const vti_stepper *stepper, struct columns *columns);

/** Their values for the bodies at time t, but for energy_modified, which verdict_row puts in its place. */
void columns_values(const struct columns *columns, double t, const vti_bodies *bodies, double row[COLUMNS]);

#endif
