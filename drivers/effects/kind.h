/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What an effect of scenes is: all that the programs know of it. Each has a file of its own here, which defines one
 * struct effect_kind, and is named in the list of kinds.h; nobody else knows it by name. What is NULL or 0 is absent,
 * unless kinds_check (kinds.c) asks for it. */
#ifndef VTI_KIND_H
#define VTI_KIND_H

#include <stddef.h>

#include "kinds.h"
#include "scene_field.h"
#include "sink.h"

struct scene;
struct scene_reader;
struct model;
struct invariant;
struct table;
struct table_kind;
struct tables;

/** What effects give bodies, in the bits of vti_effect. */
enum effect_gift { EFFECT_FORCE = 1 << VTI_QUANTITY_FORCE, EFFECT_MOMENT = 1 << VTI_QUANTITY_MOMENT };

/** Which pairs of bodies that overlap are in contact: all but those that lines hold, or all. */
enum effect_touch { EFFECT_TOUCH_APART = 1, EFFECT_TOUCH_ALL = 2 };

/** An effect of a model. */
struct effect {
    const struct effect_kind *kind;
    const void *settings;      /* kind->settings bytes: what the scene says */
    void *self;                /* what it acts with: from effect_memory, or NULL */
    vti_sum booked[VTI_TERMS]; /* its booked energies, which make points to where it has some; a run keeps them */
    vti_sum *by_body;          /* what of these each body has lost, of clumps each sphere, [of_body] of vti_effect;
                                  NULL: nobody asks (scene.by_body) */
};

/** An effect as a slice of the bodies feels it. */
struct effect_part {
    vti_effect made;
    void *memory; /* its lists, of room bytes */
    size_t room;
    vti_bonds bonds; /* what made acts with, of the kind's */
    vti_contacts contacts;
    int64_t age; /* of the lists that these are taken from; 0: none yet */
};

/** A term of its energy, or an entry of what it has booked, in pictures. */
struct effect_term {
    const char *name;    /* as in the library and in files */
    const char *symbol;  /* mathtext */
    const char *meaning; /* a word or two */
    const char *colour;  /* #rrggbb; two of one scene should be apart for every kind of sight */
};

enum { EFFECT_QUANTITIES = 8 };

/** Pairs of bodies that it holds together: lines in pictures, cells of trajectories, and left out of the search for
 *  pairs in contact. */
struct effect_lines {
    const char *name;                    /* of one; with an s, of all */
    const char *const *quantity;         /* names of the numbers of each line in files */
    int quantities;                      /* at most EFFECT_QUANTITIES */
    int (*told)(const struct effect *e); /* how many of them, from the first on, this scene has; NULL: all */
    int64_t (*count)(const struct effect *e);
    /** The bodies, from 0, of line k; the spheres of clumps, where it acts on these, as values are asked of them. */
    void (*ends)(const struct effect *e, int64_t k, int64_t pair[2]);
    /** value[q][k] for quantity q of line k, with the bodies where they are at the end of the step. Returns VTI_OK or a
     *  status. */
    int (*values)(const struct effect *e, const vti_bodies *bodies, int64_t step, double *const *value);
};

/** Lines that break as a run goes on (EQUATIONS 6.7), or are made; those that have broken still count. */
struct effect_breaks {
    int (*may)(const struct effect *e); /* whether they do in this scene; where they do not, nobody asks for more */
    /** Those that have broken at the end of the step: how many, and in *pair [][2] their bodies. Asked once a step. */
    int64_t (*broken)(struct effect *e, int64_t step, const int64_t **pair);
    const char *name[2]; /* columns of a run: lines that hold, and fragments that they hold together */
    void (*count)(const struct effect *e, double value[2]); /* the values of these columns now */
    /** The first body of the fragment that each body is in at the end of the step; -1 of a body that had no line. */
    void (*fragments)(const struct effect *e, int64_t step, double *fragment);
};

/** Planes n.x = d that bodies do not pass, and cylinders that they stay in, as they are at t = 0. */
struct effect_planes {
    const char *name; /* of one; with an s, of all */
    /** How many; in *plane [count][4]: n, d. */
    int64_t (*get)(const struct effect *e, const double **plane);
    /** How many cylinders; in *cylinder [count][7]: axis, a point on it, radius. NULL: none. */
    int64_t (*cylinders)(const struct effect *e, const double **cylinder);
    /** How each moves, planes first: on and on with the same velocity and spin. NULL, itself or what it returns: none
     *  does. */
    const vti_wall_motion *(*motion)(const struct effect *e);
    /** The largest |(v - V).N| of a body at x with the velocity v, V being that of a plane or cylinder where it is now,
     *  and N its normal there. */
    double (*approach)(const struct effect *e, const double x[3], const double v[3]);
};

struct chunks; /* chunks.h */

/** What touches, for effects that act where surfaces meet. */
struct effect_surfaces {
    const vti_contacts *contacts; /* of spheres, NULL if there are none; its list changes as pairs are found anew */
    const vti_walls *walls;       /* planes, NULL if there are none */
    double reach;                 /* the list has all pairs with a narrower gap */
    const struct chunks *chunks;  /* of the list and the bodies; NULL: they are few, and done in one piece */
};

/** A step of h from `before` to `now`; the longest time between two evaluations of the forces in it is gap h. */
struct effect_way {
    const double *before; /* [count of bodies][width], rows that begin with x and v */
    int64_t width;
    const vti_bodies *now;
    double h, gap;
};

/** Numbers that the motion keeps because of it. */
struct effect_invariants {
    const struct invariant *list;
    int count;
    void (*values)(const struct effect *e, const vti_bodies *bodies, double *values);
    int momenta; /* how many of them are momenta, which are the first */
    /** The momenta of many states, value[momenta][stride]: body k < count has the attitude, as a quaternion, and Omega
     *  of body 0 in state k, all numbers of like kind side by side. */
    void (*of_states)(const struct effect *e, const vti_bodies *states, double *value, int64_t stride);
};

/** What it remembers from step to step, which with the bodies and booked energies is all that a run goes on from. */
struct effect_memory_of {
    int64_t (*size)(const struct effect *e); /* doubles, now */
    void (*get)(const struct effect *e, double *memory);
    /** Takes what get has put there, at most left doubles. Returns how many they were, or -1: they are none of these,
     *  or there is no memory. */
    int64_t (*put)(struct effect *e, const double *memory, int64_t left);
};

/** What it follows along a run, and what a run must keep of it to go on with the same bits. */
struct effect_watch {
    /** At t = 0, or before put. Returns 0, or -1 if there is no memory. */
    int (*start)(struct effect *e);
    /** Frees what it follows with; nothing is asked after it but start. */
    void (*end)(struct effect *e);
    /** At every row of the run, with the energy of the motion and of the springs, and a step that none is longer
     *  than. */
    void (*row)(struct effect *e, const vti_bodies *bodies, double energy, double h);
    /** At every step, whose velocities may not be known yet. */
    void (*step)(struct effect *e, const vti_bodies *bodies);
    /** How many of its lines have turned past half a turn, where a moment changes its side. */
    int64_t (*turned)(const struct effect *e);
    /** What must be kept: how many doubles, and the doubles. */
    int64_t (*size)(const struct effect *e);
    void (*give)(const struct effect *e, struct sink *sink);
    void (*put)(struct effect *e, const double *state);
};

struct effect_kind {
    enum effect_number number;

    /* What a scene says. */
    const char *key; /* the key at its top that calls for the effect */
    /** The row of that key, then those of the keys in it; offsets are in the settings. */
    const struct scene_field *fields;
    int fields_count;
    size_t settings; /* bytes of the struct that values go to: zeros, then what defaults puts there */
    void (*defaults)(void *settings);
    /** What no single row says, when the whole scene is read. Returns 0, or -1 with one line by scene_reader_fail. */
    int (*check)(const struct scene_reader *reader, const struct scene *scene, const void *settings);
    /** The effect as far as settings and table decide, before there are bodies: what it needs and gives, whether it is
     *  smooth. table is its own, NULL if it is not read yet. One that acts by its flow alone gives here what bodies are
     *  to have: a moment if it turns them. */
    vti_effect (*draft)(const void *settings, const struct table *table);
    int spheres; /* 1: acts where surfaces meet: bodies need diameters, and small steps to meet */
    /** Whether it acts on the spheres of clumps, by the settings of all kinds; NULL: as spheres says. */
    int (*on_spheres)(const union effect_settings *all);
    int near; /* 1: needs also the pairs that do not touch yet and may at the end of the step */

    /* Its table, which one of the fields names (SCENE_PATH). */
    const struct table_kind *table;
    /** Whether scene and tables go together; the model knows by now whether bodies translate and turn. Returns 0, or -1
     *  with one line in *message. */
    int (*check_tables)(const struct model *model, const void *settings, const struct tables *tables,
                        struct message *message);

    /* In a model. */
    /** Completes the draft in *made with a self that outlives this call; NULL: it is complete. All bodies are there,
     *  and the effects before it in the list; table is its own. Returns 0, or -1 with one line in *message; destroy
     *  follows in either case, when the model ends. */
    int (*make)(struct effect *e, const struct model *model, const struct table *table, vti_effect *made,
                struct message *message);
    void (*destroy)(struct effect *e); /* frees what self points to, unless that is NULL; not self */
    /** Finds the pairs that touch, before forces and energies are evaluated. Returns 0, or -1 with one line in
     *  *message. */
    int (*find_pairs)(struct effect *e, const vti_bodies *bodies, struct message *message);
    /** At the end of every step of a model whose lines break: the lines between these count pairs of bodies have just
     *  broken. Returns as find_pairs. */
    int (*release)(struct effect *e, const vti_bodies *bodies, int64_t count, const int64_t *pair,
                   struct message *message);
    /** At the end of every step of such a model, at t, after what breaks: makes lines anew, and returns how many, or -1
     *  with one line in *message. */
    int64_t (*join)(struct effect *e, struct model *model, int64_t step, double t, struct message *message);
    /** Makes *part act on the pairs alone that name a body of the slice, if the effect's pairs have changed since the
     *  last call. Threads call it at the same time, each with a part of its own. Returns 0, or -1 if there is no
     *  memory. NULL: the effect has no pairs, or a slice goes through all of them. */
    int (*take_part)(const struct effect *e, const vti_bodies *slice, struct effect_part *part);
    const struct effect_term *terms; /* of all energies that it may have, and may book */
    int terms_count;

    /* What a run prints and checks of it. */
    /** Printed after the list of effects at the start of a run: "80 bonds". */
    void (*say)(const struct effect *e, char *text, size_t size);
    /** A note at the start of a run about what scene or tables say and probably do not mean; "" if there is none. */
    void (*note)(const struct effect *e, const struct model *model, char *text, size_t size);
    /** Names what limits the step (vti_stable_step). NULL: "KEY at body 3" does. */
    void (*limit)(const struct effect *e, const struct vti_deformation *at, const vti_stable *stable, char *text,
                  size_t size);
    /** Raises the strain or overlap of *at to what it is when two bodies that meet with this energy have none left. */
    void (*deform)(const struct effect *e, const vti_bodies *bodies, double energy, vti_deformation *at);
    /** The largest energy that a single spring of it holds where the bodies are, of the pairs of the last find_pairs.
     *  NULL: it has no springs. */
    double (*held)(const struct effect *e, const vti_bodies *bodies);
    /** The largest overlap, as a share of the distance at which the contact begins, of the pairs of the last
     *  find_pairs; at most 0 where nothing touches. NULL: it has no contacts. */
    double (*deepest)(const struct effect *e, const vti_bodies *spheres);
    /** The largest change of a relative velocity by a touch that the step has missed: one that lasts no longer than the
     *  time between two evaluations of the forces, of bodies that are apart at both ends of the step and overlap in
     *  between. Not called for clumps. NULL: it misses none. */
    double (*missed)(const struct effect *e, const struct effect_way *way);
    /** The acceleration [3] that it gives every body, for how far they fall. */
    const double *(*field)(const struct effect *e);
    /** The largest rate, 1/time, at which it slows a motion that others push. */
    double (*slowing)(const struct effect *e, const struct model *model);
    /** The same of motions that there are, be they pushed or not. NULL: it slows none that nothing pushes. */
    double (*slowing_free)(const struct effect *e, const struct model *model);
    /** Which overlapping pairs are in contact: enum effect_touch. NULL: it has no contact between bodies. */
    int (*touching)(const struct effect *e);
    /** Whether its stiffness follows from the bodies' materials, columns young and poisson of their table. NULL: it
     *  does not. */
    int (*by_material)(const struct effect *e);
    /** Where a body i that does not translate is drawn. */
    void (*centre)(const struct effect *e, const vti_bodies *bodies, int64_t i, double x[3]);
    const struct effect_invariants *invariants;
    /** energy[i] of each body i < count alone, whose attitudes are quaternions, of an effect with one term that is the
     *  sum over the bodies; all numbers of like kind lie side by side. NULL: it is no such sum, or nobody has said
     *  so. */
    void (*each)(const struct effect *e, const vti_bodies *bodies, double *energy);
    const struct effect_lines *lines;
    const struct effect_planes *planes;
    /** Sets those members of *surfaces that it has, and no others. */
    void (*surfaces)(const struct effect *e, struct effect_surfaces *surfaces);
    /** The bonds of its lines, which others damp. */
    const vti_bonds *(*bonds)(const struct effect *e);
    /** The friction where they touch, of the pairs whose first body is in chunk k; k is 0 where there are no chunks. */
    const vti_friction *(*friction)(const struct effect *e, int64_t k);
    const struct effect_breaks *breaks;
    const struct effect_watch *watch;
    const struct effect_memory_of *memory; /* beside booked energies */
};

/** Makes self, of so many bytes and zeros. Returns it, or NULL with one line in *message. */
void *effect_memory(struct effect *e, size_t bytes, struct message *message);
/** The effect of the model that has friction where surfaces meet; NULL if none has. */
const struct effect *effect_with_friction(const struct model *model);

struct scene_numbers;

/** Whether a list at a path of the scene has a number for each of the walls, or none. Returns 0, or -1 with one line in
 *  *message. */
int effect_walls_match(const struct model *model, const char *path, const struct scene_numbers *numbers,
                       const vti_walls *walls, struct message *message);

/** Room for n int64 or double, which may move: the part's memory, or NULL. */
void *effect_part_room(struct effect_part *part, int64_t n);

/** Arrays in initialisers of struct effect_kind, with their lengths. */
#define EFFECT_FIELDS(ARRAY) .fields = (ARRAY), .fields_count = sizeof(ARRAY) / sizeof((ARRAY)[0])
#define EFFECT_TERMS(ARRAY) .terms = (ARRAY), .terms_count = sizeof(ARRAY) / sizeof((ARRAY)[0])

#endif
