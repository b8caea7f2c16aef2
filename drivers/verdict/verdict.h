/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The verdict on a run: can it be believed? It looks at the rows of a run (columns.h) and, where effects follow
 * something, at every step.
 *
 * Energy (EQUATIONS 6.9). H is the column total, what effects have booked included, H~ = H - (h^2/8) sum(F^2/m +
 * RM^2/J) where the stepper is Verlet's. S is the largest so far of T + U of the effects between bodies: of fields,
 * walls and pivots, which break a momentum (vti_effect.breaks), the energy is left out, and T is taken without that of
 * the centre of mass in those directions in which nothing from outside acts. Bad: H - H(0) > S/4 and H~ - H~(0) > S/4
 * at a row, or not finite. Both, since H alone swings by up to (h omega)^2/4 of S in the best of runs, and H~ is exact
 * for linear forces only; so exact that it stays when a linear oscillator blows up. Therefore H - H(0) > 0.7 S is bad
 * by itself: the energy has more than tripled, as it does in stable runs only above 0.84 of the stable step, where (h
 * omega)^2/4 is 0.7. vti3 shows velocities of half a step before, by which its H swings by h omega/2 too: in fields it
 * is called bad where it need not be, in two of 2000 random scenes below half of the stable step. */
#ifndef VTI_VERDICT_H
#define VTI_VERDICT_H

#include <stddef.h>
#include <stdint.h>

#include "columns.h"
#include "modified.h"
#include "vti.h"

/* ---- the slope of a series --------------------------------------------------------------------------------------- */

/* The slope of a long series in little memory: means over blocks that grow with the series, and a line through them. */

enum { TREND_BLOCKS = 64 };

/** All doubles, so that it can be kept as a row of numbers. Start from zeros. */
struct trend {
    double blocks, width, filled;            /* whole blocks, values in each, values in the one that is being filled */
    double t[TREND_BLOCKS], y[TREND_BLOCKS]; /* means */
    double t_sum, y_sum;                     /* of the block that is being filled */
};

void trend_add(struct trend *s, double t, double y);

/** Least squares over the whole blocks: y per t, and its standard error by what the line leaves. Values that lie near
 *  each other in time are not independent; means over the 32 to 64 blocks of a long series nearly are. NaN below four
 *  blocks. */
void trend_slope(const struct trend *s, double *slope, double *error);

/* ---- the verdict ------------------------------------------------------------------------------------------------- */

enum verdict_grade { VERDICT_GOOD, VERDICT_DOUBTFUL, VERDICT_BAD };

/** What was found. Members of eight bytes each, as verdict_numbers lists them. */
struct judgement {
    int64_t verdict;     /* verdict_grade */
    double energy_gain;  /* as a share of verdict_scale, the largest of the smaller of both gains; bad above 1/4 */
    double energy_swing; /* (largest - smallest H)/S */
    double energy_slope; /* of the modified energy, of H where there is none, over time (trend_slope) */
    double energy_slope_error; /* its standard error */
    double energy_scale;       /* S */
    double travel;             /* places_travel, the largest; NaN where bodies do not meet */
    double rotation;           /* largest h|Omega|, radians */
    double angle_error;        /* turning_error of that */
    double stable_step;        /* the stepper's least, as contacts came; infinite if nothing oscillates */
    double overlap;            /* the largest seen, as a share of the contact's length; 0 where nothing touches */
    double slowing;            /* the largest z = c t/m of a drift; 0 without drag and dashpots */
    int64_t bonds_turned;      /* past half a turn */
};

/** A member of struct judgement: its name in files, and where it is. */
struct verdict_number {
    const char *name;
    size_t offset;
    int is_integer;
};
enum { VERDICT_NUMBERS = 13 };
extern const struct verdict_number verdict_numbers[VERDICT_NUMBERS];

/** Of the length of a contact: deeper, centres may pass each other. */
#define VERDICT_MUCH_OVERLAP 0.5

/** "good", "doubtful", "bad" */
const char *verdict_word(int64_t grade);

/** What is gathered along the way; all doubles, as they are kept in a checkpoint. */
struct findings {
    double rows, broken;
    double first, first_kicked; /* H(0), H~(0) */
    double scale, size;         /* S; the largest sum of |terms|, whose rounding is no gain */
    double idle;                /* nor is less than this, which rounding gives to springs at rest */
    double booked;              /* the largest sum of what has been booked, |Q| */
    double gain, gain_t, loss;  /* the largest; gain_t is when it was first bad */
    double highest, lowest;     /* H */
    double travel, rotation, stable, stable_t;
    double pressed;         /* the largest energy of what touches, to a tenth */
    double varies;          /* 1: steps do, and verdict.h is the longest since the row before */
    double lately;          /* the longest step since the row before, where steps vary */
    double longest, before; /* step since the last look at the stable step, and what that was there */
    double share;           /* of the stable step, the largest */
    double deepest;         /* the largest overlap at a look, as a share of the contact's length */
    double force2;          /* the square of the largest force on a body at a look between rows */
    double slowing;      /* largest z = c t/m of a drift of bodies that are pushed too; 0 without drag and dashpots */
    double slowing_free; /* the same of drag, of what moves, be it pushed or not */
    double rounding, fastest; /* places_rounding, the largest; the largest speed along an axis */
    struct trend trend;
};

struct verdict {
    struct model *model;
    const vti_stepper *stepper;
    const struct columns *columns;
    double h, mass, diameter; /* of all bodies; of the smallest, 0 where none meet */
    int meet;                 /* 1: bodies touch each other, not walls alone */
    int watches;              /* 1: an effect follows something at every step */
    int touches;              /* 1: bodies touch each other or walls */
    int open[3];              /* 1: something from outside acts along this axis */
    struct modified modified;
    struct findings found;
};

/** All must outlive it; columns are those of the model and the stepper. Returns 0, or -1 with one line in *message. */
int verdict_create(struct verdict *v, struct model *model, const vti_stepper *stepper, double h,
                   const struct columns *columns, struct message *message);
/** Before the model ends; harmless a second time. */
void verdict_destroy(struct verdict *v);

/** At every look of a run whose steps vary: the longest since the look before. */
void verdict_longest(struct verdict *v, double h);
/** The row of the bodies at t, whose forces are those of their positions (or, after a step that ends with a drift,
 *  nearly), and takes it into account. The stable step is taken at the first 32 rows, then at every second up to row
 *  64, at every fourth up to 128, and so on, as it costs about as much as a step, and at those at which what touches
 *  holds a tenth more energy than before. */
void verdict_row(struct verdict *v, double t, const vti_bodies *bodies, double row[COLUMNS]);
/** At every step, whose forces are those of its positions. Contacts come and go between rows: where the largest force
 *  on a body exceeds by a quarter that of any step before, overlaps and the stable step are looked at. */
void verdict_step(struct verdict *v, double t, const vti_bodies *bodies);

/** What gains and losses are shares of: S, or what was booked where that is more. */
static inline double verdict_scale(const struct findings *f)
{
    return f->booked > f->scale ? f->booked : f->scale;
}

/** What is found so far; broken: 1 if the run ended on its way. In *line one line of it. */
struct judgement verdict_judge(const struct verdict *v, int broken, struct message *line);

enum { VERDICT_WARNINGS = 3 };
/** At t = 0, before any step: what of travel, rotation and rounding per step calls for a word. Returns how many lines
 *  there are. */
int verdict_warnings(const struct verdict *v, const vti_bodies *bodies, struct message lines[VERDICT_WARNINGS]);

/** What a run must keep to end with the same verdict after it was interrupted. */
int64_t verdict_size(const struct verdict *v);
void verdict_give(const struct verdict *v, struct sink *sink);
void verdict_put(struct verdict *v, const double *state);

/* ---- angles of a step -------------------------------------------------------------------------------------------- */

/* By what angle a step turns a body, and how far that is from h|Omega| (EQUATIONS 2). Nothing here calls libm but for
 * square roots, so that what is reported has the same bits everywhere. */

/** The angle, from 0 on and not folded at full turns, by which a drift of the law (vti_law) turns a body of t|Omega| =
 *  s >= 0: asin s (closed; s <= 1 is taken for more), 2 atan(s/2) (Cayley), 2 atan2(v, c) of the pair (c, v) of the
 *  exact laws. */
double turning_angle(int64_t law, double s);

/** Sum over the stepper's drifts a_k h of | turning_angle(a_k s) - a_k s |, as a share of s = h|Omega|. 0 for s = 0,
 *  and for a stepper that is not made of drifts. */
double turning_error(const vti_stepper *stepper, double s);

/** The largest turning_error that is no cause for a remark. Exact laws are meant to turn by h|Omega|: 1e-3. The angles
 *  of the others err as s^2/12 and s^2/6, which their order says already: 0.1, at h|Omega| = 1.2 (Cayley) and 0.7
 *  (closed). */
double turning_tolerance(const vti_stepper *stepper);

#endif
