/* SPDX-License-Identifier: BSD-3-Clause
 * The parts of the binder, in files of their own. */
#ifndef VTI_EFFECTS_BINDER_H
#define VTI_EFFECTS_BINDER_H

#include "kind.h"
#include "model.h"
#include "tables.h"

/** What bonds bear, in the order of the columns and of the members of vti_rupture. */
enum { LIMIT_STRETCH, LIMIT_NORMAL, LIMIT_SHEAR, LIMIT_BENDING, LIMIT_TORSION, LIMIT_ENERGY, LIMITS };

/** Columns of the table of bonds: i j (bodies, from 0), moment axial shear (stiffnesses), limits, and at rest the
 *  length, the direction nx ny nz and the rotation turn_x turn_y turn_z turn_w. */
enum {
    BOND_I,
    BOND_J,
    BOND_MOMENT,
    BOND_AXIAL,
    BOND_SHEAR,
    BOND_LIMITS,
    BOND_LENGTH = BOND_LIMITS + LIMITS,
    BOND_NORMAL,
    BOND_TURN = BOND_NORMAL + 3
};

/** Stiffnesses and limits of all bonds, in the order of the columns; 0 is a term, or a limit, that the file does not
 *  name. */
struct binder_settings {
    char table[SCENE_PATH_SIZE]; /* of the bonds, "" for the neighbours of the arrangement */
    double stiffness[3];
    int64_t shear_form; /* vti_shear; 0: the scene does not say (binder_shear) */
    int64_t on;         /* BINDER_ON_BODIES, or BINDER_ON_SPHERES of clumps: what the table numbers */
    double limit[LIMITS];
    int64_t when;       /* BINDER_START or BINDER_TOUCHING */
    int64_t most;       /* bonds of a body that are made where bodies touch; 0: any number */
    double from, until; /* times between which they are; until is infinite where it is not given */
};

/** The form of shear, where there is shear. */
static inline int64_t binder_shear(const struct binder_settings *binder)
{
    return binder->shear_form != 0 ? binder->shear_form : VTI_SHEAR_OBJECTIVE;
}

/** When bonds are made: at t = 0, or at the end of the step in which their bodies touch (binder_touch.c). */
enum { BINDER_START, BINDER_TOUCHING };
enum { BINDER_ON_BODIES, BINDER_ON_SPHERES };

/** Which bonds have turned past half a turn (bond_turns.c). */
struct bond_turns {
    const struct binder_self *binder;
    double least;    /* energy that takes the weakest bond to half a turn, K^m pi^2/2; infinite without such bonds */
    double watching; /* 1 while there is as much */
    double every;    /* so many steps may go by between looks */
    double left;     /* so many until the next look */
    double turned;   /* bonds that have */
    int are_near;    /* all were near where they began at the last look, and pair says so */
    double *pair;    /* [all][4], by number: R_i R_j^T as a quaternion (v, w) that is followed; zeros for one that has
                        turned */
};

/** Bonds that break (binder_break.c), or are made as a run goes on; all zeros where none does. Bonds have the numbers
 *  that they have in the scene, and their arrays keep all of them: those that hold, in their order, and behind them
 *  those that have broken. */
struct bond_break {
    vti_rupture rupture;
    double *memory; /* limits, and broke */
    int64_t *id;    /* [all] number of the bond at each place of the list */
    int64_t *ends;  /* [all][2] bodies of each bond, by number */
    double *broke;  /* [all] the step at whose end it broke, by number; infinite while it holds */
    double *made;   /* [all] the step at whose end it was made, by number; NULL: all at t = 0 */
    int limits;     /* 1 if there are any */
    int64_t *root;  /* [bodies] a body of the same fragment with no larger number, its own of the first one; -1 of a
                        body that was never bonded */
    int64_t bodies;
    int64_t holding; /* as of the last time that somebody asked what has broken */
    int64_t changes; /* how often the list has changed */
};

/** Bonds that are made where bodies touch (binder_touch.c); all zeros where none is. */
struct bond_touch {
    int64_t room;   /* arrays of bonds, in struct binder_self and in its members, are for so many */
    double *turn;   /* [room][4] rotations at rest; memory of struct binder_self has rest vectors only */
    int64_t *known; /* [all][2] bodies of all bonds that have been made, i < j, ascending */
    int64_t *meet;  /* [bodies] how many bonds hold it, where there may only be so many */
};

struct binder_self {
    vti_bonds bonds;     /* those that hold; what the effect's self points to, so it stands first */
    int64_t all;         /* how many there have been so far */
    const int64_t *body; /* of each sphere, where they join spheres of clumps; else NULL */
    int64_t *pair;
    double *memory; /* rest vectors, rotations at rest if they have any, and stiffnesses */
    struct bond_turns turns;
    struct bond_break breaking;
    struct bond_touch touch;
};

/* ---- what a scene says (binder_keys.c), and what it cannot say (binder_check.c) ---------------------------------- */

enum { BINDER_FIELDS = 19 };
extern const struct scene_field binder_fields[BINDER_FIELDS];
extern const struct table_kind binder_table;

/* As struct effect_kind has them. */
void binder_defaults(void *settings);
int binder_check(const struct scene_reader *reader, const struct scene *scene, const void *settings);
int binder_check_tables(const struct model *model, const void *settings, const struct tables *tables,
                        struct message *message);

/** Whether there is the term of a column, BOND_MOMENT to BOND_SHEAR: the scene gives its stiffness, or the table, which
 *  may be NULL, has the column. */
int binder_has_term(const struct binder_settings *binder, const struct table *table, int column);

/* ---- bonds of the start (binder_bonds.c), and how they are followed ---------------------------------------------- */

/** Makes e->self->bonds. Returns 0, or -1 with one line in *message. */
int binder_make_bonds(struct effect *e, const struct model *model, const struct table *table, struct message *message);

/** The bonds of a slice (binder_part.c). */
int binder_take_part(const struct effect *e, const vti_bodies *slice, struct effect_part *part);

/** Follows bonds to half a turn. */
extern const struct effect_watch binder_watch;

/** Of each bond: its energy, the sum over its terms, its stretch r/L0 - 1, and 1 while it holds, if bonds break. */
extern const struct effect_lines binder_lines;

/* ---- bonds that are made where bodies touch (binder_touch.c) ----------------------------------------------------- */

/** In place of binder_make_bonds: none yet. */
int binder_make_none(struct effect *e, const struct model *model, struct message *message);
void binder_free_touch(struct bond_touch *touch);
/** As effect_kind has it. */
int64_t binder_join(struct effect *e, struct model *model, int64_t step, double t, struct message *message);
/** What a run goes on with, as struct effect_memory_of has it. */
int64_t binder_touch_size(const struct effect *e);
void binder_touch_get(const struct effect *e, double *memory);
int64_t binder_touch_put(struct effect *e, const double *memory, int64_t left);

/** Whether bonds are made as a run goes on. */
static inline int binder_touches(const struct binder_self *self)
{
    return self->touch.room > 0;
}

/* ---- rupture (binder_break.c) ------------------------------------------------------------------------------------ */

/** Whether a limit is in the scene or in the table, which may be NULL. */
int binder_has_limit(const struct binder_settings *binder, const struct table *table, int limit);
int binder_may_break(const struct binder_settings *binder, const struct table *table);
/** What *effect of bonds needs, gives and books besides, if they break or are made. */
void binder_add_rupture(vti_effect *effect, int breaks);
/** Limits of the scene, or of the table, of which *breaking keeps copies; room for them is there. */
void binder_take_limits(struct effect *e, const struct table *table);
/** Bonds of numbers whose broke is not infinite leave the list. Returns 0, or -1 if there is no memory. */
int binder_take_out(struct binder_self *self);
/** Makes e->self->breaking of the bonds, if they break. Returns 0, or -1 with one line in *message. */
int binder_make_breaking(struct effect *e, const struct model *model, const struct table *table,
                         struct message *message);
void binder_free_breaking(struct bond_break *breaking);

/** The number of the bond at place k of the list. */
static inline int64_t binder_number(const struct binder_self *self, int64_t k)
{
    return self->breaking.id != NULL ? self->breaking.id[k] : k;
}

extern const struct effect_breaks binder_breaks;
extern const struct effect_memory_of binder_memory;

#endif
