/* SPDX-License-Identifier: BSD-3-Clause
 *
 * How the advice is found. A stepper of the highest order that the scene may have is refined until its runs agree to a
 * fraction of the error asked for: that is the solution. Then every stepper searches its own way to that error
 * (search.c), and the fastest wins.
 *
 * Over the whole time that takes some hundred times the run that is advised on. So it is done in stages, each with more
 * of the time than the one before and fewer steppers, as far as the purse goes: what the first part of the time has
 * shown is carried over, errors growing with the time. Where forces have kinks the first part may be without any, and
 * only the whole time tells; then stages are of errors that are ever harder to reach. */
#include "stages.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "number.h"

double advise_share(const struct scene *scene)
{
    return scene_first_with(scene, EFFECT_KINKED) != NULL ? 1.0 : 0.3;
}

int advise_measure(const char *name)
{
    for (int m = 0; m < COST_MEASURES; ++m)
        if (strcmp(name, cost_measures[m]) == 0)
            return m;
    return -1;
}

/* ---- what there is to advise on ---------------------------------------------------------------------------------- */

static int64_t rank_of(const vti_stepper *stepper)
{
    return 2 * stepper->order + (strcmp(method_kind(stepper), "paper") != 0);
}

/** The highest orders first: they set the limit for the others; of an order those of the paper last, since of offers
 *  that are alike the first is taken. Rivals come last, and set none. Of ours those that the model may be run by, where
 *  none is named. */
static int list_offers(struct stages *g, const struct model *model, struct message *message)
{
    enum { HIGHEST = 16 };
    struct advice *a = g->search.advice;
    const struct advise_request *r = g->request;
    const int64_t known = r->count > 0 ? r->count : method_count();
    for (int rival = 0; rival <= 1; ++rival)
        for (int64_t rank = 2 * HIGHEST + 1; rank > 1; --rank)
            for (int64_t k = 0; k < known && a->count < ADVICE_MOST; ++k) {
                const vti_stepper *stepper = r->count > 0 ? r->steppers[k] : method_at(k);
                struct message refused;
                if (rank_of(stepper) != rank || (method_rival(stepper) != NULL) != rival || (r->count == 0 && rival))
                    continue;
                if (travel_check(stepper, model, r->count > 0 ? message : &refused) == 0)
                    a->offers[a->count++] = offers_none(stepper);
                else if (r->count > 0)
                    return -1;
            }
    if (method_rival(a->offers[0].stepper) != NULL)
        return message_set(message,
                           "--steppers: only rivals, which are never advised; name one of ours too, such as %s",
                           a->checked->name);
    return 0;
}

static int choose_measure(struct stages *g, const struct model *model, struct message *message)
{
    struct search *s = &g->search;
    s->trajectory = cost_main_measure(model);
    s->measure = g->request->measure >= 0 ? g->request->measure : s->trajectory;
    if ((s->measure == COST_ATTITUDE && !model->turns) || (s->measure == COST_POSITION && !model->translates))
        return message_set(message, "--measure: %s has no %s; take %s", s->scene->name, cost_measures[s->measure],
                           cost_measures[s->trajectory]);
    s->advice->measure = s->measure;
    return 0;
}

static void stop(const vti_view *view, int64_t n)
{
    for (int64_t k = 0; view->c[0] != NULL && k < 3 * n; ++k)
        view->c[k % 3][k / 3 * view->stride] = 0.0;
}

/** The largest |F|/m and |RM|/J at the start: what a kick for the time 1 gives the bodies of this model, which are
 *  stopped for that. */
static double pushed(struct model *model)
{
    const vti_bodies *b = &model->bodies;
    double most = 0.0;
    if (model_forces(model, b) != VTI_OK)
        return INFINITY;
    stop(&b->v, b->count);
    stop(&b->omega, b->count);
    if (vti_kick(1.0, b) != VTI_OK)
        return INFINITY;
    for (int64_t i = 0; b->v.c[0] != NULL && i < b->count; ++i) {
        const int64_t at = i * b->v.stride;
        const double v[3] = {b->v.c[0][at], b->v.c[1][at], b->v.c[2][at]};
        most = fmax(most, vti_norm(v));
    }
    return fmax(most, vti_max_turn(1.0, b));
}

/** The scene's own numbers. */
static int look_at(struct stages *g)
{
    struct search *s = &g->search;
    struct model model;
    vti_stable begin;
    if (model_create(s->scene, &model, s->message) != 0)
        return -1;
    s->purse.start = clock_now() - g->from;
    if (g->request->begin != NULL)
        g->request->begin(&model);
    s->dissipates = model_dissipates(&model) != NULL;
    s->advice->checked = vti_stepper_find(s->dissipates ? "chin4" : "srkn11");
    s->advice->nominal = search_order(s, s->advice->checked);
    s->bodies = model.bodies.count;
    s->omega0 = vti_max_turn(1.0, &model.bodies);
    s->kinked = scene_first_with(s->scene, EFFECT_KINKED) != NULL;
    s->breaks = model_breaks(&model);
    s->doubt = s->breaks ? 30.0 : s->kinked ? 10.0 : 3.0;
    int failed = model_find_limits(&model, &s->advice->limits, s->message);
    s->advice->energy = model_energy(&model, &model.bodies);
    vti_deformation at = s->advice->limits.at;
    begin = s->advice->limits.within;
    if (failed == 0 && at.strain > 0.0) {
        at.strain = 0.0;
        failed = model_stable_step(&model, &model.bodies, &at, &begin, s->message);
    }
    s->stable_h = failed == 0 ? begin.h : NAN;
    if (failed == 0)
        failed = choose_measure(g, &model, s->message);
    if (failed == 0)
        failed = list_offers(g, &model, s->message);
    s->pushed = failed == 0 ? pushed(&model) : NAN;
    model_destroy(&model);
    return failed;
}

/* ---- all of it --------------------------------------------------------------------------------------------------- */

/** Whether a run by half of the stable step has no more steps than can be counted. */
static int can_count(const struct advice *a, const struct search *s, const vti_stepper *stepper)
{
    return a->t_end <= 0.5 * LOOP_STEPS * search_longest(s, stepper);
}

/** Refuses an end that no stable steps reach, before any pilot. */
static int refuse_uncountable(const struct stages *g)
{
    const struct search *s = &g->search;
    const struct advice *a = s->advice;
    double longest = 0.0;
    for (int64_t k = 0; k < a->count; ++k) {
        const vti_stepper *stepper = a->offers[k].stepper;
        if (method_rival(stepper) == NULL && can_count(a, s, stepper))
            return 0;
        longest = method_rival(stepper) == NULL ? fmax(longest, search_longest(s, stepper)) : longest;
    }
    return message_set(
        s->message,
        "%s: t_end: '%s' is more than 2^53 steps of h = %.3g, the longest that is safely stable; take an earlier one",
        s->scene->name, NUMBER(a->t_end), 0.5 * longest);
}

/** Where no pilot came to its end: by half of the stable step something comes out, and nothing is known of its error.
 *  Returns the one to take: of order 2, of one evaluation, if there is one. Of steppers whose steps could not be
 *  counted nothing is offered; refuse_uncountable has seen to it that there are others. */
static int64_t by_stability(struct stages *g)
{
    struct search at_end = g->search;
    struct advice *a = g->search.advice;
    int64_t best = -1;
    int found = 0;
    at_end.t_end = a->t_end;
    for (int64_t k = 0; k < a->count; ++k) {
        struct offer *o = &a->offers[k];
        if (!can_count(a, &at_end, o->stepper)) {
            *o = offers_none(o->stepper);
            continue;
        }
        o->steps = 2 * search_fewest(&at_end, o->stepper);
        o->h = a->t_end / (double)o->steps;
        o->force_evals = o->steps * (vti_multistep_find(o->stepper->name) != NULL ? 1 : o->stepper->evals);
        o->error = NAN;
        o->source = OFFER_STABILITY;
        for (int m = 0; m < COST_MEASURES; ++m)
            o->errors[m] = NAN;
        const int verlet = o->stepper->order == 2 && search_order(&at_end, o->stepper) > 1.0;
        if (method_rival(o->stepper) == NULL && (best < 0 || (verlet && !found)))
            best = k;
        found = found || (verlet && best == k);
    }
    return best;
}

static int by_seconds(const void *a, const void *b)
{
    const double p = ((const struct offer *)a)->seconds, q = ((const struct offer *)b)->seconds;
    return (p > q) - (p < q);
}

/** The advice first, then ours, then rivals, by rising seconds. */
static void sort_offers(struct stages *g)
{
    struct advice *a = g->search.advice;
    int64_t best = offers_fastest(g);
    if (best < 0)
        best = by_stability(g);
    const struct offer first = a->offers[best];
    int64_t ours = 0;
    for (int64_t k = 0; k < a->count; ++k) {
        const struct offer o = a->offers[k];
        if (method_rival(o.stepper) == NULL && o.stepper != first.stepper) {
            a->offers[k] = a->offers[ours];
            a->offers[ours++] = o;
        }
    }
    for (int64_t k = ours; k < a->count; ++k)
        if (a->offers[k].stepper == first.stepper) {
            memmove(&a->offers[1], &a->offers[0], (size_t)k * sizeof first);
            a->offers[0] = first;
            break;
        }
    qsort(a->offers + 1, (size_t)ours, sizeof first, by_seconds);
    qsort(a->offers + 1 + ours, (size_t)(a->count - 1 - ours), sizeof first, by_seconds);
}

int advise(const struct advise_request *request, struct advice *advice, struct message *message)
{
    struct stages g;
    memset(advice, 0, sizeof *advice);
    memset(&g, 0, sizeof g);
    g.from = g.pace_from = clock_now();
    advice->target = g.goal = request->target;
    advice->budget = request->budget;
    advice->t_end = request->t_end;
    advice->known = advice->order = advice->max_omega = advice->together = NAN;
    g.request = request;
    g.search.scene = request->scene;
    g.search.advice = advice;
    g.search.say = request->say;
    g.search.message = message;
    g.search.purse.until = request->budget > 0.0 ? g.from + request->budget : INFINITY;
    int failed = look_at(&g);
    advice->start = clock_now() - g.from;
    if (failed == 0)
        failed = refuse_uncountable(&g);
    if (failed == 0) {
        struct search at_end = g.search;
        at_end.t_end = request->t_end;
        g.pace_from = clock_now();
        /* kinks ask for a sixth of the stable step or so */
        stages_open_purse(&g,
                          (g.search.kinked ? 6.0 : 1.0) * (double)search_fewest(&at_end, vti_stepper_find("exact")));
        stages_all_active(&g);
        failed = stages_go(&g);
    }
    if (failed == 0)
        sort_offers(&g);
    pilot_destroy(&g.search.solution);
    advice->work = g.search.purse.work;
    advice->seconds = clock_now() - g.from;
    return failed;
}
