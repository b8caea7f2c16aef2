/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What the errors of pilots are measured against: a solution, by steps halved until two runs agree to a share of the
 * error asked for. */
#include "advise.h"

#include <math.h>

#include "clock.h"
#include "plain.h"

/* the solution is known to this share of the error asked for */
static const double known_share = 0.03;

/* ---- errors ------------------------------------------------------------------------------------------------------ */

double search_error(const struct search *s, const struct pilot *pilot, int measure)
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

void search_errors(const struct search *s, const struct pilot *pilot, double errors[COST_MEASURES])
{
    /* an error is right to a half of it, as a solution may be off by twice of known */
    static const double enough = 6.0;
    for (int m = 0; m < COST_MEASURES; ++m) {
        const int can_tell = !pilot->failed && scene_has(pilot, m) && (s->solved || m == COST_ENERGY);
        const double error = can_tell ? search_error(s, pilot, m) : NAN;
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
    r->stalled = resolved && (r->apart > 0.5 * r->last || !(r->apart < SEARCH_TOO_FAR)) ? r->stalled + 1 : 0;
    r->last = r->apart < SEARCH_TOO_FAR ? r->apart : INFINITY;
    return r->stalled >= STALLED + 2 * !(r->apart < SEARCH_TOO_FAR) || r->halvings >= MOST + STALLED ? ADVISE_PARTED
                                                                                                     : 0;
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
        s->purse.until = whole.until - (1.0 - share) * fmax(whole.until - clock_now(), 0.0);
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
    if (result == ADVISE_SPENT && r.halvings > 2 && !(r.apart < SEARCH_TOO_FAR) && s->t_end == s->advice->t_end)
        return ADVISE_PARTED;
    return s->solved ? 0 : result;
}
