/* SPDX-License-Identifier: BSD-3-Clause */
#include "stable.h"

#include <math.h>

static void say_bound(const vti_stable *stable, const char *by, const vti_stepper *stepper, double h, FILE *file)
{
    const double step = model_stable_of(stepper, stable->h);
    if (isnan(step))
        fputs("not known", file);
    else if (isinf(step))
        fputs("no limit (nothing is in contact or bonded)", file);
    else if (step == 0.0)
        fprintf(file, "no step is sure, for %s", by);
    else
        fprintf(file, "%.4g, set by %s", step, by);
    if (isfinite(step) && step > 0.0 && h > 0.0)
        fprintf(file, "; h is %.3g of it", h / step);
    fputc('\n', file);
}

void stable_say(const struct model_limits *l, const vti_stepper *stepper, double h, FILE *file)
{
    fprintf(file, "stable step of %s at rest: ", stepper->name);
    say_bound(&l->rest, l->rest_by, stepper, h, file);
    if (!(l->at.strain > 0.0 || l->at.overlap > 0.0))
        return;
    fputs("with ", file);
    if (l->at.strain > 0.0)
        fprintf(file, "bonds strained by up to %.2g", l->at.strain);
    if (l->at.overlap > 0.0)
        fprintf(file, "%scontacts overlapped by up to %.2g", l->at.strain > 0.0 ? " and " : "", l->at.overlap);
    fputs(" (estimated from the energy of single bodies): ", file);
    say_bound(&l->within, l->within_by, stepper, h, file);
}

double stable_least(const struct model_limits *l, const vti_stepper *stepper)
{
    return model_stable_of(stepper, model_limits_least(l));
}
