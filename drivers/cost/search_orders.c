/* SPDX-License-Identifier: BSD-3-Clause
 *
 * By what orders the errors of a stepper fall in a scene: its own where nothing dissipates and forces are smooth. */
#include "advise.h"

#include <math.h>

#include "plain.h"

static int is_multistep(const vti_stepper *stepper)
{
    return vti_multistep_find(stepper->name) != NULL;
}

/** Whether places and attitudes are those of a reversible step to less than what is asked for: a kick and a drift are
 *  Verlet's step but for half a kick at the start. */
static int begins_unkicked(const struct search *s, const vti_stepper *stepper)
{
    static const double share = 0.01;
    const int kick_and_drift = stepper->kick != NULL && stepper->stages == 1 && stepper->reversible == 0;
    const double half = 0.5 * fmin(s->stable_h, s->t_end);
    return kick_and_drift && (s->measure == COST_ATTITUDE || s->measure == COST_POSITION) &&
           half * s->pushed * s->t_end <= share * s->target;
}

double search_order(const struct search *s, const vti_stepper *stepper)
{
    const double own = (double)stepper->order;
    if (s->dissipates)
        return stepper->lag > 0.0 ? 1.0 : fmin(own, 2.0);
    return begins_unkicked(s, stepper) ? 2.0 : own;
}

int search_falls_alike(const struct search *s, const vti_stepper *stepper, int measure)
{
    return measure == COST_ATTITUDE || measure == COST_POSITION || !begins_unkicked(s, stepper);
}

double search_most_order(const struct search *s, const vti_stepper *stepper)
{
    return fmax((double)stepper->order, search_order(s, stepper));
}

double search_kinked_order(const struct search *s, const vti_stepper *stepper)
{
    return fmin(search_order(s, stepper), is_multistep(stepper) ? 3.0 : 2.0);
}

/** By what order errors have been seen to fall where forces have kinks, of steppers of a higher one. */
static double usual_among_kinks(const vti_stepper *stepper)
{
    return is_multistep(stepper) ? 4.5 : 2.5;
}

double search_usual_order(const struct search *s, const vti_stepper *stepper)
{
    return fmin(search_order(s, stepper), usual_among_kinks(stepper));
}

double search_lasting_order(const struct search *s, const vti_stepper *stepper, double shown)
{
    return s->kinked || s->dissipates ? fmin(shown, search_kinked_order(s, stepper)) : shown;
}

void search_doubt(const struct search *s, struct offer *o, double order, double finer)
{
    const double more = 1.0, root = 0.5, longer = fmax(finer, 1.0), own = search_most_order(s, o->stepper),
                 most = s->kinked ? fmin(own, usual_among_kinks(o->stepper) + more) : own;
    o->doubt = s->doubt * sqrt(longer);
    if (s->breaks) /* a bond that breaks at another step changes what comes after */
        o->doubt = INFINITY;
    o->below = (s->kinked || s->dissipates) && isfinite(o->doubt)
                   ? s->doubt * plain_power(longer, fmax(most - order, root))
                   : o->doubt;
}
