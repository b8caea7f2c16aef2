/* SPDX-License-Identifier: BSD-3-Clause
 * What the files of friction share. */
#ifndef VTI_FRICTION_ROOM_H
#define VTI_FRICTION_ROOM_H

#include "chunks.h"
#include "kind.h"

/** What the pairs whose first body is in a chunk, and its bodies at walls, hold, and lose in one drift. */
struct friction_chunk {
    vti_friction friction;
    vti_walls walls;
    vti_history history; /* with room for twice as many touches as there may be after the next drift */
    vti_sum lost[VTI_FRICTION_BOOKS], work;
};

struct friction_self {
    vti_friction friction; /* of all; what the effect acts with */
    vti_scalars diameter;
    const struct chunks *chunks; /* NULL: none */
    int64_t count;               /* of chunks, or 1, of which only the history is used */
    struct friction_chunk *chunk;
    double *by_pair;        /* of all chunks, where bodies have books: what each pair loses in one drift; NULL: none */
    vti_effect whole, made; /* as in one piece, and as it is */
};

/* ---- what springs remember (friction_memory.c) ------------------------------------------------------------------- */

/** Room for so many touches. Returns 0, or -1 if there is no memory. */
int friction_make_room(vti_history *history, int64_t touches);
/** Frees its memory. */
void friction_free(vti_history *history);
/** What all springs hold, for a run that goes on. */
extern const struct effect_memory_of friction_memory;
/** Room for what may touch after the next drift (kind.h). */
int friction_find_pairs(struct effect *e, const vti_bodies *bodies, struct message *message);

/* ---- by chunks (friction_chunks.c) ------------------------------------------------------------------------------- */

/** Makes the chunks, or the one of all, once friction is complete but for its history. Returns 0, or -1 if memory is
 *  out. */
int friction_make_chunks(struct friction_self *self);
/** Makes the effect in one piece work by chunks, if there are any. */
void friction_by_chunks(struct friction_self *self, vti_effect *made);
/** As in kind.h. */
int friction_take_part(const struct effect *e, const vti_bodies *slice, struct effect_part *part);

#endif
