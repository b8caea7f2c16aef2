/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What the checks share: bodies in the layout of the callback, fields of force, the host, and the report that they
 * fill. Each check writes its lines; response.c, spin.c and run.c turn what they find into sentences. */
#ifndef VTI_CHECK_PARTS_H
#define VTI_CHECK_PARTS_H

#include "vti.h"
#include "vti_check.h"

#define CHECK_PI 3.14159265358979323846

/** |a - b| */
static inline double difference(const double a[3], const double b[3])
{
    const double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return vti_norm(d);
}

/** The larger; once NaN, it stays. */
static inline double larger(double most, double x)
{
    return isnan(most) || x <= most ? most : x;
}

/** A state; all in the inertial frame. */
struct bodies {
    int64_t n;
    double x[3 * VTI_CHECK_BODIES], v[3 * VTI_CHECK_BODIES], q[4 * VTI_CHECK_BODIES], w[3 * VTI_CHECK_BODIES];
    double mass[VTI_CHECK_BODIES], inertia[VTI_CHECK_BODIES];
};

/** Forces as one effect, or, count = 0, free motion. It points into itself and must not be moved. */
struct field {
    vti_effect effect;
    vti_bonds bonds;
    int64_t count;
};

/** The kick by a load, F/m or M/J, in units of the right one: ratio times 1, own or own/other, where own is what the
 *  load is to be divided by (m of a force) and other what one might take for it (J). NaN if it is none of these. */
enum kick_law { KICK_RIGHT, KICK_UNDIVIDED, KICK_BY_OTHER, KICK_LAWS };
struct kick {
    int law;
    double ratio;
};

/** A host's constants, in units of the right ones. 0 or NaN: it does nothing, or what it does is no constant. */
struct constants {
    double flight, turn; /* distance of a free flight, angle of a free spin */
    struct kick force, moment;
    int64_t extra_steps; /* that it takes beyond those it is asked for */
};

/** A callback, and what is seen of it. */
struct host {
    vti_check_advance *advance;
    void *self;
    struct constants constants; /* which are corrected for */
    const struct field *field;  /* of the run under way */
    const struct bodies *start; /* of the run under way */
    int64_t calls;              /* of forces in the run under way */
    int primed;                 /* its first call was at the start */
};

struct kit {
    struct host host;
    vti_check_report *report;
    int rotates;       /* 0: translation only */
    double order;      /* of convergence, the least of all */
    int masked;        /* a sentence names what makes kicks meaningless */
    int attitude_lost; /* a sentence says already that attitudes are wrong */
};

/* ---- bodies.c ---------------------------------------------------------------------------------------------------- */

/** n bodies at rest at 0, unturned, m = J = 1. */
struct bodies vti_kit_bodies_none(int64_t n);
/** Takes *b further by the library's "srkn11", order 6. */
void vti_kit_bodies_advance_reference(struct bodies *b, const struct field *field, double h, int64_t steps);
/** Forces and moments of n <= VTI_CHECK_BODIES bodies; NaN where x or q is not finite. */
void vti_kit_bodies_forces(const struct field *field, int64_t n, const double *x, const double *q, double *force,
                           double *moment);
int vti_kit_bodies_are_finite(const struct bodies *b);
/** Sets everything to NaN. */
void vti_kit_bodies_lose(struct bodies *b);
/** Views on *b, without force and moment. */
vti_bodies vti_kit_bodies_views(const struct bodies *b);
/** Kinetic and field's energies; NaN if *b is not finite. */
double vti_kit_bodies_energy(const struct bodies *b, const struct field *field);
/** alpha of body i. *b is finite. */
void vti_kit_bodies_alpha(const struct bodies *b, int64_t i, double alpha[3]);
void vti_kit_bodies_set_alpha(struct bodies *b, int64_t i, const double alpha[3]);

/** Largest differences over the bodies of two states; attitudes by the angle. NaN if one is not finite. */
struct apart {
    double x, v, attitude, w;
};
struct apart vti_kit_bodies_apart(const struct bodies *a, const struct bodies *b);

/* ---- host.c ------------------------------------------------------------------------------------------------------ */

/** Takes *b further by the host, its constants corrected; if it refuses, everything is NaN. */
void vti_kit_host_advance(struct host *host, struct bodies *b, const struct field *field, double h, int64_t steps);
/** The size of a kick in units of the right one. */
double vti_kit_kick_size(const struct kick *kick, double own, double other);

/* ---- spin.c ------------------------------------------------------------------------------------------------------ */

/** What a free spin of size w about an axis has turned a body by that is turned already. NaN if the host refuses. */
struct turn {
    double angle, across; /* about the axis, and beside it */
    int side;             /* +1: the axis is one of space, -1: of the body */
    double spin;          /* along the axis, after the turn */
};
struct turn vti_kit_free_turn(struct kit *kit, double w, double h, int64_t steps);
/** The sentence where attitudes do not follow spins. */
void vti_kit_say_side(struct kit *kit, const struct turn *turn, double should_be);

/* ---- euler.c ----------------------------------------------------------------------------------------------------- */

/** A body of three principal moments and its angular momentum in space, and what acts on it: a constant moment in
 *  space, and a weight 1 along -e3 at arm. */
struct top {
    double q[4], L[3], I[3], moment[3], arm[3];
};
/** The usual one: turned, spinning, free. */
struct top vti_kit_top_usual(void);
/** The body after a time t, by Euler's equations with g times their gyroscopic term. */
struct top vti_kit_top_moved(const struct top *start, double g, double t);
/** The body after so many steps of the host; NaN if it refuses. */
struct top vti_kit_top_hosted(struct kit *kit, const struct top *start, double h, int64_t steps);
/** The angle between two attitudes; NaN if one is. */
double vti_kit_top_turned(const struct top *a, const struct top *b);

/* ---- ratios.c ---------------------------------------------------------------------------------------------------- */

/** Whether two ratios are one: to 1e-4. */
int vti_kit_same_ratio(double a, double b);
/** Whether a ratio is not 1: to 1e-4. */
int vti_kit_ratio_is_off(double ratio);
/** The sentences on constants that are off. */
void vti_kit_say_ratios(struct kit *kit, const struct constants *c);

/* ---- scenes.c ---------------------------------------------------------------------------------------------------- */

/** The paper's pendulum: m g = J = 1, turned by 3 pi/4, spinning slowly. */
struct bodies vti_kit_scene_pendulum(struct field *field);
/** Two bonded bodies that turn steadily like a rigid one, the bond stretched as the centripetal force demands. *r is
 *  the distance. */
struct bodies vti_kit_scene_rigid(struct field *field, double *r);
/** Two unlike bodies held by the axial spring alone, at a distance of 1.3 and going round each other: nothing turns. */
struct bodies vti_kit_scene_spring(struct field *field);
/** Two unlike bodies, bonded (moment, axial, shear), strained, moving and spinning; where only translation is looked
 *  at, vti_kit_scene_spring. */
struct bodies vti_kit_scene_bonded(const struct kit *kit, struct field *field);
/** Two bodies on a spring along x, stretched by 1e-3; oscillates by the frequency 1. */
struct bodies vti_kit_scene_stretch(struct field *field);
/** Two bodies on a torsion spring about z, twisted by 1e-3; oscillates by the frequency 1. */
struct bodies vti_kit_scene_torsion(struct field *field);

/* ---- words.c ----------------------------------------------------------------------------------------------------- */

/** A line: measured at most (relation -1) or at least (+1) bound, or else the verdict is otherwise. Returns the
 *  line. */
vti_check_line *vti_kit_line(struct kit *kit, const char *name, double measured, int relation, double bound,
                             int otherwise);
/** What a line says besides. */
void vti_kit_line_say(vti_check_line *line, const char *format, ...) __attribute__((format(printf, 2, 3)));
/** A sentence, once. */
void vti_kit_fault(struct kit *kit, const char *format, ...) __attribute__((format(printf, 2, 3)));
void vti_kit_remark(struct kit *kit, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* ---- the checks, in their order ---------------------------------------------------------------------------------- */

/* constants.c: ratios of distance, turn and kicks, which are corrected from there on */
void vti_kit_constants(struct kit *kit);
void vti_kit_spin(struct kit *kit);     /* spin.c: law, half turns, norm */
void vti_kit_response(struct kit *kit); /* response.c: what constant and growing loads do */
void vti_kit_frame(struct kit *kit);    /* frame.c: a load on a body that is turned */
void vti_kit_pendulum(struct kit *kit); /* motion.c */
void vti_kit_torsion(struct kit *kit);  /* motion.c; translation only: of a stretched pair */
void vti_kit_rigid(struct kit *kit);    /* motion.c */
void vti_kit_order(struct kit *kit);    /* motion.c */
void vti_kit_momentum(struct kit *kit); /* structure.c */
void vti_kit_reversal(struct kit *kit); /* structure.c */
void vti_kit_two_form(struct kit *kit); /* two_form.c */
void vti_kit_energy(struct kit *kit);   /* structure.c */
void vti_kit_inertia(struct kit *kit);  /* inertia.c: instead of all others, of bodies of three moments */

#endif
