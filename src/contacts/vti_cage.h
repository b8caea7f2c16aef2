/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Contacts that may come (EQUATIONS 6.10): each body i in a cage of as many neighbours as have room around it, or as
 * there are bodies. As |u_i - u_j|^2 <= 2 |u_i|^2 + 2 |u_j|^2, contacts are no stiffer than springs of twice the k_ij
 * of all neighbours together that hold every body to its place. */
#ifndef VTI_CAGE_H
#define VTI_CAGE_H

#include "vti_hertz.h"

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

/** How many spheres of radius other and more have room around one of that radius, centres no nearer than the share
 *  apart of both radii: they are 2 psi apart and more, seen from it, sin psi = apart other/(radius + other), and z caps
 *  of that angle cover a sphere at most: z (1 - cos psi) <= 2. */
static inline double vti_cage_room(double radius, double other, double apart)
{
    const double sine = apart * (other / (radius + other)), s2 = sine * sine;
    return 2.0 * (1.0 + sqrt(1.0 - s2)) / s2;
}

/** sqrt(R_i R_j far), which is sqrt(R* L) of the longest contact with a sphere of radius other */
static inline double vti_cage_curvature(const struct vti_cages *c, double radius, double other)
{
    return sqrt(radius * other * c->far);
}

/** The cage of body i.
 *
 *  Of one K for all, k_ij = (3/2) K o^{1/2}/L^2 is largest with the smallest neighbours, which are the most, too. Of a
 *  material k_ij = 2 E* (R* L o)^{1/2} grows with the neighbour: z neighbours of one size have room for z R_j^{1/2},
 *  which first falls and then rises with R_j (d log/d log R_j = 1/2 - (1 - u)(1 + 1/cos psi) rises with u = R_j/(R_i +
 *  R_j)), and so is largest at either end; and n - 1 neighbours are no stiffer than as many of the largest. */
static inline struct vti_cage vti_cage_at(const struct vti_cages *c, int64_t i, double o)
{
    const vti_contacts *p = c->contacts;
    const double radius = 0.5 * vti_scalar(&p->diameter, i), others = (double)(c->bodies - 1);
    const double apart = o < 1.0 ? (1.0 - o) * c->near : 0.0, small = vti_cage_room(radius, c->least, apart);
    struct vti_cage cage = {fmin(others, small), c->near * (radius + c->least), p->stiffness};
    if (p->modulus.p != NULL) {
        const double modulus = vti_hertz_reduced(vti_scalar(&p->modulus, i), c->modulus), length = cage.length;
        const double large = vti_cage_room(radius, c->most, apart);
        const double at_least = vti_cage_curvature(c, radius, c->least),
                     at_most = vti_cage_curvature(c, radius, c->most);
        const double together = fmin(others * at_most, fmax(small * at_least, large * at_most));
        cage.stiffness = 4.0 / 3.0 * modulus * length * length * (together / cage.z);
    }
    return cage;
}

#endif
