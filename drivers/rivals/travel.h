/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The interface through which all programs run a stepper, of the core or a rival: which there are, and a run of one of
 * them. */
#ifndef VTI_TRAVEL_H
#define VTI_TRAVEL_H

#include "loop.h"

struct rival;  /* rival.h */
struct course; /* rival.h */

/** Lets scenes name rivals as their stepper. To be called before the first scene is read. */
void method_admit(void);

/** Every stepper of the core whose angular velocity is spatial, its multistep methods, then every rival. Not to be
 *  called first by two threads. */
int64_t method_count(void);
/** NULL outside 0 <= i < method_count(). */
const vti_stepper *method_at(int64_t i);
/** The same of bodies of three moments: the steppers of the core, and the rivals that know such bodies, which
 *  method_at does not list. NULL after the last. */
const vti_stepper *method_general_at(int64_t i);
/** Whether it moves bodies of three moments, or spheres if moments is 0. */
int method_moves(const vti_stepper *method, int moments);
/** All that method_find knows. NULL outside of them. */
const vti_stepper *method_named_at(int64_t i);
/** Also those that are not listed. NULL if there is none. */
const vti_stepper *method_find(const char *name);
/** NULL for a method of the core. */
const struct rival *method_rival(const vti_stepper *stepper);
/** The stepper with steps by a tolerance, such as "srkn11-tol" of srkn11; itself if it is one; NULL if it has no
 *  estimate of its error. */
const vti_stepper *method_controlled(const vti_stepper *stepper);
/** What the scene runs the stepper as: itself, or with steps by its tolerance or its control; NULL if it cannot be. */
const vti_stepper *method_for(const struct scene *scene, const vti_stepper *stepper);
/** What runs it, where it is not a list of kicks and drifts: the engine of a rival, of a multistep method or of steps
 *  of variable length, which all are a struct rival; else NULL. */
const struct rival *method_engine(const vti_stepper *stepper);
/** Whether its steps follow how fast bodies turn. */
int method_is_varied(const vti_stepper *stepper);
/** Whether it is one of ours that chooses its steps itself. */
int method_chooses(const vti_stepper *stepper);
/** The same of rivals too: a step has to be cut wherever somebody looks. */
int method_varies(const vti_stepper *stepper);
/** Whether it has an estimate of what a step errs by. */
int method_estimates(const vti_stepper *stepper);
/** As in files: "ours", "paper", "rival". */
const char *method_kind(const vti_stepper *stepper);

/** Lists "exact,rk4" of an option in list[most]. Returns how many, or -1 with one line in *message that names the
 *  known ones. */
int64_t methods_read(const char *option, const char *text, const vti_stepper **list, int64_t most,
                     struct message *message);

/** Of the longest name in letters, at least 14: a column of a table. */
int methods_width(const vti_stepper *const *list, int64_t n);

/** A run of a stepper: it owns what the stepper needs beside the model. */
struct travel {
    const vti_stepper *stepper;
    vti_stepper list; /* where that is one of kicks and drifts: the same with the scene's rotor */
    struct model *model;
    double h;
    int64_t steps;         /* taken so far */
    struct course *course; /* of a rival or a multistep method, else NULL */
    double *copies;        /* of velocities, for steppers that lag; else NULL */
    vti_bodies seen[2];    /* of a course: what observers are shown, in time and raw; sealed */
};

/** Whether the stepper can take the model: where something dissipates, not all can. Returns 0, or -1 with one line in
 *  *message. */
int travel_check(const vti_stepper *stepper, const struct model *model, struct message *message);

/** Prepares a run of *model by *stepper from t = 0, by steps of h; where the scene has a tolerance or a control, by
 *  steps that these choose, and h is then the time between two states that observers can see. The model must outlive
 *  the run, and nobody else may change it; where its bodies are at any time travel_bodies tells, and they need not.
 *  Returns 0, or -1 with one line in *message. */
int travel_create(struct travel *travel, const vti_stepper *stepper, struct model *model, double h,
                  struct message *message);

/** So many steps further, shown to observers as loop_run shows them; the first call also takes the forces at t = 0. Of
 *  a course observers see attitudes as alpha. Returns 0; 1 if an observer stopped it; -1 with one line in *message
 *  (such as: step too large), after which there is nothing left to do but travel_destroy. */
int travel_show(struct travel *travel, int64_t steps, const struct observer *observers, int observers_count,
                struct message *message);
/** The same without observers, in a tight loop. */
int travel_go(struct travel *travel, int64_t steps, struct message *message);

/** The bodies, with x, v, attitude (alpha or a unit quaternion) and omega all of the time steps h: velocities of a
 *  lagging stepper are brought there on copies. The views hold until the next travel_go. */
vti_bodies travel_bodies(struct travel *travel);

/** What a course keeps beside the model's bodies, *count doubles that belong into a checkpoint and are put back from
 *  it; NULL and 0 for a list of kicks and drifts. */
double *travel_state(struct travel *travel, int64_t *count);
/** After the model's bodies, as a raw observer saw them, and travel_state are what they were after so many steps: a
 *  fresh travel goes on from there with the same bits. Force evaluations of a course are counted anew. */
void travel_resume(struct travel *travel, int64_t steps);

/** Force evaluations of a run to here without a stop, the first at t = 0 included: what a stop costs (a stepper
 *  takes the forces again when it goes on) is not counted. */
int64_t travel_force_evals(const struct travel *travel);

/** What steps of variable length have come to. */
struct travel_tally {
    int64_t accepted, rejected; /* steps taken, and steps undone because their errors were too large */
    int64_t cut;                /* steps tried to end where somebody looked, which are undone thereafter */
    int64_t evals;              /* force evaluations of all of them */
    double longest;             /* step since the look before; 0 at first */
    double tolerance;           /* 0: steps go by the scene's control */
};

/** 1, and the tally, of steps of variable length; else 0. */
int travel_tally(const struct travel *travel, struct travel_tally *tally);

/** Steps of h between looks at what may stop a run, in which bodies are moved so often; of steps of variable length,
 *  many of which may fit into one of h, 1. */
int64_t travel_pause(const struct travel *travel, int64_t moves);

void travel_destroy(struct travel *travel);

#endif
