/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bodies of any inertia where they act on each other: vti_joint.h. */
#include "vti_joint.h"
#include "../vti_moments.h"

/* ---- bodies ------------------------------------------------------------------------------------------------------ */

static void load_turning(const vti_bodies *b, int64_t i, struct vti_joint_side *side)
{
    if (vti_has(&b->moments)) {
        vti_rotor_axes(b, i, side->per, side->axis);
        if (vti_has(&b->spin))
            vti_rotor_over(b, i, &b->spin, side->w);
        else
            vti_load(&b->omega, i, side->w);
        return;
    }
    vti_load(&b->omega, i, side->w);
    for (int k = 0; k < 3; ++k) {
        side->per[k] = 1.0 / vti_scalar(&b->inertia, i);
        side->axis[k][k] = 1.0;
    }
}

void vti_joint_load(const struct vti_bearing *of, int64_t i, const double place[3], struct vti_joint_side *side)
{
    static const struct vti_joint_side still;
    const vti_bodies *const b = of->bodies;
    double lever[3] = {0.0, 0.0, 0.0};
    *side = still;
    side->body = i;
    if (of->clumps != NULL) {
        side->body = of->clumps->body[i] - of->clumps->base;
        vti_clump_lever(of->clumps, b, i, side->body, lever);
    }
    for (int k = 0; k < 3; ++k)
        side->arm[k] = lever[k] + place[k];
    if (vti_has(&b->v)) {
        side->per_m = 1.0 / vti_scalar(&b->mass, side->body);
        vti_load(&b->v, side->body, side->v);
    }
    if (vti_has(&b->omega) || vti_has(&b->spin))
        load_turning(b, side->body, side);
}

void vti_joint_store(const struct vti_bearing *of, const struct vti_joint_side *side)
{
    const vti_bodies *const b = of->bodies;
    double w[3];
    if (side->body < 0)
        return;
    if (vti_has(&b->v))
        vti_store(&b->v, side->body, side->v);
    if (vti_has(&b->spin)) {
        vti_add(&b->spin, side->body, side->taken);
        if (vti_has(&b->omega)) {
            vti_rotor_over(b, side->body, &b->spin, w);
            vti_store(&b->omega, side->body, w);
        }
    } else if (vti_has(&b->omega))
        vti_store(&b->omega, side->body, side->w);
}

/* ---- velocities and impulses ------------------------------------------------------------------------------------- */

void vti_joint_velocity(const struct vti_joint *at, int turns, double u[3])
{
    const struct vti_joint_side *const i = &at->side[0], *const j = &at->side[1];
    double of_i[3], of_j[3];
    vti_cross(i->w, i->arm, of_i);
    vti_cross(j->w, j->arm, of_j);
    for (int k = 0; k < 3; ++k)
        u[k] = turns ? i->w[k] - j->w[k] : (i->v[k] - j->v[k]) + (of_i[k] - of_j[k]);
}

/** L += l */
static void turn(struct vti_joint_side *side, const double l[3])
{
    for (int k = 0; k < 3; ++k) {
        const double by = side->per[k] * vti_dot(side->axis[k], l);
        for (int c = 0; c < 3; ++c)
            side->w[c] += by * side->axis[k][c];
        side->taken[k] += l[k];
    }
}

void vti_joint_push(struct vti_joint *at, int turns, const double p[3])
{
    for (int j = 0; j < 2; ++j) {
        struct vti_joint_side *const side = &at->side[j];
        const double own[3] = {j ? -p[0] : p[0], j ? -p[1] : p[1], j ? -p[2] : p[2]};
        double moment[3];
        if (turns) {
            turn(side, own);
            continue;
        }
        for (int k = 0; k < 3; ++k)
            side->v[k] += side->per_m * own[k];
        vti_cross(side->arm, own, moment);
        turn(side, moment);
    }
}

/* ---- modes ------------------------------------------------------------------------------------------------------- */

/** e.K f, or e.H f */
static double inverse_mass_of(const struct vti_joint *at, int turns, const double e[3], const double f[3])
{
    double sum = turns ? 0.0 : (at->side[0].per_m + at->side[1].per_m) * vti_dot(e, f);
    for (int j = 0; j < 2; ++j) {
        const struct vti_joint_side *const side = &at->side[j];
        double of_e[3] = {e[0], e[1], e[2]}, of_f[3] = {f[0], f[1], f[2]};
        if (!turns) {
            vti_cross(side->arm, e, of_e);
            vti_cross(side->arm, f, of_f);
        }
        for (int k = 0; k < 3; ++k)
            sum += side->per[k] * vti_dot(side->axis[k], of_e) * vti_dot(side->axis[k], of_f);
    }
    return sum;
}

/** Jacobi's rotation that makes a diagonal, and the directions along. */
static void rotate(double a[2][2], double g[2][3])
{
    if (a[0][1] == 0.0)
        return;
    const double ratio = 0.5 * (a[1][1] - a[0][0]) / a[0][1];
    const double t = copysign(1.0, ratio) / (fabs(ratio) + sqrt(1.0 + ratio * ratio)), c = 1.0 / sqrt(1.0 + t * t),
                 s = t * c;
    a[0][0] -= t * a[0][1];
    a[1][1] += t * a[0][1];
    for (int k = 0; k < 3; ++k) {
        const double g_p = g[0][k], g_q = g[1][k];
        g[0][k] = c * g_p - s * g_q;
        g[1][k] = s * g_p + c * g_q;
    }
}

/** Beside the largest inverse mass a small one is not known below the rounding error of the largest, which is taken
 *  then: with one that is too small the impulse would be too large, and the mode would gain energy. */
static const double least_inverse_mass = 0x1p-48;

void vti_joint_modes_of(const struct vti_joint *at, int turns, int n, const double span[][3],
                        struct vti_joint_modes *modes)
{
    double a[2][2] = {{0.0}}, largest = 0.0;
    modes->count = n;
    for (int p = 0; p < n; ++p)
        for (int k = 0; k < 3; ++k)
            modes->along[p][k] = span[p][k];
    for (int p = 0; p < n; ++p)
        for (int q = p; q < n; ++q)
            a[p][q] = a[q][p] = inverse_mass_of(at, turns, span[p], span[q]);
    rotate(a, modes->along);
    for (int p = 0; p < n; ++p)
        largest = a[p][p] > largest ? a[p][p] : largest;
    for (int p = 0; p < n; ++p)
        modes->inverse_mass[p] = a[p][p] > least_inverse_mass * largest ? a[p][p] : least_inverse_mass * largest;
}

void vti_joint_decay(const struct vti_joint_modes *modes, const double c[3], double t, const double a[3], double p[3])
{
    double z[3];
    struct vti_decay d[3];
    p[0] = p[1] = p[2] = 0.0;
    for (int m = 0; m < modes->count; ++m)
        z[m] = c[m] * t * modes->inverse_mass[m];
    vti_decays(modes->count, z, d);
    for (int m = 0; m < modes->count; ++m) {
        const double k = modes->inverse_mass[m], size = k > 0.0 ? -d[m].gone / k * vti_dot(a, modes->along[m]) : 0.0;
        for (int q = 0; q < 3; ++q)
            p[q] += size * modes->along[m][q];
    }
}

double vti_joint_lost(const struct vti_joint_modes *modes, const double a[3], const double p[3])
{
    double lost = 0.0;
    for (int m = 0; m < modes->count; ++m) {
        const double size = vti_dot(p, modes->along[m]);
        lost -= size * (vti_dot(a, modes->along[m]) + 0.5 * modes->inverse_mass[m] * size);
    }
    return lost;
}

void vti_joint_across(const double n[3], double span[2][3])
{
    int least = fabs(n[1]) < fabs(n[0]) ? 1 : 0;
    least = fabs(n[2]) < fabs(n[least]) ? 2 : least;
    const double axis[3] = {least == 0, least == 1, least == 2};
    vti_cross(n, axis, span[0]);
    const double length = vti_norm(span[0]);
    for (int k = 0; k < 3; ++k)
        span[0][k] /= length;
    vti_cross(n, span[0], span[1]);
}
