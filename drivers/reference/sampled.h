/* SPDX-License-Identifier: BSD-3-Clause
 * The reference of a model whose motion has kinks (contacts, walls) or whose bodies are many: states at multiples of an
 * interval, and an estimate of how well they are known, from a second integration. */
#ifndef VTI_SAMPLED_H
#define VTI_SAMPLED_H

#include "equations.h"
#include "watch.h"

struct sampled {
    struct model *model;
    int64_t width, count; /* doubles in a state; states 0 ... count - 1 */
    double interval;
    double *states;      /* [count][width] */
    vti_bodies seen;     /* of the last sampled_step; sealed */
    double energy_error; /* largest |E - E_0| of a state */
    double spread;       /* ||q' - q||_{H1}/||q||_{H1} of a solution q' of a tolerance 100 times larger */
};

/** Room for states at 0, interval, ..., intervals interval. */
int sampled_create(struct sampled *sampled, struct model *model, double interval, int64_t intervals,
                   struct message *message);
void sampled_destroy(struct sampled *sampled);
/** Who follows, or is followed by, another who makes the other of the two solutions at the same time: at is called with
 *  k when state k is made, by the first, or before it is read, by the second. Returns 0, or WATCH_ASKED. */
struct sampled_other {
    int (*at)(void *self, int64_t k);
    void *self;
};

/** Fills the states, and then finds how far they are from those of a looser tolerance. other is NULL where both are
 *  done here, one after the other. Each returns 0, or -1 with one line in *message, or WATCH_ASKED. */
int sampled_solve(struct sampled *sampled, const struct sampled_other *other, const struct watch *watch,
                  struct message *message);
int sampled_compare(struct sampled *sampled, const struct sampled_other *other, const struct watch *watch,
                    struct message *message);

/** sqrt(change_squared/norm_squared), and 0 where nothing has changed, though the norm be 0, as of bodies that rest in
 *  the origin. */
double sampled_relative(double change_squared, double norm_squared);

/** State k; the views point into the reference. */
vti_bodies sampled_state(struct sampled *sampled, int64_t k);
/** The same, sealed; they hold until the next call. */
const vti_bodies *sampled_step(struct sampled *sampled, int64_t k);

#endif
