/* SPDX-License-Identifier: BSD-3-Clause
 * Sweeps: keys of a scene and the values that they go through, and the points that these make together. */
#ifndef VTI_SWEEP_H
#define VTI_SWEEP_H

#include <stddef.h>
#include <stdint.h>

#include "message.h"

enum { SWEEP_AXES = 8, SWEEP_KEY = 96, SWEEP_VALUE = 256, SWEEP_TEXT = SWEEP_KEY + SWEEP_VALUE, SWEEP_MOST = 1000000 };

/** One --sweep. */
struct sweep_axis {
    char key[SWEEP_KEY]; /* "binder.axial" */
    const char *list;    /* "100,200", or NULL for a range: value k is from + k step */
    double from, step;
    int64_t count;
};

/** The first axis is the ensemble: means and spreads are over its values, at each value of the others. In the order
 *  of points it runs fastest and the last one slowest. Zeros are a sweep without axes, of one point. */
struct sweep {
    struct sweep_axis axis[SWEEP_AXES];
    int count;
};

/** Adds the axis "key=1:1000", "key=0:1:1/8" (ends included) or "key=100,200"; commas within brackets belong to a
 *  value. The text must outlive the sweep. Returns 0, or -1 with one line in *message. */
int sweep_add(struct sweep *sweep, const char *text, struct message *message);

/** Refuses a value, of --set or of an option, for a key that is swept: no run would have it. Returns 0, or -1 with one
 *  line in *message. */
int sweep_check_set(const struct sweep *sweep, const char *set, struct message *message);

/** How many points there are, at most SWEEP_MOST + 1. */
int64_t sweep_points(const struct sweep *sweep);

/** Which value of an axis point p has. */
int64_t sweep_index(const struct sweep *sweep, int64_t p, int axis);

/** The value of that number as text, cut off at size. Returns out. */
char *sweep_value(const struct sweep_axis *axis, int64_t k, char *out, size_t size);

/** The overrides of point p as they follow --set, sweep->count of them. */
void sweep_overrides(const struct sweep *sweep, int64_t p, char out[SWEEP_AXES][SWEEP_TEXT]);

#endif
