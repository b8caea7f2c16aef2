/* SPDX-License-Identifier: BSD-3-Clause
 * The search through its stages: what stages.c, laws.c, offers.c and advise.c share. */
#ifndef VTI_STAGES_H
#define VTI_STAGES_H

#include "advise.h"

/** The search through its stages. */
struct stages {
    struct search search;
    const struct advise_request *request;
    double from;             /* when it began, clock_now */
    double pace_from;        /* when the first pilot did */
    double goal;             /* the error at the end of the whole time */
    int active[ADVICE_MOST]; /* offers that the next stage goes on with */
    int64_t active_count;
    int latest[ADVICE_MOST]; /* offers that the last stage has told something of */
    double part;             /* of the time, that the last two runs of one stepper went over */
    int whole;               /* it was over the whole time */
    int complete;            /* ... and of the error asked for */
    int cut;                 /* all that is known was followed from runs of searches that the purse has cut short */
};

/* ---- offers ------------------------------------------------------------------------------------------------------ */

/** An offer of which nothing is known. */
struct offer offers_none(const vti_stepper *stepper);
/** How many times larger the error at the end of the time is than that at the end of a stage. */
double offers_growth(const struct search *s, const vti_stepper *stepper, int measure);
/** What a stage has found, searching for the error that leads to target, for the whole time and the error asked for. */
void offers_carry_over(const struct stages *g, const struct offer *found, double target, struct offer *o);
/** Once it is known how errors grow: offers from a part of the time by steps that make up for that. before: their
 *  offers_growth so far. */
void offers_regrow(struct stages *g, const double before[ADVICE_MOST]);
/** Of the run, as pilot_cost counts it; infinite where there is none. */
double offers_cost(const struct offer *o);
/** The number of the offer of ours that the search goes by, or -1: of those that the last stage has shown the one that
 *  costs least. And of the one that is the advice in the end: the fastest, or, of those that take as long to a tenth,
 *  by which seconds differ from run to run, the one that costs least. If that one's run was made, the advice is one of
 *  those that were: any other costs twice as much. */
int64_t offers_best(const struct stages *g);
int64_t offers_fastest(const struct stages *g);

/* ---- stages ------------------------------------------------------------------------------------------------------ */

/** Without a limit in seconds the purse goes by the run as it is predicted by now, of so many evaluations. */
void stages_open_purse(struct stages *g, double evals);
/** Work that a share of what is left would do, by the seconds that work has taken so far. */
double stages_work_left(const struct stages *g, double share);
void stages_all_active(struct stages *g);
/** From now on the energy is what can be told. The finest run of the stepper of the solution tells it already. */
void stages_by_energy(struct stages *g);
/** As many stages as the purse has room for. Returns 0, or -1 with one line in *message. */
int stages_go(struct stages *g);

/* ---- where only the whole time tells, and the purse has a few runs ----------------------------------------------- */

/** Whether that is so: a search over the whole time takes some dozen runs of the stepper of the solution. */
int laws_are_due(const struct stages *g);
/** As many steppers as the purse has two runs for (search_law.c). The first takes what it needs; it tells what the run
 *  will be like, and with it how much the purse holds. Returns 0, -1 or ADVISE_SPENT. */
int laws_go(struct stages *g);

#endif
