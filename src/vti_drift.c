/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The second of the two primitives of every stepper (EQUATIONS 2), in loops as those of vti_kick.c:
 *
 *     drift(t): x += t v,  alpha <- alpha (+) dalpha(t Omega)                                                        */
#include "vti_sum.h"

/* ---- drift of positions -------------------------------------------------------------------------------------- */

static inline void translate_loop(double *restrict x0, double *restrict x1, double *restrict x2, int64_t sx,
                                  const double *restrict v0, const double *restrict v1, const double *restrict v2,
                                  int64_t sv, double t, int64_t begin, int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        x0[i * sx] += t * v0[i * sv];
        x1[i * sx] += t * v1[i * sv];
        x2[i * sx] += t * v2[i * sv];
    }
}

/** x += t v */
static void translate(double t, const vti_view *x, const vti_view *v, const vti_view *low, int64_t begin, int64_t end)
{
    if (vti_has(low)) {
        vti_sum_compensated(t, x, v, NULL, low, begin, end);
        return;
    }
#define TRANSLATE(SX, SV) translate_loop(x->c[0], x->c[1], x->c[2], SX, v->c[0], v->c[1], v->c[2], SV, t, begin, end)
    if (vti_is_packed(x) && vti_is_packed(v))
        vti_sum_packed(x->c[0] + 3 * begin, v->c[0] + 3 * begin, t, 3 * (end - begin));
    else if (x->stride == 1 && v->stride == 1)
        TRANSLATE(1, 1);
    else
        TRANSLATE(x->stride, v->stride);
#undef TRANSLATE
}

/* ---- drift of attitudes -------------------------------------------------------------------------------------- */

/** The increment dalpha = 2 f u/c of a body that turns by u = t Omega. small: as in vti_rrv_increment. */
struct increment {
    double c, f;
    int small;
};

/** With s^2 = u.u,
 *      closed, VTI-1     dalpha = 2 u/(1 + sqrt(1 - s^2))
 *      Cayley, VTI-2, 3  dalpha = u
 *      exact             dalpha = 2 tan(s/2)/s u by its continued fraction, without a pole as
 *                        c = 2 - s^2/5, f = 1 - s^2/60;  c = 2 - 3s^2/14 + s^4/840, f = 1 - s^2/42
 *  Where s^2 would overflow, s has long lost its fraction of a turn: a half turn, c = 0, is as good as any.
 *  Below s^2 = 8, c > 0.36 in both of the exact. */
VTI_INLINE struct increment increment(int law, const double u[3])
{
    if (law == VTI_LAW_CAYLEY)
        return (struct increment){2.0, 1.0, 0};
    const double s2 = vti_dot(u, u);
    if (law == VTI_LAW_CLOSED)
        return (struct increment){1.0 + sqrt(1.0 - s2), 1.0, 0};
    const int small = s2 < 8.0;
    if (!small && !(s2 < 0x1p60))
        return (struct increment){0.0, 1.0, 0};
    const double f = 1.0 - s2 * (law == VTI_LAW_EXACT ? 1.0 / 60.0 : 1.0 / 42.0);
    const double c = 2.0 - s2 * (law == VTI_LAW_EXACT ? 1.0 / 5.0 : (180.0 - s2) * (1.0 / 840.0));
    return (struct increment){c, f, small};
}

/** alpha <- alpha (+) dalpha for side = 1, in space; for side = -1 in the body's frame. */
VTI_INLINE void turn_by(int law, double side, const double u[3], double a[3])
{
    const struct increment d = increment(law, u);
    vti_rrv_turn_by(d.c, d.f, u, d.small, side, a);
}

VTI_INLINE void turn_loop(int law, double side, double *restrict a0, double *restrict a1, double *restrict a2,
                          int64_t sa, const double *restrict w0, const double *restrict w1, const double *restrict w2,
                          int64_t sw, double t, int64_t begin, int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        const double u[3] = {t * w0[i * sw], t * w1[i * sw], t * w2[i * sw]};
        double a[3] = {a0[i * sa], a1[i * sa], a2[i * sa]};
        turn_by(law, side, u, a);
        a0[i * sa] = a[0];
        a1[i * sa] = a[1];
        a2[i * sa] = a[2];
    }
}

VTI_INLINE void turn_alpha(int law, double side, double t, const vti_view *a, const vti_view *w, int64_t begin,
                           int64_t end)
{
    if (vti_is_packed(a) && vti_is_packed(w)) {
        double *p = a->c[0];
        const double *q = w->c[0];
        turn_loop(law, side, p, p + 1, p + 2, 3, q, q + 1, q + 2, 3, t, begin, end);
    } else
        turn_loop(law, side, a->c[0], a->c[1], a->c[2], a->stride, w->c[0], w->c[1], w->c[2], w->stride, t, begin, end);
}

/** The same with the rounding error of alpha carried along. */
VTI_INLINE void turn_compensated(int law, double side, double t, const vti_view *a, const vti_view *w,
                                 const vti_view *low, int64_t begin, int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        double u[3], base[3], add[3], r[3];
        vti_load(w, i, u);
        vti_load(a, i, base);
        vti_load(low, i, r);
        for (int k = 0; k < 3; ++k)
            u[k] *= t;
        const struct increment d = increment(law, u);
        const int incremental = vti_rrv_increment(d.c, d.f, u, d.small, side, base, add);
        for (int k = 0; k < 3; ++k) {
            r[k] = incremental ? r[k] : 0.0;
            base[k] = add_compensated(incremental ? base[k] : 0.0, add[k], &r[k]);
        }
        vti_store(a, i, base);
        vti_store(low, i, r);
    }
}

/** q <- normalise((u, c) q), or q (u, c) in the body's frame: the same increment on a host's quaternion. */
VTI_INLINE void turn_quat(int law, double side, double t, const vti_quat_view *quat, const vti_view *w, int64_t begin,
                          int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        double u[3], q[4], r[4], x[3];
        vti_load(w, i, u);
        for (int k = 0; k < 3; ++k)
            u[k] *= t;
        for (int k = 0; k < 4; ++k)
            q[k] = quat->xyzw[k][i * quat->stride];
        /* scaled, lest the square of a huge u overflow */
        const struct increment d = increment(law, u);
        const double s = vti_max3(u) > VTI_RRV_LARGE ? VTI_RRV_DOWN : 1.0, c = s * d.c;
        for (int k = 0; k < 3; ++k)
            u[k] *= s * d.f;
        vti_cross(u, q, x);
        for (int k = 0; k < 3; ++k)
            r[k] = c * q[k] + q[3] * u[k] + side * x[k];
        r[3] = c * q[3] - vti_dot(u, q);
        const double scale = 1.0 / sqrt(vti_dot(r, r) + r[3] * r[3]);
        for (int k = 0; k < 4; ++k)
            quat->xyzw[k][i * quat->stride] = r[k] * scale;
    }
}

/* ---- kick and drift -------------------------------------------------------------------------------------------- */

/** Few bodies, one after the other in registers: Omega += kick_t RM/J as in vti_kick.c, then the turn. A body that is alone
 *  would wait for what it has just stored. */
VTI_INLINE void kick_and_turn(int law, double side, double kick_t, double t, const vti_bodies *b, int64_t begin,
                              int64_t end)
{
    const vti_view omega = b->omega, moment = b->moment, alpha = b->alpha;
    for (int64_t i = begin; i < end; ++i) {
        double w[3], m[3], a[3];
        vti_load(&omega, i, w);
        vti_load(&alpha, i, a);
        if (kick_t != 0.0 && vti_has(&moment)) {
            const double k = kick_t / vti_scalar(&b->inertia, i);
            vti_load(&moment, i, m);
            for (int c = 0; c < 3; ++c)
                w[c] += k * m[c];
            vti_store(&omega, i, w);
        }
        const double u[3] = {t * w[0], t * w[1], t * w[2]};
        turn_by(law, side, u, a);
        vti_store(&alpha, i, a);
    }
}

VTI_INLINE void push_alpha(int law, double side, double kick_t, double t, const vti_bodies *b, int64_t begin,
                           int64_t end)
{
    if (end - begin <= VTI_FEW && !vti_has(&b->omega_low))
        kick_and_turn(law, side, kick_t, t, b, begin, end);
    else {
        vti_kick_omega(kick_t, b, begin, end);
        turn_alpha(law, side, t, &b->alpha, &b->omega, begin, end);
    }
}

/* Literal arguments, so that each way to keep the attitude, each law and each frame is a loop of its own. */
#define TURNS(NAME, LAW, SIDE)                                                                                         \
    static void alpha_##NAME(double kick_t, double t, const vti_bodies *b, int64_t begin, int64_t end)                 \
    {                                                                                                                  \
        push_alpha(LAW, SIDE, kick_t, t, b, begin, end);                                                               \
    }                                                                                                                  \
    static void compensated_##NAME(double kick_t, double t, const vti_bodies *b, int64_t begin, int64_t end)           \
    {                                                                                                                  \
        vti_kick_omega(kick_t, b, begin, end);                                                                         \
        turn_compensated(LAW, SIDE, t, &b->alpha, &b->omega, &b->alpha_low, begin, end);                               \
    }                                                                                                                  \
    static void quat_##NAME(double kick_t, double t, const vti_bodies *b, int64_t begin, int64_t end)                  \
    {                                                                                                                  \
        vti_kick_omega(kick_t, b, begin, end);                                                                         \
        turn_quat(LAW, SIDE, t, &b->quat, &b->omega, begin, end);                                                      \
    }
TURNS(closed, VTI_LAW_CLOSED, 1.0)
TURNS(cayley, VTI_LAW_CAYLEY, 1.0)
TURNS(exact, VTI_LAW_EXACT, 1.0)
TURNS(exact9, VTI_LAW_EXACT9, 1.0)
TURNS(closed_body, VTI_LAW_CLOSED, -1.0)
TURNS(cayley_body, VTI_LAW_CAYLEY, -1.0)
TURNS(exact_body, VTI_LAW_EXACT, -1.0)
TURNS(exact9_body, VTI_LAW_EXACT9, -1.0)
#undef TURNS

typedef void turn(double kick_t, double t, const vti_bodies *b, int64_t begin, int64_t end);

enum { BY_ALPHA, COMPENSATED, BY_QUAT };

/** [how the attitude is kept][frame is the body's][law] */
#define KEPT(BY)                                                                                                       \
    {                                                                                                                  \
        {NULL, BY##_closed, BY##_cayley, BY##_exact, BY##_exact9},                                                     \
        {                                                                                                              \
            NULL, BY##_closed_body, BY##_cayley_body, BY##_exact_body, BY##_exact9_body                                \
        }                                                                                                              \
    }
static turn *const turns[3][2][VTI_LAW_EXACT9 + 1] = {KEPT(alpha), KEPT(compensated), KEPT(quat)};
#undef KEPT

void vti_push(int law, int frame, double kick_t, double t, const vti_bodies *b, int64_t begin, int64_t end)
{
    vti_kick_v(kick_t, b, begin, end);
    if (vti_has(&b->x) && vti_has(&b->v))
        translate(t, &b->x, &b->v, &b->x_low, begin, end);
    if (!vti_has_attitude(b) || !vti_has(&b->omega)) {
        vti_kick_omega(kick_t, b, begin, end);
        return;
    }
    const int kept = !vti_has(&b->alpha) ? BY_QUAT : vti_has(&b->alpha_low) ? COMPENSATED : BY_ALPHA;
    turns[kept][frame == VTI_FRAME_BODY][law](kick_t, t, b, begin, end);
}

/* ---- the bound of the closed form ----------------------------------------------------------------------------- */

/** u = t (Omega + kick_t RM/J), by the operations of the kick and the drift, so that what is tested here is what the
 *  square root will see. */
static inline void kicked_turn(const vti_bodies *b, double kick_t, double t, int64_t i, double u[3])
{
    double m[3], low[3] = {0.0, 0.0, 0.0};
    vti_load(&b->omega, i, u);
    if (kick_t != 0.0 && vti_has(&b->moment)) {
        const double k = kick_t / vti_scalar(&b->inertia, i);
        vti_load(&b->moment, i, m);
        if (vti_has(&b->omega_low))
            vti_load(&b->omega_low, i, low);
        for (int c = 0; c < 3; ++c)
            u[c] = vti_has(&b->omega_low) ? add_compensated(u[c], k * m[c], &low[c]) : u[c] + k * m[c];
    }
    for (int c = 0; c < 3; ++c)
        u[c] *= t;
}

/** The body with the largest s = |u|, or the first whose s is not a number. */
static void name_worst(const vti_bodies *b, double kick_t, double t, vti_fault *fault)
{
    double worst = -1.0;
    for (int64_t i = b->first; i < b->first + b->count && !isnan(worst); ++i) {
        double u[3];
        kicked_turn(b, kick_t, t, i, u);
        const double s = vti_norm(u);
        if (!(s <= worst)) {
            worst = s;
            vti_blame(VTI_E_TOO_LARGE, i, s, VTI_QUANTITY_OMEGA, fault);
        }
    }
}

int vti_drift_refuses(int law, double kick_t, double t, const vti_bodies *b, vti_fault *fault)
{
    if (law != VTI_LAW_CLOSED || !vti_has_attitude(b) || !vti_has(&b->omega))
        return VTI_OK;
    int refused = 0;
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        double u[3];
        kicked_turn(b, kick_t, t, i, u);
        refused |= !(vti_dot(u, u) < 1.0);
    }
    if (refused && fault != NULL)
        name_worst(b, kick_t, t, fault);
    return refused ? VTI_E_TOO_LARGE : VTI_OK;
}

/* ---- the public primitive ---------------------------------------------------------------------------------------- */

int vti_drift(int law, int frame, double t, const vti_bodies *b, vti_fault *fault)
{
    vti_blame_none(VTI_OK, fault);
    int status = vti_bodies_ready_or(b, fault);
    if (status == VTI_OK)
        status = vti_law_check(law, frame);
    if (status == VTI_OK && !isfinite(t))
        status = vti_blame(VTI_E_TIME, -1, t, VTI_QUANTITY_NONE, fault);
    if (status == VTI_OK)
        status = vti_drift_refuses(law, 0.0, t, b, fault);
    if (status == VTI_OK)
        vti_push(law, frame, 0.0, t, b, b->first, b->first + b->count);
    return status;
}
