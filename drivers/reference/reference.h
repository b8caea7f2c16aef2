/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The reference solution of a model, by GSL's rk8pd on the continuous equations, the same on every rank: of few
 * bodies in smooth motion for any time (smooth.h), else at multiples of an interval (sampled.h). Where something
 * dissipates there are no such equations, and it is by steps of our own (stepped.h). */
#ifndef VTI_REFERENCE_H
#define VTI_REFERENCE_H

#include <mpi.h>

#include "sampled.h"
#include "smooth.h"

struct reference {
    double interval; /* 0: known at any time, else at multiples of it */
    struct smooth smooth;
    struct sampled sampled;
    double energy_error; /* largest |E - E_0| */
    double uncertainty;  /* relative, of the solution: what interpolation adds, and how far a looser tolerance leads */
    double rounding;     /* the same, where rounding leaves more than interpolation adds (smooth.h); else 0 */
};

/** 1 if the model's motion can be read at any time: no contacts, no walls, no dissipation, few bodies. */
int reference_is_smooth(const struct model *model);

/** The memory that a reference takes on every rank, in bytes, unless somebody says otherwise. */
#define REFERENCE_BYTES 1e9

/** How far a model is integrated, and for whom. */
struct reference_span {
    double t_end;
    double interval; /* 0, or for models that are not smooth an interval of which t_end is a multiple */
    double finest;   /* the shortest step that will be compared with it, of models that dissipate (stepped.h); others do
                        not ask, and those are refused at 0 */
    double bytes;    /* that panels take on every rank at most */
};

/** Integrates *model, which must outlive the reference, to t_end on rank 0 of comm (and, at intervals, on rank 1 beside
 *  it) and shares it with all. What does not fit into span->bytes is integrated again when it is read (smooth.h);
 *  states at intervals take what they take. watch looks on there. Collective. Returns 0 on all ranks, or -1 on all with
 *  one line in *message, or WATCH_ASKED on all. */
int reference_create(struct model *model, const struct reference_span *span, MPI_Comm comm,
                     const struct study_watch *watch, struct reference *reference, struct message *message);
/** The same, with the same bits, by this rank for itself. */
int reference_alone(struct model *model, const struct reference_span *span, const struct watch *watch,
                    struct reference *reference, struct message *message);
void reference_destroy(struct reference *reference);

/** To be called before the two below are asked about t. Returns 0, or -1 with one line in *message, or
 *  WATCH_ASKED. Not collective. */
int reference_seek(struct reference *reference, double t, const struct watch *watch, struct message *message);
/** The bodies at t, attitudes as quaternions (not normalised). The views point into the reference and hold until the
 *  next call. */
vti_bodies reference_at(struct reference *reference, double t);
/** The same at an interval, of a reference that has one: bodies that are sealed. */
const vti_bodies *reference_state(struct reference *reference, double t);
/** Both for t = step h and *count - 1 steps that follow, of a reference that is known at any time, with the same bits,
 *  for those who go through the steps in order: *states side by side (states.h), which hold until the next call.
 *  Returns 0, or what reference_seek returns. */
int reference_block(struct reference *reference, double h, int64_t step, const struct watch *watch,
                    const double **states, int64_t *count, struct message *message);

/** ||q||^2_{H1(0,t)} = int_0^t |x|^2 + |v|^2 + theta^2 + |Omega|^2, exact to the reference's own error. */
double reference_norm_squared(struct reference *reference, double t);

#endif
