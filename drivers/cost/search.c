/* SPDX-License-Identifier: BSD-3-Clause
 *
 * From its largest stable step on a stepper is run with ever more steps, each number chosen by the order seen so
 * far, until it meets the error from below, or would cost several times what the best has needed; then its order
 * tells the rest. */
#include "advise.h"

#include <math.h>
#include <stddef.h>

#include "plain.h"

/* h is aimed at a share of the error asked for, and taken if the error lies between the lowest share and 1 */
static const double aim = 0.7, lowest = 0.35;

/* runs of one stepper at most, and of these between a run that misses the error and one that meets it */
enum { TRIES = 24, REFINEMENTS = 4 };

int search_run(struct search *s, const vti_stepper *stepper, int64_t steps, struct pilot *pilot)
{
    if (s->say != NULL)
        s->say(stepper->name, steps);
    const struct trial trial = {stepper, s->advice->t_end / (double)steps, steps, s->advice->t_end};
    return pilot_run(s->scene, &trial, pilot, s->message);
}

int64_t search_fewest(const struct search *s, const vti_stepper *stepper)
{
    double h = 0.9 * 0.5 * (isnan(stepper->reach) ? 2.0 : stepper->reach) * s->stable_h;
    if (stepper->law == VTI_LAW_CLOSED && s->omega0 > 0.0)
        h = fmin(h, 0.9 / s->omega0);
    return (int64_t)fmax(4.0, ceil(fmin(s->advice->t_end / h, 1e15)));
}

/** A run on the way: how many steps gave what error. */
struct point {
    int64_t steps;
    double error;
};

/** Of one step, as the last run has shown it. */
struct price {
    double evals, seconds;
};

/** Order between two points, kept within what can be meant, since coarse runs may not converge yet and kinks leave 2
 *  of any order; the stepper's own if there is only one. */
static double order_between(const vti_stepper *stepper, const struct point *coarse, const struct point *fine)
{
    const double most = (double)stepper->order + 1.0, least = 0.9 * fmin((double)stepper->order, 2.0);
    if (coarse->steps == 0 || !(coarse->error < 0.3))
        return (double)stepper->order;
    return fmin(
        fmax(plain_log2(coarse->error / fine->error) / plain_log2((double)fine->steps / (double)coarse->steps), least),
        most);
}

static int64_t steps_for(const struct point *p, double order, double error)
{
    return (int64_t)ceil((double)p->steps * plain_power(p->error / error, 1.0 / order));
}

/** Steps between two points, one on each side of the error aimed at. */
static int64_t steps_between(const struct point *above, const struct point *below, double error)
{
    /* by the error where that falls evenly, else by halves: it may jump */
    double share = plain_log2(above->error / error) / plain_log2(above->error / below->error);
    share = share > 0.1 && share < 0.9 ? share : 0.5;
    const double steps = (double)above->steps * plain_power((double)below->steps / (double)above->steps, share);
    return (int64_t)llrint(fmin(fmax(steps, (double)above->steps + 1.0), (double)below->steps - 1.0));
}

static void offer_set(const struct search *s, struct offer *o, int64_t steps, double error, const struct price *price,
                      int measured)
{
    o->steps = steps;
    o->force_evals = llrint(price->evals * (double)steps);
    o->h = s->advice->t_end / (double)steps;
    o->error = error;
    o->seconds = price->seconds * (double)steps;
    o->measured = measured;
}

/** The next number of steps to try, or 0 if the search is over. above: the finest run that misses the error; below: the
 *  coarsest that meets it (steps = 0: none so far). */
static int64_t next_try(const struct search *s, const vti_stepper *stepper, const struct point *before,
                        const struct point *above, const struct point *below)
{
    const double target = s->advice->target;
    if (below->steps > 0) {
        const int good = below->error >= lowest * target;
        return good || above->steps == 0 || below->steps - above->steps < 2 ? 0
                                                                            : steps_between(above, below, aim * target);
    }
    if (!(above->error < 0.3))
        return 2 * above->steps;
    const int64_t steps = steps_for(above, order_between(stepper, before, above), aim * target);
    return (int64_t)fmin(fmax((double)steps, 1.2 * (double)above->steps + 1.0), 4.0 * (double)above->steps);
}

/** Whether a run of so many steps costs too much to be made. Runs that are too coarse to converge tell nothing about
 *  finer ones, so more is spent until one does. */
static int is_too_dear(const struct search *s, const struct price *price, const struct point *finest, int64_t steps,
                       double limit)
{
    const double cost = (double)steps * price->evals;
    return cost > (finest->error < 0.3 ? limit : 4.0 * limit) && isfinite(s->limit);
}

/** Follows the order from the finest run to where it meets the error. */
static void follow(const struct search *s, struct offer *o, const struct point *before, const struct point *finest,
                   const struct price *price)
{
    const double error = aim * s->advice->target, nominal = (double)o->stepper->order;
    const double seen = order_between(o->stepper, before, finest);
    const int64_t steps = steps_for(finest, fabs(seen - nominal) < 0.7 ? nominal : seen, error);
    offer_set(s, o, steps, error, price, 0);
}

int search_stepper(struct search *s, struct offer *o, double limit)
{
    struct point before = {0, INFINITY}, above = {0, INFINITY}, below = {0, 0.0};
    struct price price = {0.0, 0.0};
    int refinements = 0;
    int64_t steps = search_fewest(s, o->stepper);
    for (int k = 0; k < TRIES && steps > 0; ++k) {
        struct pilot pilot;
        if (search_run(s, o->stepper, steps, &pilot) != 0)
            return -1;
        const struct point p = {steps, pilot_error(&pilot, &s->solution)};
        price.seconds = pilot.seconds / (double)steps;
        price.evals = o->stepper->evals > 0 ? (double)o->stepper->evals : (double)pilot.force_evals / (double)steps;
        pilot_destroy(&pilot);
        refinements += below.steps > 0;
        if (p.error <= s->advice->target) {
            below = p;
            offer_set(s, o, steps, p.error, &price, 1);
        } else {
            before = above;
            above = p;
        }
        steps = refinements < REFINEMENTS ? next_try(s, o->stepper, &before, &above, &below) : 0;
        if (below.steps == 0 && is_too_dear(s, &price, &above, steps, limit))
            break;
    }
    if (below.steps == 0 && above.error < 0.3)
        follow(s, o, &before, &above, &price);
    else if (below.steps == 0)
        o->seconds = INFINITY;
    return 0;
}
