/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bodies by their numbers in chunks, as many as their number says, and pairs in contact by the chunks of their bodies:
 * what threads do at once where velocities or memory of both bodies change. Groups of one round share no chunk, so that
 * they may be done in any order; and as chunks and rounds do not depend on threads, bits do not either. */
#ifndef VTI_CHUNKS_H
#define VTI_CHUNKS_H

#include "vti.h"

enum { CHUNKS_MOST = 64 };

/** The pairs between two chunks, or inside of one, in the order of the list. */
struct chunk_group {
    int64_t low, high; /* chunks of i and of j */
    vti_contacts contacts;
};

struct chunks {
    int64_t bodies, count;     /* chunks; 1 of few bodies */
    int64_t age;               /* lists taken so far */
    vti_contacts *of;          /* [count] the pairs whose first body is in the chunk, in the order of the list */
    struct chunk_group *group; /* [groups], inside of chunks first, then round by round */
    int64_t groups;
    int64_t *rank; /* [count][count] which group that of low and high is */
    int64_t *ends; /* [rounds] of the groups in it */
    int64_t rounds;
    int64_t *pair, room; /* by groups */
    double *length;      /* likewise */
};

/** Chunks of so many bodies, without pairs. Returns 0, or -1 if memory is out; chunks_destroy follows either way. */
int chunks_create(struct chunks *chunks, int64_t bodies);
void chunks_destroy(struct chunks *chunks);

/** Takes the pairs i < j of *all, ascending by i, which must stay as they are until the next call. Returns 0, or -1 if
 *  memory is out. */
int chunks_take(struct chunks *chunks, const vti_contacts *all);

/** The pairs of *all that name a body of the slice, copied to pair, and their lengths to length. */
vti_contacts chunks_pairs_of(const vti_contacts *all, const vti_bodies *slice, int64_t *pair, double *length);

/** The chunk of a body. */
int64_t chunks_of(const struct chunks *chunks, int64_t body);
/** The bodies of chunk k among those of *bodies, a slice or all. */
vti_bodies chunks_slice(const struct chunks *chunks, int64_t k, const vti_bodies *bodies);

/** Calls work for every group, round by round, those of a round at once; backwards: the last round first. Groups inside
 *  of chunks are one round, the first; of others only those with pairs are called. */
void chunks_by_rounds(const struct chunks *chunks, int backwards, void (*work)(void *self, int64_t group), void *self);
/** Adds what a chunk has booked to the sum of all, and begins anew. */
void chunks_book(vti_sum *all, vti_sum *own);
/** Calls work for every chunk, all at once; returns the sum of what it returns. */
int64_t chunks_all(const struct chunks *chunks, int64_t (*work)(void *self, int64_t chunk), void *self);

#endif
