/* SPDX-License-Identifier: BSD-3-Clause
 * What is said of a run by what was found: good, doubtful or bad, in numbers and in words. */
#include <stdio.h>
#include <string.h>

#include "verdict_parts.h"

#define MEMBER(NAME, IS_INTEGER)                                                                                       \
    {                                                                                                                  \
#NAME, offsetof(struct judgement, NAME), IS_INTEGER                                                            \
    }
const struct verdict_number verdict_numbers[VERDICT_NUMBERS] = {MEMBER(verdict, 1),
                                                                MEMBER(energy_gain, 0),
                                                                MEMBER(energy_swing, 0),
                                                                MEMBER(energy_slope, 0),
                                                                MEMBER(energy_slope_error, 0),
                                                                MEMBER(energy_scale, 0),
                                                                MEMBER(travel, 0),
                                                                MEMBER(rotation, 0),
                                                                MEMBER(angle_error, 0),
                                                                MEMBER(stable_step, 0),
                                                                MEMBER(overlap, 0),
                                                                MEMBER(slowing, 0),
                                                                MEMBER(bonds_turned, 1)};

static const double some_travel = 0.1;  /* diameters per step: contacts are met that deep */
static const double near_travel = 0.01; /* the same of two, if dashpots or friction look no further ahead (contact.c) */
static const double much_slowing = 0.8; /* z of a drift: bodies settle by 5 % too fast */
static const double much_of_way = 0.05; /* of the ways of what is only slowed: z = 1.12 between half kicks */
static const double much_rounding = 1e-3; /* of the way of a step */
static const double most_travel = 1.0;    /* two bodies may pass through each other unseen */

const char *verdict_word(int64_t grade)
{
    return grade == VERDICT_GOOD ? "good" : grade == VERDICT_DOUBTFUL ? "doubtful" : "bad";
}

/** Diameters per step from which on contacts may be met late. */
static double much_travel(const struct verdict *v)
{
    const struct scene *scene = v->model->scene;
    if (scene->tolerance > 0.0) /* steps that have met one late are taken anew */
        return INFINITY;
    return scene_first_with(scene, EFFECT_NEAR) != NULL ? near_travel : some_travel;
}

/** A pair may be through within a step, and a wall be met at any depth; a tolerance finds both. */
static int passes(const struct verdict *v)
{
    return v->found.travel > most_travel && v->model->scene->tolerance == 0.0;
}

/** Of what nothing pushes, whose velocities are right; what is pushed as well settles too fast before that. */
static double way_error(const struct verdict *v)
{
    const struct findings *f = &v->found;
    return f->slowing_free > f->slowing ? stability_way_error(v->stepper, f->slowing_free) : 0.0;
}

static int64_t grade(const struct verdict *v, const struct judgement *j, int broken)
{
    const struct findings *f = &v->found;
    if (broken || f->broken != 0.0 || !(f->gain <= VERDICT_MOST_GAIN * verdict_scale(f)) || passes(v))
        return VERDICT_BAD;
    const int doubtful = f->loss > VERDICT_MOST_GAIN * verdict_scale(f) || f->travel > much_travel(v) ||
                         j->angle_error > turning_tolerance(v->stepper) || f->share > 1.0 || j->bonds_turned > 0 ||
                         way_error(v) > much_of_way || f->slowing > much_slowing || f->deepest > VERDICT_MUCH_OVERLAP ||
                         f->rounding > much_rounding;
    return doubtful ? VERDICT_DOUBTFUL : VERDICT_GOOD;
}

/** Where a tolerance chooses the steps, h is not theirs. */
static const char *remedy(const struct verdict *v)
{
    return v->model->scene->tolerance > 0.0 ? "reduce the tolerance" : "reduce h";
}

/** Appends to the line. */
#define SAY(...) snprintf(line->text + strlen(line->text), sizeof line->text - strlen(line->text), __VA_ARGS__)

/** Of S; of bodies at rest, whose S is 0, nothing. */
static double share_of_scale(const struct findings *f, double energy)
{
    return f->scale > 0.0 ? energy / f->scale : 0.0;
}

static void say_energy(const struct verdict *v, const struct judgement *j, int broken, struct message *line)
{
    const struct findings *f = &v->found;
    if (broken || f->broken != 0.0)
        SAY("broke off; ");
    if (f->gain > VERDICT_MOST_GAIN * verdict_scale(f)) {
        SAY("the energy grew from %.6g to %.6g, too much from t = %.6g on: %s", f->first, f->highest, f->gain_t,
            remedy(v));
        return;
    }
    if (f->loss > VERDICT_MOST_GAIN * verdict_scale(f))
        SAY("%.3g of the energy's scale was lost; ", f->loss / verdict_scale(f));
    else
        SAY("energy kept, gains %.2g of its scale (bad above %.2g); ", j->energy_gain, VERDICT_MOST_GAIN);
    SAY("swing %.2g", j->energy_swing);
    if (!isnan(j->energy_slope))
        SAY(", drift %.2g +- %.1g per unit of time", share_of_scale(f, j->energy_slope),
            share_of_scale(f, j->energy_slope_error));
    SAY(" (%s of the scale %.4g)", isnan(j->energy_slope) ? "share" : "shares", f->scale);
    if (isnan(j->energy_slope))
        SAY(", too few rows for a drift");
}

static void say_steps(const struct verdict *v, const struct judgement *j, struct message *line)
{
    const double degrees = 57.295779513082320877;
    const struct findings *f = &v->found;
    const int varies = f->varies != 0.0;
    if (v->diameter > 0.0)
        SAY("; %.2g diameters a step%s", j->travel,
            passes(v)                    ? ": what bodies meet they may pass through"
            : j->travel > much_travel(v) ? ": contacts are met late"
                                         : "");
    if (v->model->turns)
        SAY("; %.3g degrees a step", degrees * j->rotation);
    if (j->angle_error > turning_tolerance(v->stepper))
        SAY(", by %s off by %.2g of it", v->stepper->name, j->angle_error);
    if (isfinite(j->stable_step))
        SAY("; %s %.3g of the %sstable step%s %.4g (t = %.6g)", varies ? "steps are up to" : "h is", f->share,
            varies ? "" : "least ", varies ? ", the least" : "", j->stable_step, f->stable_t);
    if (f->deepest > VERDICT_MUCH_OVERLAP)
        SAY("; contacts are up to %.2g of their length deep: make them stiffer, or what meets may pass through",
            f->deepest);
    if (f->slowing > much_slowing)
        SAY("; h is %.3g times the time m/c in which a body is slowed: what is pushed settles too fast", f->slowing);
    if (way_error(v) > much_of_way)
        SAY("; h is %.3g times the time m/c in which drag slows a body: displacements and angles of what drag alone "
            "slows are off by up to %.2g of themselves; %s",
            f->slowing_free, way_error(v), remedy(v));
    if (f->rounding > much_rounding)
        SAY("; bodies are so far from the origin that rounding takes up to %.2g of their displacement in a step: move "
            "it nearer",
            f->rounding);
    if (j->bonds_turned > 0)
        SAY("; %lld bond%s turned past half a turn", (long long)j->bonds_turned, j->bonds_turned > 1 ? "s" : "");
}

struct judgement verdict_judge(const struct verdict *v, int broken, struct message *line)
{
    const struct findings *f = &v->found;
    struct judgement j = {0};
    j.energy_gain = f->gain > 0.0 ? f->gain / verdict_scale(f) : 0.0;
    j.energy_scale = f->scale;
    j.energy_swing = share_of_scale(f, f->highest - f->lowest);
    trend_slope(&f->trend, &j.energy_slope, &j.energy_slope_error);
    j.travel = v->diameter > 0.0 ? f->travel : NAN;
    j.rotation = f->rotation;
    j.angle_error = turning_error(v->stepper, f->rotation);
    j.stable_step = f->stable;
    j.overlap = f->deepest;
    j.slowing = fmax(f->slowing, f->slowing_free);
    int64_t k = 0;
    for (struct effect *e; (e = verdict_next_watch(v->model, &k)) != NULL;)
        j.bonds_turned += e->kind->watch->turned(e);
    j.verdict = grade(v, &j, broken);
    message_set(line, "verdict: %s: ", verdict_word(j.verdict));
    say_energy(v, &j, broken, line);
    say_steps(v, &j, line);
    return j;
}

int verdict_warnings(const struct verdict *v, const vti_bodies *bodies, struct message lines[VERDICT_WARNINGS])
{
    int n = 0;
    double fastest = 0.0;
    if (v->model->scene->tolerance > 0.0) /* h is not that of the steps */
        return 0;
    const double idle = stability_idle(v->model, bodies);
    const double rounding = v->model->translates ? places_rounding(v, bodies, idle, &fastest) : 0.0;
    if (rounding > much_rounding)
        message_set(&lines[n++],
                    "bodies are so far from the origin that rounding takes up to %.2g of their displacement in a "
                    "step; move the origin nearer, or take a larger h",
                    rounding);
    const double far = v->diameter > 0.0 ? places_travel(v, bodies) : 0.0, turn = vti_max_turn(v->h, bodies);
    if (far > much_travel(v))
        message_set(&lines[n++],
                    "a body moves by %.3g diameters of the smallest per step: contacts are met late%s; reduce h to "
                    "%.3g",
                    far, far > most_travel ? " or not at all" : "", v->h * much_travel(v) / far);
    if (turning_error(v->stepper, turn) > turning_tolerance(v->stepper))
        message_set(&lines[n++],
                    "h|Omega| is up to %.4g, and %s turns by another angle there, off by %.2g of it; reduce h", turn,
                    v->stepper->name, turning_error(v->stepper, turn));
    return n;
}
