/* SPDX-License-Identifier: BSD-3-Clause
 * The two solutions of a sampled reference by two ranks at once: rank 0 of a communicator makes the states that are
 * kept, rank 1 those of the looser tolerance, and compares. */
#ifndef VTI_SAMPLED_PAIR_H
#define VTI_SAMPLED_PAIR_H

#include <mpi.h>

#include "sampled.h"

/** To be called by ranks 0 and 1 of comm, with a watch each. Afterwards both have all states, energy_error and spread,
 *  with the bits of sampled_solve and sampled_compare by one rank. Returns 0, or -1 with one line in *message, or
 *  WATCH_ASKED; not always the same on both. */
int sampled_pair_integrate(struct sampled *sampled, MPI_Comm comm, const struct watch *watch, struct message *message);

#endif
