/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Kicks and drifts of bodies with three moments (EQUATIONS 7.1, 7.2), one after the other: kick(t) is L += t RM,
 * drift(t) the increment of vti_rotor.h onto the attitude, and L stays as it is. */
#define VTI_WIDTH 1
#include "vti_rotor.h"

#include "../vti_move_body.h"
#include "../vti_moments.h"
#include "../vti_ready.h"

/* ---- one body ---------------------------------------------------------------------------------------------------- */

static void body_of(const vti_bodies *b, int64_t i, struct rotor_body *body)
{
    double a[4] = {0.0, 0.0, 0.0, 1.0}, p[4];
    if (vti_has_attitude(b))
        vti_load_pair(b, i, a);
    for (int k = 0; k < 4 && vti_has_attitude(b) && vti_has(&b->alpha); ++k)
        a[k] *= 0.5; /* alpha/2 and 1, as in the kernels */
    for (int k = 0; k < 4; ++k) {
        p[k] = b->principal.xyzw[0] != NULL ? b->principal.xyzw[k][i * b->principal.stride] : 0.0;
        body->q[k] = a[k];
    }
    if (b->principal.xyzw[0] != NULL)
        rotor_principal(a, p, body->q);
    body->square = vti_pair_square(body->q);
    body->turned = b->principal.xyzw[0] != NULL;
    vti_load(&b->moments, i, body->m);
}

void vti_rotor_over(const vti_bodies *b, int64_t i, const vti_view *L, double w[3])
{
    struct rotor_body body;
    body_of(b, i, &body);
    vti_load(L, i, w);
    rotor_times(&body, 1, w, w);
}

void vti_rotor_axes(const vti_bodies *b, int64_t i, double per[3], double axis[3][3])
{
    struct rotor_body body;
    body_of(b, i, &body);
    const double scale = 2.0 / body.square;
    for (int k = 0; k < 3; ++k) {
        const double e[3] = {k == 0, k == 1, k == 2};
        per[k] = 1.0 / body.m[k];
        lanes_rotate(body.q, scale, 1.0, e, axis[k]);
    }
}

/** L after the kicks: of spin, or by way of Omega += t R_p diag(k) R_p^T RM. Kicks are stored if they are to be. */
static void kicked(const struct vti_move *move, const vti_bodies *b, int64_t i, const struct rotor_body *body,
                   int stores, double L[3])
{
    const int spins = vti_has(&b->spin), carries = spins && vti_has(&b->spin_low);
    const vti_view *const view = spins ? &b->spin : &b->omega;
    double low[3] = {0.0, 0.0, 0.0}, by[3];
    const vti_view carried = carries ? (vti_view){{low, low + 1, low + 2}, 0, 0} : vti_view_none();
    vti_load(view, i, L);
    if (vti_has(&b->moment) && (move->before != 0.0 || move->kick != 0.0)) {
        vti_load(&b->moment, i, by);
        if (!spins)
            rotor_times(body, 1, by, by);
        if (carries)
            vti_load(&b->spin_low, i, low);
        if (move->before != 0.0)
            add_by(move->before, by, &carried, 0, L);
        if (move->kick != 0.0)
            add_by(move->kick, by, &carried, 0, L);
        if (stores)
            vti_store(view, i, L);
        if (stores && carries)
            vti_store(&b->spin_low, i, low);
    }
    if (!spins)
        rotor_times(body, 0, L, L);
}

void vti_rotor_spin(const vti_bodies *b, int64_t i, double L[3])
{
    const struct vti_move none = {.drift = 0.0};
    struct rotor_body body;
    body_of(b, i, &body);
    kicked(&none, b, i, &body, 0, L);
}

struct vti_rotor_rates vti_rotor_rates_of(const vti_bodies *b, int64_t i)
{
    struct rotor_body body;
    double L[3], p[3], w[3];
    vti_rotor_spin(b, i, L);
    body_of(b, i, &body);
    struct rotor_moments along;
    const struct rotor_axes at = rotor_axes_of(body.m, &along);
    const struct rotor_rates per = rotor_rates_of(1.0, &along);
    lanes_rotate(body.q, 2.0 / body.square, -1.0, L, p);
    struct vti_rotor_rates rates = {.energy = 0.0};
    for (int k = 0; k < 3; ++k) {
        w[k] = p[k] / body.m[k];
        rates.energy += 0.5 * w[k] * p[k];
    }
    rotor_onto(&at, p, p);
    const double turns[3] = {per.turn * vti_norm(L), 2.0 * fabs(per.half[0] * p[0]), 2.0 * fabs(per.half[1] * p[1])};
    rates.most = vti_norm(w);
    for (int k = 0; k < 3; ++k)
        rates.most = vti_larger(rates.most, turns[k]);
    return rates;
}

/* ---- drift ------------------------------------------------------------------------------------------------------- */

typedef void drift(const struct rotor_start *from, const struct rotor_body *body, struct rotor_increment *d);

/* Literal arguments, so that each law and each rotor is code of its own. */
#define DRIFT(LAW, ROTOR)                                                                                              \
    static void drift_##LAW##_##ROTOR(const struct rotor_start *from, const struct rotor_body *body,                   \
                                      struct rotor_increment *d)                                                       \
    {                                                                                                                  \
        rotor_drift(VTI_LAW_##LAW, ROTOR, &from, body, d, 1);                                                          \
    }
#define LAWS(ROTOR)                                                                                                    \
    DRIFT(CLOSED, ROTOR)                                                                                               \
    DRIFT(CAYLEY, ROTOR)                                                                                               \
    DRIFT(EXACT, ROTOR)                                                                                                \
    DRIFT(EXACT9, ROTOR)
LAWS(2)
LAWS(4)
LAWS(6)

#define BY_LAW(ROTOR)                                                                                                  \
    {                                                                                                                  \
        NULL, drift_CLOSED_##ROTOR, drift_CAYLEY_##ROTOR, drift_EXACT_##ROTOR, drift_EXACT9_##ROTOR                    \
    }
/** [half of the rotor, less 1][law] */
static drift *const drifts[3][VTI_LAW_EXACT9 + 1] = {BY_LAW(2), BY_LAW(4), BY_LAW(6)};

/** 2, 4 or 6 */
static int rotor_of(const struct vti_move *move)
{
    return move->rotor == 0 ? 2 : move->rotor;
}

/** Where a drift begins; in another unit of moments and L, if their products leave the range. */
static void start_of(double t, const struct rotor_body *body, const double L[3], struct rotor_start *from)
{
    rotor_start_of(t, body, L, from);
    const double largest = vti_max3(body->m);
    if (from->range < ROTOR_RANGE || !vti_is_positive(largest))
        return;
    const int size = ilogb(largest);
    struct rotor_body same = *body;
    double l[3];
    for (int k = 0; k < 3; ++k) {
        same.m[k] = scalbn(body->m[k], -size);
        l[k] = scalbn(L[k], -size);
    }
    rotor_start_of(t, &same, l, from);
}

/** A drift by turns so large that their squares leave the range: they have long lost their fraction of a turn, and any
 *  finite ones are as good. */
static void drift_hard(int law, int rotor, double t, const struct rotor_body *body, const double L[3],
                       struct rotor_increment *d)
{
    const double size = vti_max3(L);
    const double n[3] = {size > 0.0 ? L[0] / size : L[0], size > 0.0 ? L[1] / size : L[1],
                         size > 0.0 ? L[2] / size : L[2]};
    struct rotor_start start;
    const struct rotor_start *const from = &start;
    struct rotor_list list = {.hard = 1};
    double u[3];
    start_of(1.0, body, n, &start);
    const double unit = vti_max3(start.p), rate = start.turn * unit;
    for (int k = 0; k < 3; ++k) {
        start.p[k] /= unit > 0.0 ? unit : 1.0;
        u[k] = t == 0.0 ? 0.0 : t * (rate * (size * start.p[k]));
        u[k] = isinf(u[k]) ? copysign(0x1p1000, u[k]) : u[k];
    }
    for (int k = 0; k < 2; ++k)
        start.e[k] *= (t * size) * unit; /* however large: the turns are cut */
    start.square = vti_dot(start.p, start.p);
    start.about_x = (start.e[0] * start.e[0]) * start.square;
    rotor_lists_of(law, rotor, &from, &list, 1);
    const struct increment whole = increment(law, u);
    const double *const cf = whole.cf, most = fabs(cf[1]) * vti_max3(u),
                        s = vti_scale(most > fabs(cf[0]) ? most : cf[0]);
    rotor_join(body, start.scale, &start.at, list.b, s * cf[0], s * cf[1], u, d);
    const double largest_u = vti_max3(d->u), back = vti_scale(largest_u > fabs(d->c) ? largest_u : fabs(d->c));
    d->c *= back;
    for (int k = 0; k < 3; ++k)
        d->u[k] *= back;
}

/** The increment of a sphere, however far it turns. */
static void drift_sphere(int law, double t, const struct rotor_body *body, const double L[3], struct rotor_increment *d)
{
    rotor_sphere(law, t, 1.0 / body->m[0], L, d);
    for (int k = 0; k < 3; ++k)
        d->u[k] = t == 0.0 ? 0.0 : isinf(d->u[k]) ? copysign(0x1p1000, d->u[k]) : d->u[k];
    const struct increment whole = increment(law, d->u);
    d->c = whole.cf[0];
    d->f = whole.cf[1];
}

/** Returns its side: 1 in space, -1 in the body. */
static double find_increment(const struct vti_move *move, const struct rotor_body *body, const double L[3],
                             struct rotor_increment *d)
{
    const int rotor = rotor_of(move);
    if (rotor_is_round(body->m)) {
        drift_sphere(move->law, move->drift, body, L, d);
        return 1.0;
    }
    struct rotor_start from;
    start_of(move->drift, body, L, &from);
    drifts[rotor / 2 - 1][move->law](&from, body, d);
    const double size = d->c * d->c + d->f * d->f * vti_dot(d->u, d->u);
    if (!(size < 0x1p100 && size > 0x1p-100))
        drift_hard(move->law, rotor, move->drift, body, L, d);
    return rotor_side(body);
}

/** Where vti_rrv_increment would take its incremental form, with the operations of the kernels. */
static int turn_incremental(const struct rotor_increment *d, double side, const vti_view *alpha, int64_t i)
{
    double a[3], add[3];
    vti_load(alpha, i, a);
    const double half[3] = {0.5 * a[0], 0.5 * a[1], 0.5 * a[2]};
    const double dot = rotor_incremental(d->c, d->u, side, half, add);
    if (!(d->c > VTI_RRV_SMALL && d->c < VTI_RRV_LARGE && vti_max3(d->u) < VTI_RRV_NEAR * d->c) ||
        !(vti_max3(a) < VTI_RRV_NEAR && 4.0 * fabs(dot) < d->c))
        return 0;
    for (int k = 0; k < 3; ++k)
        a[k] += add[k];
    vti_store(alpha, i, a);
    return 1;
}

static void turn_one(const struct vti_move *move, const vti_bodies *b, int64_t i, const struct rotor_body *body,
                     const double L[3])
{
    struct rotor_increment d;
    const double side = find_increment(move, body, L, &d);
    const struct increment whole = {{d.c, d.f}, 0};
    if (!vti_has(&b->alpha))
        turn_quat(whole, side, d.u, &b->quat, i);
    else if (vti_has(&b->alpha_low))
        turn_compensated(whole, side, d.u, &b->alpha, &b->alpha_low, i);
    else if (rotor_is_round(body->m) || !turn_incremental(&d, side, &b->alpha, i))
        turn_alpha(whole, side, d.u, &b->alpha, i);
}

/** The drift is its own adjoint, and L stays as it is in it: -t leads back to where it began. */
void vti_rotor_turned(const vti_bodies *b, int64_t i, const vti_drifted *drifted, int steady, double a[3])
{
    /* shorter by less than rounding, so that turns of the closed form stay below 1 on the way back as well */
    const struct vti_move back = {
        .drift = -(1.0 - 0x1p-50) * drifted->t, .law = (int)drifted->law, .rotor = (int)drifted->rotor};
    struct rotor_body body;
    struct rotor_increment d;
    double L[3], w[3], before[3];
    body_of(b, i, &body);
    vti_rotor_spin(b, i, L);
    const double side = find_increment(&back, &body, L, &d);
    a[0] = a[1] = a[2] = 0.0;
    vti_rrv_turn_by(d.c, d.f, d.u, 0, 1.0, a);
    if (side < 0.0) { /* in the body's frame */
        double q[4];
        vti_load_pair(b, i, q);
        vti_pair_rotate(q, 1.0, a, a);
    }
    if (steady) { /* Omega before it is R^T J^-1 R L, R being that of the increment and J as it is now */
        vti_rrv_rotate_back(a, L, before);
        rotor_times(&body, 1, before, before);
        vti_rrv_rotate(a, before, before);
        rotor_times(&body, 1, L, w);
    }
    for (int k = 0; k < 3; ++k)
        a[k] = steady ? 0.5 * drifted->t * (before[k] + w[k]) : -a[k];
}

/* ---- all of them ------------------------------------------------------------------------------------------------- */

static void move_one(const struct vti_move *move, const vti_bodies *b, int64_t i)
{
    const int drifts_too = move->drifts && vti_has_attitude(b);
    struct rotor_body body;
    double L[3], w[3];
    body_of(b, i, &body);
    kicked(move, b, i, &body, 1, L);
    if (drifts_too) {
        turn_one(move, b, i, &body, L);
        body_of(b, i, &body);
    }
    if (vti_has(&b->omega) && vti_has_attitude(b) && (drifts_too || vti_has(&b->spin))) {
        rotor_times(&body, 1, L, w);
        vti_store(&b->omega, i, w);
    }
}

void vti_rotor_move(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    if (!vti_has(&b->spin) && !vti_has(&b->omega))
        return;
    for (int64_t i = begin; i < end; ++i)
        move_one(move, b, i);
}

/** The largest turn of the drift, after the kicks. */
static double most_of(const struct vti_move *move, const vti_bodies *b, int64_t i)
{
    struct rotor_body body;
    double L[3];
    body_of(b, i, &body);
    kicked(move, b, i, &body, 0, L);
    if (rotor_is_round(body.m)) {
        struct rotor_increment d;
        rotor_sphere(VTI_LAW_CLOSED, move->drift, 1.0 / body.m[0], L, &d);
        return sqrt(vti_dot(d.u, d.u));
    }
    struct rotor_start from;
    start_of(move->drift, &body, L, &from);
    return rotor_most(VTI_LAW_CLOSED, rotor_of(move), &from);
}

int vti_rotor_check(const struct vti_move *move, const vti_bodies *b, vti_fault *fault)
{
    if (move->frame != VTI_FRAME_SPACE)
        return vti_refuse(VTI_E_FRAME, -1, 0.0, VTI_QUANTITY_MOMENTS, fault);
    if (!vti_is_rotor(move->rotor))
        return VTI_E_STEPPER;
    if (move->law != VTI_LAW_CLOSED || !vti_has_attitude(b) || (!vti_has(&b->spin) && !vti_has(&b->omega)))
        return VTI_OK;
    int status = VTI_OK;
    double worst = -1.0;
    for (int64_t i = vti_move_below(move, b); i < b->first + b->count && !isnan(worst); ++i) {
        const double most = most_of(move, b, i);
        if (!(most < 1.0) && !(most <= worst)) {
            worst = most;
            status =
                vti_refuse(VTI_E_TOO_LARGE, i, most, vti_has(&b->spin) ? VTI_QUANTITY_SPIN : VTI_QUANTITY_OMEGA, fault);
        }
    }
    return status;
}
