/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Campello's implicit map, as the paper prints it, with phi = 1/2, and by other names with 0 and 1:
 *
 *     v+ = v + h/m [phi F + (1 - phi) F+]             x+ = x + h v+
 *     Omega+ = Omega + h/J [phi RM + (1 - phi) RM+]    alpha+ = alpha (+) h Omega+
 *
 * E. M. B. Campello, A description of rotations for DEM models of particle systems, Comput. Part. Mech. 2, 109
 * (2015). It is of first order for every phi and dissipates for phi < 1: it shrinks phase volumes by 1 + (1 - phi)(h
 * omega)^2 per step (E17); with phi = 1 it is VTI-3. F+ and RM+ are found by fixed-point iteration from F and RM,
 * which contracts by (1 - phi)(h omega)^2 and ends when the loads of all bodies together change by less than a share
 * TOLERANCE of themselves; that is far below the error of the method itself. (+) h Omega+ is done on quaternions. */
#include "quaternion.h"
#include "verlet.h"

#include <string.h>

static const double tolerance = 1e-10;

enum { ITERATIONS = 100 };

/** The state at the start of a step, and the loads of the last iteration. */
struct before {
    double *x, *v, *f, *f_last, *w, *m, *m_last, *q;
};

enum { VECTORS = 7, QUATERNION = 4, OWN = 3 * VECTORS + QUATERNION };

static struct before before_in(const struct course *c)
{
    const int64_t n = 3 * c->n;
    double *p = c->own;
    const struct before b = {p, p + n, p + 2 * n, p + 3 * n, p + 4 * n, p + 5 * n, p + 6 * n, p + 7 * n};
    return b;
}

static void copy(double *to, const double *from, int64_t n)
{
    if (from != NULL)
        memcpy(to, from, (size_t)n * sizeof *to);
}

static void remember(const struct course *c, const struct before *b)
{
    copy(b->x, c->x, 3 * c->n);
    copy(b->v, c->v, 3 * c->n);
    copy(b->f, c->f, 3 * c->n);
    copy(b->w, c->w, 3 * c->n);
    copy(b->m, c->m, 3 * c->n);
    copy(b->q, c->q, 4 * c->n);
}

/** v+ = v + h/m [phi F + (1 - phi) F+] */
static void kick(double h, double phi, double *restrict after, const double *restrict before, const double *restrict f,
                 const double *restrict f_after, const vti_scalars *per, int64_t n)
{
    for (int64_t i = 0; i < n; ++i) {
        const double k = h * per->p[i * per->stride], a = phi * k, b = (1.0 - phi) * k;
        for (int64_t j = 3 * i; j < 3 * i + 3; ++j)
            after[j] = before[j] + (a * f[j] + b * f_after[j]);
    }
}

/** x+ = x + h v+ */
static void translate(double h, double *restrict after, const double *restrict before, const double *restrict v,
                      int64_t n)
{
    for (int64_t j = 0; j < 3 * n; ++j)
        after[j] = before[j] + h * v[j];
}

/** One iteration, with the loads as they stand for F+ and RM+. */
static void move(const struct course *c, const struct before *b)
{
    if (c->f != NULL)
        kick(c->h, c->rival->phi, c->v, b->v, b->f, c->f, &c->per_mass, c->n);
    if (c->x != NULL)
        translate(c->h, c->x, b->x, c->v, c->n);
    if (c->m != NULL)
        kick(c->h, c->rival->phi, c->w, b->w, b->m, c->m, &c->per_inertia, c->n);
    copy(c->q, c->q != NULL ? b->q : NULL, 4 * c->n);
    rival_turn(c->h, c->q, c->w, quat_turn_normalised, 0, c->n);
}

/** sum |f - last|^2 <= tolerance^2 sum |f|^2 */
static int settled(const double *restrict f, const double *restrict last, int64_t n)
{
    double change = 0.0, size = 0.0;
    for (int64_t j = 0; f != NULL && j < 3 * n; ++j) {
        const double d = f[j] - last[j];
        change += d * d;
        size += f[j] * f[j];
    }
    return change <= tolerance * tolerance * size;
}

static int step(struct course *c, const struct before *b)
{
    remember(c, b);
    for (int iteration = 0; iteration < ITERATIONS; ++iteration) {
        move(c, b);
        copy(b->f_last, c->f, 3 * c->n);
        copy(b->m_last, c->m, 3 * c->n);
        const int status = course_forces(c);
        if (status != VTI_OK)
            return status;
        if (settled(c->f, b->f_last, c->n) && settled(c->m, b->m_last, c->n))
            return VTI_OK;
    }
    return RIVAL_E_DIVERGES;
}

static int go(struct course *c, int64_t steps)
{
    const struct before b = before_in(c);
    int status = VTI_OK;
    for (int64_t k = 0; k < steps && status == VTI_OK; ++k) {
        status = step(c, &b);
        c->steps += status == VTI_OK;
    }
    return status;
}

#define CAMPELLO(called, share, says)                                                                                  \
    {                                                                                                                  \
        .stepper = RIVAL_STEPPER(called, 1, 0.0, 0, NAN, says), .own_width = OWN, .go = go, .takes_forces = 1,         \
        .phi = (share)                                                                                                 \
    }

const struct rival rival_campello =
    CAMPELLO("campello", 0.5,
             "implicit map with phi = 1/2 by fixed-point iteration: first order, dissipates (Campello 2015; E17)");
const struct rival rival_campello_0 =
    CAMPELLO("campello-0", 0.0, "Campello's map with phi = 0: kicks by the forces at the end of the step (E17)");
const struct rival rival_campello_1 =
    CAMPELLO("campello-1", 1.0, "Campello's map with phi = 1: explicit, the map of vti3 (E17)");
