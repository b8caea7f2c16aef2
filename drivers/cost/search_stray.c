/* SPDX-License-Identifier: BSD-3-Clause
 *
 * How what a step errs by grows: two runs that begin a nudge apart, over the whole time, as coarse as can be. */
#include "advise.h"

#include <math.h>
#include <string.h>

/* large beside rounding, and small: there is room for twelve orders of growth */
static const double nudge = 1e-12, lost = 0.1;

/** Longer steps, near what is stable, may make a motion stray that does not. */
static int64_t stray_steps(const struct search *s)
{
    enum { FINER = 4 };
    const vti_stepper *exact = vti_stepper_find("exact");
    struct search whole = *s;
    whole.t_end = s->advice->t_end;
    return pilot_steps(FINER * (double)search_fewest(&whole, exact));
}

double search_stray_work(const struct search *s)
{
    return 2.0 * (double)stray_steps(s) * (double)s->bodies;
}

int search_stray(struct search *s)
{
    const vti_stepper *exact = vti_stepper_find("exact");
    struct pilot pair[2];
    const int64_t steps = stray_steps(s);
    const struct trial trial = {exact, s->advice->t_end / (double)steps, steps, s->advice->t_end};
    memset(pair, 0, sizeof pair);
    int result = 0;
    for (int k = 0; k < 2 && result == 0; ++k) {
        const struct pilot_way way = {.nudge = k * nudge, .blind = 1};
        result = pilot_run(s->scene, &trial, &s->purse, way, &pair[k], s->message);
        s->advice->evals += (double)pair[k].force_evals;
    }
    for (int mark = 0; mark < PILOT_MARKS && result == 0; ++mark) {
        const double apart = pilot_error(&pair[1], &pair[0], s->trajectory, mark) / nudge;
        s->strayed[mark] = isfinite(apart) ? fmax(apart, mark > 0 ? s->strayed[mark - 1] : 0.0) : 0.0;
    }
    pilot_destroy(&pair[0]);
    pilot_destroy(&pair[1]);
    return result;
}

double search_growth(const struct search *s, double t)
{
    const double mark = t / s->advice->t_end * PILOT_MARKS, most = s->strayed[PILOT_MARKS - 1];
    const double at = s->strayed[(int)fmin(fmax(mark - 1.0, 0.0), PILOT_MARKS - 1.0)];
    return at > 0.0 ? most / (at * fmin(mark, 1.0)) : 1.0; /* before the first mark in proportion to time */
}

int search_knows_growth(const struct search *s)
{
    return s->strayed[PILOT_MARKS - 1] > 0.0;
}

int search_strays(struct search *s, double goal)
{
    static const double rounding = 1e-14; /* of some steps */
    const double reached = fmin(lost / nudge, goal / rounding);
    int mark = 0;
    while (mark < PILOT_MARKS && s->strayed[mark] < reached)
        ++mark;
    if (mark == PILOT_MARKS)
        return 0;
    s->advice->together = s->advice->t_end * mark / PILOT_MARKS;
    s->advice->unsure = 0;
    return 1;
}
