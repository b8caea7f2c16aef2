/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The first of the two primitives of every stepper (EQUATIONS 2):
 *
 *     kick(t):  v += t F/m,  Omega += t RM/J
 *
 * Each loop is written once, for any stride, and compiled for the usual strides as well, which changes its speed and not
 * its bits. `restrict` stands on parameters because compilers do not honour it on pointers taken from a struct. */
#include "vti_sum.h"

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
        vti_sum_compensated(t, v, f, m, low, begin, end);
        return;
    }
#define KICK(SV, SF, SM)                                                                                               \
    kick_loop(v->c[0], v->c[1], v->c[2], SV, f->c[0], f->c[1], f->c[2], SF, m->p, SM, t, begin, end)
    if (end - begin > VTI_FEW && vti_is_packed(v) && vti_is_packed(f) && m->stride == 0)
        vti_sum_packed(v->c[0] + 3 * begin, f->c[0] + 3 * begin, t / *m->p, 3 * (end - begin));
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

void vti_kick_v(double t, const vti_bodies *b, int64_t begin, int64_t end)
{
    if (t != 0.0 && vti_has(&b->v) && vti_has(&b->force))
        kick_view(t, &b->v, &b->force, &b->mass, &b->v_low, begin, end);
}

void vti_kick_omega(double t, const vti_bodies *b, int64_t begin, int64_t end)
{
    if (t != 0.0 && vti_has(&b->omega) && vti_has(&b->moment))
        kick_view(t, &b->omega, &b->moment, &b->inertia, &b->omega_low, begin, end);
}

int vti_kick(double t, const vti_bodies *b)
{
    const int status = vti_bodies_ready(b);
    if (status != VTI_OK)
        return status;
    if (!isfinite(t))
        return VTI_E_TIME;
    vti_kick_v(t, b, b->first, b->first + b->count);
    vti_kick_omega(t, b, b->first, b->first + b->count);
    return VTI_OK;
}
