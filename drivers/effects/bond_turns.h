/* SPDX-License-Identifier: BSD-3-Clause
 * Bonds whose bodies have turned past half a turn against each other: there the moment of a bond changes its side,
 * which a binder does not. Attitudes alone do not show it; one has to follow them. */
#ifndef VTI_BOND_TURNS_H
#define VTI_BOND_TURNS_H

#include "vti.h"

struct bond_turns {
    const vti_bonds *bonds;
    double least;    /* energy that takes the weakest bond to half a turn, K^m pi^2/2; infinite without such bonds */
    double watching; /* 1 while there is as much */
    double turned;   /* bonds that have */
    double *pair;    /* [bonds][4]: R_i R_j^T as a quaternion (v, w) that is followed; zeros for one that has turned */
};

/** The bonds must outlive it. Returns 0, or -1 if there is no memory. */
int bond_turns_create(struct bond_turns *b, const vti_bonds *bonds);
void bond_turns_destroy(struct bond_turns *b);

/** Looks whether bonds can get there at all: they cannot while twice the energy of the motion and of the springs is
 *  below what it takes. Now and then. */
void bond_turns_gate(struct bond_turns *b, const vti_bodies *bodies, double energy);
/** Follows them, if they can. At every step. */
void bond_turns_follow(struct bond_turns *b, const vti_bodies *bodies);

/** What a run must keep to go on with the same counts. */
int64_t bond_turns_size(const struct bond_turns *b);
void bond_turns_get(const struct bond_turns *b, double *state);
void bond_turns_put(struct bond_turns *b, const double *state);

#endif
