/* SPDX-License-Identifier: BSD-3-Clause
 *
 * From its largest stable step on a stepper is run with ever more steps, each number chosen by the order seen so
 * far, until it meets the error from below, or would cost several times what the best has needed, or more than the
 * purse has left; then its order tells the rest. */
#include "advise.h"

#include <math.h>

#include "plain.h"

/* h is aimed at a share of the error asked for, and taken if the error lies between the lowest share and 1 */
static const double aim = 0.7, lowest = 0.35;

/* runs of one stepper at most, and of these between a run that misses the error and one that meets it */
enum { TRIES = 24, REFINEMENTS = 4 };

double search_aim(const struct search *s)
{
    return s->kinked ? 0.3 : aim;
}

int search_run(struct search *s, const vti_stepper *stepper, int64_t steps, struct pilot *pilot)
{
    return search_run_beside(s, stepper, steps, NULL, pilot);
}

int search_run_beside(struct search *s, const vti_stepper *stepper, int64_t steps, const struct pilot *beside,
                      struct pilot *pilot)
{
    if (s->say != NULL)
        s->say(stepper->name, steps);
    const struct trial trial = {stepper, s->t_end / (double)steps, steps, s->t_end};
    const struct pilot_way way = {.beside = beside, .measure = s->trajectory};
    const int result = pilot_run(s->scene, &trial, &s->purse, way, pilot, s->message);
    s->advice->evals += (double)pilot->force_evals;
    return result;
}

double search_longest(const struct search *s, const vti_stepper *stepper)
{
    const double stable = isnan(stepper->reach) ? s->stable_h : model_stable_of(stepper, s->stable_h);
    double h = 0.9 * stable;
    if (stepper->law == VTI_LAW_CLOSED && s->omega0 > 0.0)
        h = fmin(h, 0.9 / s->omega0);
    return h;
}

int64_t search_fewest(const struct search *s, const vti_stepper *stepper)
{
    return pilot_steps(s->t_end / search_longest(s, stepper));
}

/* ---- the search -------------------------------------------------------------------------------------------------- */

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
 *  of any order; that of the stepper in this scene if there is only one. */
static double order_between(const struct search *s, const vti_stepper *stepper, const struct point *coarse,
                            const struct point *fine)
{
    const double here = search_order(s, stepper), most = search_most_order(s, stepper) + 1.0,
                 least = 0.9 * fmin(here, 2.0);
    if (coarse->steps == 0 || !(coarse->error < SEARCH_TOO_FAR))
        return here;
    return fmin(
        fmax(plain_log2(coarse->error / fine->error) / plain_log2((double)fine->steps / (double)coarse->steps), least),
        most);
}

static int64_t steps_for(const struct point *p, double order, double error)
{
    return pilot_steps((double)p->steps * plain_power(p->error / error, 1.0 / order));
}

/** Steps between two points, one on each side of the error aimed at. */
static int64_t steps_between(const struct point *above, const struct point *below, double error)
{
    /* by the error where that falls evenly, else by halves: it may jump */
    double share = plain_log2(above->error / error) / plain_log2(above->error / below->error);
    share = share > 0.1 && share < 0.9 ? share : 0.5;
    const double steps = (double)above->steps * plain_power((double)below->steps / (double)above->steps, share);
    return pilot_steps(
        fmin(fmax(steps, (double)above->steps + 1.0), (double)(below->steps - pilot_unit(below->steps))));
}

static void offer_set(const struct search *s, struct offer *o, int64_t steps, double error, const struct price *price)
{
    o->steps = steps;
    o->force_evals = llrint(price->evals * (double)steps);
    o->h = s->t_end / (double)steps;
    o->error = error;
    o->seconds = price->seconds * (double)steps;
}

/** How far off an error may be because the solution is: twice what halvings let expect, since that may be more. */
static double unsure(const struct search *s)
{
    return s->solved && s->measure != COST_ENERGY ? 2.0 * s->advice->known : 0.0;
}

/** The run was made: its error is as sure as the solution is. One that is not known to as much tells that it is
 *  small. */
static void offer_measured(const struct search *s, struct offer *o, const struct pilot *pilot, double error,
                           const struct price *price)
{
    offer_set(s, o, pilot->steps, error, price);
    search_errors(s, pilot, o->errors);
    o->source = OFFER_MEASURED;
    const double sure = 1.2, off = unsure(s);
    o->doubt = fmax(sure, 1.0 + off / error);
    o->below = error > off ? fmax(sure, error / (error - off)) : INFINITY;
}

/** The next number of steps to try, or 0 if the search is over. above: the finest run that misses the error; below: the
 *  coarsest that meets it (steps = 0: none so far). */
static int64_t next_try(const struct search *s, const vti_stepper *stepper, const struct point *before,
                        const struct point *above, const struct point *below)
{
    if (below->steps > 0) {
        const int good = below->error >= lowest * s->target;
        return good || above->steps == 0 || below->steps - above->steps < 2 * pilot_unit(below->steps)
                   ? 0
                   : steps_between(above, below, aim * s->target);
    }
    if (!(above->error < SEARCH_TOO_FAR))
        return 2 * above->steps;
    const int64_t steps = steps_for(above, order_between(s, stepper, before, above), aim * s->target);
    return pilot_steps(fmin(fmax((double)steps, 1.2 * (double)above->steps + 1.0), 4.0 * (double)above->steps));
}

/** Whether a run of so many steps costs too much to be made. Runs that are too coarse to converge tell nothing about
 *  finer ones, so more is spent until one does. */
static int is_too_dear(const struct search *s, const vti_stepper *stepper, const struct price *price,
                       const struct point *finest, int64_t steps, double limit)
{
    const double cost = pilot_cost(stepper, (double)steps * price->evals);
    return cost > (finest->error < SEARCH_TOO_FAR ? limit : 4.0 * limit) && isfinite(s->limit);
}

/** Whether the purse ends it for certain, by work. */
static int is_beyond_purse(const struct search *s, const vti_stepper *stepper, int64_t steps)
{
    return (double)steps * pilot_evals(stepper) * (double)s->bodies >= s->purse.most - s->purse.work;
}

/** How many times more than run p, of this stepper, all its runs let expect of one in so many steps (offer.usual). One
 *  run of a few bodies, which meet a few touches, says little. */
static double usual_of(const struct search *s, const vti_stepper *stepper, const struct point *runs, int count,
                       const struct point *p)
{
    static const double scatter = 9.0;
    double most = p->error;
    int told = 0;
    for (int k = 0; k < count && s->kinked; ++k)
        if (runs[k].error < SEARCH_TOO_FAR) {
            most = fmax(most, runs[k].error * plain_power((double)runs[k].steps / (double)p->steps,
                                                          search_kinked_order(s, stepper)));
            ++told;
        }
    return p->error > 0.0 ? (told == 1 ? 1.0 + scatter / (double)s->bodies : 1.0) * most / p->error : 1.0;
}

/** Follows the order from the finest run to where it meets the error. The longer the way, the more an order that is off
 *  by a half matters; and runs that the purse has cut short may be too coarse to show a higher order that lasts. */
static void follow(const struct search *s, struct offer *o, const struct point *before, const struct point *finest,
                   double usual, const struct price *price, int cut)
{
    const double error = search_aim(s) * s->target, here = search_order(s, o->stepper);
    const double seen = search_lasting_order(s, o->stepper, order_between(s, o->stepper, before, finest));
    const struct point from = {finest->steps, usual * finest->error};
    const int64_t steps = steps_for(&from, fabs(seen - here) < 0.7 || (cut && seen > here) ? here : seen, error);
    offer_set(s, o, steps, error, price);
    for (int m = 0; m < COST_MEASURES; ++m)
        o->errors[m] = m == s->measure ? error : NAN;
    o->source = OFFER_FOLLOWED;
    search_doubt(s, o, seen, (double)steps / (double)finest->steps);
    o->below *= usual;
}

int search_stepper(struct search *s, struct offer *o, double limit)
{
    struct point before = {0, INFINITY}, above = {0, INFINITY}, below = {0, 0.0};
    struct price price = {0.0, 0.0};
    struct point runs[TRIES];
    int refinements = 0, count = 0, cut = 0;
    int64_t steps = search_fewest(s, o->stepper);
    for (int k = 0; k < TRIES && steps > 0; ++k) {
        struct pilot pilot;
        cut = below.steps == 0 && above.error < SEARCH_TOO_FAR;
        if (cut && is_beyond_purse(s, o->stepper, steps))
            break; /* what is left may do for another stepper */
        const int result = search_run(s, o->stepper, steps, &pilot);
        if (result != 0) {
            pilot_destroy(&pilot);
            if (result < 0 || (below.steps == 0 && !cut))
                return result;
            break; /* what is known is worth telling */
        }
        cut = 0;
        const struct point p = {steps, search_error(s, &pilot, s->measure)};
        price.seconds = pilot.seconds / (double)steps;
        price.evals = o->stepper->evals > 0 ? (double)o->stepper->evals : (double)pilot.force_evals / (double)steps;
        refinements += below.steps > 0;
        runs[count++] = p;
        if (p.error <= s->target) {
            below = p;
            offer_measured(s, o, &pilot, p.error, &price);
        } else {
            before = above;
            above = p;
        }
        pilot_destroy(&pilot);
        steps = refinements < REFINEMENTS ? next_try(s, o->stepper, &before, &above, &below) : 0;
        if (below.steps == 0 && is_too_dear(s, o->stepper, &price, &above, steps, limit))
            break;
    }
    o->order =
        below.steps > 0 ? order_between(s, o->stepper, &above, &below) : order_between(s, o->stepper, &before, &above);
    if (below.steps > 0) {
        o->missed = above.steps > 0 ? above.error : NAN;
        o->usual = usual_of(s, o->stepper, runs, count, &below);
    } else if (above.error < SEARCH_TOO_FAR)
        follow(s, o, &before, &above, usual_of(s, o->stepper, runs, count, &above), &price, cut);
    return cut ? ADVISE_SPENT : 0;
}
