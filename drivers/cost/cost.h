/* SPDX-License-Identifier: BSD-3-Clause
 * A cost study: every case with every method, errors first, times after and apart from them, then prices. */
#ifndef VTI_COST_H
#define VTI_COST_H

#include <mpi.h>

#include "cost_price.h"
#include "store.h"

/** What is known about a case besides its runs. */
struct cost_facts {
    int turns; /* 0: priced by the error of velocities */
    double
        uncertainty; /* of the reference by its own estimate, relative (reference.h); rounding on a long way is not in it */
};

/** What came out; filled in on rank 0, empty elsewhere. Ladder and prices of case c and method m stand at c
 *  methods_count + m. */
struct cost {
    const struct cost_plan *plan;
    struct cost_facts facts[COST_CASES];
    struct cost_ladder *ladders;               /* [cases_count * methods_count] */
    struct cost_price (*prices)[COST_TARGETS]; /* the same */
    int64_t runs;                              /* that went well */
    int ranks;
    double seconds; /* for everything */
};

/** Runs the plan on all ranks of comm. All but seconds and their spread is the same for any number of ranks.
 *  Collective. Ladders (struct cost_ladder) that the store holds are not computed again; the others come into it;
 *  times are taken anew. Returns 0, or on all ranks -1 with one line in *message on rank 0, or WATCH_ASKED. store
 *  and watch may be NULL. */
int cost_run(const struct cost_plan *plan, MPI_Comm comm, const struct study_watch *watch, const struct store *store,
             struct cost *cost, struct message *message);
void cost_destroy(struct cost *cost);

#endif
