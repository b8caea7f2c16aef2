/* SPDX-License-Identifier: BSD-3-Clause
 *
 * One body of three moments with its state, for the tests that follow its motion. */
#ifndef VTI_TESTS_TOP_H
#define VTI_TESTS_TOP_H

#include "bodies.h"
#include "play.h"

enum top_storage { TOP_ALPHA, TOP_QUAT, TOP_RESIDUALS, TOP_STORAGES };

/** What of the spin a host shows: L, L and Omega, or Omega. */
enum top_spin { TOP_L, TOP_BOTH, TOP_OMEGA };

typedef struct top {
    double alpha[3], quat[4], spin[3], omega[3], moment[3], alpha_low[3], spin_low[3], moments[3], principal[4];
    enum top_storage storage;
    enum top_spin shows;
    int turned; /* whether its principal axes are not the body's */
} top;

static inline vti_bodies top_bodies(top *p)
{
    vti_bodies b = vti_bodies_none(1);
    b.moments = vti_view_packed(p->moments);
    b.moment = vti_view_packed(p->moment);
    if (p->turned)
        b.principal = quats_packed(p->principal);
    if (p->shows != TOP_OMEGA)
        b.spin = vti_view_packed(p->spin);
    if (p->shows != TOP_L)
        b.omega = vti_view_packed(p->omega);
    if (p->storage == TOP_QUAT)
        b.quat = quats_packed(p->quat);
    else
        b.alpha = vti_view_packed(p->alpha);
    if (p->storage == TOP_RESIDUALS) {
        b.alpha_low = vti_view_packed(p->alpha_low);
        if (p->shows != TOP_OMEGA)
            b.spin_low = vti_view_packed(p->spin_low);
    }
    return b;
}

static inline rotor top_attitude(const top *p)
{
    return p->storage == TOP_QUAT ? quat_of_xyzw(p->quat) : quat_of_alpha(p->alpha);
}

/** R_p: from the principal axes into space. */
static inline rotor top_axes(const top *p)
{
    return p->turned ? quat_times(top_attitude(p), quat_of_xyzw(p->principal)) : top_attitude(p);
}

static inline void top_set_attitude(top *p, rotor q)
{
    quat_store(q, p->quat, p->alpha);
}

/** R_p diag(1/moments) R_p^T L */
static inline void top_omega(const top *p, double w[3])
{
    const rotor q = top_axes(p);
    quat_rotate(quat_conj(q), p->spin, w);
    for (int k = 0; k < 3; ++k)
        w[k] /= p->moments[k];
    quat_rotate(q, w, w);
}

/** Moments of a real body: of three shares of a mass, a + b, b + c, c + a. */
static inline void top_moments(rng *g, double least, double moments[3])
{
    double share[3];
    for (int k = 0; k < 3; ++k)
        share[k] = exp(uniform(g, log(least), 0));
    for (int k = 0; k < 3; ++k)
        moments[k] = share[k] + share[(k + 1) % 3];
}

/** A random body, |L| of about the moments. */
static inline top top_random(rng *g, enum top_storage storage, enum top_spin shows)
{
    top p;
    memset(&p, 0, sizeof p);
    double q[4];
    random_unit(g, 4, q);
    const rotor attitude = {q[0], q[1], q[2], q[3]};
    top_set_attitude(&p, attitude);
    random_unit(g, 4, p.principal);
    top_moments(g, 0.1, p.moments);
    random_vector(g, p.moments[0], p.spin);
    random_vector(g, 1, p.moment);
    p.storage = storage;
    p.shows = shows;
    p.turned = rng_below(g, 2);
    top_omega(&p, p.omega);
    return p;
}

#endif
