/* SPDX-License-Identifier: BSD-3-Clause
 * vti-advise: a scene and an error in, a stepper and a step out. The work is in study/advise.c. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "advise.h"
#include "number.h"
#include "options.h"
#include "terminal.h"
#include "table_hdf5.h"

static struct option_list sets;
static const char *steppers;
static double target = 1e-4, t_end, budget = 120.0;
static int json;

static const struct option_row rows[] = {
    OPTION_PARAGRAPH(
        "Finds by pilot runs which stepper and step reach a given error at the end of the scene in the\n"
        "least time, and what the others would need. The error is that at the end: the largest angle\n"
        "between a body's attitude and the true one, in radians; where nothing turns, the relative error of\n"
        "the velocities.\n"),
    {"--error", "E", OPTION_NUMBER, &target, 1e-12, 0.1, "1e-4, 1/64 or 2^-7", "the error to reach (default 1e-4)"},
    {"--steppers", "A,B", OPTION_TEXT, &steppers, OPTION_ANY,
     "only these steppers (default: all of ours); rivals, what others use, are measured too and never advised"},
    {"--t-end", "T", OPTION_NUMBER, &t_end, 0, 0, "10, 1e3 or 2^7", "end time (default: the scene's)"},
    {"--budget", "SECONDS", OPTION_NUMBER, &budget, 0, 0, "60 or 1e3",
     "how long finding the solution may take (default 120)"},
    {"--set", "PATH=VALUE", OPTION_EACH, &sets, OPTION_ANY, "override a value of the scene; may be repeated"},
    {"--json", NULL, OPTION_ON, &json, OPTION_ANY,
     "one JSON object with the keys stepper, h, predicted_error, predicted_seconds, stable_h, h_max_omega, "
     "alternatives; "
     "warnings go to stderr"},
    {0}};

static const struct options options = {"vti-advise", "", "[options] SCENE.yaml", rows, 1};

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

static void say_offer(const struct offer *o, int width, FILE *file)
{
    if (!isfinite(o->seconds)) {
        fprintf(file, "  %-*s       too dear to tell\n", width, o->stepper->name);
        return;
    }
    fprintf(file, "  %-*s %10.4g %10lld %12lld ", width, o->stepper->name, o->h, (long long)o->steps,
            (long long)o->force_evals);
    say_seconds(o->seconds, file);
    fprintf(file, " %9.1e %s%s\n", o->error, o->measured ? "" : "(from coarser runs)",
            method_rival(o->stepper) != NULL ? "(a rival, to compare with)" : "");
}

/** What to use, what the others would need, and how the step stands to stability and rotation. */
static void say_advice(const struct scene *scene, const struct advice *a, FILE *file)
{
    const struct offer *best = &a->offers[0];
    int width = 0;
    for (int64_t k = 0; k < a->count; ++k) {
        const int w = methods_width(&a->offers[k].stepper, 1);
        width = w > width ? w : width;
    }
    fprintf(file, "%s to t = %g: %s at h = %.6g reaches %.1e (asked for: %g) in", scene->name, a->t_end,
            best->stepper->name, best->h, best->error, a->target);
    say_seconds(best->seconds, file);
    fprintf(file, "\n\n  %-*s %10s %10s %12s %10s %9s\n", width, "stepper", "h", "steps", "force evals", "time  ",
            "error");
    for (int64_t k = 0; k < a->count; ++k)
        say_offer(&a->offers[k], width, file);
    fputc('\n', file);
    stable_say(&a->limits, best->stepper, best->h, file);
    fprintf(file, "rotation per step: h max|Omega| = %.3g\n", best->h * a->max_omega);
    fprintf(file, "times are of the steps alone, without output; the solution is known to %.0e\n", a->known);
}

/** One line each for what should give pause. */
static void say_warnings(const struct scene *scene, const struct advice *a, FILE *file)
{
    const struct offer *best = &a->offers[0];
    const double nominal = (double)a->checked->order;
    const char *kink = scene_first_with(scene, EFFECT_KINKED);
    if (kink != NULL && a->order < nominal - 1.0)
        fprintf(
            file,
            "warning: the forces of this scene are not smooth enough for high order: %s, of order %.0f, shows order "
            "%.1f; that of %s has kinks\n",
            a->checked->name, nominal, a->order, kink);
    if (best->h > 0.95 * stable_least(&a->limits, best->stepper))
        fprintf(file,
                "warning: h = %.4g is near the stable step %.4g: what is off by less than the error may still grow\n",
                best->h, stable_least(&a->limits, best->stepper));
    if (best->h * a->max_omega > 1.0)
        fprintf(file, "warning: bodies turn by up to %.2g radians per step\n", best->h * a->max_omega);
    if (vti_multistep_find(best->stepper->name) != NULL)
        fprintf(file,
                "note: %s is a multistep method and not symplectic: its energy drifts in proportion to time; for times "
                "much "
                "longer than t = %g name the others by --steppers\n",
                best->stepper->name, a->t_end);
    if (best->error < 0.33 * a->target)
        fprintf(file, "note: stability, not the error, sets the step: the error is %.1e\n", best->error);
}

/* JSON knows no infinity: null */
static void json_number(const char *key, double value, FILE *file)
{
    if (isfinite(value))
        fprintf(file, "\"%s\": %s", key, NUMBER(value));
    else
        fprintf(file, "\"%s\": null", key);
}

static void json_offer(const struct offer *o, FILE *file)
{
    fprintf(file, "\"stepper\": \"%s\", ", o->stepper->name);
    if (method_rival(o->stepper) != NULL)
        fputs("\"kind\": \"rival\", ", file);
    json_number("h", o->steps > 0 ? o->h : NAN, file);
    fputs(", ", file);
    json_number("predicted_error", o->steps > 0 ? o->error : NAN, file);
    fputs(", ", file);
    json_number("predicted_seconds", o->seconds, file);
}

/** One JSON object with the keys stepper, h, predicted_error, predicted_seconds, stable_h, h_max_omega,
 *  alternatives. */
static void print_json(const struct advice *a, FILE *file)
{
    fputs("{", file);
    json_offer(&a->offers[0], file);
    fputs(", ", file);
    json_number("stable_h", fmin(a->limits.rest.h, a->limits.within.h), file);
    fputs(", ", file);
    json_number("h_max_omega", a->offers[0].h * a->max_omega, file);
    fputs(", \"alternatives\": [", file);
    for (int64_t k = 1; k < a->count; ++k) {
        fputs(k > 1 ? ", {" : "{", file);
        json_offer(&a->offers[k], file);
        fputs("}", file);
    }
    fputs("]}\n", file);
}

/** What is being run, on a terminal. */
static void show(const char *stepper, int64_t steps)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r\033[Ktrying %s in %lld steps", stepper, (long long)steps);
}

static int give_advice(struct scene *scene, struct message *message)
{
    static const vti_stepper *list[ADVICE_MOST];
    int64_t listed = 0;
    static struct advice advice;
    if (steppers != NULL && (listed = methods_read("--steppers", steppers, list, ADVICE_MOST, message)) < 0)
        return -1;
    if (t_end == 0.0)
        t_end = scene->t_end;
    const int failed = advise(scene, target, t_end, budget, list, listed, show, &advice, message);
    if (isatty(STDERR_FILENO))
        fputs("\r\033[K", stderr);
    if (failed != 0)
        return -1;
    if (json)
        print_json(&advice, stdout);
    else
        say_advice(scene, &advice, stdout);
    say_warnings(scene, &advice, json ? stderr : stdout);
    return 0;
}

int main(int argc, char **argv)
{
    static struct scene scene;
    static struct tables tables;
    struct message message = {""};
    const char *const *scenes;
    int count;
    method_admit();
    const enum options_end asked = options_read(&options, argc, argv, 1, &scenes, &count, &message);
    if (asked == OPTIONS_TOLD)
        return 0;
    int failed = asked == OPTIONS_WRONG ? -1 : 0;
    if (failed == 0 && count == 0)
        failed = message_set(&message, "no scene is named; see vti-advise --help");
    if (failed == 0)
        failed = scene_read(scenes[0], sets.text, sets.count, &scene, &message);
    if (failed == 0)
        failed = tables_read(&scene, &tables, &message);
    if (failed == 0)
        failed = give_advice(&scene, &message);
    if (failed == 0)
        failed = output_end(&message);
    if (failed != 0)
        fprintf(stderr, "vti-advise: %s\n", message.text);
    tables_destroy(&tables);
    return failed != 0;
}
