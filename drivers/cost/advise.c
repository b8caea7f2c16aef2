/* SPDX-License-Identifier: BSD-3-Clause
 *
 * How the advice is found. A stepper of order 6 is refined until its runs agree to a fraction of the error asked
 * for: that is the solution. Then every stepper searches its own way to that error (search.c), and the fastest wins. */
#include "advise.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plain.h"

/* the solution is known to this share of the error asked for */
static const double known_share = 0.03;

/* ---- the solution ------------------------------------------------------------------------------------------------ */

static int unknowable(const struct search *s, const struct pilot *finest, double apart)
{
    return message_set(
        s->message,
        "%s: runs of %s in %lld and in half as many steps still end %.1e apart at t = %g, so no error of "
        "%g can be told there; ask for a larger --error or a shorter --t-end",
        s->scene->name, s->advice->checked->name, (long long)finest->steps, apart, s->advice->t_end, s->advice->target);
}

static int too_long(const struct search *s, double seconds)
{
    return message_set(
        s->message,
        "%s: to tell an error of %g at t = %g from runs of %s would take about %.0f more seconds; ask for a "
        "larger --error or a shorter --t-end, or allow --budget %.0f",
        s->scene->name, s->advice->target, s->advice->t_end, s->advice->checked->name, seconds, 2.0 * seconds);
}

/** What refining until the solution is known will take, from how long the finest run took: its steps are doubled as
 *  often as the order tells. */
static double seconds_to_go(const struct search *s, double order)
{
    const double doublings = ceil(plain_log2(s->advice->known / (known_share * s->advice->target)) / fmax(order, 2.0));
    return s->solution.seconds * 2.0 * (plain_exp2(doublings) - 1.0);
}

/** Doubles the steps until two runs agree. Leaves the last in s->solution. */
static int find_solution(struct search *s)
{
    enum { STALLED = 4 };
    struct advice *a = s->advice;
    int64_t steps = search_fewest(s, a->checked);
    double last = INFINITY;
    a->order = NAN;
    if (search_run(s, a->checked, steps, &s->solution) != 0)
        return -1;
    for (int halvings = 1, stalled = 0;; ++halvings) {
        struct pilot finer;
        steps *= 2;
        if (search_run(s, a->checked, steps, &finer) != 0)
            return -1;
        const double apart = pilot_error(&s->solution, &finer);
        pilot_destroy(&s->solution);
        s->solution = finer;
        /* what is left after a halving of h is 1/(2^p - 1) of what that changed; no order is taken for granted */
        const double order = isfinite(last) && apart > 0.0 ? fmin(fmax(plain_log2(last / apart), 1.0), 8.0) : 1.0;
        if (isfinite(last) && apart > 1e-13)
            a->order = order;
        a->known = apart / (plain_exp2(order) - 1.0);
        if (halvings > 1 && a->known <= known_share * a->target) {
            a->max_omega = s->solution.max_omega; /* other runs may be far off, and still end as numbers */
            return 0;
        }
        stalled = apart > 0.5 * last ? stalled + 1 : 0;
        last = apart < 0.3 ? apart : INFINITY; /* angles that large say nothing yet */
        if (stalled == STALLED)
            return unknowable(s, &s->solution, apart);
        /* not before runs are long enough for their times, and fine enough for their order, to mean something */
        if (s->solution.seconds > 0.02 * s->budget && seconds_to_go(s, order) > s->budget)
            return too_long(s, seconds_to_go(s, order));
    }
}

/* ---- all of them ------------------------------------------------------------------------------------------------- */

static int by_seconds(const void *a, const void *b)
{
    const struct offer *p = a, *q = b;
    const int p_is_rival = method_rival(p->stepper) != NULL, q_is_rival = method_rival(q->stepper) != NULL;
    return p_is_rival != q_is_rival ? p_is_rival - q_is_rival : (p->seconds > q->seconds) - (p->seconds < q->seconds);
}

/** The least of several times of the same run, for runs that are over in a blink. */
static int time_again(struct search *s, struct offer *o)
{
    enum { MOST = 9 };
    const double enough = 0.2;
    double spent = o->seconds, least = o->seconds;
    for (int k = 0; k < MOST && spent < enough; ++k) {
        struct pilot pilot;
        if (search_run(s, o->stepper, o->steps, &pilot) != 0)
            return -1;
        least = fmin(least, pilot.seconds);
        spent += pilot.seconds;
        pilot_destroy(&pilot);
    }
    o->seconds = least;
    return 0;
}

static int make_offers(struct search *s)
{
    struct advice *a = s->advice;
    for (int64_t k = 0; k < a->count; ++k) {
        struct offer *o = &a->offers[k];
        if (search_stepper(s, o, s->limit) != 0)
            return -1;
        if (o->measured && time_again(s, o) != 0)
            return -1;
        if (o->measured && method_rival(o->stepper) == NULL)
            s->limit = fmin(s->limit, 2.0 * (double)o->force_evals);
    }
    qsort(a->offers, (size_t)a->count, sizeof a->offers[0], by_seconds);
    /* the advice itself is a run that was made */
    for (int k = 0; k < ADVICE_MOST && !a->offers[0].measured && isfinite(a->offers[0].seconds); ++k) {
        if (search_stepper(s, &a->offers[0], INFINITY) != 0 ||
            (a->offers[0].measured && time_again(s, &a->offers[0]) != 0))
            return -1;
        qsort(a->offers, (size_t)a->count, sizeof a->offers[0], by_seconds);
    }
    return a->offers[0].measured
               ? 0
               : message_set(s->message, "%s: no stepper was seen to reach an error of %g; ask for a larger --error",
                             s->scene->name, a->target);
}

/** The scene's own numbers. */
static int look_at(struct search *s)
{
    struct model model;
    if (model_create(s->scene, &model, s->message) != 0)
        return -1;
    vti_stable begin;
    int failed = model_find_limits(&model, &s->advice->limits, s->message);
    const vti_deformation at = {s->advice->limits.at.overlap, 0.0, 0};
    if (failed == 0)
        failed = model_stable_step(&model, &model.bodies, &at, &begin, s->message);
    s->stable_h = failed == 0 ? begin.h : NAN;
    if (failed == 0 && !model.turns && !model.translates)
        failed =
            message_set(s->message, "%s: nothing moves in this scene; there is no error to advise on", s->scene->name);
    s->omega0 = vti_max_turn(1.0, &model.bodies);
    model_destroy(&model);
    return failed;
}

/** The highest orders first: they set the limit for the others. Rivals come last, and set none. */
static void list_offers(struct advice *a, const vti_stepper *const *steppers, int64_t count)
{
    enum { HIGHEST = 16 };
    const int64_t known = count > 0 ? count : method_count();
    for (int rival = 0; rival <= 1; ++rival)
        for (int64_t order = HIGHEST; order > 0; --order)
            for (int64_t k = 0; k < known && a->count < ADVICE_MOST; ++k) {
                const vti_stepper *stepper = count > 0 ? steppers[k] : method_at(k);
                if (stepper->order == order && (method_rival(stepper) != NULL) == rival && (count > 0 || !rival))
                    a->offers[a->count++].stepper = stepper;
            }
}

int advise(const struct scene *scene, double target, double t_end, double budget, const vti_stepper *const *steppers,
           int64_t count, void (*say)(const char *stepper, int64_t steps), struct advice *advice,
           struct message *message)
{
    struct search s;
    memset(advice, 0, sizeof *advice);
    memset(&s, 0, sizeof s);
    advice->target = target;
    advice->t_end = t_end;
    advice->checked = vti_stepper_find("srkn11");
    s.scene = scene;
    s.advice = advice;
    s.limit = INFINITY;
    s.budget = budget;
    s.say = say;
    s.message = message;
    list_offers(advice, steppers, count);
    int failed = look_at(&s);
    if (failed == 0 && method_rival(advice->offers[0].stepper) != NULL)
        failed =
            message_set(message, "--steppers: only rivals, which are never advised; name one of ours too, such as %s",
                        advice->checked->name);
    if (failed == 0)
        failed = find_solution(&s);
    if (failed == 0)
        failed = make_offers(&s);
    pilot_destroy(&s.solution);
    return failed;
}
