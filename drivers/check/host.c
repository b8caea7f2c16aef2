/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The callback: forces that it is given, and steps that it takes. Once the host's constants are known (constants.c),
 * its velocities and loads are converted here by what they are off, so that everything else is judged as if they were
 * right:
 *
 *     v_host = v/flight,   omega_host = omega/turn,   F_host = F/(flight kick_F),   M_host = M/(turn kick_M). */
#include "check.h"

#include <float.h>

/** Is it where the run began? To a few roundings, for hosts whose attitudes are something else than quaternions. */
static int is_start(const struct bodies *start, const double *x, const double *q)
{
    int same = 1;
    for (int64_t k = 0; k < 3 * start->n; ++k)
        same = same && fabs(x[k] - start->x[k]) <= 64.0 * DBL_EPSILON;
    for (int64_t i = 0; i < start->n; ++i) {
        const double *a = q + 4 * i, *b = start->q + 4 * i; /* q and -q are one attitude */
        same = same && fabs(fabs(vti_dot(a, b) + a[3] * b[3]) - 1.0) <= 64.0 * DBL_EPSILON;
    }
    return same;
}

static void scale(double *a, int64_t n, double by)
{
    for (int64_t k = 0; k < n; ++k)
        a[k] *= by;
}

double vti_kit_kick_size(const struct kick *kick, double own, double other)
{
    const double by = kick->law == KICK_UNDIVIDED ? own : kick->law == KICK_BY_OTHER ? own / other : 1.0;
    return kick->ratio * by;
}

/** What a measured ratio is to be divided out by: 1 where there is nothing to divide by. */
static double divisor(double ratio)
{
    return isfinite(ratio) && ratio != 0.0 ? ratio : 1.0;
}

static void kit_forces(void *kit, int64_t n, const double *x, const double *q, double *force, double *moment)
{
    struct host *host = kit;
    const struct constants *c = &host->constants;
    if (n != host->start->n) {
        for (int64_t k = 0; k < 3 * n; ++k)
            force[k] = moment[k] = NAN;
        return;
    }
    if (host->calls++ == 0)
        host->primed = is_start(host->start, x, q);
    vti_kit_bodies_forces(host->field, n, x, q, force, moment);
    for (int64_t i = 0; i < n; ++i) {
        const double m = host->start->mass[i], j = host->start->inertia[i];
        scale(force + 3 * i, 3, 1.0 / (divisor(c->flight) * divisor(vti_kit_kick_size(&c->force, m, j))));
        scale(moment + 3 * i, 3, 1.0 / (divisor(c->turn) * divisor(vti_kit_kick_size(&c->moment, j, m))));
    }
}

void vti_kit_host_advance(struct host *host, struct bodies *b, const struct field *field, double h, int64_t steps)
{
    const struct bodies start = *b;
    const double flight = divisor(host->constants.flight), turn = divisor(host->constants.turn);
    if (!vti_kit_bodies_are_finite(b))
        return;
    host->field = field;
    host->start = &start;
    host->calls = 0;
    host->primed = 0;
    scale(b->v, 3 * b->n, 1.0 / flight);
    scale(b->w, 3 * b->n, 1.0 / turn);
    const int status = host->advance(host->self, h, steps - host->constants.extra_steps, b->n, b->x, b->v, b->q, b->w,
                                     b->mass, b->inertia, kit_forces, host);
    host->start = NULL;
    scale(b->v, 3 * b->n, flight);
    scale(b->w, 3 * b->n, turn);
    if (status != 0 || !vti_kit_bodies_are_finite(b))
        vti_kit_bodies_lose(b);
}
