/* SPDX-License-Identifier: BSD-3-Clause
 * What the files of contact share. */
#ifndef VTI_CONTACT_ROOM_H
#define VTI_CONTACT_ROOM_H

#include "chunks.h"
#include "kind.h"
#include "neighbours.h"
#include "partings.h"

struct contact_self {
    vti_contacts contacts; /* its list is that of neighbours, as of the last find_pairs */
    struct neighbours neighbours;
    int parts;                /* 1 if bonds, whose bodies do not touch, may break */
    struct partings partings; /* of those that have */
    double *length;           /* of the list, of room for so many; while some pair has one of its own */
    int64_t room;
    int64_t age;          /* how often pairs or lengths have changed */
    int begun;            /* pairs have been found before */
    struct chunks chunks; /* of the list; all zeros where nobody asks for them */
    double modulus;       /* of the material */
    double stiffness;     /* K of the softest pair that there may be */
};

/* ---- pairs (contact_pairs.c); all but the first two as in kind.h ------------------------------------------------- */

/** The distance at which pair k of the list begins to touch. */
double contact_length(const vti_contacts *list, int64_t k);
/** The bodies of pair k as people number them; of clumps those whose spheres they are. */
void contact_name_pair(const struct neighbours *list, int64_t k, int64_t body[2]);
int contact_find_pairs(struct effect *e, const vti_bodies *bodies, struct message *message);
int contact_release(struct effect *e, const vti_bodies *bodies, int64_t count, const int64_t *pair,
                    struct message *message);
int contact_take_part(const struct effect *e, const vti_bodies *slice, struct effect_part *part);
extern const struct effect_memory_of contact_memory;

/* ---- touches between two evaluations (contact_missed.c) ---------------------------------------------------------- */

/** As in kind.h. */
double contact_missed(const struct effect *e, const struct effect_way *way);

#endif
