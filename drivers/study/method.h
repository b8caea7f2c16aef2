/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The seam through which a study runs a stepper of the core or a rival: what there is, and one of them on its way through a
 * model. */
#ifndef VTI_METHOD_H
#define VTI_METHOD_H

#include "model.h"

struct rival;  /* rivals/rival.h */
struct course; /* rivals/rival.h */

struct method {
    const char *name;           /* as in files: "exact", "lammps-richardson" */
    const char *kind;           /* "ours", "paper", "rival" */
    const char *about;          /* one line: what it is, who uses it, source */
    int64_t order;              /* 0 if it does not converge in attitude at all */
    const vti_stepper *stepper; /* of the core; NULL for a rival */
    const struct rival *rival;  /* NULL for a stepper */
};

/** Every stepper of the core whose angular velocity is spatial, then every rival. Not to be called first by two threads. */
int64_t method_count(void);
/** NULL outside 0 <= i < method_count(). */
const struct method *method_at(int64_t i);
/** NULL if there is none. */
const struct method *method_find(const char *name);

/** A method on its way through a model: it owns what the method needs beside the model. */
struct travel {
    const struct method *method;
    struct model *model;
    double h, lag;         /* velocities live at t - lag h */
    int64_t steps;         /* taken so far */
    int64_t force_evals;   /* of a stepper; a rival counts its own */
    struct course *course; /* of a rival */
    double *copies;        /* of velocities, for methods that lag; else NULL */
};

/** Prepares *method to take *model, at t = 0, by steps of h. The model must outlive the travel and be left alone by others: the
 *  method moves its bodies, or leaves them behind. Returns 0, or -1 with one line in *message. */
int travel_create(struct travel *travel, const struct method *method, struct model *model, double h,
                  struct message *message);

/** So many steps further, in a tight loop without observers; the first call also takes the forces at t = 0. Returns 0, or -1
 *  with one line in *message (such as: step too large), after which there is nothing left to do but travel_destroy. */
int travel_go(struct travel *travel, int64_t steps, struct message *message);

/** The bodies, with x, v, attitude (alpha or a unit quaternion) and omega all of the time steps h: velocities of a lagging
 *  method are brought there on copies. The views hold until the next travel_go. */
vti_bodies travel_bodies(struct travel *travel);

/** Force evaluations of a run to here without a stop, the first at t = 0 included: what a stop costs (a stepper takes the
 *  forces again when it goes on) is not counted. */
int64_t travel_force_evals(const struct travel *travel);

void travel_destroy(struct travel *travel);

#endif
