/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Sound bodies and lists for the tests of wrong use, which spoil copies of them; memory that must stay as it is. */
#ifndef VTI_TESTS_MISUSE_H
#define VTI_TESTS_MISUSE_H

#include "support.h"

enum { N = 4, V = 3 * N };

static struct memory {
    double x[V], v[V], f[V], alpha[V], w[V], m[V], x_low[V], quat[4 * N], mass[N], inertia[N], other[V];
} now, before;
static double scratch[N];
static const double bad_times[] = {0.0, -0.125, NAN, INFINITY, -INFINITY}, stiffness = 10.0, diameter = 1.5;
static const double rest[4] = {-1, 0, 0, 1}, plane[4] = {0, 0, 1, 0}, no_mass = 0.0, negative = -1.0,
                    not_a_number = NAN;
static const int64_t pair[2] = {0, 1};
static const vti_pendulum pendulum = {1.0, {0, 0, 1}};
static const vti_gravity gravity = {{0, 0, -1}};
static vti_bodies good;
static vti_bonds bonds;
static vti_contacts contacts;
static vti_walls walls;

static inline int setup(void **state)
{
    (void)state;
    double *p = (double *)&now;
    for (size_t k = 0; k < sizeof now / sizeof *p; ++k)
        p[k] = 0.25 + 0.0625 * (double)k;
    good = vti_bodies_none(N);
    good.x = vti_view_packed(now.x);
    good.v = vti_view_packed(now.v);
    good.force = vti_view_packed(now.f);
    good.alpha = vti_view_packed(now.alpha);
    good.omega = vti_view_packed(now.w);
    good.moment = vti_view_packed(now.m);
    good.x_low = vti_view_packed(now.x_low);
    good.mass = vti_scalars_array(now.mass);
    good.inertia = vti_scalars_array(now.inertia);
    const vti_scalars k = vti_scalars_one(&stiffness), d = vti_scalars_one(&diameter);
    const vti_bonds some_bonds = {1, pair, 0, rest, k, k, k, VTI_SHEAR_OBJECTIVE};
    const vti_contacts some_contacts = {1, pair, 0, d, 1.0};
    const vti_walls some_walls = {1, plane, d, 1.0};
    bonds = some_bonds;
    contacts = some_contacts;
    walls = some_walls;
    before = now;
    return 0;
}

static inline const vti_stepper *vti2(void)
{
    return vti_stepper_find("vti2");
}

static inline vti_bodies elsewhere(void)
{
    vti_bodies b = good;
    b.x = vti_view_packed(now.other);
    b.x_low = vti_view_none();
    return b;
}

#endif
