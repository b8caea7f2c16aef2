/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What the checks share: bodies in the layout of the callback, fields of force, the host, and the report that they fill.
 * Each check writes its lines; response.c, spin.c and run.c turn what they find into sentences. */
#ifndef VTI_CHECK_PARTS_H
#define VTI_CHECK_PARTS_H

#include "vti.h"
#include "vti_check.h"

#define CHECK_PI 3.14159265358979323846

/** A state; all in the inertial frame. */
struct bed {
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

/** A callback, and what is seen of it. */
struct host {
    vti_check_advance *advance;
    void *self;
    const struct field *field; /* of the run under way */
    const struct bed *start;   /* of the run under way */
    int64_t calls;             /* of forces in the run under way */
    int primed;                /* its first call was at the start */
};

struct kit {
    struct host host;
    vti_check_report *report;
    int rotates;       /* 0: translation only */
    double order;      /* of convergence, the least of all */
    int energy_known;  /* a sentence says already what the energy does */
    int attitude_lost; /* a sentence says already that attitudes are wrong */
};

/* ---- bed.c ------------------------------------------------------------------------------------------------------- */

/** n bodies at rest at 0, unturned, m = J = 1. */
struct bed bed_none(int64_t n);
/** Takes *b further by the host; if it refuses, everything is not a number. */
void bed_advance(struct host *host, struct bed *b, const struct field *field, double h, int64_t steps);
/** The same by the library's "srkn11", order 6. */
void bed_advance_reference(struct bed *b, const struct field *field, double h, int64_t steps);
int bed_is_finite(const struct bed *b);
/** Views on *b, without force and moment. */
vti_bodies bed_bodies(const struct bed *b);
/** Kinetic and field's energies; NaN if *b is not finite. */
double bed_energy(const struct bed *b, const struct field *field);
/** alpha of body i. *b is finite. */
void bed_alpha(const struct bed *b, int64_t i, double alpha[3]);
void bed_set_alpha(struct bed *b, int64_t i, const double alpha[3]);

/** Largest differences over the bodies of two states; attitudes by the angle. NaN if one is not finite. */
struct apart {
    double x, v, attitude, w;
};
struct apart bed_apart(const struct bed *a, const struct bed *b);

/* ---- scenes.c ----------------------------------------------------------------------------------------------------- */

/** The paper's pendulum: m g = J = 1, turned by 3 pi/4, spinning slowly. */
struct bed scene_pendulum(struct field *field);
/** Two unlike bodies, bonded (moment, axial, shear), strained, moving and spinning. */
struct bed scene_pair(struct field *field);
/** The same bond turning steadily like a rigid body, stretched as its centripetal force demands. *r is the distance. */
struct bed scene_rigid(struct field *field, double *r);
/** The pair of scene_pair held by the axial spring alone, at a distance of 1.3 and going round each other: nothing turns. */
struct bed scene_spring(struct field *field);
/** scene_pair, or scene_spring where only translation is looked at. */
struct bed scene_bonded(const struct kit *kit, struct field *field);
/** Two bodies on a spring along x, stretched by 1e-3; oscillates by the frequency 1. */
struct bed scene_stretch(struct field *field);
/** Two bodies on a torsion spring about z, twisted by 1e-3; oscillates by the frequency 1. */
struct bed scene_torsion(struct field *field);

/* ---- words.c ------------------------------------------------------------------------------------------------------ */

/** A line: measured at most (relation -1) or at least (+1) bound, or else the verdict is otherwise. Returns the line. */
vti_check_line *kit_line(struct kit *kit, const char *name, double measured, int relation, double bound, int otherwise);
/** What a line says besides. */
void line_say(vti_check_line *line, const char *format, ...) __attribute__((format(printf, 2, 3)));
/** A sentence, once. */
void kit_fault(struct kit *kit, const char *format, ...) __attribute__((format(printf, 2, 3)));
void kit_remark(struct kit *kit, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* ---- the checks, in their order ------------------------------------------------------------------------------------ */

void check_spin(struct kit *kit);     /* spin.c: law, side, half turns, norm */
void check_response(struct kit *kit); /* response.c: what constant and growing loads do */
void check_frame(struct kit *kit);    /* spin.c: a moment on a body that is turned */
void check_pendulum(struct kit *kit); /* motion.c */
void check_torsion(struct kit *kit);  /* motion.c; translation only: of a stretched pair */
void check_rigid(struct kit *kit);    /* motion.c */
void check_order(struct kit *kit);    /* motion.c */
void check_momentum(struct kit *kit); /* structure.c */
void check_reversal(struct kit *kit); /* structure.c */
void check_two_form(struct kit *kit); /* two_form.c */
void check_energy(struct kit *kit);   /* structure.c */

#endif
