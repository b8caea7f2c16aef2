/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Contacts that may come (EQUATIONS 6.10): each body i in a cage of as many neighbours as have room around it, or as
 * there are bodies. As |u_i - u_j|^2 <= 2 |u_i|^2 + 2 |u_j|^2, contacts are no stiffer than springs of twice the k_ij
 * of all neighbours together that hold every body to its place. */
#ifndef VTI_CAGE_H
#define VTI_CAGE_H

#include "vti_hertz.h"
#include "../vti_ready.h"

/** What cages depend on: extremes over bodies and pairs. */
struct vti_cages {
    const vti_contacts *contacts;
    int64_t bodies;
    double least, most; /* radii */
    double modulus;     /* the largest; 0 where there is none */
    double near, far;   /* L of a pair over (D_i + D_j)/2: the least, 1 at most, and the most, 1 at least */
};

/** The neighbours of a body, at the overlap o of each. */
struct vti_cage {
    double z;         /* how many they are */
    double length;    /* L of the shortest contact that there may be */
    double stiffness; /* z contacts of this K on that length are as stiff as all neighbours together, or stiffer */
};

/** VTI_E_BOND if a pair that has a length of its own names bodies outside the slice. */
static inline int vti_cages_of(const vti_contacts *p, const vti_bodies *b, struct vti_cages *cages)
{
    struct vti_cages c = {p, b->count, INFINITY, 0.0, 0.0, 1.0, 1.0};
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        c.least = fmin(c.least, 0.5 * vti_scalar(&p->diameter, i));
        c.most = fmax(c.most, 0.5 * vti_scalar(&p->diameter, i));
        c.modulus = fmax(c.modulus, p->modulus.p != NULL ? vti_scalar(&p->modulus, i) : 0.0);
    }
    for (int64_t k = 0; p->length.p != NULL && k < p->count; ++k) {
        const int64_t i = p->pair[2 * k] - p->base, j = p->pair[2 * k + 1] - p->base;
        if (vti_pair_check(b, i, j) != VTI_OK)
            return VTI_E_BOND;
        const double mean = 0.5 * vti_scalar(&p->diameter, i) + 0.5 * vti_scalar(&p->diameter, j);
        c.near = fmin(c.near, vti_scalar(&p->length, k) / mean);
        c.far = fmax(c.far, vti_scalar(&p->length, k) / mean);
    }
    *cages = c;
    return VTI_OK;
}

/** How many spheres of radii from least to most have room around one of that radius, centres no nearer than the share q
 *  of both radii and those that touch it no farther than the share far of both. A ball of radius q least inside each,
 *  as near to it as can be, keeps its centre between
 *
 *      inner = q (radius + least)    and    outer = far radius + (far - q) most + q least,
 *
 *  and 2 q least from the others. Seen from the middle two of them are 2 psi apart and more, where v = 1 - cos(2 psi)
 *  is least with both outside or with one at either end, and z caps of the angle psi cover a sphere at most: z (1 - cos
 *  psi) <= 2. And all lie between two spheres, the volume of which tells, too: of those that overlap much some hide
 *  behind others. */
static inline double vti_cage_room(const struct vti_cages *c, double radius, double least, double most, double q)
{
    const double ball = q * least, inner = q * (radius + least), outer = c->far * radius + (c->far - q) * most + ball;
    const double apart = 2.0 * ball, depth = outer - inner, hole = q * radius / ball, all = outer / ball + 1.0;
    const double v =
        fmin(0.5 * (apart / outer) * (apart / outer), (apart - depth) / inner * ((apart + depth) / outer) * 0.5);
    const double volume = all * all * all - hole * hole * hole, caps = 4.0 * (1.0 + sqrt(1.0 - 0.5 * v)) / v;
    return !(ball > 0.0) ? INFINITY : v > 0.0 ? fmin(volume, caps) : volume;
}

/** k L^2 of a pair of body i with others of radii from least to most at the overlap o is (3/2) K o^{1/2}: the largest
 *  K/L^2 that there may be, of one K for all with the smallest, of a material, 4/3 E* (R* L)^{1/2}, with the
 *  largest. */
static inline double vti_cage_hardness(const struct vti_cages *c, int64_t i, double least, double most)
{
    const vti_contacts *p = c->contacts;
    const double radius = 0.5 * vti_scalar(&p->diameter, i), length = c->near * (radius + least);
    if (p->modulus.p == NULL)
        return p->stiffness / (length * length);
    return 4.0 / 3.0 * vti_hertz_reduced(vti_scalar(&p->modulus, i), c->modulus) * sqrt(radius * most * c->far);
}

/** The cage of body i: for each octave of sizes as many as there is room for, as if there were no others. */
static inline struct vti_cage vti_cage_at(const struct vti_cages *c, int64_t i, double o)
{
    const double radius = 0.5 * vti_scalar(&c->contacts->diameter, i), others = (double)(c->bodies - 1);
    const double q = o < 1.0 ? (1.0 - o) * c->near : 0.0, length = c->near * (radius + c->least);
    double z = 0.0, together = 0.0, least = c->least, most = 0.0;
    while (most < c->most && least > 0.0) {
        most = fmin(2.0 * least, c->most);
        const double room = fmin(others, vti_cage_room(c, radius, least, most, q));
        z += room;
        together += room * vti_cage_hardness(c, i, least, most);
        least = most;
    }
    z = fmin(z, others);
    together = fmin(together, others * vti_cage_hardness(c, i, c->least, c->most));
    return (struct vti_cage){z, length, together / z * (length * length)};
}

#endif
