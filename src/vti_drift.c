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

/** The increment dalpha = 2 u/c of a body that turns with w for the time t, from u = t w; s^2 = |t w|^2.
 *      closed, VTI-1     dalpha = 2 t w/(1 + sqrt(1 - s^2))
 *      Cayley, VTI-2, 3  dalpha = t w
 *      exact             dalpha = 2 tan(s/2)/s t w by its continued fraction, without a pole as the pair
 *                        c = 2 - s^2/5, u = (1 - s^2/60) t w;  c = 2 - 3s^2/14 + s^4/840, u = (1 - s^2/42) t w
 *  Where s^2 would overflow, s has long lost its fraction of a turn: a half turn, (c, u) = (0, t w), is as good as any. */
VTI_INLINE double increment(int law, double u[3])
{
    if (law == VTI_LAW_CAYLEY)
        return 2.0;
    const double s2 = vti_dot(u, u);
    if (law == VTI_LAW_CLOSED)
        return 1.0 + sqrt(1.0 - s2);
    const int known = s2 < 0x1p60;
    const double scale = 1.0 - s2 * (law == VTI_LAW_EXACT ? 1.0 / 60.0 : 1.0 / 42.0);
    const double c = 2.0 - s2 * (law == VTI_LAW_EXACT ? 1.0 / 5.0 : (180.0 - s2) * (1.0 / 840.0));
    for (int k = 0; k < 3; ++k)
        u[k] *= known ? scale : 1.0;
    return known ? c : 0.0;
}

VTI_INLINE void turn_loop(int law, double side, double *restrict a0, double *restrict a1, double *restrict a2,
                          int64_t sa, const double *restrict w0, const double *restrict w1, const double *restrict w2,
                          int64_t sw, double t, int64_t begin, int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        double u[3] = {t * w0[i * sw], t * w1[i * sw], t * w2[i * sw]}, a[3] = {a0[i * sa], a1[i * sa], a2[i * sa]};
        const double c = increment(law, u);
        vti_rrv_turn_side(c, u, side, a);
        a0[i * sa] = a[0];
        a1[i * sa] = a[1];
        a2[i * sa] = a[2];
    }
}

VTI_INLINE void turn_alpha(int law, double side, double t, const vti_view *a, const vti_view *w, int64_t begin,
                           int64_t end)
{
#define TURN(SA, SW) turn_loop(law, side, a->c[0], a->c[1], a->c[2], SA, w->c[0], w->c[1], w->c[2], SW, t, begin, end)
    if (a->stride == 3 && w->stride == 3)
        TURN(3, 3);
    else if (a->stride == 1 && w->stride == 1)
        TURN(1, 1);
    else
        TURN(a->stride, w->stride);
#undef TURN
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
        const double c = increment(law, u);
        const int incremental = vti_rrv_increment(c, u, side, base, add);
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
        const double wide = increment(law, u), s = vti_max3(u) > VTI_RRV_LARGE ? VTI_RRV_DOWN : 1.0, c = s * wide;
        for (int k = 0; k < 3; ++k)
            u[k] *= s; /* lest the square of a huge u overflow */
        vti_cross(u, q, x);
        for (int k = 0; k < 3; ++k)
            r[k] = c * q[k] + q[3] * u[k] + side * x[k];
        r[3] = c * q[3] - vti_dot(u, q);
        const double scale = 1.0 / sqrt(vti_dot(r, r) + r[3] * r[3]);
        for (int k = 0; k < 4; ++k)
            quat->xyzw[k][i * quat->stride] = r[k] * scale;
    }
}

VTI_INLINE void turn(int law, int frame, double t, const vti_bodies *b, int64_t begin, int64_t end)
{
    const double side = frame == VTI_FRAME_BODY ? -1.0 : 1.0;
    if (vti_has(&b->alpha_low))
        turn_compensated(law, side, t, &b->alpha, &b->omega, &b->alpha_low, begin, end);
    else if (vti_has(&b->alpha))
        turn_alpha(law, side, t, &b->alpha, &b->omega, begin, end);
    else
        turn_quat(law, side, t, &b->quat, &b->omega, begin, end);
}

VTI_INLINE void turn_by(int law, int frame, double t, const vti_bodies *b, int64_t begin, int64_t end)
{
    if (law == VTI_LAW_CLOSED)
        turn(VTI_LAW_CLOSED, frame, t, b, begin, end);
    else if (law == VTI_LAW_CAYLEY)
        turn(VTI_LAW_CAYLEY, frame, t, b, begin, end);
    else if (law == VTI_LAW_EXACT)
        turn(VTI_LAW_EXACT, frame, t, b, begin, end);
    else
        turn(VTI_LAW_EXACT9, frame, t, b, begin, end);
}

void vti_drift_range(int law, int frame, double t, const vti_bodies *b, int64_t begin, int64_t end)
{
    if (vti_has(&b->x) && vti_has(&b->v))
        translate(t, &b->x, &b->v, &b->x_low, begin, end);
    if (!vti_has_attitude(b) || !vti_has(&b->omega))
        return;
    /* literal arguments, so that each law and frame is a loop of its own */
    if (frame == VTI_FRAME_SPACE)
        turn_by(law, VTI_FRAME_SPACE, t, b, begin, end);
    else
        turn_by(law, VTI_FRAME_BODY, t, b, begin, end);
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
            fault->body = i;
            fault->value = s;
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

int vti_law_check(int law, int frame)
{
    if (law < VTI_LAW_CLOSED || law > VTI_LAW_EXACT9)
        return VTI_E_STEPPER;
    return frame == VTI_FRAME_SPACE || frame == VTI_FRAME_BODY ? VTI_OK : VTI_E_FRAME;
}

int vti_drift(int law, int frame, double t, const vti_bodies *b, vti_fault *fault)
{
    int status = vti_bodies_ready(b);
    if (status == VTI_OK)
        status = vti_law_check(law, frame);
    if (status == VTI_OK && !isfinite(t))
        status = VTI_E_TIME;
    if (fault != NULL) {
        fault->body = -1;
        fault->value = t;
    }
    if (status == VTI_OK)
        status = vti_drift_refuses(law, 0.0, t, b, fault);
    if (status == VTI_OK)
        vti_drift_range(law, frame, t, b, b->first, b->first + b->count);
    return status;
}
