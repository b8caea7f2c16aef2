/* SPDX-License-Identifier: BSD-3-Clause */
#include "modified.h"

#include <math.h>
#include <stdlib.h>

int modified_exists(const vti_stepper *s, const struct model *model)
{
    return model->bodies.moments.c[0] == NULL && s->stages == 1 && s->probe == NULL && s->drift[0] == 1.0 &&
           s->drift[1] == 0.0 && s->kick[0] + s->kick[1] == 1.0;
}

int modified_create(struct modified *m, struct model *model, const vti_stepper *stepper, double h)
{
    *m = (struct modified){.model = model, .stepper = stepper, .h = h};
    return state_fork_create(&m->probe, &model->bodies, modified_exists(stepper, model) ? OWN_ALL : 0);
}

void modified_destroy(struct modified *m)
{
    free(m->probe.memory);
    m->probe.memory = NULL;
}

/* ---- sums over bodies -------------------------------------------------------------------------------------------- */

/** Sum of the products of two views, with 1/weight where there is one; 0 if one is absent. */
static double sum_of_products(const vti_bodies *b, const vti_view *p, const vti_view *q, const vti_scalars *weight)
{
    vti_sum sum = {0.0, 0.0};
    for (int64_t i = 0; p->c[0] != NULL && q->c[0] != NULL && i < b->count; ++i) {
        const double per = weight != NULL ? 1.0 / weight->p[i * weight->stride] : 1.0;
        for (int k = 0; k < 3; ++k)
            vti_sum_add(&sum, per * p->c[k][i * p->stride] * q->c[k][i * q->stride]);
    }
    return vti_sum_value(&sum);
}

/** F.v + RM.Omega */
static double power(const vti_bodies *b)
{
    return sum_of_products(b, &b->force, &b->v, NULL) + sum_of_products(b, &b->moment, &b->omega, NULL);
}

/** F^2/m + RM^2/J */
static double squares(const vti_bodies *b)
{
    return sum_of_products(b, &b->force, &b->force, &b->mass) + sum_of_products(b, &b->moment, &b->moment, &b->inertia);
}

/** J Omega^4 */
static double fourths(const vti_bodies *b)
{
    vti_sum sum = {0.0, 0.0};
    for (int64_t i = 0; b->omega.c[0] != NULL && i < b->count; ++i) {
        const int64_t at = i * b->omega.stride;
        const double w[3] = {b->omega.c[0][at], b->omega.c[1][at], b->omega.c[2][at]}, w2 = vti_dot(w, w);
        vti_sum_add(&sum, b->inertia.p[i * b->inertia.stride] * w2 * w2);
    }
    return vti_sum_value(&sum);
}

/* ---- the energies ------------------------------------------------------------------------------------------------ */

/** kick(h/2) drift(h) kick(h/2) conserves H + h^2 (v V'' v/12 - (F^2/m + RM^2/J)/24 + c J Omega^4) + O(h^4), the
 *  Baker-Campbell-Hausdorff series of its parts. v V'' v = -d(F.v + RM.Omega)/dt along a free drift. A drift that turns
 *  by asin(h Omega), 2 atan(h Omega/2) or h Omega is that of a kinetic energy with c = 1/24, -1/48 or 0. */
static double turn_part(int64_t law)
{
    return law == VTI_LAW_CLOSED ? 1.0 / 24.0 : law == VTI_LAW_CAYLEY ? -1.0 / 48.0 : 0.0;
}

/** The series knows nothing where its terms overflow. */
static double or_nan(double energy)
{
    return isfinite(energy) ? energy : NAN;
}

struct energies modified_energies(struct modified *m, const vti_bodies *bodies, double total)
{
    struct energies e = {NAN, NAN};
    const vti_stepper *s = m->stepper;
    vti_bodies *p = &m->probe.bodies;
    if (m->probe.memory == NULL) /* rivals, of which some have no list of kicks */
        return e;
    /* the difference along a drift of t errs by t omega/2 of itself: little beside (h omega)^2, which the series leaves
     * out */
    const double h2 = m->h * m->h, t = m->h / 65536.0, late = 0.5 - s->kick[1] - s->lag;
    state_fork_take(&m->probe, *bodies);
    /* velocities to the middle of the step's two kicks, where VTI-3 is VTI-2 */
    if (late != 0.0)
        vti_kick(late * m->h, p);
    const double centred = total + (vti_kinetic_translation(p) - vti_kinetic_translation(bodies)) +
                           (vti_kinetic_rotation(p) - vti_kinetic_rotation(bodies));
    const double before = power(p), loads = squares(p), turns = turn_part(s->law) * fourths(p);
    e.kicked = or_nan(centred - h2 / 8.0 * loads);
    if (vti_drift(VTI_LAW_EXACT, (int)s->frame, t, p, NULL) != VTI_OK || model_forces(m->model, p) != VTI_OK)
        return e;
    e.modified = or_nan(centred + h2 * ((before - power(p)) / t / 12.0 - loads / 24.0 + turns));
    return e;
}
