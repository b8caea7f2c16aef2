/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The reference solution of a model: GSL's rk8pd on the continuous equations
 *
 *     x' = v,  v' = F/m,  q' = (1/2) Omega q,  Omega' = RM/J
 *
 * with the attitude as a quaternion, kept so that it can be read at any time of [0, t_end]. It shares the effects' forces
 * with the steppers and nothing else. */
#ifndef VTI_REFERENCE_H
#define VTI_REFERENCE_H

#include <mpi.h>

#include "model.h"
#include "panels.h"

struct reference {
    const struct model *model;
    struct panels panels;
    double *state;              /* where reference_at writes */
    double energy_error;        /* largest |E - E_0| at the ends of the panels */
    double interpolation_error; /* largest panels_tail */
};

/** Integrates *model, which must outlive the reference, to t_end on rank 0 of comm and gives every rank a copy. Collective.
 *  Returns 0 on all ranks, or -1 on all with one line in *message. */
int reference_create(const struct model *model, double t_end, MPI_Comm comm, struct reference *reference,
                     struct message *message);
void reference_destroy(struct reference *reference);

/** The bodies at 0 <= t <= t_end, attitudes as quaternions (not normalised). The views point into the reference and are
 *  overwritten by the next call. */
vti_bodies reference_at(struct reference *reference, double t);

/** The exact norm, ||q||^2_{H1(0,t)} = int_0^t |x|^2 + |v|^2 + theta^2 + |Omega|^2 with theta in [0, pi]: Gauss-Legendre
 *  on the panels, split where a body passes a half turn, since the integrand has a kink there. */
double reference_norm_squared(struct reference *reference, double t);

#endif
