/* SPDX-License-Identifier: BSD-3-Clause */
#include "smooth.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sampled.h"

/* The tolerance of a step of rk8pd, and the share of the state that interpolation may add. */
static const double step_tolerance = 1e-14, interpolation_tolerance = 1e-13;
/* That of a second solution, which tells how errors of a step have grown. They go as the tolerance: what the first one
 * is off by is a hundredth of how far the two are apart, and a thirtieth is said; but where they have parted. */
static const double looser = 100.0, share_of_spread = 1.0 / 30.0;
/* The first panels, but not so many at first. They are halved until the interpolants are good, as long as that helps or
 * takes no memory that is not there. */
static const double first_panel = 0.5, first_panels = 4096.0;
static const double most_panels = 0x1p40;

int smooth_create(struct smooth *s, struct model *model, struct message *message)
{
    memset(s, 0, sizeof *s);
    s->model = model;
    s->state = calloc((size_t)equations_width(model), sizeof *s->state);
    s->block = calloc((size_t)(PANELS_BLOCK * equations_width(model) + PANELS_SPARE), sizeof *s->block);
    s->samples = calloc((size_t)(SMOOTH_SAMPLES * equations_width(model)), sizeof *s->samples);
    if (s->state == NULL || s->block == NULL || s->samples == NULL)
        return scene_no_memory(model->scene, message);
    return 0;
}

void smooth_destroy(struct smooth *s)
{
    panels_destroy(&s->panels);
    equations_destroy(&s->equations);
    free(s->state);
    free(s->block);
    free(s->samples);
    free(s->starts);
    free(s->sums);
    s->state = s->block = s->samples = s->starts = NULL;
    s->sums = NULL;
}

/* ---- windows ----------------------------------------------------------------------------------------------------- */

static double *start_of(const struct smooth *s, int64_t window)
{
    return s->starts + window * (SMOOTH_START + equations_width(s->model));
}

vti_sum smooth_sum_before(const struct smooth *s, int64_t window)
{
    const double *start = start_of(s, window);
    const vti_sum sum = {start[1], start[2]};
    return sum;
}

static void keep_start(struct smooth *s, int64_t window, vti_sum sum)
{
    double *start = start_of(s, window);
    start[0] = s->t;
    start[1] = sum.high;
    start[2] = sum.low;
    memcpy(start + SMOOTH_START, s->state, (size_t)equations_width(s->model) * sizeof *s->state);
}

int smooth_resize(struct smooth *s, int64_t count, int64_t held, double t_end)
{
    const int64_t width = equations_width(s->model);
    free(s->starts);
    free(s->sums);
    s->window = s->sums_window = -1;
    s->windows = (count + held - 1) / held;
    s->starts = calloc((size_t)(s->windows * (SMOOTH_START + width)), sizeof *s->starts);
    s->sums = calloc((size_t)held, sizeof *s->sums);
    return panels_create(&s->panels, width - 1, count, held, t_end) != 0 || s->starts == NULL || s->sums == NULL ? -1
                                                                                                                 : 0;
}

static int64_t window_of(const struct smooth *s, int64_t panel)
{
    return panel / s->panels.held;
}

/** The panel after the last of a window. */
static int64_t end_of(const struct smooth *s, int64_t window)
{
    const int64_t end = (window + 1) * s->panels.held;
    return end < s->panels.count ? end : s->panels.count;
}

/* ---- integration ------------------------------------------------------------------------------------------------- */

/** Goes to the start of a window, with an integrator that knows nothing of what came before, or the panels would
 *  depend on that. */
static int enter(struct smooth *s, int64_t window, const struct watch *watch, struct message *message)
{
    const double *start = start_of(s, window);
    equations_destroy(&s->equations);
    if (equations_create(&s->equations, s->model, step_tolerance, watch, message) != 0)
        return -1;
    s->t = start[0];
    memcpy(s->state, start + SMOOTH_START, (size_t)equations_width(s->model) * sizeof *s->state);
    s->panels.first = window * s->panels.held;
    s->window = -1;
    return 0;
}

/** Returns as equations_advance does. */
static int one_panel(struct smooth *s, int64_t p, struct message *message)
{
    const struct panels *panels = &s->panels;
    const double share = (double)p / (double)panels->count;
    for (int k = 0; k < PANELS_NODES; ++k) {
        const double to = panels_time(panels, p, panels->node[k]);
        const int failed = equations_advance(&s->equations, share, &s->t, to, s->state, message);
        if (failed != 0)
            return failed;
        memcpy(panels_row(panels, p, k), s->state, (size_t)panels->width * sizeof *s->state);
    }
    return 0;
}

int smooth_seek(struct smooth *s, double t, const struct watch *watch, struct message *message)
{
    double tau;
    if (s->windows == 1 && s->window == 0)
        return 0;
    const int64_t window = window_of(s, panels_find(&s->panels, t, &tau));
    if (window == s->window)
        return 0;
    if (enter(s, window, watch, message) != 0)
        return -1;
    for (int64_t p = s->panels.first; p < end_of(s, window); ++p) {
        const int failed = one_panel(s, p, message);
        if (failed != 0)
            return failed;
        if (watch_see(watch, (double)p / (double)s->panels.count))
            return WATCH_ASKED;
    }
    s->window = window;
    return 0;
}

/** Keeps what the window after this one starts from. */
static void hand_on(struct smooth *s, int64_t window)
{
    vti_sum sum = smooth_sum_before(s, window);
    keep_start(s, window + 1, sum);
    for (int64_t p = s->panels.first; p < end_of(s, window); ++p) /* which needs s->state */
        vti_sum_add(&sum, smooth_panel_integral(s, p, 1.0));
    start_of(s, window + 1)[1] = sum.high;
    start_of(s, window + 1)[2] = sum.low;
}

static double sample_time(double t_end, int64_t k)
{
    return t_end * ((double)(k + 1) / SMOOTH_SAMPLES);
}

/** Those of the window in memory. */
static void take_samples(struct smooth *s, int64_t window)
{
    for (int64_t k = 0; k < SMOOTH_SAMPLES; ++k) {
        double tau;
        const int64_t p = panels_find(&s->panels, sample_time(s->panels.t_end, k), &tau);
        if (window_of(s, p) == window)
            panels_read(&s->panels, p, tau, s->samples + k * equations_width(s->model));
    }
}

/** One pass over all panels, which leaves the last window in memory; or over those up to the first that interpolates
 *  worse than tolerance. */
static int one_pass(struct smooth *s, double tolerance, const struct watch *watch, struct message *message)
{
    const vti_bodies bodies = equations_bodies(s->model, s->state);
    const vti_sum nothing = {0.0, 0.0};
    double squares = 0.0;
    s->t = s->energy_error = s->tail = s->interpolation_error = s->rounding = s->rounding_most = 0.0;
    equations_start(s->model, s->state);
    keep_start(s, 0, nothing);
    const double energy = model_energy(s->model, &bodies);
    for (int64_t window = 0; window < s->windows; ++window) {
        if (enter(s, window, watch, message) != 0)
            return -1;
        const double *const unit = s->equations.unit, norm_unit = sqrt(unit[equations_width(s->model) - 1]);
        for (int64_t p = s->panels.first; p < end_of(s, window); ++p) {
            const int failed = one_panel(s, p, message);
            if (failed != 0)
                return failed;
            s->rounding_most = fmax(s->rounding_most, 2.0 * DBL_EPSILON * panels_most(&s->panels, p, unit));
            s->rounding_most = fmax(s->rounding_most, s->equations.floor.highest);
            s->energy_error = fmax(s->energy_error, fabs(model_energy(s->model, &bodies) - energy));
            s->tail = fmax(s->tail, panels_tail(&s->panels, p, unit));
            s->interpolation_error = fmax(s->interpolation_error, panels_tail(&s->panels, p, NULL) / norm_unit);
            if (s->tail > fmax(tolerance, s->rounding_most))
                return 0;
            if (watch_see(watch, (double)(p + 1) / (double)s->panels.count))
                return WATCH_ASKED;
        }
        squares += equations_rounding_squared(&s->equations);
        s->rounding = sqrt(squares);
        s->window = window;
        take_samples(s, window);
        if (window + 1 < s->windows)
            hand_on(s, window);
    }
    return 0;
}

int smooth_integrate(struct smooth *s, double t_end, double bytes, const struct watch *watch, struct message *message)
{
    const double panel = (double)(PANELS_NODES * (equations_width(s->model) - 1)) * (double)sizeof(double);
    const double fit = fmax(1.0, floor(bytes / panel)); /* into memory */
    double last = INFINITY;
    if (!(t_end / first_panel <= most_panels))
        return message_set(message, "%s: no reference solution can be had up to t = %g; shorten t_end",
                           s->model->scene->name, t_end);
    for (int64_t count = (int64_t)fmin(ceil(t_end / first_panel), first_panels);; count *= 2) {
        const double windows = ceil((double)count / fit), held = ceil((double)count / windows),
                     twice = 2.0 * (double)count;
        if (smooth_resize(s, count, (int64_t)held, t_end) != 0)
            return message_set(message, "%s: out of memory for the reference solution; give less of it with --memory",
                               s->model->scene->name);
        /* where the passes after this one are made whatever it finds, one bad panel is enough */
        const double enough = 2.0 * twice <= fit ? interpolation_tolerance : INFINITY;
        const int failed = one_pass(s, enough, watch, message);
        const int helps = s->tail < 0.5 * last;
        last = s->tail;
        if (failed != 0 || last <= fmax(interpolation_tolerance, s->rounding_most) ||
            (twice > fit && (!helps || twice > most_panels)))
            return failed;
    }
}

int smooth_looser(struct model *model, double t_end, double *other, const struct watch *watch, struct message *message)
{
    const int64_t width = equations_width(model);
    struct equations eq;
    double t = 0.0;
    int failed = equations_create(&eq, model, looser * step_tolerance, watch, message);
    if (failed != 0)
        return -1;
    equations_start(model, other);
    for (int64_t k = 0; k < SMOOTH_SAMPLES && failed == 0; ++k) {
        double *const state = other + k * width;
        if (k > 0)
            memcpy(state, state - width, (size_t)width * sizeof *state);
        failed = equations_advance(&eq, (double)k / SMOOTH_SAMPLES, &t, sample_time(t_end, k), state, message);
    }
    equations_destroy(&eq);
    return failed;
}

double smooth_spread(struct smooth *s, const double *other)
{
    const int64_t width = equations_width(s->model);
    double sum = 0.0;
    for (int64_t k = 0; k < SMOOTH_SAMPLES; ++k) {
        const vti_bodies kept = equations_bodies(s->model, s->samples + k * width),
                         looser_one = equations_bodies(s->model, (double *)other + k * width);
        sum += vti_h1_distance(&looser_one, &kept) * s->panels.t_end / SMOOTH_SAMPLES;
    }
    const double spread = sampled_relative(sum, smooth_norm_squared(s, s->panels.t_end));
    return spread < REFERENCE_PARTED ? share_of_spread * spread : spread;
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

vti_bodies smooth_at(struct smooth *s, double t)
{
    double tau;
    const int64_t p = panels_find(&s->panels, t, &tau);
    panels_read(&s->panels, p, tau, s->state);
    return equations_bodies(s->model, s->state);
}

const double *smooth_block(struct smooth *s, double h, int64_t step, int64_t *count)
{
    double tau[PANELS_BLOCK], *const block = panels_aligned(s->block);
    const int64_t p = panels_find_block(&s->panels, h, step, tau, count);
    panels_read_block(&s->panels, p, tau, *count, block);
    return block;
}
