/* SPDX-License-Identifier: BSD-3-Clause
 * Where a long row of numbers goes, some at a time, so that it need not be in memory as a whole. */
#ifndef VTI_SINK_H
#define VTI_SINK_H

#include <stdint.h>

struct sink {
    void (*add)(struct sink *sink, const double *numbers, int64_t count);
    void *context; /* what add puts them into */
};

#endif
