/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Explicit Runge-Kutta methods on y = (x, v, q, Omega), each by its tableau:
 *
 *     k_i = f(y + h sum_{j < i} a_ij k_j),   y <- y + h sum_i b_i k_i,   q <- q/|q|
 *
 * Stage quaternions are not normalised; forces take the attitude that such a quaternion points to. Of a tableau's
 * terms only those are added up that are not zero. */
#ifndef VTI_RUNGE_KUTTA_H
#define VTI_RUNGE_KUTTA_H

#include "rivals.h"

enum { TABLEAU_STAGES = 15 };

struct tableau {
    int stages, order;
    double a[TABLEAU_STAGES][TABLEAU_STAGES]; /* row i: the weights of earlier slopes in stage i */
    double b[TABLEAU_STAGES];
};

/** Weights of DOP853's two errors, of orders 5 and 3: b less those of embedded formulas. */
extern const double tableau_dop853_error[2][12];

extern const struct tableau tableau_rk4, tableau_pd8, tableau_dop853, tableau_vern9; /* tableaus.c */

/** Of one method at one step: which slopes it adds up, and room for them. */
struct runge_kutta;

/** For states of n doubles. NULL if there is no memory. */
struct runge_kutta *runge_kutta_create(const struct tableau *tableau, double h, int64_t n);
void runge_kutta_destroy(struct runge_kutta *method);
/** Steps of h from now on. */
void runge_kutta_resize(struct runge_kutta *method, double h);
/** The slopes of the step before, [stages][n]. */
double *const *runge_kutta_slopes(const struct runge_kutta *method);
/** y one step further. first: f(y), or NULL, by which the step takes it. Returns the status of the forces; y stays what
 *  it was unless that is VTI_OK. */
int runge_kutta_step(struct runge_kutta *method, struct course *course, double *y, const double *first);

#endif
