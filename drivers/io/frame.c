/* SPDX-License-Identifier: BSD-3-Clause */
#include "record.h"

#include <stddef.h>
#include <string.h>

#include "shape.h"

/** Takes so many doubles from *next on. */
static int64_t place(int64_t doubles, int64_t *next)
{
    *next += doubles;
    return *next - doubles;
}

void frame_layout_of(const struct model *model, int fields, struct frame_layout *layout)
{
    const vti_bodies *b = &model->bodies;
    int64_t next = 2;
    memset(layout, 0, sizeof *layout);
    layout->model = layout->booking = model;
    layout->n = b->count;
    layout->translates = b->v.c[0] != NULL;
    layout->turns = b->omega.c[0] != NULL;
    layout->x = place(3 * b->count, &next);
    if (layout->translates)
        layout->v = place(3 * b->count, &next);
    if (layout->turns) {
        layout->omega = place(3 * b->count, &next);
        layout->alpha = place(3 * b->count, &next);
    }
    if ((fields & FIELD_FORCE) != 0)
        layout->force = place(3 * b->count, &next);
    if ((fields & FIELD_MOMENT) != 0)
        layout->moment = place(3 * b->count, &next);
    layout->entries = model_body_books(model, layout->entry);
    if (layout->entries > 0)
        layout->lost = place(layout->entries * b->count, &next);
    layout->doubles = next;
}

/** Where body i stands. */
static int64_t at(const struct frame_layout *layout, int64_t i)
{
    return 3 * (layout->number != NULL ? layout->number[i] : i);
}

static void copy(const struct frame_layout *layout, const vti_view *view, double *to)
{
    for (int64_t i = 0; i < layout->n; ++i)
        for (int k = 0; k < 3; ++k)
            to[at(layout, i) + k] = view->c[k][i * view->stride];
}

void frame_take(const struct frame_layout *layout, int64_t step, double t, const vti_bodies *bodies, double *frame)
{
    frame[0] = (double)step;
    frame[1] = t;
    for (int64_t i = 0; i < layout->n; ++i)
        shape_centre(layout->model, bodies, i, frame + layout->x + at(layout, i));
    if (layout->translates)
        copy(layout, &bodies->v, frame + layout->v);
    if (layout->turns) {
        copy(layout, &bodies->omega, frame + layout->omega);
        copy(layout, &bodies->alpha, frame + layout->alpha);
    }
    if (layout->force != 0)
        copy(layout, &bodies->force, frame + layout->force);
    if (layout->moment != 0)
        copy(layout, &bodies->moment, frame + layout->moment);
    for (int64_t k = 0; k < layout->entries; ++k)
        model_body_booked(layout->booking, k, layout->number, frame + layout->lost + k * layout->n);
}

void frame_lost(const struct frame_layout *layout, const double *frame, double *lost)
{
    memset(lost, 0, (size_t)layout->n * sizeof *lost);
    for (int64_t k = 0; k < layout->entries; ++k)
        for (int64_t i = 0; i < layout->n && strncmp(layout->entry[k], "lost_", 5) == 0; ++i)
            lost[i] += frame[layout->lost + k * layout->n + i];
}

void frame_attitudes(const struct frame_layout *layout, const double *frame, double *xyzw)
{
    for (int64_t i = 0; i < layout->n; ++i)
        vti_rrv_to_quat_xyzw(frame + layout->alpha + 3 * i, xyzw + 4 * i);
}

void frame_attitudes_w_first(const struct frame_layout *layout, const double *frame, double *wxyz)
{
    frame_attitudes(layout, frame, wxyz);
    for (double *q = wxyz; q < wxyz + 4 * layout->n; q += 4) {
        const double w = q[3];
        q[3] = q[2];
        q[2] = q[1];
        q[1] = q[0];
        q[0] = w;
    }
}

void frame_directors(const struct frame_layout *layout, const double *frame, double *directors)
{
    static const double x_axis[3] = {1.0, 0.0, 0.0};
    for (int64_t i = 0; i < layout->n; ++i)
        vti_rrv_rotate(frame + layout->alpha + 3 * i, x_axis, directors + 3 * i);
}

/** P of body i as a rescaled Rodrigues vector. */
static void principal_of(const vti_quat_view *principal, int64_t i, double p[3])
{
    double q[4] = {0.0, 0.0, 0.0, 1.0};
    for (int k = 0; k < 4 && principal->xyzw[0] != NULL; ++k)
        q[k] = principal->xyzw[k][i * principal->stride];
    vti_rrv_from_quat_xyzw(q, p);
}

void frame_principal(const struct frame_layout *layout, const double *frame, int64_t i, double xyzw[4])
{
    double p[3], r[3];
    principal_of(&layout->model->bodies.principal, i, p);
    vti_rrv_compose(p, frame + layout->alpha + 3 * i, r);
    vti_rrv_to_quat_xyzw(r, xyzw);
}

void frame_ellipsoids(const struct frame_layout *layout, const double *frame, double *tensors)
{
    for (int64_t i = 0; i < layout->n; ++i) {
        double axes[3], p[3], *tensor = tensors + 9 * i;
        shape_axes(layout->model, i, axes);
        principal_of(&layout->model->bodies.principal, i, p);
        for (int k = 0; k < 9; ++k)
            tensor[k] = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double unit[3] = {axis == 0, axis == 1, axis == 2};
            double body[3], u[3];
            vti_rrv_rotate(p, unit, body);
            vti_rrv_rotate(frame + layout->alpha + 3 * i, body, u);
            for (int k = 0; k < 9; ++k)
                tensor[k] += axes[axis] * u[k / 3] * u[k % 3];
        }
    }
}

void frame_sphere(const struct frame_layout *layout, const double *frame, int64_t s, double x[3], double v[3])
{
    const vti_clumps *clumps = &layout->model->clumps.list;
    const int64_t i = 3 * clumps->body[s];
    double r[3], turn[3];
    vti_rrv_rotate(frame + layout->alpha + i, clumps->offset + 3 * s, r);
    vti_cross(frame + layout->omega + i, r, turn);
    for (int k = 0; k < 3; ++k) {
        x[k] = frame[layout->x + i + k] + r[k];
        v[k] = frame[layout->v + i + k] + turn[k];
    }
}

int frame_has_fragments(const struct frame_layout *layout)
{
    return shape_breaking(layout->model) != NULL;
}

void frame_fragments(const struct frame_layout *layout, const double *frame, double *fragment)
{
    const struct effect *breaking = shape_breaking(layout->model);
    breaking->kind->breaks->fragments(breaking, (int64_t)frame[0], fragment);
}

int frame_quantities(const struct record *record, struct frame_quantity list[FRAME_QUANTITIES])
{
    const struct frame_layout *layout = &record->frames;
    const struct frame_quantity known[FRAME_KNOWN] = {{"velocity", layout->v, 3, NULL},
                                                      {"omega", layout->omega, 3, NULL},
                                                      {"alpha", layout->alpha, 3, NULL},
                                                      {"attitude_xyzw", layout->alpha, 4, frame_attitudes},
                                                      {"attitude_wxyz", layout->alpha, 4, frame_attitudes_w_first},
                                                      {"director", layout->alpha, 3, frame_directors},
                                                      {"ellipsoid", shape_has_axes(record->model), 9, frame_ellipsoids},
                                                      {"force", layout->force, 3, NULL},
                                                      {"moment", layout->moment, 3, NULL},
                                                      {"fragment", frame_has_fragments(layout), 1, frame_fragments},
                                                      {"lost", layout->lost, 1, frame_lost}};
    int count = 0;
    for (int k = 0; k < FRAME_KNOWN; ++k)
        if (known[k].place != 0)
            list[count++] = known[k];
    for (int64_t k = 0; k < layout->entries; ++k)
        list[count++] = (struct frame_quantity){layout->entry[k], layout->lost + k * layout->n, 1, NULL};
    return count;
}

/* ---- what effects say of a frame --------------------------------------------------------------------------------- */

vti_bodies frame_bodies(const struct frame_layout *layout, const double *frame)
{
    double *state = (double *)frame; /* views are of what may be written; effects write forces and moments only */
    vti_bodies b = layout->model->bodies;
    b.spin = vti_view_none();
    b.x_low = b.v_low = b.alpha_low = b.omega_low = vti_view_none();
    if (layout->translates) {
        b.x = vti_view_packed(state + layout->x);
        b.v = vti_view_packed(state + layout->v);
    }
    if (layout->turns) {
        b.omega = vti_view_packed(state + layout->omega);
        b.alpha = vti_view_packed(state + layout->alpha);
    }
    return b;
}
