/* SPDX-License-Identifier: BSD-3-Clause
 * Where a study keeps the results of its tasks as they come in, so that a study that dies can go on. On rank 0. */
#ifndef VTI_STORE_H
#define VTI_STORE_H

#include <stdint.h>

#include "message.h"

struct store {
    void *self;
    /** Whether the result of the task is there: 1, and *rank that did it and *result are set; else 0. */
    int (*recall)(void *self, int64_t task, int *rank, void *result);
    /** Keeps it. Returns 0, or -1 with one line in *message. */
    int (*keep)(void *self, int64_t task, int rank, const void *result, struct message *message);
};

#endif
