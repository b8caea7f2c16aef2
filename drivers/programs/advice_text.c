/* SPDX-License-Identifier: BSD-3-Clause */
#include "advice_text.h"

#include <math.h>

#include "number.h"
#include "stable_text.h"

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

void advice_say(const struct scene *scene, const struct advice *a, FILE *file)
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

void advice_warn(const struct scene *scene, const struct advice *a, FILE *file)
{
    const struct offer *best = &a->offers[0];
    const double nominal = (double)a->checked->order;
    if ((scene->has_contact || scene->has_wall) && a->order < nominal - 1.0)
        fprintf(
            file,
            "warning: the forces of this scene are not smooth enough for high order: %s, of order %.0f, shows order "
            "%.1f; the stiffness of a contact sets in with a kink\n",
            a->checked->name, nominal, a->order);
    if (best->h > 0.95 * stable_least(&a->limits, best->stepper))
        fprintf(file,
                "warning: h = %.4g is near the stable step %.4g: what is off by less than the error may still grow\n",
                best->h, stable_least(&a->limits, best->stepper));
    if (best->h * a->max_omega > 1.0)
        fprintf(file, "warning: bodies turn by up to %.2g radians per step\n", best->h * a->max_omega);
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

void advice_json(const struct advice *a, FILE *file)
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
