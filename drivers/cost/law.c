/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Where forces have kinks the first part of the time tells nothing of the rest, and whole runs are dear. Two of one
 * stepper are the least: in n and in 2 n steps they differ by what the first errs, less a fourth, and from there on
 * errors fall with the square of h, since touches leave no more of any order (EQUATIONS 8.5). */
#include "advise.h"

#include <math.h>
#include <string.h>

#include "plain.h"

/* as in search.c: h is aimed at this share of the error, and angles above the other say nothing */
static const double aim = 0.7, too_far = 0.3;

static double order_of(const vti_stepper *stepper)
{
    return fmin((double)stepper->order, 2.0);
}

double law_evals(const struct search *s, const vti_stepper *stepper)
{
    return 3.0 * (double)search_fewest(s, stepper) * (double)(stepper->evals > 0 ? stepper->evals : 1);
}

/** The largest difference of the second half of the marks: at one of them it may pass through zero. */
static double apart(const struct pilot *coarse, const struct pilot *fine, int measure)
{
    double most = pilot_error(coarse, fine, measure, PILOT_MARKS - 1);
    for (int mark = PILOT_MARKS / 2; mark < PILOT_MARKS - 1; ++mark)
        most = fmax(most, pilot_error(coarse, fine, measure, mark));
    return most;
}

/** What the finer run errs by all measures; of the energy it shows itself. */
static void errors_of(const struct search *s, const struct pilot *coarse, const struct pilot *fine, double order,
                      double errors[COST_MEASURES])
{
    const vti_bodies *b = &fine->at[PILOT_MARKS - 1];
    for (int m = 0; m < COST_MEASURES; ++m) {
        const int has = (m != COST_ATTITUDE || b->alpha.c[0] != NULL) && (m != COST_POSITION || b->x.c[0] != NULL);
        errors[m] = has ? apart(coarse, fine, m) : NAN;
        if (m == COST_ENERGY)
            errors[m] = pilot_error(fine, NULL, m, PILOT_MARKS - 1);
        else if (!(apart(coarse, fine, s->trajectory) < too_far))
            errors[m] = NAN; /* they have parted */
        else
            errors[m] /= plain_exp2(order) - 1.0;
    }
}

/** The finer run as an offer. */
static void offer_run(const struct search *s, struct offer *o, const struct pilot *fine)
{
    o->steps = fine->steps;
    o->h = s->t_end / (double)fine->steps;
    o->force_evals = fine->force_evals;
    o->seconds = fine->seconds;
    o->order = order_of(o->stepper);
}

/** From that run, and its errors, to the steps that meet the error asked for. */
void search_law_follow(const struct search *s, struct offer *o)
{
    static const double least = 0.5; /* the coarser run was made too */
    const double finer = fmax(plain_power(o->errors[s->measure] / (aim * s->target), 1.0 / o->order), least);
    const int64_t steps = pilot_steps((double)o->steps * finer);
    const double more = (double)steps / (double)o->steps, less = plain_power(more, -o->order);
    for (int m = 0; m < COST_MEASURES; ++m)
        o->errors[m] *= less;
    o->steps = steps;
    o->h = s->t_end / (double)steps;
    o->error = o->errors[s->measure];
    o->force_evals = llrint((double)o->force_evals * more);
    o->seconds *= more;
    o->more = more;
    o->source = OFFER_FOLLOWED;
    search_doubt(s, o, o->order, finer);
    if (s->measure == COST_ENERGY)
        o->doubt = fmin(o->doubt, 5.0 * sqrt(fmax(finer, 1.0)));
}

int search_law(struct search *s, struct offer *o, int64_t steps)
{
    struct pilot coarse, fine;
    const double order = order_of(o->stepper);
    memset(&fine, 0, sizeof fine);
    int result = search_run(s, o->stepper, steps, &coarse);
    if (result == 0)
        result = search_run(s, o->stepper, 2 * steps, &fine);
    if (result == 0 && !fine.failed) {
        errors_of(s, &coarse, &fine, order, o->errors);
        offer_run(s, o, &fine);
        s->advice->together = search_together(s, &coarse, &fine);
        s->advice->max_omega = fine.max_omega;
        if (s->measure != COST_ENERGY && !(o->errors[s->trajectory] < too_far))
            result = ADVISE_PARTED;
        else
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
