/* SPDX-License-Identifier: BSD-3-Clause
 * What touches, with the forces there. */
#ifndef VTI_TOUCH_FORCES_H
#define VTI_TOUCH_FORCES_H

#include "kind.h"

/** Two spheres that overlap and are in contact, or a sphere and a wall. */
struct touch {
    int64_t i, j;          /* bodies as people number them, or spheres of clumps, i < j; j = -1 - w: wall w, planes
                              before cylinders */
    double from[3], to[3]; /* the centre of i; that of j, or the place on the wall that is nearest to it */
    double normal[3];      /* elastic force on i */
    double tangential[3];  /* on i, of the spring of sliding friction; zeros where there is none */
    double overlap;        /* length */
};

struct touch_list {
    int64_t count, room;
    struct touch *touch; /* ascending by i, then by j; from malloc */
};

/** Whether bodies of the model can touch each other or walls. */
int touch_forces_may(const struct model *model);

/** Finds what touches now, of the pairs of the last model_find_pairs for these bodies; springs of friction as they
 *  are. Of clumps their spheres are looked at in place of the bodies. *list, zeros at first, is filled anew. Returns 0,
 *  or -1 if there is no memory. */
int touch_forces_find(const struct model *model, const vti_bodies *bodies, struct touch_list *list);
/** Frees its memory. */
void touch_forces_free(struct touch_list *list);

#endif
