/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Where forces have kinks the first part of the time tells nothing of the rest, and whole runs are dear. Two of one
 * stepper, in n and in 2 n steps, are the least. By what order errors fall from the one to the other they do not tell:
 * between the stepper's own, p, and the least that touches leave, k = 2; of multistep methods, which take off what they
 * miss of a touch, between one more and 3 (block, pile, torus and two bodies that meet: 2.8 to 7.9 from one halving to
 * the next for an7, 1.7 to 5.3 for chin4). The difference d is the error of the coarser run; that of the finer one is
 * put amid, d/((2^p - 1)(2^k - 1))^(1/2). To finer steps still errors are followed by k, the slower one. */
#include "advise.h"

#include <math.h>
#include <string.h>

#include "plain.h"

double search_law_evals(const struct search *s, const vti_stepper *stepper)
{
    return 3.0 * (double)search_fewest(s, stepper) * pilot_evals(stepper);
}

/** How many times less the finer run errs than the two differ, at the most and at the least. */
static double most_finer(const struct search *s, const vti_stepper *stepper)
{
    const double more = vti_multistep_find(stepper->name) != NULL ? 1.0 : 0.0;
    return plain_exp2(search_most_order(s, stepper) + more) - 1.0;
}

static double least_finer(const struct search *s, const vti_stepper *stepper)
{
    return plain_exp2(search_kinked_order(s, stepper)) - 1.0;
}

static double finer_by(const struct search *s, const vti_stepper *stepper)
{
    return sqrt(most_finer(s, stepper) * least_finer(s, stepper));
}

/** The difference at the end, which may pass through zero there, or what is usual at the second half of the marks, of
 *  which one may lie within a touch that only one of the runs has met yet. */
static double apart(const struct pilot *coarse, const struct pilot *fine, int measure)
{
    enum { FIRST = PILOT_MARKS / 2 };
    double at[PILOT_MARKS - FIRST];
    for (int mark = FIRST; mark < PILOT_MARKS; ++mark)
        at[mark - FIRST] = pilot_error(coarse, fine, measure, mark);
    const double end = at[PILOT_MARKS - FIRST - 1];
    return fmax(end, race_median(at, PILOT_MARKS - FIRST));
}

/** What the finer run errs by all measures; of the energy it shows itself, alone if it is the coarser one too. */
static void errors_of(const struct search *s, const struct pilot *coarse, const struct pilot *fine, double finer,
                      double errors[COST_MEASURES])
{
    const vti_bodies *b = &fine->at[PILOT_MARKS - 1];
    for (int m = 0; m < COST_MEASURES; ++m) {
        const int has = (m != COST_ATTITUDE || b->alpha.c[0] != NULL) && (m != COST_POSITION || b->x.c[0] != NULL);
        errors[m] = has ? apart(coarse, fine, m) : NAN;
        if (m == COST_ENERGY)
            errors[m] = pilot_error(fine, NULL, m, PILOT_MARKS - 1);
        else if (fine == coarse || !(apart(coarse, fine, s->trajectory) < SEARCH_TOO_FAR))
            errors[m] = NAN; /* they have parted */
        else
            errors[m] /= finer;
    }
}

/** That run as an offer. */
static void offer_run(const struct search *s, struct offer *o, const struct pilot *fine)
{
    o->steps = fine->steps;
    o->h = s->t_end / (double)fine->steps;
    o->force_evals = fine->force_evals;
    o->seconds = fine->seconds;
    o->order = search_kinked_order(s, o->stepper);
}

/** The energy of that run is known, and may be good enough. */
static int meets(const struct search *s, struct offer *o)
{
    static const double sure = 1.2;
    if (s->measure != COST_ENERGY || !(o->errors[COST_ENERGY] <= s->target))
        return 0;
    o->error = o->errors[COST_ENERGY];
    o->more = 1.0;
    o->source = OFFER_MEASURED;
    o->doubt = o->below = sure;
    return 1;
}

/** From that run, and its errors, to the steps that meet the error asked for. */
void search_law_follow(const struct search *s, struct offer *o)
{
    if (meets(s, o))
        return;
    static const double scatter = 3.0, coarser = 0.5;
    static const double faster = 4.0; /* two orders of a doubling: 5.5 of chin4 on the torus to t = 1, from 176 steps */
    const double above = o->errors[s->measure] / (search_aim(s) * s->target),
                 order = above > 1.0 ? o->order : plain_log2(1.0 + finer_by(s, o->stepper)),
                 fewest = (double)search_fewest(s, o->stepper) / (double)o->steps,
                 finer = fmax(plain_power(above, 1.0 / order), fmax(coarser, fewest));
    const int64_t steps = pilot_steps((double)o->steps * finer);
    const double more = (double)steps / (double)o->steps, less = plain_power(more, -order);
    for (int m = 0; m < COST_MEASURES; ++m)
        o->errors[m] = search_falls_alike(s, o->stepper, m) ? o->errors[m] * less : NAN;
    o->steps = steps;
    o->h = s->t_end / (double)steps;
    o->error = o->errors[s->measure];
    o->force_evals = llrint((double)o->force_evals * more);
    o->seconds *= more;
    o->more = more;
    o->source = OFFER_FOLLOWED;
    search_doubt(s, o, o->order, finer);
    if (s->measure == COST_ENERGY && vti_multistep_find(o->stepper->name) == NULL)
        o->doubt = fmin(o->doubt, 5.0 * sqrt(fmax(finer, 1.0)));
    if (s->measure != COST_ENERGY) { /* of which the finer run has shown its own */
        const double either = sqrt(most_finer(s, o->stepper) / least_finer(s, o->stepper)),
                     wider = fmax(1.0, scatter * either / s->doubt);
        o->doubt *= wider;
        o->below *= wider;
    }
    if (o->coarse)
        o->below *= faster;
}

/** What two runs tell, before it is followed. Returns 0, or ADVISE_PARTED. */
static int tell(struct search *s, struct offer *o, const struct pilot *coarse, const struct pilot *fine)
{
    const struct pilot *whole = fine->parted > 0 ? coarse : fine;
    errors_of(s, coarse, whole, finer_by(s, o->stepper), o->errors);
    offer_run(s, o, whole);
    o->coarse = coarse->steps < 2 * search_fewest(s, o->stepper);
    if (s->measure != COST_ENERGY)
        s->advice->together = search_together(s, coarse, fine);
    s->advice->max_omega = whole->max_omega;
    const int near = o->errors[s->trajectory] < SEARCH_TOO_FAR; /* 0 of NaN, where it was not flown on */
    return s->measure != COST_ENERGY && !near ? ADVISE_PARTED : 0;
}

/** The finer run becomes the coarser one, beside which one in twice as many steps is flown; where the finer one was not
 *  flown to its end, up to there. */
static int halve(struct search *s, const vti_stepper *stepper, struct pilot *coarse, struct pilot *fine)
{
    pilot_destroy(coarse);
    *coarse = *fine;
    memset(fine, 0, sizeof *fine);
    return search_run_beside(s, stepper, 2 * coarse->steps, coarse, fine);
}

/** The work of flying on by halve. */
static double halving(const struct search *s, const vti_stepper *stepper, const struct pilot *fine)
{
    const double part = fine->parted > 0 ? (double)fine->parted / PILOT_MARKS : 1.0;
    return part * 2.0 * (double)fine->steps * pilot_evals(stepper) * (double)s->bodies;
}

/** The work of the run that is advised on if trajectories do part: without a time finer runs take no more than is left
 *  of that. */
static double work_by_energy(const struct search *s, const struct offer *o)
{
    struct search by = *s;
    struct offer run = *o;
    by.measure = COST_ENERGY;
    by.target = s->advice->target;
    search_law_follow(&by, &run);
    return advise_share(s->scene) * (double)run.force_evals * (double)s->bodies * s->advice->t_end / s->t_end;
}

/** Where the finer run was ended early: two whole runs from there on. */
static int fly_whole(struct search *s, const vti_stepper *stepper, struct pilot *coarse, struct pilot *fine)
{
    const int64_t steps = coarse->steps;
    pilot_destroy(coarse);
    pilot_destroy(fine);
    memset(fine, 0, sizeof *fine);
    const int result = search_run(s, stepper, steps, coarse);
    return result != 0 ? result : search_run_beside(s, stepper, 2 * steps, coarse, fine);
}

/** Two runs have parted: too coarse, or as all do? Where they parted early it is told by the next one, up to there,
 *  before whole ones are flown. Runs that agree for half as long again as those before, or are half as far apart, or by
 *  less than what says nothing, may still come together. Leaves in the offer what the finest whole runs tell. Returns
 *  as search_law does. */
static int part_again(struct search *s, struct offer *o, double may, struct pilot *coarse, struct pilot *fine)
{
    static const double longer = 1.5, nearer = 0.5, two_runs = 3.0;
    struct advice *a = s->advice;
    const vti_stepper *stepper = o->stepper;
    const double until = isfinite(s->purse.until) ? may : fmin(may, fmax(PURSE_LEAST, work_by_energy(s, o)));
    int result = ADVISE_PARTED;
    a->unsure = 1;
    while (result == ADVISE_PARTED && a->unsure && s->purse.work + halving(s, stepper, fine) <= until) {
        const int early = fine->parted > 0, resolved = !search_unresolved(s, fine);
        const int mark = (early ? fine->parted : PILOT_MARKS) - 1;
        const double before = a->together, far = pilot_error(coarse, fine, s->trajectory, mark),
                     whole = (double)fine->steps * pilot_evals(stepper) * (double)s->bodies;
        result = halve(s, stepper, coarse, fine);
        if (result != 0 || fine->failed)
            break;
        if (!early)
            result = tell(s, o, coarse, fine);
        a->together = search_together(s, coarse, fine);
        const int known = fine->parted == 0 || fine->parted > mark; /* if not, they part earlier */
        const double near = known ? pilot_error(coarse, fine, s->trajectory, mark) : INFINITY;
        a->unsure = !resolved || a->together > longer * before || near < fmax(nearer * far, SEARCH_TOO_FAR);
        if (early && a->unsure && s->purse.work + two_runs * whole <= until) {
            result = fly_whole(s, stepper, coarse, fine);
            if (result != 0 || fine->failed)
                break;
            result = tell(s, o, coarse, fine);
        } else if (early)
            return ADVISE_PARTED;
    }
    return result < 0 ? -1 : result == 0 && !fine->failed ? 0 : ADVISE_PARTED; /* what is known is worth telling */
}

int search_law(struct search *s, struct offer *o, int64_t steps, double may)
{
    const double until = s->purse.work + may;
    struct pilot coarse, fine;
    memset(&fine, 0, sizeof fine);
    int result = search_run(s, o->stepper, steps, &coarse);
    if (result == 0)
        result = search_run_beside(s, o->stepper, 2 * steps, s->measure != COST_ENERGY ? &coarse : NULL, &fine);
    if (result == 0 && !fine.failed) {
        result = tell(s, o, &coarse, &fine);
        if (result == ADVISE_PARTED)
            result = part_again(s, o, until, &coarse, &fine);
        if (result == 0)
            search_law_follow(s, o);
    }
    pilot_destroy(&coarse);
    pilot_destroy(&fine);
    return result;
}

void search_law_energy(const struct search *s, struct offer *o, const struct pilot *run)
{
    if (run->memory == NULL || run->failed || run->spent)
        return;
    offer_run(s, o, run);
    o->errors[COST_ENERGY] = pilot_error(run, NULL, COST_ENERGY, PILOT_MARKS - 1);
    search_law_follow(s, o);
}
