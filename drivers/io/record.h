/* SPDX-License-Identifier: BSD-3-Clause
 * What a run has recorded, as the writers of its files see it. */
#ifndef VTI_RECORD_H
#define VTI_RECORD_H

#include "columns.h"
#include "frame.h"
#include "journal.h"
#include "verdict.h"

struct record {
    struct model *model; /* its list of contacts is made to fit the frame that is written */
    const vti_stepper *stepper;
    double h;
    int64_t complete; /* 1 if the run reached its end */
    struct columns columns;
    struct frame_layout frames;
    int fields; /* fields.h */
    struct journal *journal;
    char *identity;             /* of the run (identity.h) */
    struct judgement judgement; /* once it has ended */
};

/** Calls take for all rows, in blocks of count >= 1 rows from row first, row by row of doubles. It returns 0 to go
 *  on. Returns 0, or -1 with one line in *message or if take did not return 0. */
int record_rows(const struct record *record, int (*take)(void *self, int64_t first, int64_t count, const double *rows),
                void *self, struct message *message);

/** The same for all frames, one by one. */
int record_frames(const struct record *record, int (*take)(void *self, int64_t k, const double *frame), void *self,
                  struct message *message);

/** The box, low to high, that just holds the spheres of all frames; points where there are no diameters. Returns 0, or
 *  -1 with one line in *message. */
int record_box(const struct record *record, double low[3], double high[3], struct message *message);

#endif
