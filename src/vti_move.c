/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The two primitives of every stepper (EQUATIONS 2):
 *
 *     kick(t):  v += t F/m,  Omega += t RM/J
 *     drift(t): x += t v,    alpha <- alpha (+) dalpha(t Omega)
 *
 * Each loop is written once, for any stride, and compiled for the usual strides as well, which changes its speed and not
 * its bits. `restrict` stands on parameters because compilers do not honour it on pointers taken from a struct. */
#include "vti_internal.h"

/** a += b with the rounding error of the sum carried in *low (two-sum, exact whatever the magnitudes). */
static inline double add_compensated(double a, double b, double *low)
{
    const double y = b + *low, s = a + y, z = s - a;
    *low = (a - (s - z)) + (y - z);
    return s;
}

/** a += t b with residuals, for any stride: the compensated form of a kick (t/m) or of a translation. */
static void add_view(double t, const vti_view *a, const vti_view *b, const vti_scalars *m, const vti_view *low,
                     int64_t begin, int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        const double k = m != NULL ? t / vti_scalar(m, i) : t;
        for (int c = 0; c < 3; ++c) {
            double *p = a->c[c] + i * a->stride;
            *p = add_compensated(*p, k * b->c[c][i * b->stride], low->c[c] + i * low->stride);
        }
    }
}

/** a += k b of n numbers: what kick and translation are where vectors lie packed and one mass serves all. */
static void add_packed(double *restrict a, const double *restrict b, double k, int64_t n)
{
    for (int64_t i = 0; i < n; ++i)
        a[i] += k * b[i];
}

/* ---- kick ---------------------------------------------------------------------------------------------------- */

static inline void kick_loop(double *restrict v0, double *restrict v1, double *restrict v2, int64_t sv,
                             const double *restrict f0, const double *restrict f1, const double *restrict f2,
                             int64_t sf, const double *restrict m, int64_t sm, double t, int64_t begin, int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        const double k = t / m[i * sm];
        v0[i * sv] += k * f0[i * sf];
        v1[i * sv] += k * f1[i * sf];
        v2[i * sv] += k * f2[i * sf];
    }
}

/** v += t f/m */
static void kick_view(double t, const vti_view *v, const vti_view *f, const vti_scalars *m, const vti_view *low,
                      int64_t begin, int64_t end)
{
    if (vti_has(low)) {
        add_view(t, v, f, m, low, begin, end);
        return;
    }
#define KICK(SV, SF, SM)                                                                                               \
    kick_loop(v->c[0], v->c[1], v->c[2], SV, f->c[0], f->c[1], f->c[2], SF, m->p, SM, t, begin, end)
    if (vti_is_packed(v) && vti_is_packed(f) && m->stride == 0)
        add_packed(v->c[0] + 3 * begin, f->c[0] + 3 * begin, t / *m->p, 3 * (end - begin));
    else if (v->stride == 3 && f->stride == 3 && m->stride == 1)
        KICK(3, 3, 1);
    else if (v->stride == 1 && f->stride == 1 && m->stride == 0)
        KICK(1, 1, 0);
    else if (v->stride == 1 && f->stride == 1 && m->stride == 1)
        KICK(1, 1, 1);
    else
        KICK(v->stride, f->stride, m->stride);
#undef KICK
}

void vti_kick_range(double t, const vti_bodies *b, int64_t begin, int64_t end)
{
    if (vti_has(&b->v) && vti_has(&b->force))
        kick_view(t, &b->v, &b->force, &b->mass, &b->v_low, begin, end);
    if (vti_has(&b->omega) && vti_has(&b->moment))
        kick_view(t, &b->omega, &b->moment, &b->inertia, &b->omega_low, begin, end);
}

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
        add_view(t, x, v, NULL, low, begin, end);
        return;
    }
#define TRANSLATE(SX, SV) translate_loop(x->c[0], x->c[1], x->c[2], SX, v->c[0], v->c[1], v->c[2], SV, t, begin, end)
    if (vti_is_packed(x) && vti_is_packed(v))
        add_packed(x->c[0] + 3 * begin, v->c[0] + 3 * begin, t, 3 * (end - begin));
    else if (x->stride == 1 && v->stride == 1)
        TRANSLATE(1, 1);
    else
        TRANSLATE(x->stride, v->stride);
#undef TRANSLATE
}

/* ---- drift of attitudes -------------------------------------------------------------------------------------- */

/** The increment dalpha = 2 u/c of a body that turns with w for the time t, u = t w; s^2 = u.u.
 *      VTI-1     dalpha = 2 t w/(1 + sqrt(1 - s^2))
 *      VTI-2, 3  dalpha = t w                                                                                     */
static inline double increment(int law, const double u[3])
{
    return law == VTI_LAW_CLOSED ? 1.0 + sqrt(1.0 - vti_dot(u, u)) : 2.0;
}

static inline void turn_loop(int law, double side, double *restrict a0, double *restrict a1, double *restrict a2,
                             int64_t sa, const double *restrict w0, const double *restrict w1,
                             const double *restrict w2, int64_t sw, double t, int64_t begin, int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        const double u[3] = {t * w0[i * sw], t * w1[i * sw], t * w2[i * sw]};
        double a[3] = {a0[i * sa], a1[i * sa], a2[i * sa]};
        vti_rrv_turn_side(increment(law, u), u, side, a);
        a0[i * sa] = a[0];
        a1[i * sa] = a[1];
        a2[i * sa] = a[2];
    }
}

static inline void turn_alpha(int law, double side, double t, const vti_view *a, const vti_view *w, int64_t begin,
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
static inline void turn_compensated(int law, double side, double t, const vti_view *a, const vti_view *w,
                                    const vti_view *low, int64_t begin, int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        double u[3], base[3], add[3], r[3];
        vti_load(w, i, u);
        vti_load(a, i, base);
        vti_load(low, i, r);
        for (int k = 0; k < 3; ++k)
            u[k] *= t;
        const int incremental = vti_rrv_increment(increment(law, u), u, side, base, add);
        for (int k = 0; k < 3; ++k) {
            r[k] = incremental ? r[k] : 0.0;
            base[k] = add_compensated(incremental ? base[k] : 0.0, add[k], &r[k]);
        }
        vti_store(a, i, base);
        vti_store(low, i, r);
    }
}

/** q <- normalise((u, c) q), or q (u, c) in the body's frame: the same increment on a host's quaternion. */
static inline void turn_quat(int law, double side, double t, const vti_quat_view *quat, const vti_view *w,
                             int64_t begin, int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        double u[3], q[4], r[4], x[3];
        vti_load(w, i, u);
        for (int k = 0; k < 3; ++k)
            u[k] *= t;
        for (int k = 0; k < 4; ++k)
            q[k] = quat->xyzw[k][i * quat->stride];
        const double c = increment(law, u);
        vti_cross(u, q, x);
        for (int k = 0; k < 3; ++k)
            r[k] = c * q[k] + q[3] * u[k] + side * x[k];
        r[3] = c * q[3] - vti_dot(u, q);
        const double scale = 1.0 / sqrt(vti_dot(r, r) + r[3] * r[3]);
        for (int k = 0; k < 4; ++k)
            quat->xyzw[k][i * quat->stride] = r[k] * scale;
    }
}

static inline void turn(int law, int frame, double t, const vti_bodies *b, int64_t begin, int64_t end)
{
    const double side = frame == VTI_FRAME_BODY ? -1.0 : 1.0;
    if (vti_has(&b->alpha_low))
        turn_compensated(law, side, t, &b->alpha, &b->omega, &b->alpha_low, begin, end);
    else if (vti_has(&b->alpha))
        turn_alpha(law, side, t, &b->alpha, &b->omega, begin, end);
    else
        turn_quat(law, side, t, &b->quat, &b->omega, begin, end);
}

void vti_drift_range(int law, int frame, double t, const vti_bodies *b, int64_t begin, int64_t end)
{
    if (vti_has(&b->x) && vti_has(&b->v))
        translate(t, &b->x, &b->v, &b->x_low, begin, end);
    if (!vti_has_attitude(b) || !vti_has(&b->omega))
        return;
    /* literal arguments, so that each law and frame is a loop of its own */
    if (law == VTI_LAW_CLOSED && frame == VTI_FRAME_SPACE)
        turn(VTI_LAW_CLOSED, VTI_FRAME_SPACE, t, b, begin, end);
    else if (law == VTI_LAW_CLOSED)
        turn(VTI_LAW_CLOSED, VTI_FRAME_BODY, t, b, begin, end);
    else if (frame == VTI_FRAME_SPACE)
        turn(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, t, b, begin, end);
    else
        turn(VTI_LAW_CAYLEY, VTI_FRAME_BODY, t, b, begin, end);
}

/* ---- the bound of the closed form ----------------------------------------------------------------------------- */

/** u = t (Omega + kick_t RM/J), by the operations of the kick and the drift, so that what is tested here is what the
 *  square root will see. */
static inline void kicked_turn(const vti_bodies *b, double kick_t, double t, int64_t i, double u[3])
{
    double m[3], low[3] = {0.0, 0.0, 0.0};
    vti_load(&b->omega, i, u);
    if (vti_has(&b->moment)) {
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

/* ---- the public primitives ------------------------------------------------------------------------------------ */

int vti_law_check(int law, int frame)
{
    if (law != VTI_LAW_CLOSED && law != VTI_LAW_CAYLEY)
        return VTI_E_STEPPER;
    return frame == VTI_FRAME_SPACE || frame == VTI_FRAME_BODY ? VTI_OK : VTI_E_FRAME;
}

int vti_kick(double t, const vti_bodies *b)
{
    const int status = vti_bodies_ready(b);
    if (status != VTI_OK)
        return status;
    if (!isfinite(t))
        return VTI_E_TIME;
    vti_kick_range(t, b, b->first, b->first + b->count);
    return VTI_OK;
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
