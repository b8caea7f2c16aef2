/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Drag as the exact flow of velocities (EQUATIONS 6.3). With u = v - V, z = c t/m, E = exp(-z), phi = (t/m) (1 - E)/z
 * and k the quadratic coefficient,
 *
 *     m du/dt = -c u - k |u| u      u(t) = u E/(1 + k |u| phi)           (c = 0: u/(1 + k t |u|/m))
 *     J dOmega/dt = -c_r Omega      Omega(t) = Omega exp(-c_r t/J)
 *
 *     dL/dt = -c_r Omega            about each principal axis of a body with moments the same, by its own moment
 *
 * A sphere of a clump, with the tensor K of vti_joint.h at its centre: du/dt = -(c + k |u|) K u is linear in the time
 * tau, dtau = (c + k |u|) dt, and
 *
 *     u = exp(-K tau) u0,     tau = c t + ln(1 + k |u0| phi)/kappa,     kappa = u0.K u0/u0.u0,     phi of m = 1/kappa
 *
 * is exact where k = 0 or u0 is an eigenvector of K, of second order else, and gains nowhere. The spheres of a body do
 * not commute: one after the other, backwards in the reverse order.
 *
 * Booked is p.(v + v')/2, what the impulse p on the medium takes (6.1). */
#include "vti_drag_flow.h"
#include "vti_joint.h"
#include "../contacts/vti_touch_table.h"
#include "../vti_shares.h"
#include "../vti_ready.h"

static double value(const vti_scalars *s, int64_t i)
{
    return s->p != NULL ? vti_scalar(s, i) : 0.0;
}

static int slows(const vti_drag *p)
{
    return p->linear.p != NULL || p->quadratic.p != NULL;
}

/** The velocity of body i, the residual of compensated sums included. */
static void store(const vti_view *view, const vti_view *low, int64_t i, const double a[3], double kept)
{
    vti_store(view, i, a);
    for (int k = 0; k < 3 && vti_has(low); ++k)
        low->c[k][i * low->stride] = vti_settled(kept * low->c[k][i * low->stride]);
}

static void slow(const vti_drag *p, const vti_bodies *b, int64_t i, double t, vti_sum *lost)
{
    const double m = vti_scalar(&b->mass, i);
    double v[3];
    vti_load(&b->v, i, v);
    const double u[3] = {v[0] - p->medium[0], v[1] - p->medium[1], v[2] - p->medium[2]};
    const struct vti_decay e = vti_drag_decay(value(&p->linear, i), value(&p->quadratic, i), vti_norm(u), m, t);
    vti_sum_add(lost, vti_drag_slow(&e, p->medium, m, v));
    store(&b->v, &b->v_low, i, v, e.kept);
}

static void slow_turning(const vti_drag *p, const vti_bodies *b, int64_t i, double t, vti_sum *lost)
{
    static const double still[3] = {0.0, 0.0, 0.0};
    const double j = vti_scalar(&b->inertia, i);
    const struct vti_decay e = vti_drag_decay_linear(value(&p->angular, i), j, t);
    double w[3];
    vti_load(&b->omega, i, w);
    vti_sum_add(lost, vti_drag_slow(&e, still, j, w));
    store(&b->omega, &b->omega_low, i, w, e.kept);
}

/** L of a body of any inertia, about its principal axes. */
static void slow_axes(struct vti_joint *at, double c, double t, vti_sum *lost)
{
    const double each[3] = {c, c, c};
    struct vti_joint_modes axes = {.count = 3};
    double l[3];
    memcpy(axes.inverse_mass, at->side[0].per, sizeof axes.inverse_mass);
    memcpy(axes.along, at->side[0].axis, sizeof axes.along);
    vti_joint_decay(&axes, each, t, at->side[0].w, l);
    vti_sum_add(lost, vti_joint_lost(&axes, at->side[0].w, l));
    vti_joint_push(at, 1, l);
}

static const double centre[3];

static void slow_general(const vti_drag *p, const vti_bodies *b, int64_t i, double t, vti_sum *lost)
{
    const struct vti_bearing itself = {NULL, b};
    struct vti_joint at = {.side = {{.body = i}, {.body = -1}}};
    vti_joint_load(&itself, i, centre, &at.side[0]);
    slow_axes(&at, value(&p->angular, i), t, lost);
    vti_joint_store(&itself, &at.side[0]);
}

/* ---- spheres of clumps ------------------------------------------------------------------------------------------- */

/** Along the arm a sphere moves as its body does, by 1/m, and across it by what the two other modes of K are. */
static void find_modes(const struct vti_joint *at, struct vti_joint_modes *modes)
{
    const double *const arm = at->side[0].arm, length = vti_norm(arm);
    double n[3] = {1.0, 0.0, 0.0}, span[2][3];
    for (int k = 0; k < 3 && length > VTI_COINCIDENT; ++k)
        n[k] = arm[k] / length;
    vti_joint_across(n, span);
    vti_joint_modes_of(at, 0, 2, (const double(*)[3])span, modes);
    memcpy(modes->along[2], n, sizeof n);
    modes->inverse_mass[2] = at->side[0].per_m;
    modes->count = 3;
}

/** ln(1 + x) of x >= 0: by ln(1 + x) = 2 ln(1 + y), y = x/(1 + sqrt(1 + x)), until the series of 2 atanh(x/(2 + x))
 *  ends at (x/(2 + x))^12 < 2^-60. */
static double log_above(double x)
{
    double factor = 2.0, sum = 0.0;
    while (x > 1.0 / 16.0) {
        x /= 1.0 + sqrt(1.0 + x);
        factor *= 2.0;
    }
    const double y = x / (2.0 + x);
    for (int n = 5; n >= 0; --n)
        sum = 1.0 / (2 * n + 1) + y * y * sum;
    return factor * y * sum;
}

/** tau of a sphere with the velocity u beside the medium. */
static double exposure(const struct vti_joint_modes *modes, const double u[3], double c, double k, double t)
{
    const double uu = vti_dot(u, u);
    double kappa = 0.0;
    for (int m = 0; m < 3; ++m)
        kappa += modes->inverse_mass[m] * vti_dot(u, modes->along[m]) * vti_dot(u, modes->along[m]);
    if (!(k > 0.0 && kappa > 0.0))
        return c * t;
    kappa /= uu;
    const double z = c * t * kappa;
    const struct vti_decay e = vti_decay(z);
    return c * t + log_above(k * sqrt(uu) * t * kappa * vti_decay_mean(z, &e)) / kappa;
}

static void slow_sphere(const vti_drag *p, struct vti_joint *at, int64_t s, double t)
{
    struct vti_joint_modes modes;
    double v[3], u[3], push[3];
    find_modes(at, &modes);
    vti_joint_velocity(at, 0, v);
    for (int d = 0; d < 3; ++d)
        u[d] = v[d] - p->medium[d];
    const double tau = exposure(&modes, u, value(&p->linear, s), value(&p->quadratic, s), t), each[3] = {tau, tau, tau};
    vti_joint_decay(&modes, each, 1.0, u, push);
    vti_sum_add(&p->lost[0], vti_joint_lost(&modes, v, push));
    vti_joint_push(at, 0, push);
}

static void flow_spheres(const void *self, const vti_clumps *clumps, const vti_bodies *bodies, double t, double drift)
{
    const vti_drag *p = self;
    vti_sum own[VTI_DRAG_BOOKS];
    vti_drag single = *p; /* which books what one sphere loses */
    const struct vti_bearing of = {clumps, bodies};
    const vti_bodies spheres = vti_clumps_spheres(clumps, bodies);
    const int pushes = slows(p), back = drift < 0.0;
    struct vti_joint at = {.side = {{.body = -1}, {.body = -1}}};
    single.lost = own;
    for (int64_t k = 0; k < spheres.count; ++k) {
        const int64_t s = spheres.first + (back ? spheres.count - 1 - k : k);
        memset(own, 0, sizeof own);
        vti_joint_load(&of, s, centre, &at.side[0]);
        if (pushes && !back)
            slow_sphere(&single, &at, s, t);
        if (p->angular.p != NULL)
            slow_axes(&at, vti_scalar(&p->angular, s), t, &own[1]);
        if (pushes && back)
            slow_sphere(&single, &at, s, t);
        vti_joint_store(&of, &at.side[0]);
        vti_share_out(own, VTI_DRAG_BOOKS, p->lost, p->by_body, s, -1);
    }
}

/* ---- the effect -------------------------------------------------------------------------------------------------- */

static void flow_singly(const vti_drag *p, const vti_bodies *b, double t, double drift);

/** One motion of all bodies: by kernels, which leave over what they cannot do, or else one by one. */
static void slow_all(const vti_drag *p, const vti_bodies *b, double t, int singly,
                     void (*one)(const vti_drag *p, const vti_bodies *b, int64_t i, double t, vti_sum *lost), int book)
{
    const int64_t end = b->first + b->count;
    for (int64_t i = b->first; i < end; ++i) {
        if (!singly)
            i = vti_touch_kernels_for(end - i)->drag(p, b, t, book, i, end);
        if (i < end)
            one(p, b, i, t, &p->lost[book]);
    }
}

static void flow(const void *self, const vti_bodies *b, double t, double drift)
{
    const vti_drag *p = self;
    if (p->by_body != NULL) {
        flow_singly(p, b, t, drift);
        return;
    }
    if (slows(p))
        slow_all(p, b, t, vti_has(&b->v_low), slow, 0);
    if (p->angular.p != NULL && vti_has(&b->moments))
        slow_all(p, b, t, 1, slow_general, 1);
    else if (p->angular.p != NULL)
        slow_all(p, b, t, vti_has(&b->omega_low), slow_turning, 1);
}

/** Bodies one by one, so that what each loses is known. */
static void flow_singly(const vti_drag *p, const vti_bodies *b, double t, double drift)
{
    vti_drag single = *p;
    single.by_body = NULL;
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        const vti_bodies body = vti_bodies_slice(*b, i, 1);
        vti_sum own[VTI_DRAG_BOOKS] = {{0.0, 0.0}};
        single.lost = own;
        flow(&single, &body, t, drift);
        vti_share_out(own, VTI_DRAG_BOOKS, p->lost, p->by_body, i, -1);
    }
}

static int are_good(const vti_scalars *s, const vti_bodies *b)
{
    int good = 1;
    const int64_t end = s->stride == 0 ? b->first + (b->count > 0) : b->first + b->count;
    for (int64_t i = b->first; s->p != NULL && i < end; ++i)
        good &= isfinite(vti_scalar(s, i)) && vti_scalar(s, i) >= 0.0;
    return good;
}

/** Whether what it slows now is there. */
static int has_needs(const vti_drag *p, const vti_bodies *b)
{
    return (!slows(p) || (vti_has(&b->v) && b->mass.p != NULL)) && (p->angular.p == NULL || vti_has(&b->omega));
}

/** One value for all is looked at; arrays, where the library was built to look, are if they are long enough. */
static int check(const void *self, const vti_bodies *b)
{
    const vti_drag *p = self;
    const vti_scalars *const all[] = {&p->linear, &p->quadratic, &p->angular};
    if (!has_needs(p, b))
        return VTI_E_NEEDS;
    int good = isfinite(p->medium[0]) && isfinite(p->medium[1]) && isfinite(p->medium[2]);
    for (int k = 0; k < 3; ++k) {
        if (all[k]->p != NULL && vti_ends_before(all[k], b->first + b->count - 1))
            return VTI_E_COUNT;
        if (VTI_LOOKS || all[k]->stride == 0)
            good &= are_good(all[k], b);
    }
    if (!good)
        return VTI_E_DAMPING;
    if (p->lost == NULL)
        return VTI_E_NULL;
    return p->angular.p != NULL && b->inertia.p == NULL && !vti_has(&b->moments) ? VTI_E_INERTIA : VTI_OK;
}

vti_effect vti_drag_effect(const vti_drag *drag)
{
    static const char *const book[VTI_DRAG_BOOKS] = {"lost_drag_translation", "lost_drag_rotation"};
    const int64_t force = 1 << VTI_QUANTITY_V | 1 << VTI_QUANTITY_MASS, moment = 1 << VTI_QUANTITY_OMEGA;
    if (drag == NULL || drag->lost == NULL)
        return vti_effect_none();
    const int pushes = slows(drag), turns = drag->angular.p != NULL;
    const vti_effect effect = {.name = "drag",
                               .check = check,
                               .springs = vti_springs_none,
                               .flow = flow,
                               .flow_clumps = flow_spheres,
                               .self = drag,
                               .needs = (pushes ? force : 0) | (turns ? moment : 0),
                               .smooth = 1,
                               .settles = 1,
                               .breaks = (pushes ? VTI_BREAKS_LINEAR | VTI_BREAKS_ANGULAR : 0) |
                                         (turns ? VTI_BREAKS_ANGULAR | VTI_BREAKS_SPINS : 0),
                               .dissipates = 1,
                               .books = pushes + turns,
                               .book = book + !pushes,
                               .booked = drag->lost + !pushes,
                               .by_body = drag->by_body != NULL ? drag->by_body + !pushes : NULL,
                               .of_body = VTI_DRAG_BOOKS};
    return effect;
}
