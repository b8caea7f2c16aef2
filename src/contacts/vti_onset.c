/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What equal steps miss where a Hertzian contact begins or ends within one (EQUATIONS 3, 8.1). A time t inside of the
 * crossing the overlap is r t + c t^2, and the force along the normal n + t n'
 *
 *     k (r t + c t^2)^{3/2} (n + t n') = k r^{3/2} [t^{3/2} n + t^{5/2} ((3/2) (c/r) n + n')] + ...,   k = K/L^{5/2},
 *
 * which no polynomial follows: sums over its samples have an impulse P and a dipole Q too many (I. Navot, An extension
 * of the Euler-Maclaurin summation formula to functions with a branch singularity, J. Math. and Phys. 40, 1961),
 *
 *     P = k r^{3/2} h^{5/2} [zeta(-3/2, a) n + h zeta(-5/2, a) ((3/2) (c/r) n + n')]
 *     Q = k r^{3/2} h^{7/2} zeta(-5/2, a) n
 *
 * zeta being Hurwitz's and a h the time from the crossing to the first sample inside; where the contact ends t goes
 * backwards, and n' and Q change their signs. In a multistep method a sample's weights come to h in v and to h times
 * the time since in x, whatever the order: after the time s since the crossing m v is wrong by P and m x by s P - Q,
 * which are taken off. What is left is of order h^{9/2}. */
#include "vti_face.h"
#include "vti_touch_table.h"
#include "../vti_ready.h"

/** zeta(-3/2, a) and zeta(-5/2, a) of 0 < a <= 1 to 2e-8: four terms, and the formula of Euler and Maclaurin. */
static void zetas(double a, double *three, double *five)
{
    double sum3 = 0.0, sum5 = 0.0, y = a;
    for (int k = 0; k < 4; ++k) {
        const double y3 = y * sqrt(y);
        sum3 += y3;
        sum5 += y * y3;
        y += 1.0;
    }
    const double root = sqrt(y), y3 = y * root, y5 = y * y3, per = 1.0 / (y * y);
    *three = sum3 - 0.4 * y5 + 0.5 * y3 - 0.125 * root - per * root * (1.0 / 1920.0 - per / 21504.0);
    *five = sum5 - 2.0 / 7.0 * y * y5 + 0.5 * y5 - 5.0 / 24.0 * y3 + per * y3 * (1.0 / 384.0 - per / 21504.0);
}

/** A contact before and after a step of h: overlaps as lengths, normals, and the rate of the overlap after it. */
struct crossing {
    double overlap[2], n[2][3], rate;
    double k;
};

/** Of one that has begun or ended: what is to be taken off m v and m x. */
static void missed(const struct crossing *at, double h, double impulse[3], double shift[3])
{
    const int begins = at->overlap[1] > at->overlap[0];
    const double c = (at->overlap[0] - at->overlap[1] + h * at->rate) / (h * h), inside = at->overlap[begins];
    const double inwards = begins ? at->rate : 2.0 * c * h - at->rate, square = inwards * inwards - 4.0 * c * inside;
    const double r = sqrt(fabs(square)); /* negative by rounding alone */
    const double t = 2.0 * inside / (inwards + r), since = begins ? t : h - t;
    double three, five;
    zetas(t / h, &three, &five);
    const double scale = at->k * sqrt(r) * h * h * sqrt(h);
    const double p = scale * (r * three + 1.5 * c * h * five), q = (begins ? scale : -scale) * r * h * five;
    for (int k = 0; k < 3; ++k) {
        const double turning = (at->n[1][k] - at->n[0][k]) / h, n = at->n[1][k] - since * turning;
        impulse[k] = p * n + q * turning;
        shift[k] = since * impulse[k] - q * n;
    }
}

/** With sign 1 off body i, with -1 on it. */
static void take(const vti_bodies *b, int64_t i, double sign, const double impulse[3], const double shift[3])
{
    const double per = vti_owns(b, i) ? -sign / vti_scalar(&b->mass, i) : 0.0;
    for (int k = 0; k < 3 && per != 0.0; ++k) {
        b->v.c[k][i * b->v.stride] += per * impulse[k];
        b->x.c[k][i * b->x.stride] += per * shift[k];
    }
}

/** Pair k has begun or ended to touch. */
static void of_pair(const vti_contacts *p, int64_t k, double h, const vti_view *before, const vti_bodies *b)
{
    const int64_t i = vti_contact_body(p, k, 0), j = vti_contact_body(p, k, 1);
    const double length = vti_contact_length(p, k, i, j);
    struct crossing at = {.rate = 0.0};
    double u[3], impulse[3], shift[3];
    for (int end = 0; end < 2; ++end) {
        const double r = sqrt(vti_difference(end == 0 ? before : &b->x, i, j, at.n[end]));
        at.overlap[end] = length * VTI_JUST_TOUCHING - r;
        for (int c = 0; c < 3; ++c)
            at.n[end][c] *= r > VTI_COINCIDENT ? 1.0 / r : 0.0;
    }
    vti_difference(&b->v, i, j, u);
    at.rate = -vti_dot(at.n[1], u);
    at.k = vti_contact_stiffness(p, i, j, length) / (length * length * sqrt(length));
    missed(&at, h, impulse, shift);
    take(b, i, 1.0, impulse, shift);
    take(b, j, -1.0, impulse, shift);
}

/** Body i, if it has at wall w. Where that moves the body was where the wall's velocity says. */
static void of_body(const vti_walls *p, int64_t w, int64_t i, double h, const vti_view *before, const vti_bodies *b)
{
    static const vti_wall_motion still;
    const double *const velocity = (p->motion != NULL ? &p->motion[w] : &still)->velocity;
    const double radius = 0.5 * vti_scalar(&p->diameter, i), touching = radius * VTI_JUST_TOUCHING;
    struct crossing at = {.rate = 0.0};
    double from[3], x[3], v[3], way[3], impulse[3], shift[3];
    vti_load(before, i, from);
    vti_load(&b->x, i, x);
    for (int k = 0; k < 3; ++k) {
        from[k] += h * velocity[k];
        way[k] = x[k] - from[k];
    }
    at.overlap[0] = touching - vti_face_gap(p, w, from, at.n[0]);
    at.overlap[1] = touching - vti_face_gap(p, w, x, at.n[1]);
    const int far = at.overlap[1] * at.overlap[1] > 2.0 * vti_dot(way, way); /* as in cross_row */
    if (far || (at.overlap[0] > 0.0) == (at.overlap[1] > 0.0))
        return;
    vti_load(&b->v, i, v);
    for (int k = 0; k < 3; ++k)
        v[k] -= velocity[k];
    at.rate = -vti_dot(at.n[1], v);
    at.k = vti_face_stiffness(p, w, i, radius) / (radius * radius * sqrt(radius));
    missed(&at, h, impulse, shift);
    take(b, i, 1.0, impulse, shift);
}

/** One after the other: what is taken off one moves bodies that the next is looked for by. */
static void of_pairs(const vti_contacts *p, double h, const vti_view *before, const vti_bodies *b)
{
    const struct vti_touch_kernels *const kernels = vti_touch_kernels_for(p->count);
    for (int64_t k = 0; (k = kernels->crossing(p, before, b, k)) < p->count; ++k)
        of_pair(p, k, h, before, b);
}

static void of_walls(const vti_walls *p, double h, const vti_view *before, const vti_bodies *b)
{
    const struct vti_touch_kernels *const kernels = vti_touch_kernels_for(b->count);
    const int64_t faces = vti_faces(p), end = b->first + b->count;
    for (int64_t i = b->first; (i = kernels->crossing_wall(p, h, before, b, i)) < end; ++i)
        for (int64_t w = 0; w < faces; ++w)
            of_body(p, w, i, h, before, b);
}

static int check(double h, const vti_view *before, const vti_contacts *contacts, const vti_walls *walls,
                 const vti_bodies *b)
{
    vti_effect effects[2];
    int64_t n = 0;
    int status = vti_bodies_ready(b);
    if (status == VTI_OK)
        status = vti_multistep_suits(b, NULL);
    if (status != VTI_OK)
        return status;
    if (b->count == 0)
        return VTI_OK;
    if (before == NULL)
        return VTI_E_NULL;
    if (!vti_is_positive(h))
        return VTI_E_TIME;
    for (int k = 0; k < 3; ++k)
        if (before->c[k] == NULL)
            return VTI_E_VIEW;
        else if (before->c[k] == b->x.c[k])
            return VTI_E_ALIAS;
    vti_bodies earlier = *b; /* whose positions they are, beside those of now */
    earlier.x = *before;
    earlier.x_low = b->x;
    status = vti_bodies_fault(&earlier, NULL);
    if (status != VTI_OK)
        return status;
    if (contacts != NULL)
        effects[n++] = vti_contacts_effect(contacts);
    if (walls != NULL)
        effects[n++] = vti_walls_effect(walls);
    for (int64_t k = 0; k < n; ++k)
        effects[k].needs |= 1 << VTI_QUANTITY_V | 1 << VTI_QUANTITY_MASS;
    return vti_effects_check(effects, n, b, NULL);
}

int vti_multistep_touch(double h, const vti_view *before, const vti_contacts *contacts, const vti_walls *walls,
                        const vti_bodies *b)
{
    const int status = check(h, before, contacts, walls, b);
    if (status != VTI_OK || b->count == 0)
        return status;
    if (contacts != NULL)
        of_pairs(contacts, h, before, b);
    if (walls != NULL)
        of_walls(walls, h, before, b);
    return VTI_OK;
}
