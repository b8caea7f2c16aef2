/* SPDX-License-Identifier: BSD-3-Clause */
#include "advise_text.h"

#include <math.h>

#include "number.h"
#include "stable.h"

/* ---- words ------------------------------------------------------------------------------------------------------- */

/** "3.4 s", "12 ms" */
static void say_seconds(double seconds, FILE *file)
{
    if (seconds >= 1.0)
        fprintf(file, "%7.3g s ", seconds);
    else if (seconds >= 1e-3)
        fprintf(file, "%7.3g ms", 1e3 * seconds);
    else
        fprintf(file, "%7.3g us", 1e6 * seconds);
}

/** "1.2e-05", or a dash where there is none. */
static void say_number(double value, FILE *file)
{
    if (isfinite(value))
        fprintf(file, " %9.1e", value);
    else
        fprintf(file, " %9s", "-");
}

static const char *const sources[] = {"", "(from the stable step alone)", "(from coarser runs)",
                                      "(from the first part)", ""};

static void say_offer(const struct offer *o, int width, FILE *file)
{
    if (o->steps == 0) {
        fprintf(file, "  %-*s       not determined within --budget\n", width, o->stepper->name);
        return;
    }
    fprintf(file, "  %-*s %10.4g %10lld ", width, o->stepper->name, o->h, (long long)o->steps);
    if (o->force_evals > 0)
        fprintf(file, "%12lld ", (long long)o->force_evals);
    else
        fprintf(file, "%12s ", "-"); /* of rivals that choose their steps, or evaluate as often as it takes */
    if (isfinite(o->seconds))
        say_seconds(o->seconds, file);
    else
        fprintf(file, "%10s", "-");
    for (int m = 0; m < COST_MEASURES; ++m)
        say_number(o->errors[m], file);
    if (o->source == OFFER_MEASURED || !isfinite(o->doubt))
        fprintf(file, " %9s", "");
    else
        fprintf(file, " %8.2gx", o->doubt);
    fprintf(file, " %s%s\n", sources[o->source], method_rival(o->stepper) != NULL ? "(a rival, to compare with)" : "");
}

/** Whether the run was made, and errs by so little that the solution does not tell how much. */
static int errs_by_less(const struct offer *o)
{
    return o->source == OFFER_MEASURED && !isfinite(o->below) && isfinite(o->doubt);
}

/** "3.4e-05", "at most 3.4e-05" */
static void say_error(const struct offer *o, FILE *file)
{
    if (errs_by_less(o))
        fprintf(file, "at most %.1e", o->error * o->doubt);
    else
        fprintf(file, "%.1e", o->error);
}

/** The advice in a sentence. */
static void say_best(const struct scene *scene, const struct advice *a, FILE *file)
{
    const struct offer *best = &a->offers[0];
    const char *what = cost_measures[a->measure];
    fprintf(file, "%s to t = %g: %s at h = %.6g", scene->name, a->t_end, best->stepper->name, best->h);
    if (best->source == OFFER_STABILITY) {
        fprintf(file, " is stable; nothing is known of its error: the budget is spent, allow more by --budget\n\n");
        return;
    }
    fprintf(file, " reaches an error of the %s of ", what);
    say_error(best, file);
    fprintf(file, "%s (asked for: %g) in", best->source == OFFER_MEASURED ? "" : " or so", a->target);
    say_seconds(best->seconds, file);
    if (best->source != OFFER_MEASURED && !isfinite(best->doubt))
        fprintf(file, ";\nit is told %s: nothing is known of how far off that is",
                best->source == OFFER_SHORTER ? "from the first part of the time, before what may happen later"
                                              : "from coarser runs, and what breaks may break at another step");
    else if (best->source != OFFER_MEASURED && !isfinite(best->below))
        fprintf(file, ";\nit is at most %.1e, told %s, which err by less than pilots can tell",
                best->error * best->doubt,
                best->source == OFFER_SHORTER ? "from runs over the first part of the time" : "from coarser runs");
    else if (best->source != OFFER_MEASURED)
        fprintf(file, ";\nit lies between %.1e and %.1e, told %s", best->error / best->below, best->error * best->doubt,
                best->source == OFFER_SHORTER ? "from the first part of the time" : "from coarser runs");
    fputs("\n\n", file);
}

void advise_text(const struct scene *scene, const struct advice *a, FILE *file)
{
    const struct offer *best = &a->offers[0];
    int width = 0;
    for (int64_t k = 0; k < a->count; ++k) {
        const int w = methods_width(&a->offers[k].stepper, 1);
        width = w > width ? w : width;
    }
    say_best(scene, a, file);
    fprintf(file, "  %-*s %10s %10s %12s %10s %9s %9s %9s %9s %9s\n", width, "stepper", "h", "steps", "force evals",
            "time  ", cost_measures[0], cost_measures[1], cost_measures[2], cost_measures[3], "at most");
    for (int64_t k = 0; k < a->count; ++k)
        say_offer(&a->offers[k], width, file);
    fputc('\n', file);
    stable_say(&a->limits, best->stepper, best->h, file);
    if (isfinite(a->max_omega))
        fprintf(file, "rotation per step: h max|Omega| = %.3g\n", best->h * a->max_omega);
    fprintf(file, "times are of the steps alone, without output");
    const int part = best->source == OFFER_SHORTER || best->source == OFFER_STABILITY;
    if (isfinite(a->known))
        fprintf(file, "; the solution%s is known to %.0e", part ? " of the first part of the time" : "", a->known);
    fprintf(file, "\npilots took");
    say_seconds(a->seconds, file);
    fprintf(file, " and %.3g force evaluations\n", a->evals);
}

/** Why the error is far below what was asked for, if that is known. */
static void say_small(const struct offer *best, double asked, double stable, FILE *file)
{
    static const double far = 0.29; /* below what any search aims at */
    if (!(best->error < far * asked) || !isfinite(best->doubt))
        return;
    fprintf(file, "note: %sthe error is ",
            isfinite(best->missed)   ? ""
            : best->h > 0.5 * stable ? "stability, not the error, sets the step: "
                                     : "fewer steps are not tried: ");
    say_error(best, file);
    if (isfinite(best->missed))
        fprintf(file, ", and steps a little longer miss what was asked for: %.1e", best->missed);
    fputc('\n', file);
}

/** Seconds that would do, and more than have not. */
static double budget_for(const struct advice *a, double seconds)
{
    return fmax(seconds, 2.0 * fmax(a->budget, a->seconds));
}

void advise_warnings(const struct scene *scene, const struct advice *a, FILE *file)
{
    const struct offer *best = &a->offers[0];
    /* by half of the stable step it is half as many steps, and twice these, by nine tenths of a purse that is to hold
     * the pace of a slower moment too */
    const double two_runs = 2.0;
    const char *kink = scene_first_with(scene, EFFECT_KINKED);
    if (a->parted)
        fprintf(file,
                "warning: trajectories of the finest pilots part at t = %.4g: from there on they mean nothing at steps "
                "like these, and the advice goes by the error of the energy%s\n",
                a->together, a->unsure ? "; whether those of finer ones part too a larger --budget tells" : "");
    if (kink != NULL && a->order < a->nominal - 1.0)
        fprintf(
            file,
            "warning: the forces of this scene are not smooth enough for high order: %s, of order %.0f, shows order "
            "%.1f; that of %s has kinks\n",
            a->checked->name, a->nominal, a->order, kink);
    if (best->h > 0.95 * stable_least(&a->limits, best->stepper))
        fprintf(file,
                "warning: h = %.4g is %s the stable step %.4g: what is off by less than the error may still grow\n",
                best->h, best->h > 1.05 * stable_least(&a->limits, best->stepper) ? "above" : "near",
                stable_least(&a->limits, best->stepper));
    if (a->measure == COST_ENERGY && a->energy == 0.0)
        fprintf(file, "warning: the energy is 0 at the start, and errors of it are in its own unit: choose --error by "
                      "the energies that there will be, or another --measure\n");
    if (best->h * a->max_omega > 1.0)
        fprintf(file, "warning: bodies turn by up to %.2g radians per step\n", best->h * a->max_omega);
    if (vti_multistep_find(best->stepper->name) != NULL)
        fprintf(file,
                "note: %s is a multistep method and not symplectic: its energy drifts in proportion to time; for times "
                "much longer than t = %g name the others by --steppers\n",
                best->stepper->name, a->t_end);
    say_small(best, a->target, stable_least(&a->limits, best->stepper), file);
    const double wanted = two_runs * (double)best->force_evals;
    if (best->source == OFFER_STABILITY && a->evals == 0.0 && a->budget > 0.0)
        fprintf(file, "note: no pilot had time for a step: the scene's start and stable step took %.2g s\n", a->start);
    else if (best->source == OFFER_STABILITY && a->evals > 0.0 && a->evals < wanted)
        fprintf(file, "note: pilots were not allowed to go over the whole time; --budget %.2g would do for two runs\n",
                budget_for(a, wanted * a->seconds / a->evals));
    else if (best->source != OFFER_MEASURED && best->source != OFFER_STABILITY)
        fprintf(file, "note: pilots were not allowed to go over the whole time to this error; --budget %.2g would do\n",
                budget_for(a, 150.0 * (isfinite(best->seconds) ? best->seconds : 1.0)));
}

/* ---- JSON -------------------------------------------------------------------------------------------------------- */

/* JSON knows no infinity: null */
static void json_value(double value, FILE *file)
{
    fputs(isfinite(value) ? NUMBER(value) : "null", file);
}

static void json_number(const char *key, double value, FILE *file)
{
    fprintf(file, "\"%s\": ", key);
    json_value(value, file);
}

static void json_offer(const struct offer *o, FILE *file)
{
    static const char *const source[] = {"none", "stability", "followed", "shorter", "measured"};
    fprintf(file, "\"stepper\": \"%s\", ", o->stepper->name);
    if (method_rival(o->stepper) != NULL)
        fputs("\"kind\": \"rival\", ", file);
    json_number("h", o->steps > 0 ? o->h : NAN, file);
    fputs(", ", file);
    json_number("predicted_error", o->steps > 0 ? o->error : NAN, file);
    fputs(", ", file);
    json_number("predicted_seconds", o->seconds, file);
    fputs(", ", file);
    json_number("predicted_force_evals", o->steps > 0 && o->force_evals > 0 ? (double)o->force_evals : NAN, file);
    fprintf(file, ", \"source\": \"%s\", \"interval\": [", source[o->source]);
    json_value(o->error / o->below, file);
    fputs(", ", file);
    json_value(o->error * o->doubt, file);
    fputs("], \"errors\": {", file);
    for (int m = 0; m < COST_MEASURES; ++m) {
        fputs(m > 0 ? ", " : "", file);
        json_number(cost_measures[m], o->errors[m], file);
    }
    fputs("}", file);
}

void advise_json(const struct advice *a, FILE *file)
{
    fputs("{", file);
    json_offer(&a->offers[0], file);
    fputs(", ", file);
    json_number("stable_h", stable_least(&a->limits, a->offers[0].stepper), file);
    fputs(", ", file);
    json_number("h_max_omega", a->offers[0].h * a->max_omega, file);
    fprintf(file, ", \"measure\": \"%s\", ", cost_measures[a->measure]);
    json_number("trajectories_until", a->parted ? a->together : NAN, file);
    fputs(", \"pilots\": {", file);
    json_number("seconds", a->seconds, file);
    fputs(", ", file);
    json_number("force_evals", a->evals, file);
    fputs("}, \"alternatives\": [", file);
    for (int64_t k = 1; k < a->count; ++k) {
        fputs(k > 1 ? ", {" : "{", file);
        json_offer(&a->offers[k], file);
        fputs("}", file);
    }
    fputs("]}\n", file);
}
