/* SPDX-License-Identifier: BSD-3-Clause
 * Steps of variable length: by their errors (EQUATIONS 8.3), by a density (8.4), and what puts bodies back. */
#include <float.h>

#include "../vti_ready.h"

/* ---- steps that keep an error ------------------------------------------------------------------------------------ */

static const double safety = 0.85, shrink = 0.2, grow = 4.0, again = 0.9;

enum { LEAST_POWER = 2, MOST_POWER = 16 };

int vti_control_start(const vti_stepper *method, double tolerance, double h, vti_control *control)
{
    if (control == NULL)
        return VTI_E_NULL;
    if (method == NULL || method->estimate == NULL)
        return VTI_E_STEPPER;
    if (!vti_is_positive(tolerance))
        return VTI_E_CONTROL;
    if (!vti_is_positive(h))
        return VTI_E_TIME;
    const vti_control start = {.tolerance = tolerance,
                               .speed = 1.0,
                               .turning = 1.0,
                               .most = INFINITY,
                               .power = (double)(method->estimate_order + 1),
                               .h = h};
    *control = start;
    return VTI_OK;
}

static int is_sound(const vti_control *c)
{
    const int scales = vti_is_positive(c->tolerance) && vti_is_positive(c->speed) && vti_is_positive(c->turning);
    const int limits = c->least >= 0.0 && c->most > c->least && vti_is_positive(c->h);
    return scales && limits && c->power >= LEAST_POWER && c->power <= MOST_POWER && floor(c->power) == c->power;
}

/** min(4, max(0.2, 0.85 (1/r)^(1/n))) for r = err/tolerance; 0.2 where that is no number. The root y of y^n = r is
 *  found by Newton's method, which comes down to it from above until rounding stops it: the same bits everywhere, as no
 *  pow has. */
static double factor_of(double r, int n)
{
    const double highest = safety / shrink, lowest = safety / grow;
    double y = 2.0 * highest, next = highest;
    while (next < y && next > lowest) {
        double power = 1.0;
        y = next;
        for (int k = 1; k < n; ++k)
            power *= y;
        next = y - (y - r / power) / n;
    }
    return next <= lowest ? grow : safety / y;
}

int vti_control_judge(vti_control *control, double h, double velocity, double omega, int64_t *accepted)
{
    if (control == NULL || accepted == NULL)
        return VTI_E_NULL;
    if (!vti_is_positive(h))
        return VTI_E_TIME;
    if (!is_sound(control) || velocity < 0.0 || omega < 0.0)
        return VTI_E_CONTROL;
    const double error = vti_larger(velocity / control->speed, omega / control->turning),
                 r = error / control->tolerance;
    const int good = r <= 1.0;
    /* the next h stays positive and finite */
    const double least = vti_larger(control->least, DBL_MIN), most = control->most < DBL_MAX ? control->most : DBL_MAX;
    double factor = factor_of(r, (int)control->power);
    if (!good && h <= least)
        return VTI_E_CONTROL;
    *accepted = good;
    control->error = error;
    if (good) {
        factor = control->held != 0 && factor > 1.0 ? 1.0 : factor;
        control->h = h < control->h ? control->h : h * factor;
        ++control->accepted;
    } else {
        control->h = h * (factor < again ? factor : again);
        ++control->rejected;
    }
    control->h = control->h < least ? least : control->h > most ? most : control->h;
    control->held = !good;
    return VTI_OK;
}

/* ---- what puts bodies back --------------------------------------------------------------------------------------- */

/** One component of a quantity: of body i it is p[i*stride]. */
struct column {
    double *p;
    int64_t stride;
};

/* A step and its forces write all quantities but constants. */
#define OF_STATE(type, member) OF_##type(member)
#define OF_LOAD(type, member) OF_##type(member)
#define OF_LOW(type, member) OF_##type(member)
#define OF_CONSTANT(type, member)
#define OF_ROLE(constant, number, member, type, role) OF_##role(type, member)

#define OF_vti_view(member) +3
#define OF_vti_quat_view(member) +4
enum { COLUMNS = VTI_QUANTITIES(OF_ROLE) };
#undef OF_vti_view
#undef OF_vti_quat_view

/** Appends the components of a view to n others, if it is there; returns how many there are. */
static int64_t add_columns(struct column *column, int64_t n, double *const *c, int components, int64_t stride)
{
    for (int k = 0; k < components && c[0] != NULL; ++k) {
        column[n].p = c[k];
        column[n++].stride = stride;
    }
    return n;
}

/** Returns how many there are. */
static int64_t columns_of(const vti_bodies *b, struct column column[COLUMNS])
{
    int64_t n = 0;
#define OF_vti_view(member) n = add_columns(column, n, b->member.c, 3, b->member.stride);
#define OF_vti_quat_view(member) n = add_columns(column, n, b->member.xyzw, 4, b->member.stride);
    VTI_QUANTITIES(OF_ROLE)
    return n;
}

int64_t vti_step_keeps(const vti_bodies *b)
{
    struct column column[COLUMNS];
    const int status = vti_bodies_ready(b);
    return status == VTI_OK ? columns_of(b, column) : status;
}

enum direction { KEEP, UNDO };

/** Of each number of the bodies' slice: into the memory, or out of it. */
static int copy(const vti_bodies *b, const vti_kept *kept, enum direction direction)
{
    struct column column[COLUMNS];
    const int status = vti_bodies_ready(b);
    if (status != VTI_OK)
        return status;
    if (kept == NULL || kept->memory == NULL)
        return VTI_E_NULL;
    const int64_t n = columns_of(b, column);
    if (kept->width < n)
        return VTI_E_COUNT;
    for (int64_t i = b->first; i < b->first + b->count; ++i)
        for (int64_t k = 0; k < n; ++k) {
            double *const stored = &kept->memory[i * kept->width + k], *const live = &column[k].p[i * column[k].stride];
            if (direction == KEEP)
                *stored = *live;
            else
                *live = *stored;
        }
    return VTI_OK;
}

int vti_step_keep(const vti_bodies *b, const vti_kept *kept)
{
    return copy(b, kept, KEEP);
}

int vti_step_undo(const vti_bodies *b, const vti_kept *kept)
{
    return copy(b, kept, UNDO);
}

/* ---- variable steps without drift -------------------------------------------------------------------------------- */

static int set_density(vti_density *density, double epsilon, double rho)
{
    const double h = vti_is_positive(rho) ? epsilon / rho : 0.0;
    const vti_density next = {epsilon, rho, h};
    if (!vti_is_positive(h))
        return VTI_E_TIME;
    *density = next;
    return VTI_OK;
}

int vti_density_start(double epsilon, double wish, double rate, vti_density *density)
{
    if (density == NULL)
        return VTI_E_NULL;
    return vti_is_positive(epsilon) && vti_is_positive(wish)
               ? set_density(density, epsilon, 1.0 / wish + 0.5 * epsilon * rate)
               : VTI_E_TIME;
}

int vti_density_next(vti_density *density, double rate)
{
    return density != NULL ? set_density(density, density->epsilon, density->rho + density->epsilon * rate)
                           : VTI_E_NULL;
}
