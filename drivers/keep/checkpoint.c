/* SPDX-License-Identifier: BSD-3-Clause */
#include "checkpoint.h"

#include <stdlib.h>
#include <string.h>

#include "digest.h"
#include "state.h"

enum { BYTES = 524288 }; /* of a piece; SQLite keeps no more than 1e9 in one */

/** Bytes of all of it: the struct, the state, and the digest of both. */
static size_t whole_size(const struct checkpoint *checkpoint)
{
    return sizeof *checkpoint + sizeof(double) * (size_t)checkpoint->state_doubles + sizeof(uint64_t);
}

/** Bytes that go to the journal in pieces of BYTES, and their digest. */
struct pieces {
    struct journal *journal;
    unsigned char *piece;
    int64_t number; /* of the piece that is being filled */
    size_t filled;  /* bytes of it so far */
    uint64_t digest;
    int failed;
    struct message *message;
};

static void put_rest(struct pieces *p)
{
    if (p->failed == 0 && p->filled > 0)
        p->failed = keep_put(&p->journal->keep, KEEP_CHECKPOINT, p->number++, p->piece, p->filled, p->message);
    p->filled = 0;
}

static void put_bytes(struct pieces *p, const void *data, size_t size)
{
    const unsigned char *bytes = data;
    p->digest = digest_add(p->digest, data, size);
    while (size > 0) {
        const size_t room = BYTES - p->filled, n = size < room ? size : room;
        memcpy(p->piece + p->filled, bytes, n);
        p->filled += n;
        bytes += n;
        size -= n;
        if (p->filled == BYTES)
            put_rest(p);
    }
}

static void put_numbers(struct sink *sink, const double *numbers, int64_t count)
{
    if (count > 0)
        put_bytes(sink->context, numbers, sizeof *numbers * (size_t)count);
}

/** All of a checkpoint; memory is what the model remembers. */
static void put_checkpoint(struct pieces *p, const struct checkpoint *checkpoint, const vti_bodies *bodies,
                           const struct verdict *verdict, const double *more, int64_t more_count, const double *memory)
{
    struct sink sink = {put_numbers, p};
    put_bytes(p, checkpoint, sizeof *checkpoint);
    state_give(bodies, &sink);
    verdict_give(verdict, &sink);
    put_numbers(&sink, more, more_count);
    put_numbers(&sink, memory, model_memory_size(verdict->model));
    const uint64_t digest = p->digest;
    put_bytes(p, &digest, sizeof digest);
    put_rest(p);
}

/** Doubles of the state in a checkpoint; remembered: those that the model remembers. */
static int64_t state_doubles(const vti_bodies *bodies, const struct verdict *verdict, int64_t more_count,
                             int64_t remembered)
{
    return state_size(bodies) + verdict_size(verdict) + more_count + remembered;
}

double checkpoint_bytes(const vti_bodies *bodies, const struct verdict *verdict, int64_t more_count)
{
    struct checkpoint checkpoint = {0};
    checkpoint.state_doubles = state_doubles(bodies, verdict, more_count, model_memory_size(verdict->model));
    return (double)whole_size(&checkpoint);
}

int checkpoint_write(struct journal *journal, struct checkpoint *checkpoint, const vti_bodies *bodies,
                     const struct verdict *verdict, const double *more, int64_t more_count, struct message *message)
{
    const int64_t remembered = model_memory_size(verdict->model);
    double *memory = malloc(sizeof *memory * (size_t)(remembered + 1));
    struct pieces p = {journal, malloc(BYTES), 0, 0, DIGEST_START, 0, message};
    checkpoint->rows = journal->rows.mark;
    checkpoint->frames = journal->frames.mark;
    checkpoint->touches = journal->touches.mark;
    checkpoint->state_doubles = state_doubles(bodies, verdict, more_count, remembered);
    if (memory == NULL || p.piece == NULL) {
        free(memory);
        free(p.piece);
        return message_set(message, "%.600s: out of memory; use fewer bodies", journal->keep.path);
    }
    p.failed = journal_flush(journal, message);
    if (p.failed == 0) {
        model_memory_get(verdict->model, memory);
        put_checkpoint(&p, checkpoint, bodies, verdict, more, more_count, memory);
    }
    free(memory);
    free(p.piece);
    return p.failed != 0 ? -1 : keep_commit(&journal->keep, message);
}

int checkpoint_pieces(struct journal *journal,
                      int (*take)(void *self, size_t at, size_t all, const void *piece, size_t size), void *self,
                      struct message *message)
{
    size_t all = 0, at = 0, size;
    const void *piece;
    for (int64_t k = 0; k == 0 || at < all; ++k, at += size) {
        const int found = keep_get(&journal->keep, KEEP_CHECKPOINT, k, &piece, &size, message);
        if (found < 0)
            return -1;
        struct checkpoint checkpoint;
        if (found == 0 || (k == 0 && size < sizeof checkpoint))
            return keep_damaged(&journal->keep, "is damaged: it has no checkpoint", message);
        if (k == 0) {
            memcpy(&checkpoint, piece, sizeof checkpoint);
            all = whole_size(&checkpoint);
        }
        if (size == 0 || size > all - at)
            return keep_damaged(&journal->keep, "is damaged: its checkpoint is of another size", message);
        if (take(self, at, all, piece, size) != 0)
            return message->text[0] != '\0'
                       ? -1
                       : message_set(message, "%.600s: out of memory; use fewer bodies", journal->keep.path);
    }
    return 0;
}

struct bytes {
    unsigned char *p;
    size_t size;
};

static int take_piece(void *self, size_t at, size_t all, const void *piece, size_t size)
{
    struct bytes *bytes = self;
    if (bytes->p == NULL)
        bytes->p = malloc(all);
    bytes->size = all;
    if (bytes->p == NULL)
        return -1;
    memcpy(bytes->p + at, piece, size);
    return 0;
}

unsigned char *checkpoint_read(struct journal *journal, size_t *size, struct message *message)
{
    struct bytes bytes = {NULL, 0};
    message->text[0] = '\0';
    if (checkpoint_pieces(journal, take_piece, &bytes, message) != 0) {
        free(bytes.p);
        return NULL;
    }
    *size = bytes.size;
    return bytes.p;
}

int checkpoint_take(const unsigned char *bytes, size_t size, struct checkpoint *checkpoint, const vti_bodies *bodies,
                    struct verdict *verdict, double *more, int64_t more_count)
{
    uint64_t digest;
    const int64_t fixed = state_size(bodies) + verdict_size(verdict) + more_count;
    const size_t least = sizeof *checkpoint + sizeof(double) * (size_t)fixed + sizeof digest;
    if (size < least || (size - least) % sizeof(double) != 0)
        return -1;
    memcpy(&digest, bytes + size - sizeof digest, sizeof digest);
    if (digest != digest_add(DIGEST_START, bytes, size - sizeof digest))
        return -1;
    const int64_t memory = (int64_t)((size - least) / sizeof(double));
    memcpy(checkpoint, bytes, sizeof *checkpoint);
    /* who starts anew from step 0 moves the velocities of a lagging method anew */
    if (checkpoint->step > 0) {
        const double *state = (const double *)(const void *)(bytes + sizeof *checkpoint);
        state_put(state, bodies);
        verdict_put(verdict, state + state_size(bodies));
        if (model_memory_put(verdict->model, state + fixed, memory) != 0)
            return -1;
        if (more_count > 0)
            memcpy(more, state + state_size(bodies) + verdict_size(verdict), sizeof *more * (size_t)more_count);
    }
    return 0;
}
