/* SPDX-License-Identifier: BSD-3-Clause
 * The reference of a model whose motion is smooth and whose bodies are few: Chebyshev panels, readable at any time. */
#ifndef VTI_SMOOTH_H
#define VTI_SMOOTH_H

#include "equations.h"
#include "panels.h"

struct smooth {
    struct model *model;
    struct panels panels;       /* of the bodies' part of a state */
    double *state;              /* where smooth_at writes */
    double energy_error;        /* largest |E - E_0| at the ends of the panels */
    double interpolation_error; /* largest panels_tail */
};

/** Room for a reference of *model; the panels are made by smooth_integrate, or by panels_create and a copy. */
int smooth_create(struct smooth *smooth, struct model *model, struct message *message);
void smooth_destroy(struct smooth *smooth);
/** Integrates to t_end. Returns 0, or -1 with one line in *message. */
int smooth_integrate(struct smooth *smooth, double t_end, struct message *message);

vti_bodies smooth_at(struct smooth *smooth, double t);
/** Exact ||q||^2_{H1(0,t)}: Gauss-Legendre on the panels, split where a body passes a half turn, since the integrand
 *  (theta in [0, pi]) has a kink there. */
double smooth_norm_squared(struct smooth *smooth, double t);

#endif
