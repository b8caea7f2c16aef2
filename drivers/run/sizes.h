/* SPDX-License-Identifier: BSD-3-Clause
 * How much disk a run takes, before it goes. */
#ifndef VTI_SIZES_H
#define VTI_SIZES_H

#include "run.h"

/** Bytes, of a run that is open. */
struct run_sizes {
    double files;   /* of what it leaves, about */
    double journal; /* of OUT.run, which is there until these are written */
    double needed;  /* of both, what is not there yet */
    double space;   /* in the folder; infinite if nobody says */
};

struct run_sizes sizes_of(const struct run *run);

/** "120 MB", "2.31 GB", "1.5 TB" */
const char *sizes_text(double bytes, char text[32]);

#endif
