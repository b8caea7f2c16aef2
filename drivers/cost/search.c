/* SPDX-License-Identifier: BSD-3-Clause
 *
 * From its largest stable step on a stepper is run with ever more steps, each number chosen by the order seen so
 * far, until it meets the error from below, or would cost several times what the best has needed; then its order
 * tells the rest. */
#include "advise.h"

#include <math.h>

#include "plain.h"

/* h is aimed at a share of the error asked for, and taken if the error lies between the lowest share and 1 */
static const double aim = 0.7, lowest = 0.35;

/* the solution is known to this share of the error asked for */
static const double known_share = 0.03;

/* above this an angle says nothing about how it falls */
static const double too_far = 0.3;

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

/* ---- errors ------------------------------------------------------------------------------------------------------ */

/** That of a run of this stage: at the end if that is the scene's. Else errors grow with the time on the whole and swing
 *  about that, through zero or to twice of it: the median of what the second half of the marks says of the end. */
static double error_of(const struct search *s, const struct pilot *pilot, int measure)
{
    enum { FIRST = PILOT_MARKS / 2 };
    const struct pilot *solution = s->solved ? &s->solution : NULL;
    double at[PILOT_MARKS - FIRST];
    if (measure == COST_ENERGY || s->t_end >= s->advice->t_end)
        return pilot_error(pilot, solution, measure, PILOT_MARKS - 1);
    for (int mark = FIRST; mark < PILOT_MARKS; ++mark)
        at[mark - FIRST] = pilot_error(pilot, solution, measure, mark) * PILOT_MARKS / (mark + 1);
    return race_median(at, PILOT_MARKS - FIRST);
}

static int scene_has(const struct pilot *pilot, int measure)
{
    const vti_bodies *b = &pilot->at[PILOT_MARKS - 1];
    return measure == COST_ATTITUDE ? b->alpha.c[0] != NULL : measure == COST_POSITION ? b->x.c[0] != NULL : 1;
}

/** By the measure that is asked for and by the others; not by those by which the solution is not known well enough: it is
 *  refined by one measure, and hardly at all where the energy is asked for. */
static void all_errors(const struct search *s, const struct pilot *pilot, double errors[COST_MEASURES])
{
    static const double enough =
        6.0; /* an error is right to a half of it, as a solution may be off by twice of known */
    for (int m = 0; m < COST_MEASURES; ++m) {
        const int can_tell = !pilot->failed && scene_has(pilot, m) && (s->solved || m == COST_ENERGY);
        const double error = can_tell ? error_of(s, pilot, m) : NAN;
        errors[m] = m == s->measure || m == COST_ENERGY || error >= enough * s->known[m] ? error : NAN;
    }
}

/* ---- the solution ------------------------------------------------------------------------------------------------ */

double search_together(const struct search *s, const struct pilot *a, const struct pilot *b)
{
    const int known = b->parted > 0 ? b->parted : PILOT_MARKS;
    int mark = 0;
    while (mark < known && !(pilot_error(a, b, s->trajectory, mark) >= 0.1))
        ++mark;
    return s->t_end * mark / PILOT_MARKS;
}

int search_unresolved(const struct search *s, const struct pilot *run)
{
    static const double resolved = 0.25; /* radians, of which a Cayley step misses 1/200 */
    return s->t_end / (double)run->steps * run->max_omega > resolved;
}

enum { FOUND = ADVISE_PARTED + 1 };

/** What the refinements so far have shown. */
struct refining {
    double last, apart; /* between the runs before, and between the last two */
    double usual;       /* ... and what all of them let expect of the last, where forces have kinks */
    int halvings, stalled;
};

/** Takes note of the last two runs. Returns FOUND if the finer one is the solution, 0 if not yet, ADVISE_PARTED if it
 *  never will be. */
static int weigh(struct search *s, struct refining *r, double target)
{
    enum { STALLED = 4, MOST = 12 };
    struct advice *a = s->advice;
    /* what is left after a halving of h is 1/(2^p - 1) of what that changed; no order is taken for granted, and where
     * forces have kinks a lucky halving tells of one that is not there */
    const double most = s->kinked ? search_kinked_order(s, a->checked) : 8.0;
    const double order =
        isfinite(r->last) && r->apart > 0.0 ? fmin(fmax(plain_log2(r->last / r->apart), 1.0), 8.0) : 1.0;
    a->order = isfinite(r->last) && r->apart > 1e-13 ? order : a->order;
    r->usual = s->kinked && isfinite(r->last) ? fmax(r->apart, r->usual * plain_exp2(-most)) : r->apart;
    a->known = r->usual / (plain_exp2(fmin(order, most)) - 1.0);
    if (r->halvings > 1 && a->known <= known_share * target)
        return FOUND;
    const int resolved = !search_unresolved(s, &s->solution);
    r->stalled = resolved && (r->apart > 0.5 * r->last || !(r->apart < too_far)) ? r->stalled + 1 : 0;
    r->last = r->apart < too_far ? r->apart : INFINITY;
    return r->stalled >= STALLED + 2 * !(r->apart < too_far) || r->halvings >= MOST + STALLED ? ADVISE_PARTED : 0;
}

/** How far off the solution, the finer of two runs, is by each measure: as far as by that which a->known is of, in
 *  proportion to what the two differ. */
static void know_all(struct search *s, const struct refining *r, const struct pilot *coarse, const struct pilot *fine)
{
    const double share = r->apart > 0.0 ? s->advice->known / r->apart : 1.0;
    for (int m = 0; m < COST_MEASURES; ++m)
        s->known[m] = scene_has(fine, m) ? share * pilot_error(coarse, fine, m, PILOT_MARKS - 1) : 0.0;
}

/** Doubles the steps until two runs agree. Leaves the last in s->solution. */
static int refine(struct search *s, int measure, double target, struct refining *r)
{
    const vti_stepper *checked = s->advice->checked;
    int64_t steps = search_fewest(s, checked);
    int result = search_run(s, checked, steps, &s->solution);
    for (r->halvings = 1; result == 0; ++r->halvings) {
        struct pilot finer;
        steps *= 2;
        result = search_run(s, checked, steps, &finer);
        if (result == 0) {
            r->apart = pilot_error(&s->solution, &finer, measure, PILOT_MARKS - 1);
            s->advice->together = search_together(s, &s->solution, &finer);
        }
        if (result == 0) {
            struct pilot coarse = s->solution;
            s->solution = finer;
            result = weigh(s, r, target);
            if (result == FOUND)
                know_all(s, r, &coarse, &finer);
            pilot_destroy(&coarse);
        } else
            pilot_destroy(&finer);
    }
    return result;
}

int search_solution(struct search *s, double share)
{
    const struct purse whole = s->purse;
    struct refining r = {INFINITY, INFINITY, 0.0, 0, 0};
    const int measure = s->measure == COST_ENERGY ? s->trajectory : s->measure;
    pilot_destroy(&s->solution);
    s->solved = 0;
    s->advice->order = s->advice->known = NAN;
    s->purse.most = whole.work + share * (whole.most - whole.work);
    if (isfinite(whole.until))
        s->purse.until = whole.until - (1.0 - share) * fmax(whole.until - purse_clock(), 0.0);
    const int result = refine(s, measure, s->target, &r);
    s->purse.most = whole.most;
    s->purse.until = whole.until;
    s->solved = result == FOUND;
    s->advice->unsure = r.stalled < 2;
    if (s->solved)
        s->advice->max_omega = s->solution.max_omega; /* other runs may be far off, and still end as numbers */
    else
        s->advice->known = NAN;
    /* runs that are told apart by more than any angle tells are not brought together by what is left */
    if (result == ADVISE_SPENT && r.halvings > 2 && !(r.apart < too_far) && s->t_end == s->advice->t_end)
        return ADVISE_PARTED;
    return s->solved ? 0 : result;
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
    if (coarse->steps == 0 || !(coarse->error < too_far))
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

/** The run was made: its error is as sure as the solution is. One that is not known to as much tells that it is small. */
static void offer_measured(const struct search *s, struct offer *o, const struct pilot *pilot, double error,
                           const struct price *price)
{
    offer_set(s, o, pilot->steps, error, price);
    all_errors(s, pilot, o->errors);
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
    if (!(above->error < too_far))
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
    return cost > (finest->error < too_far ? limit : 4.0 * limit) && isfinite(s->limit);
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
        if (runs[k].error < too_far) {
            most = fmax(most, runs[k].error * plain_power((double)runs[k].steps / (double)p->steps,
                                                          search_kinked_order(s, stepper)));
            ++told;
        }
    return p->error > 0.0 ? (told == 1 ? 1.0 + scatter / (double)s->bodies : 1.0) * most / p->error : 1.0;
}

/** Follows the order from the finest run to where it meets the error. The longer the way, the more an order that is off
 *  by a half matters. */
static void follow(const struct search *s, struct offer *o, const struct point *before, const struct point *finest,
                   double usual, const struct price *price)
{
    const double error = search_aim(s) * s->target, here = search_order(s, o->stepper);
    const double seen = search_lasting_order(s, o->stepper, order_between(s, o->stepper, before, finest));
    const struct point from = {finest->steps, usual * finest->error};
    const int64_t steps = steps_for(&from, fabs(seen - here) < 0.7 ? here : seen, error);
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
    int refinements = 0, count = 0;
    int64_t steps = search_fewest(s, o->stepper);
    for (int k = 0; k < TRIES && steps > 0; ++k) {
        struct pilot pilot;
        const int result = search_run(s, o->stepper, steps, &pilot);
        if (result != 0) {
            pilot_destroy(&pilot);
            if (result < 0 || below.steps == 0)
                return result;
            break; /* what is known is worth telling */
        }
        const struct point p = {steps, error_of(s, &pilot, s->measure)};
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
    } else if (above.error < too_far)
        follow(s, o, &before, &above, usual_of(s, o->stepper, runs, count, &above), &price);
    return 0;
}
