/* SPDX-License-Identifier: BSD-3-Clause
 * What a run has recorded, as the writers of its files see it. */
#ifndef VTI_RECORD_H
#define VTI_RECORD_H

#include "columns.h"
#include "model.h"
#include "journal.h"
#include "touch_forces.h"
#include "verdict.h"

/* ---- frames ----------------------------------------------------------------------------------------------------- */

/** What is written of bodies if it is asked for (--fields); sets of them are sums. */
enum { FIELD_FORCE = 1, FIELD_MOMENT = 2, FIELD_LOST = 4, FIELD_LOADS = FIELD_FORCE | FIELD_MOMENT };

/** A frame of a trajectory: all bodies at one time, in doubles: step, t, then x[n][3], v[n][3] if the bodies translate,
 *  omega[n][3] and alpha[n][3] if they turn; if they are asked for, force[n][3], moment[n][3], and each entry of what
 *  bodies have lost [n]. */
struct frame_layout {
    const struct model *model; /* must outlive the layout */
    int64_t n;
    int translates, turns;
    int64_t x, v, omega, alpha;             /* where they are in the frame; 0 is absent */
    int64_t force, moment;                  /* likewise */
    int64_t lost, entries;                  /* where what bodies have lost is; how many entries (model_body_books) */
    const char *entry[EFFECT_TERMS_OF_ALL]; /* names of the entries */
    const struct model *booking;            /* the model that books them */
    int64_t doubles;                        /* of the whole frame */
    const int64_t *number; /* [n] where bodies go that frames are taken of (renumber.h); NULL: as they are */
};

void frame_layout_of(const struct model *model, int fields, struct frame_layout *layout);
/** Of the bodies as they are, with their forces and moments where the layout has them. */
void frame_take(const struct frame_layout *layout, int64_t step, double t, const vti_bodies *bodies, double *frame);
/* Of a frame whose bodies turn: */
/** Unit quaternions [n][4], x y z w; w >= 0. */
void frame_attitudes(const struct frame_layout *layout, const double *frame, double *xyzw);
/** The same, w x y z, as ParaView's glyphs read quaternions. */
void frame_attitudes_w_first(const struct frame_layout *layout, const double *frame, double *wxyz);
/** The bodies' own x axes R e_x [n][3], along which arrows of ParaView and VTK point unturned. */
void frame_directors(const struct frame_layout *layout, const double *frame, double *directors);

/** Ellipsoids of bodies that have axes (shape.h) [n][9], rows of the symmetric tensor R_p diag(axes) R_p^T, by whose
 *  eigenvectors and eigenvalues ParaView's tensor glyphs turn and stretch a sphere of diameter 1. */
void frame_ellipsoids(const struct frame_layout *layout, const double *frame, double *tensors);
/** Attitude of the principal axes of body i, R_p, as a unit quaternion x y z w. */
void frame_principal(const struct frame_layout *layout, const double *frame, int64_t i, double xyzw[4]);
/** Where sphere s of the model's clumps is, and its velocity. */
void frame_sphere(const struct frame_layout *layout, const double *frame, int64_t s, double x[3], double v[3]);

/** Of each body the sum [n] of what it has lost: of all entries but the work of walls. */
void frame_lost(const struct frame_layout *layout, const double *frame, double *lost);

/** Whether bodies have fragments (struct effect_breaks), and which each of them is in [n]. */
int frame_has_fragments(const struct frame_layout *layout);
void frame_fragments(const struct frame_layout *layout, const double *frame, double *fragment);

/** The model's bodies, with the state of the frame, which is only read. */
vti_bodies frame_bodies(const struct frame_layout *layout, const double *frame);

/* ---- fields that are asked for ---------------------------------------------------------------------------------- */

/** "force,moment", each once or more. Returns 0, or -1 with one line in *message. */
int record_fields_read(const char *text, int *fields, struct message *message);
/** The same text of a set. */
void record_fields_say(int fields, FILE *file);
/** Whether the model has them all: a force if an effect gives one, a moment alike, losses if an effect books some.
 *  Returns 0, or -1 with one line in *message. */
int record_fields_check(int fields, const struct model *model, struct message *message);

/* ---- what touches in frames ------------------------------------------------------------------------------------- */

/** A touch in doubles, with --contacts: the frame that it is in, from 0, and the members of struct touch, of which the
 *  forces are their sum and their sizes. */
enum touch_column {
    TOUCH_FRAME,
    TOUCH_I,
    TOUCH_J,
    TOUCH_FROM,
    TOUCH_TO = TOUCH_FROM + 3,
    TOUCH_FORCE = TOUCH_TO + 3,
    TOUCH_NORMAL = TOUCH_FORCE + 3,
    TOUCH_TANGENTIAL,
    TOUCH_OVERLAP,
    TOUCH_DOUBLES
};

void record_touch(int64_t frame, const struct touch *touch, double row[TOUCH_DOUBLES]);

/* ---- the record ------------------------------------------------------------------------------------------------- */

struct record {
    struct model *model; /* its list of contacts is made to fit the frame that is written */
    const vti_stepper *stepper;
    double h;
    int64_t complete; /* 1 if the run reached its end */
    struct columns columns;
    struct frame_layout frames;
    struct journal *journal;
    char *identity;             /* of the run (identity.h) */
    struct judgement judgement; /* once it has ended */
};

/** A quantity of the bodies that changes, as files have it: its name, where it is in a frame, components. */
struct frame_quantity {
    const char *name;
    int64_t place;
    int64_t components;
    /** Makes it from what the frame holds; NULL where the frame holds it. */
    void (*derive)(const struct frame_layout *layout, const double *frame, double *values);
};

enum { FRAME_KNOWN = 11, FRAME_QUANTITIES = FRAME_KNOWN + EFFECT_TERMS_OF_ALL };

/** Those that the record has, in the order of the files. Returns how many. */
int frame_quantities(const struct record *record, struct frame_quantity list[FRAME_QUANTITIES]);

/** Calls take for all rows, in blocks of count >= 1 rows from row first, row by row of doubles. It returns 0 to go
 *  on. Returns 0, or -1 with one line in *message or if take did not return 0. */
int record_rows(const struct record *record, int (*take)(void *self, int64_t first, int64_t count, const double *rows),
                void *self, struct message *message);

/** The same for all touches, in blocks of rows TOUCH_DOUBLES wide. */
int record_touches(const struct record *record,
                   int (*take)(void *self, int64_t first, int64_t count, const double *touches), void *self,
                   struct message *message);

/** The same for all frames, one by one. */
int record_frames(const struct record *record, int (*take)(void *self, int64_t k, const double *frame), void *self,
                  struct message *message);

/** The smallest box, low to high, around the spheres of all frames, those of clumps too, and around ellipsoids however
 *  they are turned; around the centres where there are neither. Returns 0, or -1 with one line in *message. */
int record_box(const struct record *record, double low[3], double high[3], struct message *message);

#endif
