/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The effects that scenes may call for: the one list of them. A new one is a name in this list and a file NAME.c, in
 * meson.build, that defines effect_NAME; the order is that of effects in models and of columns in files. Effects that
 * hold bodies together (kind.h, lines) stand before those that search for pairs, which leave those pairs alone; drag
 * stands first, so that its flow is the outermost (EQUATIONS 6.3). */
#ifndef VTI_KINDS_H
#define VTI_KINDS_H

#include "message.h"
#include "vti.h"

#define EFFECT_KINDS(KIND)                                                                                             \
    KIND(drag)                                                                                                         \
    KIND(binder) KIND(bond_dashpot) KIND(contact) KIND(wall) KIND(friction) KIND(dashpot) KIND(gravity) KIND(pendulum)

#define EFFECT_NUMBER(NAME) EFFECT_##NAME,
enum effect_number { EFFECT_KINDS(EFFECT_NUMBER) EFFECT_COUNT };
#undef EFFECT_NUMBER

/** Rows of terms, of all effects together: there are columns for so many (columns.h). */
enum { EFFECT_TERMS_OF_ALL = 32 };

struct effect_kind; /* kind.h */
struct table;

#define EFFECT_DECLARE(NAME) extern const struct effect_kind effect_##NAME;
EFFECT_KINDS(EFFECT_DECLARE)
#undef EFFECT_DECLARE

/** What a scene says of all effects: structs of the effects' own, one behind the other. */
union effect_settings {
    unsigned char bytes[40960];
    double number;
    int64_t count;
    void *place;
};

/** The kind of number k, NULL behind the last. */
const struct effect_kind *kinds_at(int k);
/** The kind whose key the path of a scene's field begins with; NULL if there is none. */
const struct effect_kind *kinds_find(const char *path);

/** Where the kind's own settings are. */
void *kinds_settings(const struct effect_kind *kind, union effect_settings *all);
const void *kinds_settings_of(const struct effect_kind *kind, const union effect_settings *all);
/** All of them as they are where a scene says nothing. */
void kinds_defaults(union effect_settings *all);

/** The kind's draft with its own settings. */
vti_effect kinds_draft(const struct effect_kind *kind, const union effect_settings *all, const struct table *table);
/** What may hold for an effect of a scene. */
enum effect_trait {
    EFFECT_TRANSLATING, /* acts on bodies that translate: gives a force, needs positions, or holds bodies together */
    EFFECT_SPHERES,     /* acts where surfaces meet: bodies need diameters, and small steps to meet */
    EFFECT_SURFACES,    /* has surfaces, which others damp and rub */
    EFFECT_ON_SPHERES,  /* acts on the spheres of bodies that are clumps */
    EFFECT_BONDS,       /* has bonds, which hold bodies together */
    EFFECT_NEAR,        /* looks at pairs that touch only at the end of the step, too */
    EFFECT_KINKED,      /* its force has kinks: where a contact begins, say */
    EFFECT_STIFF        /* pushes bodies that translate, and not all of them alike */
};
/** Whether it holds. */
int kinds_has(const struct effect_kind *kind, const union effect_settings *all, enum effect_trait trait);

/** Whether every kind says all that it must: at the start of programs. Returns 0, or -1 with one line in *message that
 *  names the file. */
int kinds_check(struct message *message);
/** The same for one of them, at place k of the list. */
int kinds_check_kind(int k, const struct effect_kind *kind, struct message *message);
/** The same for an effect that a kind has made of a draft. */
int kinds_check_made(const struct effect_kind *kind, const vti_effect *draft, const vti_effect *made,
                     struct message *message);

#endif
