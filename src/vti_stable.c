/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A rigorous bound of the stable step (EQUATIONS 5). The system is split into elements, one for each thing that pulls, and every body
 * into equal shares for the elements at it; the largest frequency of the whole is at most the largest of any element. With z
 * shares of a body: a = (z_i/m_i + z_j/m_j)/L0^2, b = z/J. */
#include "vti_internal.h"

static void count_pairs(const int64_t *pair, int64_t count, int64_t base, int64_t first, double *shares)
{
    for (int64_t k = 0; k < 2 * count; ++k)
        shares[pair[k] - base - first] += 1.0;
}

static void count_shares(const vti_springs *s, const vti_bodies *b, double *shares)
{
    const double each = (s->walls != NULL ? (double)s->walls->count : 0.0) + (s->pendulum != NULL ? 1.0 : 0.0);
    for (int64_t i = 0; i < b->count; ++i)
        shares[i] = each;
    if (s->bonds != NULL)
        count_pairs(s->bonds->pair, s->bonds->count, s->bonds->base, b->first, shares);
    if (s->contacts != NULL)
        count_pairs(s->contacts->pair, s->contacts->count, s->contacts->base, b->first, shares);
}

static inline double share_over(const vti_scalars *s, const vti_bodies *b, const double *shares, int64_t i)
{
    return s->p != NULL ? shares[i - b->first] / vti_scalar(s, i) : 0.0;
}

/** The larger eigenvalue of [[a+bi, a], [a, a+bj]] [[k+m, -m], [-m, k+m]], k = K^s/2, m = K^m. */
static double shear_and_moment(double a, double bi, double bj, double k, double m)
{
    const double trace = (k + m) * (2.0 * a + bi + bj) - 2.0 * m * a;
    const double det = (bi * bj + a * (bi + bj)) * (k * k + 2.0 * k * m);
    const double root = trace * trace - 4.0 * det;
    return 0.5 * (trace + sqrt(root > 0.0 ? root : 0.0));
}

static double stiffness_of(const vti_scalars *s, int64_t k)
{
    return s->p != NULL ? vti_scalar(s, k) : 0.0;
}

static double bond_frequencies(const vti_bonds *bonds, const vti_bodies *b, const double *shares)
{
    double most = 0.0;
    for (int64_t k = 0; bonds != NULL && k < bonds->count; ++k) {
        const int64_t i = bonds->pair[2 * k] - bonds->base, j = bonds->pair[2 * k + 1] - bonds->base;
        const double length = bonds->rest[4 * k + 3];
        const double a = (share_over(&b->mass, b, shares, i) + share_over(&b->mass, b, shares, j)) / (length * length);
        const double bi = share_over(&b->inertia, b, shares, i), bj = share_over(&b->inertia, b, shares, j);
        const double moment = stiffness_of(&bonds->moment, k), shear = stiffness_of(&bonds->shear, k);
        most = fmax(most, stiffness_of(&bonds->axial, k) * a);
        most = fmax(most, moment * (bi + bj));
        most = fmax(most, shear_and_moment(a, bi, bj, 0.5 * shear, moment));
    }
    return most;
}

/** Hertz: d^2U/do^2 = (3/2) K sqrt(o) */
static double contact_frequencies(const vti_springs *s, const vti_bodies *b, const double *shares)
{
    const vti_contacts *p = s->contacts;
    double most = 0.0;
    for (int64_t k = 0; p != NULL && k < p->count; ++k) {
        const int64_t i = p->pair[2 * k] - p->base, j = p->pair[2 * k + 1] - p->base;
        const double length = 0.5 * vti_scalar(&p->diameter, i) + 0.5 * vti_scalar(&p->diameter, j);
        const double a = (share_over(&b->mass, b, shares, i) + share_over(&b->mass, b, shares, j)) / (length * length);
        most = fmax(most, 1.5 * p->stiffness * sqrt(s->overlap) * a);
    }
    for (int64_t i = b->first; s->walls != NULL && s->walls->count > 0 && i < b->first + b->count; ++i) {
        const double radius = 0.5 * vti_scalar(&s->walls->diameter, i);
        const double a = share_over(&b->mass, b, shares, i) / (radius * radius);
        most = fmax(most, 1.5 * s->walls->stiffness * sqrt(s->overlap) * a);
    }
    return most;
}

static double pendulum_frequencies(const vti_pendulum *p, const vti_bodies *b, const double *shares)
{
    double most = 0.0;
    for (int64_t i = b->first; p != NULL && i < b->first + b->count; ++i)
        most = fmax(most, fabs(p->weight) * vti_norm(p->rho0) * share_over(&b->inertia, b, shares, i));
    return most;
}

int vti_stable_step(const vti_springs *springs, const vti_bodies *b, double *scratch, double *h)
{
    const int status = vti_bodies_ready(b);
    if (status != VTI_OK)
        return status;
    if (springs == NULL || scratch == NULL || h == NULL)
        return VTI_E_NULL;
    count_shares(springs, b, scratch);
    double most = bond_frequencies(springs->bonds, b, scratch);
    most = fmax(most, contact_frequencies(springs, b, scratch));
    most = fmax(most, pendulum_frequencies(springs->pendulum, b, scratch));
    *h = 2.0 / sqrt(most);
    return VTI_OK;
}
