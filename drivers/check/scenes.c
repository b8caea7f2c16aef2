/* SPDX-License-Identifier: BSD-3-Clause */
#include "check.h"

#include <string.h>

static const int64_t one_pair[2] = {0, 1};
static const double rest[4] = {-1.0, 0.0, 0.0, 1.0}; /* n0 = (x_0 - x_1)/L0 with body 1 on the right, L0 = 1 */
static const double stiff_moment = 8.0, stiff_axial = 15.0, stiff_shear = 10.0, stiff_torsion = 0.5,
                    stiff_stretch = 0.5, stiff_spring = 2.0;
static const vti_pendulum paper = {1.0, {0.0, 0.0, 1.0}};

static void bond(struct field *field, int is_torsion)
{
    memset(field, 0, sizeof *field);
    vti_bonds *b = &field->bonds;
    b->count = 1;
    b->pair = one_pair;
    b->rest = rest;
    b->moment = vti_scalars_one(is_torsion ? &stiff_torsion : &stiff_moment);
    if (!is_torsion) {
        b->axial = vti_scalars_one(&stiff_axial);
        b->shear = vti_scalars_one(&stiff_shear);
    }
    b->shear_form = VTI_SHEAR_OBJECTIVE;
    field->effect = vti_bonds_effect(b);
    field->count = 1;
}

static void set(double *to, double x, double y, double z)
{
    to[0] = x;
    to[1] = y;
    to[2] = z;
}

static void turn(struct bodies *b, int64_t i, double x, double y, double z)
{
    const double rotvec[3] = {x, y, z};
    double alpha[3];
    vti_rrv_from_rotvec(rotvec, alpha);
    vti_kit_bodies_set_alpha(b, i, alpha);
}

struct bodies vti_kit_scene_pendulum(struct field *field)
{
    struct bodies b = vti_kit_bodies_none(1);
    memset(field, 0, sizeof *field);
    field->effect = vti_pendulum_effect(&paper);
    field->count = 1;
    turn(&b, 0, 0.0, 0.75 * CHECK_PI, 0.0);
    set(b.w, 0.2, 0.0, 0.2);
    return b;
}

/** Two unlike bodies, bonded (moment, axial, shear), strained, moving and spinning. */
static struct bodies scene_pair(struct field *field)
{
    struct bodies b = vti_kit_bodies_none(2);
    bond(field, 0);
    b.mass[0] = 1.0;
    b.mass[1] = 1.5;
    b.inertia[0] = 0.4;
    b.inertia[1] = 0.7;
    set(b.x, 0.0, 0.0, 0.0);
    set(b.x + 3, 1.1, 0.1, -0.05);
    set(b.v, 0.2, -0.3, 0.1);
    set(b.v + 3, -0.1, 0.3, 0.2);
    turn(&b, 0, 0.1, -0.2, 0.15);
    turn(&b, 1, -0.1, 0.1, 0.2);
    set(b.w, 0.5, 0.3, -0.4);
    set(b.w + 3, 0.2, -0.3, 0.6);
    return b;
}

static void spring(struct field *field, const double *stiffness)
{
    bond(field, 0);
    field->bonds.moment.p = field->bonds.shear.p = NULL;
    field->bonds.axial = vti_scalars_one(stiffness);
    field->effect = vti_bonds_effect(&field->bonds);
}

struct bodies vti_kit_scene_spring(struct field *field)
{
    struct bodies b = vti_kit_bodies_none(2);
    spring(field, &stiff_spring);
    b.mass[1] = 1.5;
    set(b.x + 3, 1.3, 0.0, 0.0);
    set(b.v, 0.2, -0.6, 0.4);
    set(b.v + 3, -0.1, 0.5, 0.2);
    return b;
}

struct bodies vti_kit_scene_bonded(const struct kit *kit, struct field *field)
{
    return kit->rotates ? scene_pair(field) : vti_kit_scene_spring(field);
}

/** m r'' = -2 K/L0 (r/L0 - 1) for the distance r of two like bodies, m = L0 = 1. */
struct bodies vti_kit_scene_stretch(struct field *field)
{
    struct bodies b = vti_kit_bodies_none(2);
    spring(field, &stiff_stretch);
    set(b.x, -0.5e-3, 0.0, 0.0);
    set(b.x + 3, 1.0 + 0.5e-3, 0.0, 0.0);
    return b;
}

/** m W^2 r/2 = (K/L0)(r/L0 - 1) with m = L0 = 1: r = K/(K - W^2/2). */
struct bodies vti_kit_scene_rigid(struct field *field, double *r)
{
    const double spin = 0.5;
    struct bodies b = vti_kit_bodies_none(2);
    bond(field, 0);
    *r = stiff_axial / (stiff_axial - 0.5 * spin * spin);
    b.inertia[0] = b.inertia[1] = 0.4;
    set(b.x, -0.5 * *r, 0.0, 0.0);
    set(b.x + 3, 0.5 * *r, 0.0, 0.0);
    set(b.v, 0.3, -0.5 * spin * *r, 0.0);
    set(b.v + 3, 0.3, 0.5 * spin * *r, 0.0);
    set(b.w, 0.0, 0.0, spin);
    set(b.w + 3, 0.0, 0.0, spin);
    return b;
}

/** J theta'' = -2 K theta for the twist theta of two like bodies, J = 1. */
struct bodies vti_kit_scene_torsion(struct field *field)
{
    struct bodies b = vti_kit_bodies_none(2);
    bond(field, 1);
    set(b.x + 3, 1.0, 0.0, 0.0);
    turn(&b, 0, 0.0, 0.0, 0.5e-3);
    turn(&b, 1, 0.0, 0.0, -0.5e-3);
    return b;
}
