/* SPDX-License-Identifier: BSD-3-Clause
 *
 * AN(K, c) (EQUATIONS 8.1). With a = F/m, w = Omega, b = RM/J and the backward differences N^0 f = f_n,
 * N^j f_n = N^{j-1} f_n - N^{j-1} f_{n-1}:
 *
 *     predict   v_p = v + h sum g_j N^j a,  x_p = x + h v + h^2 sum d_j N^j a,  w_p = w + h sum g_j N^j b
 *               R_p = R turned by the Magnus vector of w(s) = w + h sum G_j(s) N^j b
 *     correct   D = f_{n+1} - sum_{j<K} N^j f_n, f_{n+1} at the predicted state
 *               v = v_p + h g_K D_a,  x = x_p + c h^2 d_K D_a,  w = w_p + h g_K D_b,  R = R(c h^2 d_K D_b) R_p */
#include <string.h>

#include "vti_adams.h"
#include "vti_move.h"
#include "vti_multistep.h"

/* c is of the widest reach for 6 and 8, of the smallest error for 9 */
static const vti_multistep methods[] = {
    {"an4", 4, 1.0, 0.565, "Adams-Nystroem, order 5, one force evaluation a step; not symplectic"},
    {"an6", 6, -0.5, 0.665, "the same of order 7"},
    {"an8", 8, -0.75, 0.665, "the same of order 9"},
    {"an9", 9, 0.75, 0.18, "the same of order 10"},
};

enum { METHODS = sizeof methods / sizeof methods[0] };

int64_t vti_multistep_count(void)
{
    return METHODS;
}

const vti_multistep *vti_multistep_at(int64_t index)
{
    return index >= 0 && index < METHODS ? &methods[index] : NULL;
}

const vti_multistep *vti_multistep_find(const char *name)
{
    for (int64_t i = 0; name != NULL && i < METHODS; ++i)
        if (strcmp(name, methods[i].name) == 0)
            return &methods[i];
    return NULL;
}

/* ---- what is remembered -------------------------------------------------------------------------------------------- */

/** The differences of body i: [depth][6], translation first. */
static inline double *differences(const vti_past *past, int64_t i)
{
    return past->memory + 6 * past->depth * i;
}

/** The first known differences of f_n become the first known + 1 of f, as far as there is room. */
static void push(double *n, int64_t depth, int64_t known, const double f[6])
{
    double now[6];
    for (int k = 0; k < 6; ++k)
        now[k] = f[k];
    for (int64_t j = 0; j <= known && j < depth; ++j)
        for (int k = 0; k < 6; ++k) {
            const double before = n[6 * j + k];
            n[6 * j + k] = now[k];
            now[k] -= before;
        }
}

static int check_past(const vti_past *past, const vti_bodies *b, vti_fault *fault)
{
    if (past == NULL)
        return VTI_E_NULL;
    const int status = vti_bodies_ready_or(b, fault);
    if (status != VTI_OK)
        return status;
    const vti_view *const low[] = {&b->x_low, &b->v_low, &b->alpha_low, &b->omega_low};
    for (int k = 0; k < 4; ++k)
        if (vti_has(low[k]))
            return vti_refuse(VTI_E_VIEW, -1, 0.0, VTI_QUANTITY_X_LOW + k, fault);
    if (past->memory == NULL || past->depth < 1 || past->known < 0 || past->known > past->depth)
        return vti_refuse(VTI_E_PAST, -1, (double)past->known, VTI_QUANTITY_NONE, fault);
    return VTI_OK;
}

int vti_multistep_record(vti_past *past, const vti_bodies *b)
{
    const int status = check_past(past, b, NULL);
    if (status != VTI_OK)
        return status;
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        double f[6];
        vti_accelerations(b, i, f);
        push(differences(past, i), past->depth, past->known, f);
    }
    past->known += past->known < past->depth;
    return VTI_OK;
}

/* ---- one body ------------------------------------------------------------------------------------------------------ */

/** sum of coefficient[j] N^j, j < depth, of the three numbers from n on, in this order. */
static void sum_of(int64_t depth, const double *coefficient, const double *n, double sum[3])
{
    double s[3] = {0.0, 0.0, 0.0};
    for (int64_t j = 0; j < depth; ++j)
        for (int k = 0; k < 3; ++k) /* three sums at once: each waits for its last addition */
            s[k] += coefficient[j] * n[6 * j + k];
    for (int k = 0; k < 3; ++k)
        sum[k] = s[k];
}

/** Bodies are turned by so many at once, in vector registers where there are enough (vti_move_kernels.h). */
enum { TILE = 64 };

/** Turns the bodies from begin on by u[count][3], to order 9 in u. */
static void turn_by(const vti_bodies *b, int64_t begin, int64_t count, double *u)
{
    const struct vti_move whole = {.drift = 1.0, .drifts = 1, .law = VTI_LAW_EXACT9, .frame = VTI_FRAME_SPACE};
    vti_bodies turned = vti_bodies_none(count);
    if (!vti_has(&b->omega) || !vti_has_attitude(b))
        return;
    turned.omega = vti_view_packed(u);
    turned.alpha = b->alpha;
    for (int k = 0; k < 3 && vti_has(&b->alpha); ++k)
        turned.alpha.c[k] += begin * b->alpha.stride;
    turned.quat = b->quat;
    for (int k = 0; k < 4 && !vti_has(&b->alpha); ++k)
        turned.quat.xyzw[k] += begin * b->quat.stride;
    vti_move_all(&whole, &turned);
}

/** The rotation vector of a turn under w(s), 0 <= s <= 1 of h (Magnus, order 6; Blanes, Casas and Ros 2000): of its values
 *  O1, O2, O3 at Gauss' nodes A1 = h O2, A2 = (r/3) h (O3 - O1), A3 = (10/3) h (O3 - 2 O2 + O1), r = sqrt(15), C1 = A1 x A2,
 *  C2 = -(1/60) A1 x (2 A3 + C1), and theta = A1 + A3/12 + (1/240)(-20 A1 - A3 + C1) x (A2 + C2). */
static void magnus(double h, double o[3][3], double theta[3])
{
    const double r3 = 1.2909944487358056; /* sqrt(15)/3 */
    double a1[3], a2[3], a3[3], c1[3], c2[3], p[3], q[3];
    for (int k = 0; k < 3; ++k) {
        a1[k] = h * o[1][k];
        a2[k] = r3 * h * (o[2][k] - o[0][k]);
        a3[k] = 10.0 / 3.0 * h * (o[2][k] - 2.0 * o[1][k] + o[0][k]);
    }
    vti_cross(a1, a2, c1);
    for (int k = 0; k < 3; ++k)
        p[k] = 2.0 * a3[k] + c1[k];
    vti_cross(a1, p, c2);
    for (int k = 0; k < 3; ++k) {
        p[k] = c1[k] - 20.0 * a1[k] - a3[k];
        q[k] = a2[k] - c2[k] / 60.0;
    }
    vti_cross(p, q, theta);
    for (int k = 0; k < 3; ++k)
        theta[k] = a1[k] + a3[k] / 12.0 + theta[k] / 240.0;
}

static void predict_turn(int64_t depth, double h, const double *n, const vti_bodies *b, int64_t i, double theta[3])
{
    double w[3], o[3][3], sum[3];
    vti_load(&b->omega, i, w);
    for (int s = 0; s < 3; ++s) {
        sum_of(depth, adams_node[s], n + 3, sum);
        for (int k = 0; k < 3; ++k)
            o[s][k] = w[k] + h * sum[k];
    }
    magnus(h, o, theta);
    sum_of(depth, adams_g, n + 3, sum);
    for (int k = 0; k < 3; ++k)
        w[k] += h * sum[k];
    vti_store(&b->omega, i, w);
}

static void predict_move(int64_t depth, double h, const double *n, const vti_bodies *b, int64_t i)
{
    double v[3], x[3], sum[3];
    vti_load(&b->v, i, v);
    if (vti_has(&b->x)) {
        vti_load(&b->x, i, x);
        sum_of(depth, adams_d, n, sum);
        for (int k = 0; k < 3; ++k)
            x[k] += h * (v[k] + h * sum[k]);
        vti_store(&b->x, i, x);
    }
    sum_of(depth, adams_g, n, sum);
    for (int k = 0; k < 3; ++k)
        v[k] += h * sum[k];
    vti_store(&b->v, i, v);
}

static void add(const vti_view *view, int64_t i, double t, const double d[3])
{
    double a[3];
    if (!vti_has(view))
        return;
    vti_load(view, i, a);
    for (int k = 0; k < 3; ++k)
        a[k] += t * d[k];
    vti_store(view, i, a);
}

/** Accelerations f of now, and D: how far off those are that were foreseen. */
static void foreseen(int64_t depth, const vti_past *past, const vti_bodies *b, int64_t i, double f[6], double off[6])
{
    static const double ones[ADAMS_MOST] = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    const double *const n = differences(past, i);
    vti_accelerations(b, i, f);
    sum_of(depth, ones, n, off);
    sum_of(depth, ones, n + 3, off + 3);
    for (int k = 0; k < 6; ++k)
        off[k] = f[k] - off[k];
}

static void correct(const vti_multistep *m, double h, const vti_past *past, const vti_bodies *b, int64_t i,
                    double turn[3])
{
    const double g = h * adams_g[m->depth], d = m->c * h * h * adams_d[m->depth];
    double f[6], off[6];
    foreseen(m->depth, past, b, i, f, off);
    add(&b->v, i, g, off);
    if (vti_has(&b->v))
        add(&b->x, i, d, off);
    add(&b->omega, i, g, off + 3);
    for (int k = 0; k < 3; ++k)
        turn[k] = d * off[3 + k];
    push(differences(past, i), past->depth, past->known, f);
}

/* ---- all of them --------------------------------------------------------------------------------------------------- */

static int check(const vti_multistep *method, double h, const vti_past *past, const vti_bodies *b, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    if (method == NULL || method->depth < 1 || method->depth > ADAMS_MOST || !isfinite(method->c))
        return VTI_E_STEPPER;
    const int status = check_past(past, b, fault);
    if (status != VTI_OK)
        return status;
    if (!(isfinite(h) && h > 0.0))
        return vti_refuse(VTI_E_TIME, -1, h, VTI_QUANTITY_NONE, fault);
    return past->known >= method->depth ? VTI_OK
                                        : vti_refuse(VTI_E_PAST, -1, (double)past->known, VTI_QUANTITY_NONE, fault);
}

int vti_multistep_predict(const vti_multistep *method, double h, const vti_past *past, const vti_bodies *b,
                          vti_fault *fault)
{
    const int status = check(method, h, past, b, fault);
    if (status != VTI_OK)
        return status;
    double theta[3 * TILE];
    for (int64_t begin = b->first, end = b->first + b->count; begin < end; begin += TILE) {
        const int64_t count = end - begin < TILE ? end - begin : TILE;
        for (int64_t i = begin; i < begin + count; ++i) {
            const double *n = differences(past, i);
            if (vti_has(&b->v))
                predict_move(method->depth, h, n, b, i);
            if (vti_has(&b->omega))
                predict_turn(method->depth, h, n, b, i, theta + 3 * (i - begin));
        }
        turn_by(b, begin, count, theta);
    }
    return VTI_OK;
}

int vti_multistep_correct(const vti_multistep *method, double h, vti_past *past, const vti_bodies *b)
{
    const int status = check(method, h, past, b, NULL);
    if (status != VTI_OK)
        return status;
    double turn[3 * TILE];
    for (int64_t begin = b->first, end = b->first + b->count; begin < end; begin += TILE) {
        const int64_t count = end - begin < TILE ? end - begin : TILE;
        for (int64_t i = begin; i < begin + count; ++i)
            correct(method, h, past, b, i, turn + 3 * (i - begin));
        turn_by(b, begin, count, turn);
    }
    past->known += past->known < past->depth;
    return VTI_OK;
}

int vti_multistep_error(const vti_multistep *method, double h, const vti_past *past, const vti_bodies *b,
                        double *velocity, double *spin)
{
    const int status = check(method, h, past, b, NULL);
    if (status != VTI_OK)
        return status;
    if (velocity == NULL || spin == NULL)
        return VTI_E_NULL;
    *velocity = *spin = 0.0;
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        double f[6], off[6];
        foreseen(method->depth, past, b, i, f, off);
        *velocity = vti_larger(*velocity, h * adams_g[method->depth] * vti_norm(off));
        *spin = vti_larger(*spin, h * adams_g[method->depth] * vti_norm(off + 3));
    }
    return VTI_OK;
}
