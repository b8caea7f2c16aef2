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

/** What pairs that begin just touching, up to rounding, lack of that. */
static const double nearly = 1.0 - 1e-12;

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

static void of_pairs(const vti_contacts *p, double h, const vti_view *before, const vti_bodies *b)
{
    for (int64_t k = 0; k < p->count; ++k) {
        const int64_t i = p->pair[2 * k] - p->base, j = p->pair[2 * k + 1] - p->base;
        const double length = vti_contact_length(p, k, i, j), touching = length * nearly;
        struct crossing at;
        double d[2][3], u[3], impulse[3], shift[3];
        const double square[2] = {vti_difference(before, i, j, d[0]), vti_difference(&b->x, i, j, d[1])};
        if (square[0] >= length * length && square[1] >= length * length)
            continue;
        for (int end = 0; end < 2; ++end) {
            const double r = sqrt(square[end]), per = r > VTI_COINCIDENT ? 1.0 / r : 0.0;
            at.overlap[end] = touching - r;
            for (int c = 0; c < 3; ++c)
                at.n[end][c] = d[end][c] * per;
        }
        if ((at.overlap[0] > 0.0) == (at.overlap[1] > 0.0))
            continue;
        vti_difference(&b->v, i, j, u);
        at.rate = -vti_dot(at.n[1], u);
        at.k = vti_contact_stiffness(p, i, j, length) / (length * length * sqrt(length));
        missed(&at, h, impulse, shift);
        take(b, i, 1.0, impulse, shift);
        take(b, j, -1.0, impulse, shift);
    }
}

/** Wall w, which moves with this velocity, and body i, which was at from, of the wall's place now, and is at x. Returns
 *  1 where that has crossed. */
static int of_wall(const vti_walls *p, int64_t w, double h, int64_t i, const double from[3], const double x[3],
                   const double velocity[3], const vti_bodies *b)
{
    const double radius = 0.5 * vti_scalar(&p->diameter, i), touching = radius * nearly;
    struct crossing at = {.rate = 0.0};
    double v[3], impulse[3], shift[3];
    at.overlap[0] = touching - vti_face_gap(p, w, from, at.n[0]);
    at.overlap[1] = touching - vti_face_gap(p, w, x, at.n[1]);
    if ((at.overlap[0] > 0.0) == (at.overlap[1] > 0.0))
        return 0;
    vti_load(&b->v, i, v);
    for (int k = 0; k < 3; ++k)
        v[k] -= velocity[k];
    at.rate = -vti_dot(at.n[1], v);
    at.k = vti_face_stiffness(p, w, i, radius) / (radius * radius * sqrt(radius));
    missed(&at, h, impulse, shift);
    take(b, i, 1.0, impulse, shift);
    return 1;
}

/** Where a wall moves it was where its velocity says. Most bodies are farther from a wall than they have come, which
 *  takes the gap at their place alone. */
static void of_walls(const vti_walls *p, double h, const vti_view *before, const vti_bodies *b)
{
    static const vti_wall_motion still;
    const int64_t faces = vti_faces(p);
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        const double touching = 0.5 * vti_scalar(&p->diameter, i) * nearly;
        double was[3], x[3], from[3] = {0.0}, way[3], n[3], square = 0.0;
        int fresh = 1; /* x is */
        vti_load(before, i, was);
        vti_load(&b->x, i, x);
        for (int64_t w = 0; w < faces; ++w) {
            const double *const velocity = (p->motion != NULL ? &p->motion[w] : &still)->velocity;
            const double overlap = touching - vti_face_gap(p, w, x, n);
            if (p->motion != NULL || fresh) {
                for (int k = 0; k < 3; ++k) {
                    from[k] = was[k] + h * velocity[k];
                    way[k] = x[k] - from[k];
                }
                square = 2.0 * vti_dot(way, way);
            }
            fresh = 0;
            if (overlap * overlap > square) /* it cannot have crossed */
                continue;
            fresh = of_wall(p, w, h, i, from, x, velocity, b);
            if (fresh)
                vti_load(&b->x, i, x);
        }
    }
}

static int check(double h, const vti_view *before, const vti_contacts *contacts, const vti_walls *walls,
                 const vti_bodies *b)
{
    vti_effect effects[2];
    int64_t n = 0;
    int status = vti_bodies_ready(b);
    if (status != VTI_OK)
        return status;
    if (before == NULL)
        return VTI_E_NULL;
    if (!vti_is_positive(h))
        return VTI_E_TIME;
    for (int k = 0; k < 3; ++k)
        if (before->c[k] == NULL)
            return VTI_E_VIEW;
        else if (before->c[k] == b->x.c[k])
            return VTI_E_ALIAS;
    vti_bodies earlier = *b; /* whose positions they are */
    earlier.x = *before;
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
