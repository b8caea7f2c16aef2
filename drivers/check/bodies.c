/* SPDX-License-Identifier: BSD-3-Clause */
#include "check.h"

#include <string.h>

struct bodies vti_kit_bodies_none(int64_t n)
{
    struct bodies b;
    memset(&b, 0, sizeof b);
    b.n = n;
    for (int i = 0; i < VTI_CHECK_BODIES; ++i)
        b.q[4 * i + 3] = b.mass[i] = b.inertia[i] = 1.0;
    return b;
}

static int all_finite(const double *a, int64_t n)
{
    for (int64_t k = 0; k < n; ++k)
        if (!isfinite(a[k]))
            return 0;
    return 1;
}

int vti_kit_bodies_are_finite(const struct bodies *b)
{
    return all_finite(b->x, 3 * b->n) && all_finite(b->v, 3 * b->n) && all_finite(b->q, 4 * b->n) &&
           all_finite(b->w, 3 * b->n);
}

void vti_kit_bodies_lose(struct bodies *b)
{
    for (int k = 0; k < 3 * VTI_CHECK_BODIES; ++k)
        b->x[k] = b->v[k] = b->w[k] = NAN;
    for (int k = 0; k < 4 * VTI_CHECK_BODIES; ++k)
        b->q[k] = NAN;
}

/* ---- forces ------------------------------------------------------------------------------------------------------ */

/** q/|q|: directions are those of the attitude, whatever the host does to its norm. */
static void normalised(const double *q, double *unit)
{
    const double norm = sqrt(vti_dot(q, q) + q[3] * q[3]), k = norm > 0.0 ? 1.0 / norm : NAN;
    for (int c = 0; c < 4; ++c)
        unit[c] = k * q[c];
}

static vti_quat_view quats(double *q)
{
    const vti_quat_view view = {{q, q + 1, q + 2, q + 3}, 4, 0};
    return view;
}

void vti_kit_bodies_forces(const struct field *field, int64_t n, const double *x, const double *q, double *force,
                           double *moment)
{
    if (!all_finite(x, 3 * n) || !all_finite(q, 4 * n)) {
        for (int64_t k = 0; k < 3 * n; ++k)
            force[k] = moment[k] = NAN;
        return;
    }
    struct bodies at = vti_kit_bodies_none(n);
    memcpy(at.x, x, (size_t)(3 * n) * sizeof *x);
    for (int64_t i = 0; i < n; ++i)
        normalised(q + 4 * i, at.q + 4 * i);
    vti_bodies b = vti_kit_bodies_views(&at);
    b.force = vti_view_packed(force);
    b.moment = vti_view_packed(moment);
    memset(force, 0, (size_t)(3 * n) * sizeof *force);
    memset(moment, 0, (size_t)(3 * n) * sizeof *moment);
    vti_apply(&field->effect, field->count, &b);
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

void vti_kit_bodies_advance_reference(struct bodies *b, const struct field *field, double h, int64_t steps)
{
    const vti_stepper *method = vti_stepper_find("srkn11");
    double force[3 * VTI_CHECK_BODIES], moment[3 * VTI_CHECK_BODIES];
    vti_bodies bodies = vti_kit_bodies_views(b);
    bodies.force = vti_view_packed(force);
    bodies.moment = vti_view_packed(moment);
    int status = vti_apply(&field->effect, field->count, &bodies);
    for (int64_t k = 0; k < steps && status == VTI_OK; ++k) {
        for (int64_t stage = 0; stage < method->stages && status == VTI_OK; ++stage) {
            status = vti_step_stage(method, stage, h, &bodies, NULL);
            if (status == VTI_OK)
                status = vti_apply(&field->effect, field->count, &bodies);
        }
        if (status == VTI_OK)
            status = vti_step_finish(method, h, &bodies);
    }
    if (status != VTI_OK)
        vti_kit_bodies_lose(b);
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

vti_bodies vti_kit_bodies_views(const struct bodies *b)
{
    /* views are made for bodies that may move; who only reads does not move them */
    struct bodies *s = (struct bodies *)b;
    vti_bodies bodies = vti_bodies_none(b->n);
    bodies.x = vti_view_packed(s->x);
    bodies.v = vti_view_packed(s->v);
    bodies.quat = quats(s->q);
    bodies.omega = vti_view_packed(s->w);
    bodies.mass = vti_scalars_array(b->mass);
    bodies.inertia = vti_scalars_array(b->inertia);
    return bodies;
}

double vti_kit_bodies_energy(const struct bodies *b, const struct field *field)
{
    struct bodies unit = *b;
    if (!vti_kit_bodies_are_finite(b))
        return NAN;
    for (int64_t i = 0; i < b->n; ++i)
        normalised(b->q + 4 * i, unit.q + 4 * i);
    const vti_bodies bodies = vti_kit_bodies_views(&unit);
    return vti_energy(&field->effect, field->count, &bodies);
}

void vti_kit_bodies_alpha(const struct bodies *b, int64_t i, double alpha[3])
{
    vti_rrv_from_quat_xyzw(b->q + 4 * i, alpha);
}

void vti_kit_bodies_set_alpha(struct bodies *b, int64_t i, const double alpha[3])
{
    vti_rrv_to_quat_xyzw(alpha, b->q + 4 * i);
}

static double most_apart(const double *a, const double *b, int64_t n)
{
    double most = 0.0;
    for (int64_t k = 0; k < n; ++k)
        most = fmax(most, fabs(a[k] - b[k]));
    return most;
}

struct apart vti_kit_bodies_apart(const struct bodies *a, const struct bodies *b)
{
    struct apart d = {NAN, NAN, NAN, NAN};
    if (!vti_kit_bodies_are_finite(a) || !vti_kit_bodies_are_finite(b))
        return d;
    d.x = most_apart(a->x, b->x, 3 * a->n);
    d.v = most_apart(a->v, b->v, 3 * a->n);
    d.w = most_apart(a->w, b->w, 3 * a->n);
    d.attitude = 0.0;
    for (int64_t i = 0; i < a->n; ++i) {
        double p[3], q[3];
        vti_kit_bodies_alpha(a, i, p);
        vti_kit_bodies_alpha(b, i, q);
        d.attitude = fmax(d.attitude, vti_rrv_distance(p, q));
    }
    return d;
}
