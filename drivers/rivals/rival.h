/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Rivals: the integrators that people use instead of ours, to compare with. Each is written from the
 * literature as a plain loop over packed arrays, and takes its forces from the same effects as our steppers. */
#ifndef VTI_RIVAL_H
#define VTI_RIVAL_H

#include <stddef.h>

#include "model.h"

struct course;
struct travel_tally; /* travel.h */
struct observer;     /* loop.h */

/** evals: of a step; 0 where they vary. reach: as in vti_stepper, NaN where nobody has worked it out. */
#define RIVAL_STEPPER(NAME, ORDER, LAG, EVALS, REACH, ABOUT)                                                           \
    {                                                                                                                  \
        .name = (NAME), .frame = VTI_FRAME_SPACE, .order = (ORDER), .evals = (EVALS), .lag = (LAG), .reach = (REACH),  \
        .about = (ABOUT)                                                                                               \
    }

enum { RIVAL_OF_SPHERES, RIVAL_OF_MOMENTS, RIVAL_OF_BOTH };

struct rival {
    vti_stepper stepper; /* what it is listed and named as: it has no coefficients, and the core refuses it */
    double phi;          /* Campello's: the share of a kick that is by the forces at the step's start */
    const void *table;   /* what the engine of a family goes by; NULL where a rival is alone */
    int64_t own_width;   /* doubles per body of its own, besides the quaternion */
    /** What it needs before the first step, forces excepted; NULL if nothing. Returns 0, or -1 if there is no memory
     *  or, with a line in *message, for another reason. */
    int (*prepare)(struct course *course, struct message *message);
    /** The next steps of h. Returns VTI_OK or a status; then course->fault may name a body. */
    int (*go)(struct course *course, int64_t steps);
    /** Makes course->bodies presentable, q as units; NULL if they are. */
    void (*show)(struct course *course);
    /** Before it goes on from a checkpoint: undoes what show has done to the memory; NULL if that is nothing. */
    void (*resume)(struct course *course);
    void (*dismiss)(struct course *course); /* NULL if there is nothing to free */
    /** What has come of steps of variable length; NULL of those of h. */
    void (*tally)(const struct course *course, struct travel_tally *tally);
    int takes_forces; /* 1: go begins with the forces of the bodies as they stand */
    int general;      /* RIVAL_OF_: which bodies it moves */
};

int64_t rival_count(void);
/** NULL outside 0 <= i < rival_count(). */
const struct rival *rival_at(int64_t i);
/** Members of a family that are found by name and not listed; NULL after the last. */
const struct rival *rival_unlisted(int64_t i);
/** Those of bodies of three moments, which are in a list of their own; NULL after the last. */
const struct rival *rival_general(int64_t i);
/** Not rivals: the library's own multistep methods, which run as rivals do; NULL outside 0 <= i <
 *  vti_multistep_count(). The first call for an i is not for two threads. */
const struct rival *multistep_at(int64_t i);

/** The same of those that choose their steps by a tolerance: their table is the vti_stepper that they step by. NULL
 *  outside 0 <= i < 3. */
const struct rival *tolerance_at(int64_t i);

/** The same of those whose steps follow how fast bodies turn: by the integrating controller, or the naive one. NULL
 *  after the last. A scene calls for them by its control; they are not listed, nor found by name. */
const struct rival *density_at(int64_t i, int naive);

/** A rival that runs a model. Arrays are [n][3], and [n][4] in the order x, y, z, w for q; those of what
 *  the model does not have are NULL. x, v, w, L, f and m are the model's own memory. */
struct course {
    const struct rival *rival;
    struct model *model;
    double h;
    int64_t n, steps, evals;
    double *x, *v, *f, *w, *m, *q, *L; /* L: angular momenta, of bodies of three moments */
    vti_scalars per_mass, per_inertia; /* 1/m and 1/J, of all bodies or of each */
    vti_bodies bodies;                 /* the views on all these: what forces are taken at */
    double *memory, *own;
    int64_t memory_doubles;
    double *number; /* [COURSE_NUMBERS], of the tool; they begin the memory, which with x, v, w is all that goes on */
    void *tool;     /* whatever a rival needs that is not numbers, or can be made anew */
    double longest; /* step, of those that choose theirs */
    double gap;     /* the largest part of that step without forces (course_longest) */
    int begun;      /* forces are those of the bodies as they stand */
    int ends;       /* 1: the next go ends where observers look only because the run ends there */
    const struct observer *wants; /* who may want steps of variable length to end sooner; NULL: nobody */
    int64_t cut_at_end;           /* steps that were tried for that, of those by a tolerance */
    vti_fault fault;
};

enum { COURSE_NUMBERS = 10 };

/** The model at t = 0 with a rival that steps it by h. Returns NULL with one line in *message if that cannot be. */
struct course *course_create(const struct rival *rival, struct model *model, double h, struct message *message);
void course_destroy(struct course *course);
/** Forces of the bodies as they stand, of a course that was put where it is (steps > 0). Returns 0, or -1 with one line
 *  in *message. */
int course_begin(struct course *course, struct message *message);
/** Takes it so many steps further. Returns 0, or -1 with one line in *message. */
int course_go(struct course *course, int64_t steps, struct message *message);
/** A step of h by a list of kicks and drifts. Returns VTI_OK, or a status of the library or of the forces. */
int course_step(struct course *course, const vti_stepper *by, double h);
/** The bodies after these steps, velocities as the rival keeps them. */
const vti_bodies *course_bodies(struct course *course);

/** h times the fastest that there is, of the frequencies that vti_stable_step allows for and the spins of the bodies as
 *  they stand; 1 if nothing oscillates or spins. Returns 0, or -1 with one line in *message. */
int course_fastest(struct course *course, double *most, struct message *message);
/** The longest step by which no head-on touch is missed in course->longest, of a method of which gap is the largest
 *  part of a step between two evaluations of forces. Returns likewise. */
int course_longest(struct course *course, double gap, struct message *message);

/** Forces and moments of the bodies as they stand. */
static inline int course_forces(struct course *course)
{
    ++course->evals;
    return model_forces(course->model, &course->bodies);
}

#endif
