/* SPDX-License-Identifier: BSD-3-Clause
 * The parts of the binder, in files of their own. */
#ifndef VTI_EFFECTS_BINDER_H
#define VTI_EFFECTS_BINDER_H

#include "kind.h"
#include "model.h"
#include "table.h"

/** Columns of the table of bonds: i j (bodies, from 0), and moment axial shear (stiffnesses). */
enum { BOND_I, BOND_J, BOND_MOMENT, BOND_AXIAL, BOND_SHEAR };

/** Stiffnesses of all bonds, in the order of the columns; 0 is a term that the file does not name. */
struct binder_settings {
    char table[SCENE_PATH_SIZE]; /* of the bonds, "" for the neighbours of the arrangement */
    double stiffness[3];
    int64_t shear_form; /* vti_shear */
};

/** Which bonds have turned past half a turn (bond_turns.c). */
struct bond_turns {
    const vti_bonds *bonds;
    double least;    /* energy that takes the weakest bond to half a turn, K^m pi^2/2; infinite without such bonds */
    double watching; /* 1 while there is as much */
    double turned;   /* bonds that have */
    double *pair;    /* [bonds][4]: R_i R_j^T as a quaternion (v, w) that is followed; zeros for one that has turned */
};

struct binder_self {
    vti_bonds bonds;
    int64_t *pair;
    double *memory; /* rest vectors and stiffnesses */
    struct bond_turns turns;
};

extern const struct table_kind binder_table;

/** Makes e->self->bonds. Returns 0, or -1 with one line in *message. */
int binder_make_bonds(struct effect *e, const struct model *model, const struct table *table, struct message *message);

/** The bonds of a slice (binder_part.c). */
int binder_take_part(const struct effect *e, const vti_bodies *slice, struct effect_part *part);

/** Follows bonds to half a turn. */
extern const struct effect_watch binder_watch;

/** Of each bond: its energy, the sum over its terms, and its stretch r/L0 - 1. */
extern const struct effect_lines binder_lines;

#endif
