/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The one table of what a scene file may hold: the path of every key, its kind, and where its value goes in struct
 * scene; the rows of effects are theirs (effects/kind.h). Reading, --set, the conversion, the range checks and the
 * lists of known keys in messages are all made from it, so that a new key is one row, and a new section a row for
 * itself and one for each of its keys. */
#ifndef VTI_SCENE_FIELD_H
#define VTI_SCENE_FIELD_H

#include <stddef.h>
#include <stdint.h>

enum scene_kind {
    SCENE_SECTION,   /* holds keys; goes nowhere */
    SCENE_NUMBER,    /* goes to a double */
    SCENE_VECTOR,    /* three numbers; goes to a double[3] */
    SCENE_COUNT,     /* whole number; goes to an int64_t */
    SCENE_COUNTS,    /* three whole numbers; goes to an int64_t[3] */
    SCENE_PLANES,    /* list of rows nx, ny, nz, d; goes to a struct scene_planes */
    SCENE_CYLINDERS, /* list of rows ax, ay, az, x, y, z, R; goes to a struct scene_cylinders */
    SCENE_SPHERES,   /* list of rows x, y, z, D; goes to a struct scene_spheres */
    SCENE_VECTORS,   /* list of rows of three numbers; goes to a struct scene_vectors */
    SCENE_NUMBERS,   /* list of numbers; goes to a struct scene_numbers */
    SCENE_YES_NO,    /* yes or no; goes to an int64_t, 1 or 0 */
    SCENE_WORD,      /* one of the row's words; goes to an int64_t */
    SCENE_PATH,      /* of a file, relative to the scene's; goes to a char[SCENE_PATH_SIZE] */
    SCENE_NAME,      /* letters, digits, _ and -; goes to a char[64] */
    SCENE_STEPPER    /* name of a stepper; goes to a const vti_stepper * */
};
enum { SCENE_KINDS = SCENE_STEPPER + 1 }; /* the last */

enum scene_need {
    SCENE_MAY, /* can be left out */
    SCENE_MUST /* must be given wherever the section that it is in is given */
};

enum scene_range { SCENE_ANY, SCENE_POSITIVE, SCENE_NOT_NEGATIVE, SCENE_NOT_ZERO, SCENE_POISSON };

#define SCENE_NOWHERE ((size_t)-1)

/** A word that stands for a number; lists end with a word NULL. */
struct scene_word {
    const char *word;
    int64_t value;
};

struct scene_field {
    const char *path; /* keys joined by dots */
    enum scene_kind kind;
    enum scene_need need;
    enum scene_range range;
    size_t offset;                  /* in struct scene, or in the settings of its effect; SCENE_NOWHERE */
    const char *about;              /* what it is, for messages: "stiffness K^pp" */
    const char *says;               /* one sentence about it, for lists and docs/scenes.md */
    const struct scene_word *words; /* of SCENE_WORD */
};

/** A kind of lists of any length, which go to a struct of their count, an int64_t, and their numbers. */
struct scene_rows {
    int64_t width, most;           /* numbers of a row, and the most rows */
    const char *name;              /* "planes" */
    const char *row, *row_example; /* "four numbers nx, ny, nz, d" and one of them; NULL: rows are numbers */
    const char *example;           /* of the list */
};

/** What those structs begin with. */
struct scene_list {
    int64_t count; /* rows */
    double numbers[];
};

/** NULL for kinds that are no such lists. */
const struct scene_rows *scene_rows_of(enum scene_kind kind);

struct scene;

/** Row k of the table; NULL behind its end. A section stands before its keys. */
const struct scene_field *scene_field_at(int k);

/** The row of a path, NULL if there is none. */
const struct scene_field *scene_field_find(const char *path);

/** The last key of the field's path if the field is directly in section ("" is the whole scene), else NULL. */
const char *scene_field_key(const struct scene_field *field, const char *section);

/** Writes the keys of a section, separated by ", ", cut off at size. Returns out. */
char *scene_field_list(const char *section, char *out, size_t size);

/** Where the field's value goes in *scene; NULL if it goes nowhere. */
void *scene_field_place(const struct scene_field *field, struct scene *scene);

/** Cuts the last key or [index] off a path; "" stays "". */
void scene_path_up(char *path);

#endif
