/* SPDX-License-Identifier: BSD-3-Clause */
#include "journal.h"

#include <stdlib.h>
#include <string.h>

#include "digest.h"
#include "state.h"

enum { PIECE = 65536 }; /* doubles of a piece; SQLite keeps no bytes beyond 1e9 in one */

/* ---- streams ----------------------------------------------------------------------------------------------------- */

struct journal_mark journal_mark_start(int64_t doubles)
{
    const struct journal_mark mark = {doubles, 0, DIGEST_START};
    return mark;
}

struct journal_marks journal_marks(const struct journal *journal)
{
    const struct journal_marks marks = {journal->rows.mark, journal->frames.mark, journal->touches.mark};
    return marks;
}

double journal_bytes(const struct journal *journal, double rows, double frames, double touches)
{
    const double share = 1.02; /* what the file adds to a double */
    return 8.0 * share *
           ((double)journal->rows.mark.doubles * rows + (double)journal->frames.mark.doubles * frames +
            (double)journal->touches.mark.doubles * touches);
}

static int put_piece(struct journal *journal, const struct journal_file *file, int64_t doubles, struct message *message)
{
    return keep_put(&journal->keep, file->table, file->loaded, file->piece, sizeof(double) * (size_t)doubles, message);
}

int journal_add(struct journal *journal, struct journal_file *file, const double *record, struct message *message)
{
    struct journal_mark *mark = &file->mark;
    int64_t at = mark->doubles * mark->count;
    mark->digest = digest_add(mark->digest, record, sizeof(double) * (size_t)mark->doubles);
    ++mark->count;
    for (int64_t left = mark->doubles; left > 0;) {
        const int64_t room = PIECE - at % PIECE, n = left < room ? left : room;
        memcpy(file->piece + at % PIECE, record, sizeof(double) * (size_t)n);
        if (n == room && put_piece(journal, file, PIECE, message) != 0)
            return -1;
        at += n;
        record += n;
        left -= n;
        file->loaded = at / PIECE;
    }
    return 0;
}

int journal_flush(struct journal *journal, struct message *message)
{
    const struct journal_file *const files[] = {&journal->rows, &journal->frames, &journal->touches};
    for (int k = 0; k < 3; ++k) {
        const int64_t doubles = files[k]->mark.doubles * files[k]->mark.count % PIECE;
        if (doubles != 0 && put_piece(journal, files[k], doubles, message) != 0)
            return -1;
    }
    return 0;
}

/** Brings a piece into memory, with at least so many doubles. */
static int load(struct journal *journal, struct journal_file *file, int64_t number, int64_t doubles,
                struct message *message)
{
    const void *bytes;
    size_t size;
    if (file->loaded == number)
        return 0;
    const int found = keep_get(&journal->keep, file->table, number, &bytes, &size, message);
    if (found < 0)
        return -1;
    if (found == 0 || size < sizeof(double) * (size_t)doubles || size > sizeof(double) * PIECE)
        return keep_damaged(&journal->keep, "is damaged: it holds less than its checkpoint counts", message);
    memcpy(file->piece, bytes, size);
    file->loaded = number;
    return 0;
}

int journal_read(struct journal *journal, struct journal_file *file, int64_t first, int64_t count, double *records,
                 struct message *message)
{
    int64_t at = file->mark.doubles * first;
    for (int64_t left = file->mark.doubles * count; left > 0;) {
        const int64_t room = PIECE - at % PIECE, n = left < room ? left : room;
        if (load(journal, file, at / PIECE, at % PIECE + n, message) != 0)
            return -1;
        memcpy(records, file->piece + at % PIECE, sizeof(double) * (size_t)n);
        at += n;
        records += n;
        left -= n;
    }
    return 0;
}

/** Sets the stream to its mark. All that it holds is read once, so that damage is seen before anything is done. */
static int start_stream(struct journal *journal, struct journal_file *file, enum keep_table table,
                        struct journal_mark mark, struct message *message)
{
    const int64_t all = mark.doubles * mark.count;
    file->table = table;
    file->mark = mark;
    file->loaded = -1;
    if (mark.doubles == 0)
        return 0;
    file->piece = malloc(sizeof(double) * PIECE);
    if (file->piece == NULL)
        return message_set(message, "out of memory; use fewer bodies");
    for (int64_t at = 0; at < all; at += PIECE)
        if (load(journal, file, at / PIECE, all - at < PIECE ? all - at : PIECE, message) != 0)
            return -1;
    file->loaded = all / PIECE;
    return 0;
}

int journal_start(struct journal *journal, const struct journal_marks *marks, struct message *message)
{
    if (start_stream(journal, &journal->rows, KEEP_ROWS, marks->rows, message) != 0 ||
        start_stream(journal, &journal->frames, KEEP_FRAMES, marks->frames, message) != 0)
        return -1;
    /* a run has no results as a study does, and a table of its own would be a page in runs without touches */
    return start_stream(journal, &journal->touches, KEEP_RESULTS, marks->touches, message);
}

void journal_end(struct journal *journal, int removes)
{
    if (removes)
        keep_remove(&journal->keep);
    else
        keep_close(&journal->keep);
    free(journal->rows.piece);
    free(journal->frames.piece);
    free(journal->touches.piece);
    journal->rows.piece = journal->frames.piece = journal->touches.piece = NULL;
}
