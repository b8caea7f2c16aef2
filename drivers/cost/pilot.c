/* SPDX-License-Identifier: BSD-3-Clause */
#include "advise.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "number.h"
#include "random.h"

/* one look at the energy of so many is timed, after so many one of so many more, as reading the time may take longer
 * than both a step and a look; and at the purse there are so many where steps vary */
enum { TIMED = 16, FIRST = 4096, RARELY = 1024, LOOKS = 64 };

/* ---- the purse --------------------------------------------------------------------------------------------------- */

/** Whether so much more work, on its way, leaves nothing. */
static int purse_is_empty(const struct purse *purse, double more)
{
    return purse->work + more >= purse->most || (isfinite(purse->until) && clock_now() >= purse->until);
}

int purse_may_start(const struct purse *purse)
{
    return !isfinite(purse->until) || clock_now() + purse->start < purse->until;
}

/* ---- on the way -------------------------------------------------------------------------------------------------- */

/** A pilot and what looks at it. */
struct flight {
    struct pilot *pilot;
    struct trial_run run;
    const struct purse *purse;
    struct pilot_way way;
    double evals;               /* of a step, with a look at every one; 0 where they vary */
    double looking;             /* seconds that are not the steps' */
    double clock;               /* seconds that reading the time takes */
    int64_t looks, timed_looks; /* at the energy, and how many of them were timed */
    double timed;               /* seconds of these */
    int64_t step;               /* the last at which the purse was looked at */
};

/** A copy at p of a view that is there. Returns where the next one goes. */
static double *keep(vti_view *view, double *p, int64_t n, int *finite)
{
    if (view->c[0] == NULL)
        return p;
    for (int64_t i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k) {
            p[3 * i + k] = view->c[k][i * view->stride];
            *finite &= isfinite(p[3 * i + k]) != 0;
        }
    *view = vti_view_packed(p);
    return p + 3 * n;
}

/** Whether the two runs are on their way to have nothing to do with each other, errors growing with the time: three
 *  times the angle that says nothing. Late in a run its end is near, and its energy is worth it. Where the coarser one
 *  was ended so, there is nothing more to compare with. */
static int has_parted(const struct flight *f, int64_t mark)
{
    enum { EARLY = PILOT_MARKS / 4 };
    static const double parted = 0.9;
    const struct pilot *beside = f->way.beside;
    if (beside != NULL && beside->parted > 0 && mark + 1 >= beside->parted)
        return 1;
    return beside != NULL && mark < EARLY &&
           pilot_error(beside, f->pilot, f->way.measure, (int)mark) * PILOT_MARKS > parted * (double)(mark + 1);
}

static int see_mark(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct flight *f = self;
    struct pilot *pilot = f->pilot;
    const double from = clock_of_thread();
    const int64_t n = bodies->count;
    int finite = 1;
    (void)t;
    if (step == 0)
        return 0;
    const int64_t mark = step == pilot->steps ? PILOT_MARKS - 1 : step / (pilot->steps / PILOT_MARKS) - 1;
    vti_bodies *b = &pilot->at[mark];
    double *p = pilot->memory + 12 * n * mark;
    *b = vti_bodies_none(n);
    b->x = bodies->x;
    b->v = bodies->v;
    b->alpha = bodies->alpha;
    b->omega = bodies->omega;
    p = keep(&b->x, p, n, &finite);
    p = keep(&b->v, p, n, &finite);
    p = keep(&b->alpha, p, n, &finite);
    keep(&b->omega, p, n, &finite);
    if (has_parted(f, mark)) {
        f->step = step;
        pilot->parted = (int)mark + 1;
    }
    f->looking += clock_of_thread() - from;
    return finite ? pilot->parted > 0 : message_set(&pilot->message, "the bodies leave the range of numbers");
}

/** Energy, with what effects have booked, and rotation. */
static int look(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct flight *f = self;
    struct pilot *pilot = f->pilot;
    struct model *model = &f->run.model;
    const int timed = f->looks % (f->looks < FIRST ? TIMED : RARELY) == 0;
    const double from = timed ? clock_of_thread() : 0.0;
    const double energy = model_energy(model, bodies) + vti_booked(model->effects, model->effects_count);
    (void)t;
    ++f->looks;
    f->timed_looks += timed;
    pilot->energy = step == 0 ? energy : pilot->energy;
    const double off = fabs(energy - pilot->energy) / (pilot->energy != 0.0 ? fabs(pilot->energy) : 1.0);
    pilot->energy_error = number_larger(pilot->energy_error, off);
    pilot->max_omega = fmax(pilot->max_omega, vti_max_turn(1.0, bodies));
    if (timed)
        f->timed += fmax(clock_of_thread() - from - f->clock, 0.0);
    return 0;
}

static int see_purse(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct flight *f = self;
    (void)t;
    f->step = step;
    f->pilot->spent = purse_is_empty(f->purse, f->evals * (double)step * (double)bodies->count);
    return f->pilot->spent;
}

/** Steps between two looks at the purse: about a millisecond's. Methods whose steps vary stop at their own where they
 *  are looked at, which costs them something. */
static int64_t purse_every(const struct flight *f, int64_t steps, int64_t bodies)
{
    static const double work = 2e4;
    const double every = f->evals > 0.0 ? fmax(1.0, work / (f->evals * (double)bodies)) : (double)steps / LOOKS;
    return (int64_t)fmin(fmax(every, 1.0), 1e15);
}

/** Seconds of the steps, of which looks are as dear as those that were timed; at the least a tenth of all. */
static double seconds_of(const struct flight *f)
{
    const double all = f->run.seconds,
                 looks = f->timed_looks > 0 ? f->timed * (double)f->looks / (double)f->timed_looks : 0.0;
    return fmax(all - f->looking - looks, 0.1 * all);
}

static int64_t fly(struct flight *f, const struct trial *trial)
{
    struct pilot *pilot = f->pilot;
    const int64_t steps = trial->steps;
    const struct observer observers[] = {
        {see_purse, f, purse_every(f, steps, f->run.model.bodies.count), 0, NULL, NULL},
        {see_mark, f, pilot->marked ? steps / PILOT_MARKS : steps, 0, NULL, NULL},
        {look, f, trial_look_every(trial), 0, NULL, NULL}};
    pilot->failed = trial_go(&f->run, steps, observers, f->way.blind ? 2 : 3, &pilot->message) != 0 && !pilot->spent &&
                    pilot->parted == 0;
    pilot->seconds = seconds_of(f);
    pilot->force_evals = travel_force_evals(&f->run.travel);
    if ((pilot->spent || pilot->parted > 0) && pilot->force_evals == 0) /* of a list of kicks that was stopped */
        pilot->force_evals = 1 + f->step * trial->stepper->evals;
    return f->run.model.bodies.count;
}

double pilot_evals(const vti_stepper *stepper)
{
    return (double)(stepper->evals > 0 ? stepper->evals : 1) + 1.0;
}

double pilot_cost(const vti_stepper *stepper, double evals)
{
    /* by the instructions of docs/accuracy.md, 1.4 to 2.1 and 1.3 to 1.5 */
    static const double sums_of_the_past = 1.7, gradient = 1.4;
    return evals * (vti_multistep_find(stepper->name) != NULL ? sums_of_the_past
                    : stepper->probe != NULL                  ? gradient
                                                              : 1.0);
}

int64_t pilot_unit(int64_t steps)
{
    enum { FEW = 8 * PILOT_MARKS };
    return steps > FEW ? PILOT_MARKS : 1;
}

int64_t pilot_steps(double steps)
{
    static const double least = 4.0;
    const double limited = ceil(fmin(fmax(steps, least), LOOP_STEPS)), unit = (double)pilot_unit((int64_t)limited);
    return (int64_t)(unit * ceil(limited / unit));
}

/** The largest component of a place, from the first body's. */
static double extent_of(const vti_bodies *b)
{
    double most = 0.0;
    for (int64_t i = 0; b->x.c[0] != NULL && i < b->count; ++i)
        for (int k = 0; k < 3; ++k)
            most = fmax(most, fabs(b->x.c[k][i * b->x.stride] - b->x.c[k][0]));
    return most > 0.0 ? most : 1.0;
}

static void nudge_view(const vti_view *view, int64_t n, double most)
{
    for (int64_t k = 0; view->c[0] != NULL && k < 3 * n; ++k)
        view->c[k % 3][k / 3 * view->stride] += random_symmetric(0, (uint64_t)k, most);
}

static void nudge_bodies(const vti_bodies *b, double nudge)
{
    nudge_view(&b->x, b->count, nudge * extent_of(b));
    nudge_view(&b->alpha, b->count, nudge);
}

int pilot_run(const struct scene *scene, const struct trial *trial, struct purse *purse, struct pilot_way way,
              struct pilot *pilot, struct message *message)
{
    struct flight flight = {.pilot = pilot, .purse = purse, .way = way};
    flight.clock = race_clock_cost();
    flight.evals = method_varies(trial->stepper) ? 0.0 : pilot_evals(trial->stepper);
    memset(pilot, 0, sizeof *pilot);
    pilot->steps = trial->steps;
    pilot->marked = trial->steps % PILOT_MARKS == 0;
    if (purse_is_empty(purse, 0.0) || !purse_may_start(purse))
        return ADVISE_SPENT;
    const double from = clock_now();
    if (trial_begin(&flight.run, scene, trial, message) != 0)
        return -1;
    purse->start = clock_now() - from;
    pilot->memory = calloc((size_t)(12 * PILOT_MARKS * flight.run.model.bodies.count), sizeof *pilot->memory);
    const int without = pilot->memory == NULL;
    if (way.nudge > 0.0)
        nudge_bodies(&flight.run.model.bodies, way.nudge);
    if (!without) {
        const int64_t bodies = fly(&flight, trial);
        purse->work += (double)bodies * (double)(pilot->force_evals + flight.looks);
    }
    trial_end(&flight.run);
    if (without)
        return scene_no_memory(scene, message);
    return pilot->spent ? ADVISE_SPENT : 0;
}

void pilot_destroy(struct pilot *pilot)
{
    free(pilot->memory);
    pilot->memory = NULL;
}

double pilot_error(const struct pilot *pilot, const struct pilot *solution, int measure, int mark)
{
    if (pilot->failed || (solution != NULL && solution->failed))
        return INFINITY;
    if (mark < PILOT_MARKS - 1 && (!pilot->marked || (solution != NULL && !solution->marked)))
        return NAN;
    if (measure == COST_ENERGY)
        return isnan(pilot->energy_error) ? INFINITY : pilot->energy_error;
    const vti_bodies *b = &pilot->at[mark], *exact = &solution->at[mark];
    return measure == COST_ATTITUDE   ? vti_attitude_distance(b, exact)
           : measure == COST_POSITION ? race_position_error(b, exact)
                                      : race_velocity_error(b, exact);
}
