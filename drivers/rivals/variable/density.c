/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Steps that follow how fast bodies turn (EQUATIONS 8.4), of the reversible lists of kicks and drifts. With h the
 * scene's, which is that of bodies at rest, and w an angular velocity of the scene, the wish for a step of n bodies and
 * its rate along the motion are
 *
 *     s = (1 + sum |Omega|^2/(n w^2))^(-1/2),   G = -(1/s) ds/dt = s^2 sum Omega.(RM/J)/(n w^2)
 *
 * By the integrating controller the density of steps is integrated along (vti_control.h), which leaves no drift; the
 * naive one, to compare with, takes h s of the state as it is. */
#include <math.h>
#include <stdio.h>

#include "cut.h"
#include "rivals.h"
#include "scene.h"
#include "travel.h"

/** Numbers of a course: where it is, the density of steps and the step to be made next, what programs are told, and
 *  whether the bodies are those of a step that was cut. Its own is their copy at the end of the last that was not. */
enum { TIME, DENSITY, STEP, LONGEST, MADE, CUTS, IS_CUT };

/** s and G of the bodies as they stand, and of their moments. */
static void wish_of(const struct course *c, double *wish, double *rate)
{
    const double w = scene_unit(c->model->scene->turning);
    double square = 0.0, growth = 0.0;
    for (int64_t i = 0; i < c->n; ++i) {
        const double *const omega = c->w + 3 * i;
        square += vti_dot(omega, omega);
        if (c->m != NULL)
            growth += vti_dot(omega, c->m + 3 * i) * c->per_inertia.p[i * c->per_inertia.stride];
    }
    const double unit = (double)c->n * w * w, inverse = 1.0 + square / unit;
    *wish = 1.0 / sqrt(inverse);
    *rate = growth / unit / inverse;
}

static int is_naive(const struct course *c)
{
    return c->model->scene->control == SCENE_NAIVE;
}

/** The step to be made next, at the start and after each. */
static int choose_step(struct course *c, int first)
{
    vti_density density = {c->h, c->number[DENSITY], 0.0};
    double wish, rate;
    wish_of(c, &wish, &rate);
    const int status = is_naive(c) || first ? vti_density_start(c->h, wish, is_naive(c) ? 0.0 : rate, &density)
                                            : vti_density_next(&density, rate);
    c->number[DENSITY] = density.rho;
    c->number[STEP] = density.h;
    if (wish < CUT_SHORTEST)
        return RIVAL_E_FINE;
    return status == VTI_E_TIME ? RIVAL_E_SPARSE : status;
}

/** All steps that end before so many of h. */
static int free_steps(struct course *c, int64_t *steps)
{
    int status = c->number[STEP] > 0.0 ? VTI_OK : choose_step(c, 1);
    while (status == VTI_OK && c->number[TIME] + c->number[STEP] < cut_end(c, c->number[TIME], steps)) {
        const double h = c->number[STEP];
        if (!(c->number[TIME] + h > c->number[TIME]))
            return RIVAL_E_LATE;
        status = course_step(c, c->rival->table, h);
        if (status == VTI_OK)
            status = choose_step(c, 0);
        c->number[TIME] += h;
        c->number[MADE] += 1.0;
        c->number[LONGEST] = fmax(c->number[LONGEST], h);
    }
    return status;
}

static int go_varied(struct course *c, int64_t steps)
{
    const vti_kept kept = cut_kept(c, 0);
    if (c->number[IS_CUT] != NOT_CUT) {
        vti_step_undo(&c->bodies, &kept);
        c->evals -= ((const vti_stepper *)c->rival->table)->evals;
    }
    c->number[LONGEST] = c->number[IS_CUT] == CUT_AT_END ? c->number[LONGEST] : 0.0;
    int status = free_steps(c, &steps);
    if (status == VTI_OK)
        status = vti_step_keep(&c->bodies, &kept);
    if (status == VTI_OK)
        status = course_step(c, c->rival->table, (double)(c->steps + steps) * c->h - c->number[TIME]);
    c->number[IS_CUT] = c->ends ? CUT_AT_END : CUT_TO_LOOK;
    c->cut_at_end = c->ends;
    c->number[CUTS] += !c->ends;
    c->steps += status == VTI_OK ? steps : 0;
    return status;
}

static void tally_varied(const struct course *c, struct travel_tally *tally)
{
    const double *number = c->number;
    tally->accepted = (int64_t)number[MADE];
    tally->rejected = 0;
    tally->cut = (int64_t)number[CUTS] + c->cut_at_end;
    tally->evals = 1 + (tally->accepted + tally->cut) * ((const vti_stepper *)c->rival->table)->evals;
    tally->longest = cut_longest(c, number[LONGEST], number[STEP]);
    tally->tolerance = 0.0;
}

/** Bodies turn, and smoothly: the density of steps that a touch would ask for is another one. */
static int prepare_varied(struct course *c, struct message *message)
{
    const struct scene *scene = c->model->scene;
    const char *const kinked = scene_first_with(scene, EFFECT_KINKED), *const how = scene_control_word(scene);
    if (kinked != NULL)
        return message_set(message,
                           "%s: control: %s: the forces of %s have kinks, and steps that follow how fast bodies turn "
                           "do not see them come; leave control out, or take srkn11 with a tolerance",
                           scene->name, how, kinked);
    if (c->w == NULL)
        return message_set(message, "%s: control: %s: steps follow how fast bodies turn, and none does; leave it out",
                           scene->name, how);
    return 0;
}

/* ---- which there are --------------------------------------------------------------------------------------------- */

enum { MOST = 32, NAME = 40 };

static int is_fit(const vti_stepper *s)
{
    return s->frame == VTI_FRAME_SPACE && s->reversible && s->lag == 0.0 && s->probe == NULL;
}

static struct rival varied[2][MOST];
static char names[2][MOST][NAME];

static void make(const vti_stepper *s, int naive, int64_t i)
{
    snprintf(names[naive][i], NAME, "%s-%s", s->name, naive ? "naive" : "integrating");
    const struct rival engine = {
        .stepper = RIVAL_STEPPER(names[naive][i], s->order, 0.0, 0, s->reach,
                                 naive ? "steps as the bodies turn, as they stand: drifts, to compare with"
                                       : "steps as the bodies turn, by the integrating controller"),
        .table = s,
        .own_width = KEEPS,
        .prepare = prepare_varied,
        .go = go_varied,
        .tally = tally_varied,
        .takes_forces = 1,
    };
    varied[naive][i] = engine;
}

const struct rival *density_at(int64_t i, int naive)
{
    int64_t fit = 0;
    for (int64_t k = 0; k < vti_stepper_count() && k < MOST; ++k) {
        if (!is_fit(vti_stepper_at(k)) || fit++ < i)
            continue;
        if (varied[naive][i].go == NULL)
            make(vti_stepper_at(k), naive, i);
        return &varied[naive][i];
    }
    return NULL;
}
