/* SPDX-License-Identifier: BSD-3-Clause
 * Advice: which stepper and which h reach a given error at the end of a scene, and what that takes. */
#ifndef VTI_ADVISE_H
#define VTI_ADVISE_H

#include "cost_ladder.h"
#include "loop.h"

/* What functions return that ended without an answer, beside 0 and -1. */
enum {
    ADVISE_SPENT = 1, /* the purse is empty */
    ADVISE_PARTED = 2 /* finer and finer runs do not come together */
};

/* ---- what pilots may cost ---------------------------------------------------------------------------------------- */

/** Looked at inside pilots. work is counted, so that without a time the same runs are made on every machine. */
struct purse {
    double until;      /* seconds of clock_now; INFINITY: any time */
    double start;      /* seconds before the first step of a pilot, as the last one took */
    double work, most; /* force evaluations and looks at the energy, times bodies: spent, and how many may be */
};

/** Force evaluations times bodies, about half a second of them, that pilots may always take. */
enum { PURSE_LEAST = 4000000 };

/** Whether there is time to start the scene once more, which nothing interrupts. */
int purse_may_start(const struct purse *purse);

/* ---- pilot runs -------------------------------------------------------------------------------------------------- */

enum { PILOT_MARKS = 16 };

/** One stepper from the start of a scene on, of which the bodies at sixteen times are kept, the last at the end. */
struct pilot {
    int64_t steps, force_evals;
    int failed;       /* a step was refused, or a state is not finite; message says why */
    int marked;       /* all of these are there; else, of runs of a few steps, only the end */
    int spent;        /* ended because the purse was empty */
    int parted;       /* ended at so many marks, having left the run that it was flown beside; 0: it was not */
    double seconds;   /* of the steps alone */
    double max_omega; /* largest |Omega| at the end of a step */
    double energy, energy_error; /* at t = 0; the largest |E - E_0|/|E_0| at the end of a step (absolute if E_0 = 0) */
    vti_bodies at[PILOT_MARKS];  /* x, v, alpha and omega, of those that the scene has */
    double *memory;
    struct message message;
};

/** The next number of steps that a pilot goes in: a multiple of PILOT_MARKS, its unit, unless it is small. Never more
 *  than LOOP_STEPS. */
int64_t pilot_steps(double steps);
int64_t pilot_unit(int64_t steps);
/** Evaluations that a step of a pilot costs: it is looked at, as errors of the energy may last for one step of a
 *  thousand, and that costs about as much as a force evaluation. */
double pilot_evals(const vti_stepper *stepper);
/** What so many evaluations by a stepper cost, with its share of the steps, in evaluations of Verlet's method. The
 *  search goes by this and not by seconds, which differ from run to run: they only say which of its offers is the
 *  fastest. */
double pilot_cost(const vti_stepper *stepper, double evals);
/** How a pilot is flown; nothing given: from the scene's start to the end, looked at at every step. */
struct pilot_way {
    const struct pilot *beside; /* a coarser run of the same time, or NULL. Where the two part early by a measure of
                                   cost_ladder.h, the rest would tell nothing of trajectories, and the run ends there */
    int measure;
    double nudge; /* it begins off by so much at most: x of the extent, alpha in radians */
    int blind;    /* nobody looks at the energy */
};
/** Runs the trial, of pilot_steps. Returns 0; ADVISE_SPENT; or -1 with one line in *message if there is no memory or no
 *  model. A run that fails on its way is pilot->failed. pilot_destroy is due after any of them. */
int pilot_run(const struct scene *scene, const struct trial *trial, struct purse *purse, struct pilot_way way,
              struct pilot *pilot, struct message *message);
void pilot_destroy(struct pilot *pilot);

/** How far a run is from the solution at a mark, by a measure of cost_ladder.h; of the energy that at all marks, for
 *  which the solution may be NULL. Infinite if either has failed, NaN at a mark that is not there. */
double pilot_error(const struct pilot *pilot, const struct pilot *solution, int measure, int mark);

/* ---- advice ------------------------------------------------------------------------------------------------------ */

enum { ADVICE_MOST = 64 };

/** Where an offer comes from. */
enum offer_source {
    OFFER_NONE,      /* no run has told anything of this stepper */
    OFFER_STABILITY, /* from the stable step alone */
    OFFER_FOLLOWED,  /* from coarser runs over the whole time, by the stepper's order */
    OFFER_SHORTER,   /* from runs over the first part of the time */
    OFFER_MEASURED   /* this very run was made */
};

/** One stepper's way to the error that was asked for. */
struct offer {
    const vti_stepper *stepper;
    int64_t steps; /* 0: none was found that it survives */
    int64_t force_evals;
    double h, error, seconds;
    double order;                 /* that its runs showed */
    double usual;                 /* times its error, what coarser runs let expect of one in so many steps: where forces
                                     have kinks one that meets a touch at the right moment errs by far less; >= 1 */
    double missed;                /* error of the run in the next fewer steps that was made; NaN: none missed */
    double more;                  /* times the steps of the finest of these, if that is why it is not one of them */
    int coarse;                   /* ... which began near its stable step, where errors fall by more than any order */
    double doubt, below;          /* the error lies between error/below and error doubt; INFINITY: anywhere */
    double part_doubt;            /* ... of what the first part of the time tells, at its end */
    double errors[COST_MEASURES]; /* by all measures; NaN where the scene has none, or nothing is known */
    enum offer_source source;
};

/** What is asked for. */
struct advise_request {
    const struct scene *scene;
    double target, t_end;
    int measure;                        /* of cost_ladder.h; -1: the scene's main one */
    double budget;                      /* seconds; 0: the share of the predicted run that advise_share says */
    const vti_stepper *const *steppers; /* count of them; 0: all of ours that the scene may be run by */
    int64_t count;
    void (*begin)(const struct model *model);        /* sees the scene before any run; may be NULL */
    void (*say)(const char *stepper, int64_t steps); /* hears of every run; may be NULL */
};

struct advice {
    double target, t_end;
    int measure;                 /* by which the offers reach the target: energy where trajectories part */
    double together;             /* up to when trajectories of the finest runs agree to a tenth; t_end where they do */
    int parted;                  /* ... and they do not: the target is the energy's */
    int unsure;                  /* ... but the finest runs are too coarse to tell whether finer ones do */
    struct model_limits limits;  /* of the step, at the start */
    double energy;               /* at the start; errors of it are shares of this unless it is 0 */
    double max_omega;            /* of the solution; NaN: there is none */
    double order;                /* that the most accurate runs showed; NaN if they needed no refining */
    double nominal;              /* ... and that of their stepper in this scene, were its forces smooth */
    const vti_stepper *checked;  /* whose runs these were */
    double known;                /* error of the solution that others are compared with; NaN: there is none */
    double budget;               /* that was asked for; 0: none was */
    double start;                /* seconds before the first pilot: of the scene's start and its stable step */
    double seconds, work, evals; /* that the pilots took; evaluations times bodies, and evaluations */
    int64_t count;
    struct offer offers[ADVICE_MOST]; /* by rising seconds, rivals after ours; the first is the advice */
};

/** The share of the predicted run that pilots take at most, if nothing else is said; more where forces have kinks, and
 *  windows tell nothing. Where that is less than half a second or so, they take that. */
double advise_share(const struct scene *scene);
/** "attitude" and so on. Returns the measure, or -1. */
int advise_measure(const char *name);

/** Works out the advice by pilot runs within the budget. There always is one: from runs over the whole time if the
 *  budget allows, else from its first part, from coarser runs, at the least from the stable step. Rivals in the list
 *  are measured too, and are never the advice. Returns 0, or -1 with one line in *message. */
int advise(const struct advise_request *request, struct advice *advice, struct message *message);

/* ---- the search of one stepper ----------------------------------------------------------------------------------- */

/* One stepper's way to an error: which number of steps meets it. */

struct search {
    const struct scene *scene;
    struct advice *advice;
    struct purse purse;
    double t_end, target;    /* of this stage: a part of the time, or an error that is easier to reach */
    int measure, trajectory; /* of the errors; and by which runs come together or not */
    struct pilot solution;
    int solved;
    double known[COST_MEASURES]; /* how far off the solution may be by each */
    double strayed[PILOT_MARKS]; /* of the whole time: how far two runs are apart that began a nudge apart, in nudges;
                                    where no pair was flown, 0 */
    double omega0;
    double stable_h; /* of bonds at rest and whatever may touch: searches begin there, and no longer step is advised */
    double limit;    /* of pilot_cost, beyond which runs are too dear */
    int64_t bodies;
    int kinked;     /* the forces are */
    int dissipates; /* something does */
    double pushed;  /* at the start: the largest |F|/m and |RM|/J */
    int breaks;     /* something may break: sooner or later by a step, and errors follow no order for long */
    double doubt;   /* of what orders tell: 3 where forces are smooth, 10 where they have kinks (EQUATIONS 8.5) */
    void (*say)(const char *stepper, int64_t steps);
    struct message *message;
};

/** A pilot run over s->t_end. Returns as pilot_run does. search_run_beside ends it where it parts from a coarser
 *  one. */
int search_run_beside(struct search *s, const vti_stepper *stepper, int64_t steps, const struct pilot *beside,
                      struct pilot *pilot);
int search_run(struct search *s, const vti_stepper *stepper, int64_t steps, struct pilot *pilot);
/** The share of the error asked for that h is aimed at where the run is not made: less where forces have kinks, as one
 *  run in a few errs by some times what others let expect. */
double search_aim(const struct search *s);
/** The longest step that is worth trying: 0.9 of the stable one, and of the closed form's own bound. */
double search_longest(const struct search *s, const vti_stepper *stepper);
/** The fewest steps that are worth trying, of that or a little less; LOOP_STEPS where these would be more. */
int64_t search_fewest(const struct search *s, const vti_stepper *stepper);
/** The stepper's order in this scene, of ever finer steps. Where something dissipates that is 2 at most, and 1 where
 *  velocities lag: no flow goes back by half a kick (EQUATIONS 6.8). Where nothing pushes at the start, places and
 *  attitudes of vti3 are of order 2 (EQUATIONS 2). */
double search_order(const struct search *s, const vti_stepper *stepper);
/** Whether errors by another measure fall by that order too: velocities and energies of vti3 never do by 2. */
int search_falls_alike(const struct search *s, const vti_stepper *stepper, int measure);
/** The highest that longer steps may show: what dissipates may be feeble. */
double search_most_order(const struct search *s, const vti_stepper *stepper);
/** The least order by which errors fall where forces have kinks: those in which touches begin and end are off by more
 *  than the others. */
double search_kinked_order(const struct search *s, const vti_stepper *stepper);
/** By what order errors fall where forces have kinks, as docs/accuracy.md has found it. */
double search_usual_order(const struct search *s, const vti_stepper *stepper);
/** What is left of an order that coarse runs have shown: where forces have kinks or something dissipates it need not
 *  last. */
double search_lasting_order(const struct search *s, const vti_stepper *stepper, double shown);
/** Says of how much doubt an error is that was followed by this order to so many times the steps. It is below it by
 *  more where a higher order may last: among kinks one more than the usual one, though no more than the stepper's own,
 *  and the stepper's own where something dissipates. */
void search_doubt(const struct search *s, struct offer *o, double order, double finer);
/** Fills in the offer of o->stepper for s->t_end and s->target by runs that cost up to the limit (pilot_cost), compared
 *  with s->solution. Returns likewise; where the purse is empty, or has no room for the next run, the offer is followed
 *  from the runs that were made, if one of them tells anything: else its source is OFFER_NONE. */
int search_stepper(struct search *s, struct offer *o, double limit);
/** Above this an angle says nothing about how it falls. */
#define SEARCH_TOO_FAR 0.3
/** The error of a run of this stage: at the end if that is the scene's. Else errors grow with the time on the whole and
 *  swing about that, through zero or to twice of it: the median of what the second half of the marks says of the
 *  end. */
double search_error(const struct search *s, const struct pilot *pilot, int measure);
/** By the measure that is asked for and by the others; NaN by those by which the solution is not known well enough: it
 *  is refined by one measure, and hardly at all where the energy is asked for. */
void search_errors(const struct search *s, const struct pilot *pilot, double errors[COST_MEASURES]);
/** Refines a->checked until its runs tell the error s->target: that is s->solution. Of the purse it takes up to the
 *  share. Returns 0, -1, ADVISE_SPENT or ADVISE_PARTED. */
int search_solution(struct search *s, double share);
/** Flies two runs over the whole time that begin a nudge apart, as coarse as can be, into s->strayed. They tell how
 *  what a step errs by grows from one part of the time to the end. Returns as pilot_run does. */
int search_stray(struct search *s);
/** The work of that. */
double search_stray_work(const struct search *s);
/** How many times further they are apart at the end than at time t; 1 if that is not known. */
double search_growth(const struct search *s, double t);
int search_knows_growth(const struct search *s);
/** Whether they stray so much that rounding alone passes the goal in the end, and no step is short enough; then from
 *  when on is advice->together. */
int search_strays(struct search *s, double goal);
/** Up to when two runs agree to a tenth, in radians or of all velocities. */
double search_together(const struct search *s, const struct pilot *a, const struct pilot *b);
/** Whether bodies turn by so much in a step of this run that it does not tell whether finer ones come together. */
int search_unresolved(const struct search *s, const struct pilot *run);

/** Fills in the offer of o->stepper from two runs, in so many steps and in twice as many. If these have nothing to do
 *  with each other, from finer ones, as far as the work that all of them may take allows, until two of those are as far
 *  apart. Returns 0, -1, ADVISE_SPENT, or ADVISE_PARTED if no two come together: then it is the finest run, or the one
 *  before if they part so early that the finest is not flown to its end, of which the energy's error is known, and
 *  search_law_follow goes on by that once s->measure is the energy. The offer stays as it is if they fail. */
int search_law(struct search *s, struct offer *o, int64_t steps, double may);
void search_law_follow(const struct search *s, struct offer *o);
/** The same from one run, of which that of the energy alone is known; s->measure is that. */
void search_law_energy(const struct search *s, struct offer *o, const struct pilot *run);
/** Force evaluations of the coarsest two runs that are worth making. */
double search_law_evals(const struct search *s, const vti_stepper *stepper);

#endif
