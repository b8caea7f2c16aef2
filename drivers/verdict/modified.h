/* SPDX-License-Identifier: BSD-3-Clause
 * The energies that steps of kick, drift, kick conserve better than the energy itself. */
#ifndef VTI_MODIFIED_H
#define VTI_MODIFIED_H

#include "model.h"
#include "state.h"

struct modified {
    struct model *model;
    const vti_stepper *stepper;
    double h;
    struct fork probe; /* bodies of its own */
};

/** Of one state. NaN where the stepper has none (modified_exists). */
struct energies {
    double kicked;   /* H - (h^2/8) sum(F^2/m + RM^2/J): exact for one linear oscillator of any h (EQUATIONS 6.9) */
    double modified; /* conserved up to h^4: tells drift from exchange between slow and fast motions */
};

/** Whether the stepper is Verlet's, be it read at half a kick's distance: vti1, vti2, vti3, vti3-leapfrog, exact.
 *  Compositions and RKN splittings conserve series of their own, which nobody here evaluates, and so do bodies with
 *  moments. */
int modified_exists(const vti_stepper *stepper, const struct model *model);

/** The model and the stepper must outlive it. Returns 0, or -1 if there is no memory; harmless where nothing exists. */
int modified_create(struct modified *m, struct model *model, const vti_stepper *stepper, double h);
void modified_destroy(struct modified *m);

/** Of bodies whose energy is total and whose forces are those of their positions. Costs one evaluation of forces; after
 *  it the model's list of contacts is that of bodies moved on a little. */
struct energies modified_energies(struct modified *m, const vti_bodies *bodies, double total);

#endif
