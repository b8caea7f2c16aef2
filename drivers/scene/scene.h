/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A scene: the bodies, the effects it calls for and how to step them, as numbers. A section that the file lacks is an
 * effect that does not exist; bodies without positions do not translate, and bodies that nothing turns have no
 * attitude. What a scene file may hold is the table in scene_field.c. */
#ifndef VTI_SCENE_H
#define VTI_SCENE_H

#include <stdio.h>

#include "kinds.h"
#include "message.h"
#include "table.h"
#include "vti.h"

enum { SCENE_PATH_SIZE = TABLE_PATH_SIZE, SCENE_PLANES_MAX = 256, SCENE_CYLINDERS_MAX = 16 };
enum { SCENE_WALLS_MAX = SCENE_PLANES_MAX + SCENE_CYLINDERS_MAX, SCENE_SPHERES_MAX = 128 };

/** The most bodies of a scene. */
enum { SCENE_BODIES_MAX = TABLE_ROWS_MAX };

/** How steps of variable length are chosen, if not by a tolerance. */
enum scene_control { SCENE_INTEGRATING = 1, SCENE_NAIVE = 2 };

/** Where the bodies are. */
enum scene_arrangement { SCENE_SINGLE, SCENE_IN_RING, SCENE_IN_CHAIN, SCENE_IN_LATTICE, SCENE_IN_TABLE };

/** Body k at the angle 2 pi k/count about center, in the plane z = center[2]. */
struct scene_ring {
    int64_t count;
    double diameter, center[3];
};

/** Body k at start + k spacing direction/|direction|. */
struct scene_chain {
    int64_t count;
    double spacing, start[3], direction[3];
};

/** Body i + counts[0] (j + counts[1] k) at corner + spacing (i, j, k). */
struct scene_lattice {
    int64_t counts[3];
    double spacing, corner[3];
};

/** Added to the velocities and the attitude vectors of all bodies, uniform in [-v, v), [-omega, omega) and [-alpha,
 *  alpha) per component (random.h); 0 is none. */
struct scene_random {
    int64_t seed;
    double v, omega, alpha;
};

struct scene_planes {
    int64_t count;
    double plane[SCENE_PLANES_MAX][4]; /* n (made unit), d: the plane n.x = d */
};

struct scene_cylinders {
    int64_t count;
    double cylinder[SCENE_CYLINDERS_MAX][7]; /* axis (made unit), a point on it, radius */
};

struct scene_spheres {
    int64_t count;
    double sphere[SCENE_SPHERES_MAX][4]; /* centre, diameter */
};

struct scene_vectors {
    int64_t count;
    double vector[SCENE_WALLS_MAX][3];
};

struct scene_numbers {
    int64_t count;
    double number[SCENE_WALLS_MAX];
};

/** Bodies that are several spheres each: templates, one behind the other, of counts spheres; of all without counts. */
struct scene_clumps {
    int given;
    struct scene_spheres spheres;
    struct scene_numbers counts;
    double density; /* 0: bodies have a mass */
};

struct tables; /* effects/tables.h */

struct scene {
    char name[64]; /* letters, digits, _ and -; of the file, up to its last dot, if the scene has none */

    /* As far as the file itself says; what a table says comes on top, and struct model has the final word. */
    int translates; /* positions are given */
    int turns;      /* attitude or angular velocity is given, or an effect turns bodies */
    int by_body;    /* 1: what is booked is kept of each body too. Set by the caller after scene_read */

    enum scene_arrangement arrangement;
    struct scene_ring ring;
    struct scene_chain chain;
    struct scene_lattice lattice;
    char table[SCENE_PATH_SIZE];     /* of the bodies */
    double mass, inertia, diameter;  /* of all bodies; 0 if the file does not say */
    double density;                  /* of all, where it says that in the place of their mass; else 0 */
    double moments[3], principal[3]; /* of all bodies that are not spheres, and how their axes lie; 0: they are */
    struct scene_clumps clumps;
    double x[3]; /* of a single body */
    double v[3], alpha[3], omega[3];
    struct scene_random random;
    int has_v, has_alpha, has_omega; /* the file gives them */

    int has[EFFECT_COUNT];          /* which effects it calls for, by their numbers (effects/kinds.h) */
    union effect_settings settings; /* what it says of them: kinds_settings_of */

    /* What the tables hold, if somebody has read them already; NULL: model_create reads them, which must then be CSV.
     * Set by the caller after scene_read, and still the caller's. */
    const struct tables *tables;

    const vti_stepper *stepper; /* "vti2" if the file has none; moments are in space */
    int64_t rotor; /* of bodies with three moments, in the place of the stepper's: 2, 4 or 6; 0 is the stepper's */
    double h, t_end;
    double tolerance;      /* of steps that keep it; 0 is none: steps of h */
    int64_t control;       /* enum scene_control, what else steps go by; 0 is nothing */
    double speed, turning; /* units of what steps go by (scene_unit) */
};

/** Reads and checks the YAML file at path. overrides are n "path.to.key=value" strings, as they follow --set; they
 *  replace or add single values before the check, the later one counts, and a value is written as in the file ("[0, 0,
 *  1]", "1/64"). Anchors are passed over, aliases refused. Returns 0, or -1 with one line in *message such as
 *  "pendulum.yaml:6:12: bodies.inertia: 'two' is not a number; write 0.01, 1e-3, 1/64 or 2^-6", where a value that came
 *  from an override is placed by "--set path=value" instead of file, line and column. An override that is an option of
 *  its own is written "--t-end=10", and placed by that. *scene needs no freeing. */
int scene_read(const char *path, const char *const *overrides, int n, struct scene *scene, struct message *message);

/** The file of a scene as it was read, for those that read it more than once: it may be edited meanwhile. */
struct scene_text {
    char *bytes;
    size_t size;
};
/** Returns 0 and scene_text_destroy is due, or -1 with one line in *message. */
int scene_text_read(const char *path, struct scene_text *text, struct message *message);
void scene_text_destroy(struct scene_text *text);
/** As scene_read. path is what messages name, and where the paths in the scene begin. */
int scene_read_text(const char *path, const struct scene_text *text, const char *const *overrides, int n,
                    struct scene *scene, struct message *message);

/** What a unit is that the scene gives, or leaves out as 0: 1. */
static inline double scene_unit(double given)
{
    return given > 0.0 ? given : 1.0;
}

/** How many bodies the scene has; 0 if only its table knows. */
int64_t scene_bodies(const struct scene *scene);
/** How many templates of clumps it has; 0 without clumps. */
int64_t scene_templates(const struct scene *scene);
/** The key that gives the positions: "bodies.ring" and so on. */
const char *scene_positions_key(const struct scene *scene);
/** What is known of each body: 1 or 0. */
struct scene_known {
    int mass, diameter, inertia;
};
/** That what the scene says and its table has, and what follows: a ring's neighbours touch, and a solid sphere's
 *  inertia is that of its mass and diameter. */
struct scene_known scene_knows(const struct scene *scene, struct scene_known table);
/** The word of its control; NULL if it has none. */
const char *scene_control_word(const struct scene *scene);
/** The key of the first of its effects that has the trait, NULL if none has. Of stiff ones steps above h may be
 *  unstable. */
const char *scene_first_with(const struct scene *scene, enum effect_trait trait);
/** Says that there is no memory for what the scene asks. Returns -1. */
int scene_no_memory(const struct scene *scene, struct message *message);

/* ---- lists for people -------------------------------------------------------------------------------------------- */

/* What a scene may name, for people: the tables that scenes are read by. */

/** Prints the steppers, the effects or the keys of scenes, one a line: name, tabulator, what it is. Returns 0, or -1
 *  with one line in *message if what is none of "steppers", "effects" and "keys". */
int scene_list(const char *what, FILE *file, struct message *message);

#endif
