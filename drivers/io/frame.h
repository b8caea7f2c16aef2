/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A frame of a trajectory: all bodies at one time, in doubles: step, t, then x[n][3], v[n][3] if the bodies
 * translate, and omega[n][3] and alpha[n][3] if they turn. */
#ifndef VTI_FRAME_H
#define VTI_FRAME_H

#include "model.h"

struct frame_layout {
    const struct model *model; /* must outlive the layout */
    int64_t n;
    int translates, turns;
    int64_t x, v, omega, alpha; /* where they are in the frame; 0 is absent */
    int64_t doubles;            /* of the whole frame */
};

void frame_layout_of(const struct model *model, struct frame_layout *layout);
void frame_take(const struct frame_layout *layout, int64_t step, double t, const vti_bodies *bodies, double *frame);
/* Of a frame whose bodies turn: */
/** Unit quaternions [n][4], x y z w; w >= 0. */
void frame_attitudes(const struct frame_layout *layout, const double *frame, double *xyzw);
/** The same, w x y z, as ParaView's glyphs read quaternions. */
void frame_attitudes_w_first(const struct frame_layout *layout, const double *frame, double *wxyz);
/** The bodies' own x axes R e_x [n][3], along which arrows of ParaView and VTK point unturned. */
void frame_directors(const struct frame_layout *layout, const double *frame, double *directors);

/** The model's bodies, with the state of the frame, which is only read. */
vti_bodies frame_bodies(const struct frame_layout *layout, const double *frame);
/** Forces and moments [n][3] of all effects, as the model gives them; of what it gives none, nothing is written. Contacts are found
 *  anew, and sums over them depend on positions alone. Returns VTI_OK or a status that model_text explains. */
int frame_loads(struct model *model, const struct frame_layout *layout, const double *frame, double *force,
                double *moment);

#endif
