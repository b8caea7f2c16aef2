/* SPDX-License-Identifier: BSD-3-Clause
 * Many states of the same bodies side by side; the integrands of the norms (EQUATIONS 4), energies and momenta of all
 * of them at once, with the bits of vti_h1_density, vti_h1_distance, vti_energy and so on of each. */
#ifndef VTI_STATES_H
#define VTI_STATES_H

#include "model.h"
#include "panels.h"

/** What there is of each body: x v if it translates, q Omega if it turns, in this order. Numbers of state k are
 *  state[...][k] of double state[bodies][states_width][PANELS_BLOCK]. */
struct states {
    int64_t bodies;
    int translates, turns;
    vti_scalars mass, inertia; /* of spheres */
};

struct states states_of(const struct model *model);
/** Numbers of a body. */
int64_t states_width(const struct states *states);

/** State k of bodies with the views of states, attitudes as alpha. */
void states_put(const struct states *states, const vti_bodies *bodies, int64_t k, double *state);

/** Force and moment of the same bodies, of those that there are: load[bodies][states_loads][PANELS_BLOCK]; zeros if
 *  they owe nothing. */
int64_t states_loads(const struct states *states);
void states_put_loads(const struct states *states, const vti_bodies *bodies, int owe, int64_t k, double *load);
/** Body i of spheres in all states, seen side by side as PANELS_BLOCK bodies. */
vti_bodies states_of_body(const struct states *states, int64_t i, double *state, double *load);

/** Of the first n states, sum over bodies of |x|^2 + |v|^2 + theta^2 + |Omega|^2; what is written behind the n is
 *  without meaning. */
void states_densities(const struct states *states, const double *state, int64_t n, double out[PANELS_BLOCK]);
/** The same of their differences from those of other, attitudes by |log(R_h R^T)|. */
void states_distances(const struct states *states, const double *state, const double *other, int64_t n,
                      double out[PANELS_BLOCK]);

/** An effect's energy, the sum of that of each body (effect_kind.each), body[bodies] by states_of_body. */
void states_sum_each(const struct states *states, const struct effect *effect, const vti_bodies *body,
                     double out[PANELS_BLOCK]);
/** Of spheres: the energy, kinetic and then terms[count][PANELS_BLOCK], the effects'. */
void states_energies(const struct states *states, const double *state, const double *terms, int64_t count, int64_t n,
                     double out[PANELS_BLOCK]);
/** Of spheres: the linear momentum, the angular one about the origin, or the spin, out[3][PANELS_BLOCK]. */
enum states_momentum { STATES_LINEAR, STATES_ANGULAR, STATES_SPIN };
void states_momenta(const struct states *states, enum states_momentum which, const double *state, int64_t n,
                    double *out);

/** Raises *most to the largest |value[k] - origin|, k < n; once NaN, it stays. */
void states_farthest(const double *value, double origin, int64_t n, double *most);

#endif
