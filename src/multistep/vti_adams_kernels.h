/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What a multistep method does to one body after the other, or two at once (EQUATIONS 8.1), its numbers in quads: of
 * the six differences of a body, translation first, the first four (a quad whose last number is the turn's) and the
 * last four (whose first is the translation's). Included by vti_move_kernels.h, for each of the vector units, and by
 * vti_multistep.c. */
#ifndef VTI_ADAMS_KERNELS_H
#define VTI_ADAMS_KERNELS_H

#include "vti_adams.h"
#include "vti_adams_magnus.h"
#include "vti_quad.h"

/** The differences of body i: [depth][6], translation first. */
VTI_INLINE double *adams_differences(const vti_past *past, int64_t i)
{
    return past->memory + 6 * past->depth * i;
}

VTI_INLINE void quad_zero(part a[PARTS])
{
    static const double none[AT_ONCE] = {0.0};
    quad_of(none, none, none, none, a);
}

/** a += t b. */
VTI_INLINE void quad_add(double t, const part b[PARTS], part a[PARTS])
{
    for (int k = 0; k < PARTS; ++k)
        a[k] += t * b[k];
}

/** A vector of the bodies from i on as (x, y, z, 0), or as (0, x, y, z) with first = 1. */
VTI_INLINE void quad_of_view(const vti_view *view, int first, int64_t i, part a[PARTS])
{
    double x[AT_ONCE], y[AT_ONCE], z[AT_ONCE], none[AT_ONCE];
    for (int l = 0; l < AT_ONCE; ++l) {
        const int64_t at = (i + l) * view->stride;
        x[l] = view->c[0][at];
        y[l] = view->c[1][at];
        z[l] = view->c[2][at];
        none[l] = 0.0;
    }
    if (first)
        quad_of(none, x, y, z, a);
    else
        quad_of(x, y, z, none, a);
}

VTI_INLINE void quad_into_view(const vti_view *view, int first, int64_t i, const part a[PARTS])
{
    for (int l = 0; l < AT_ONCE; ++l)
        for (int k = 0; k < 3; ++k)
            view->c[k][(i + l) * view->stride] = quad_get(a, l, k + first);
}

/** v_p = v + h sum g_j N^j a,  x_p = x + h v + h^2 sum d_j N^j a. */
VTI_INLINE void adams_move(int64_t depth, double h, const double *n, int64_t apart, const vti_view *x,
                           const vti_view *v, int64_t i)
{
    part a[PARTS], g[PARTS], d[PARTS], there[PARTS], speed[PARTS];
    quad_zero(g);
    quad_zero(d);
    for (int64_t j = 0; j < depth; ++j) {
        quad_load(n + 6 * j, apart, a);
        quad_add(adams_d[j], a, d);
        quad_add(adams_g[j], a, g);
    }
    quad_of_view(v, 0, i, speed);
    if (vti_has(x)) {
        quad_of_view(x, 0, i, there);
        for (int k = 0; k < PARTS; ++k)
            there[k] += h * (speed[k] + h * d[k]);
        quad_into_view(x, 0, i, there);
    }
    quad_add(h, g, speed);
    quad_into_view(v, 0, i, speed);
}

/** w_p = w + h sum g_j N^j b, and the A1 ... A4 by which a body turns meanwhile. */
VTI_INLINE void adams_spin(int64_t depth, double h, const double *n, int64_t apart, const vti_view *omega, int64_t i,
                           double *turn)
{
    part b[PARTS], g[PARTS], w[PARTS], a[4][PARTS];
    quad_zero(g);
    for (int m = 0; m < 4; ++m)
        quad_zero(a[m]);
    for (int64_t j = 0; j < depth; ++j) {
        quad_load(n + 6 * j + 2, apart, b);
        quad_add(adams_g[j], b, g);
        for (int m = 0; m < 4; ++m)
            quad_add(adams_middle[m][j], b, a[m]);
    }
    quad_of_view(omega, 1, i, w);
    for (int k = 0; k < PARTS; ++k)
        a[0][k] = h * (w[k] + h * a[0][k]);
    for (int m = 1; m < 4; ++m)
        for (int k = 0; k < PARTS; ++k)
            a[m][k] *= h * h;
    for (int m = 0; m < 4; ++m)
        quad_store(turn + 4 * m, ADAMS_PREDICTION, a[m]);
    quad_add(h, g, w);
    quad_into_view(omega, 1, i, w);
}

/** Bodies begin <= i < end, as many as are done at once, to where they will be but for the correction, attitudes
 *  excepted, which turn by turn[end - begin][ADAMS_PREDICTION]. */
static inline int64_t adams_predict(const vti_multistep *m, double h, const vti_past *past, const vti_bodies *bodies,
                                    int64_t begin, int64_t end, double *turn)
{
    const vti_view x = bodies->x, v = bodies->v, omega = bodies->omega;
    const int moves = vti_has(&v), spins = vti_has(&omega);
    const int64_t depth = m->depth, apart = 6 * past->depth;
    const double *n = adams_differences(past, begin);
    int64_t i = begin;
    for (; i + AT_ONCE <= end; i += AT_ONCE, n += AT_ONCE * apart, turn += ADAMS_PREDICTION * AT_ONCE) {
        if (moves)
            adams_move(depth, h, n, apart, &x, &v, i);
        if (spins)
            adams_spin(depth, h, n, apart, &omega, i, turn);
    }
    return i;
}

/** The acceleration by a load, a = by/over: (x, y, z, 0), or (0, x, y, z) with first = 1; 0 where there is none. */
VTI_INLINE void adams_acceleration(const vti_view *by, const vti_scalars *over, int first, int64_t i, part a[PARTS])
{
    quad_zero(a);
    if (!vti_has(by))
        return;
    double m[AT_ONCE];
    for (int l = 0; l < AT_ONCE; ++l)
        m[l] = over->p[(i + l) * over->stride];
    part per[PARTS];
    quad_of(m, m, m, m, per);
    quad_of_view(by, first, i, a);
    for (int k = 0; k < PARTS; ++k)
        a[k] /= per[k];
}

/** Accelerations, or differences of them: F/m and the first number of RM/J; the last of F/m and RM/J. */
struct adams_felt {
    part low[PARTS], high[PARTS];
};

/** A load, where there is something that it changes. */
static inline vti_view adams_load(const vti_view *load, const vti_view *changes)
{
    return vti_has(changes) ? *load : *changes;
}

VTI_INLINE void adams_feel(const vti_view *force, const vti_scalars *mass, const vti_view *moment,
                           const vti_scalars *inertia, int64_t i, struct adams_felt *f)
{
    part a[PARTS], b[PARTS];
    adams_acceleration(force, mass, 0, i, a);
    adams_acceleration(moment, inertia, 1, i, b);
    quad_three_and(a, b, f->low);
    quad_and_three(a, b, f->high);
}

/** off = f - sum N^j, j < depth, in this order: the difference from the predicted ones. writes: the levels
 *  differences of the last f, at least depth, become those of this one. */
VTI_INLINE void adams_compare(int writes, int64_t depth, int64_t levels, double *n, int64_t apart, struct adams_felt f,
                              struct adams_felt *off)
{
    struct adams_felt sum, was, now = f;
    quad_zero(sum.low);
    quad_zero(sum.high);
    for (int64_t j = 0; j < levels; ++j, n += 6) {
        quad_load(n, apart, was.low);
        quad_load(n + 2, apart, was.high);
        if (writes) {
            quad_store(n, apart, now.low);
            quad_store(n + 2, apart, now.high); /* the two numbers that are in both are the same */
        }
        for (int k = 0; k < PARTS; ++k) {
            /* cppcheck-suppress uninitvar ; quad_load writes it */
            now.low[k] -= was.low[k];
            now.high[k] -= was.high[k];
        }
        for (int k = 0; j < depth && k < PARTS; ++k) {
            sum.low[k] += was.low[k];
            sum.high[k] += was.high[k];
        }
    }
    for (int k = 0; k < PARTS; ++k) {
        /* cppcheck-suppress uninitvar ; quad_zero writes it */
        off->low[k] = f.low[k] - sum.low[k];
        off->high[k] = f.high[k] - sum.high[k];
    }
}

/** How many differences there are after the next. */
VTI_INLINE int64_t adams_levels(const vti_past *past)
{
    return past->known < past->depth ? past->known + 1 : past->depth;
}

VTI_INLINE void adams_add(const vti_view *view, int first, int64_t i, double t, const part d[PARTS])
{
    part a[PARTS];
    if (!vti_has(view))
        return;
    quad_of_view(view, first, i, a);
    quad_add(t, d, a);
    quad_into_view(view, first, i, a);
}

/** g = g_K + u. */
VTI_INLINE double adams_corrector(const vti_multistep *m)
{
    return adams_g[m->depth] + m->u;
}

/** c h^2 d_K: what the corrector adds to positions and turns by; 0, of rounding too, where it does neither. */
VTI_INLINE double adams_way(const vti_multistep *m, double h)
{
    return m->c * h * h * adams_d[m->depth];
}

/** By D, off: v = v_p + h g D_a,  x = x_p + c h^2 d_K D_a,  w = w_p + h g D_b, and turn = c h^2 d_K D_b;
 *  where c h^2 d_K = 0 turn is not written, since no body turns. */
static inline int64_t adams_correct(const vti_multistep *m, double h, const vti_past *past, const vti_bodies *bodies,
                                    int64_t begin, int64_t end, double *turn)
{
    const double g = h * adams_corrector(m), d = adams_way(m, h);
    const vti_view v = bodies->v, omega = bodies->omega, force = adams_load(&bodies->force, &v),
                   moment = adams_load(&bodies->moment, &omega);
    const vti_view x = vti_has(&v) ? bodies->x : v;
    const vti_scalars mass = bodies->mass, inertia = bodies->inertia;
    const int64_t depth = m->depth, levels = adams_levels(past), apart = 6 * past->depth;
    double *n = adams_differences(past, begin);
    int64_t i = begin;
    for (; i + AT_ONCE <= end; i += AT_ONCE, n += AT_ONCE * apart, turn += ADAMS_CORRECTION * AT_ONCE) {
        struct adams_felt f, off;
        adams_feel(&force, &mass, &moment, &inertia, i, &f);
        adams_compare(1, depth, levels, n, apart, f, &off);
        adams_add(&v, 0, i, g, off.low);
        adams_add(&omega, 1, i, g, off.high);
        if (d == 0.0)
            continue;
        adams_add(&x, 0, i, d, off.low);
        for (int k = 0; k < PARTS; ++k)
            off.high[k] *= d;
        quad_store(turn, ADAMS_CORRECTION, off.high);
    }
    return i;
}

#endif
