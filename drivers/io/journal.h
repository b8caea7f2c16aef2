/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The journal of a run: a folder beside its output, OUT.run, with the files "rows" and "frames", which only grow,
 * and "checkpoint" (checkpoint.h). The output is made from it when the run ends, so that a run that dies leaves all
 * that it has recorded, and the output of an earlier run is not touched before there is a new one. */
#ifndef VTI_JOURNAL_H
#define VTI_JOURNAL_H

#include <stdint.h>
#include <stdio.h>

#include "folder.h"

/** Where a file of records of equal size stands. */
struct journal_mark {
    int64_t doubles; /* of a record */
    int64_t count;   /* records */
    uint64_t digest; /* of all of them */
};

struct journal_file {
    FILE *stream;
    const char *name;
    struct journal_mark mark;
};

struct journal {
    char folder[FOLDER_PATH];
    int locked; /* by this program */
    struct journal_file rows, frames;
};

/** Of a file without records. */
struct journal_mark journal_mark_start(int64_t doubles);

/** Sets the folder for the outputs STEM.h5, STEM.csv and so on: all that share a file share it. Returns 0, or -1 with one line
 *  in *message. */
int journal_name(struct journal *journal, const char *stem, struct message *message);
enum { JOURNAL_NONE, JOURNAL_EARLY, JOURNAL_RUN };

/** What is there already: JOURNAL_RUN if it is a run that can go on, JOURNAL_EARLY if it is what one has left before its first
 *  checkpoint; -1 with one line in *message if another program is at work in it, or it is no journal. */
int journal_look(const struct journal *journal, struct message *message);

/** Makes the folder if need be, locks it against other programs and opens the two files, which must hold the records of
 *  these marks, bit for bit; what is behind them is cut off. Returns 0, or -1 with one line in *message and what is
 *  there as it was. */
int journal_open(struct journal *journal, struct journal_mark rows, struct journal_mark frames,
                 struct message *message);

/** Appends one record. Returns 0, or -1 with one line in *message. */
int journal_add(struct journal *journal, struct journal_file *file, const double *record, struct message *message);
/** Brings all records to the disk. Returns 0, or -1 with one line in *message. */
int journal_sync(struct journal *journal, struct message *message);
/** Reads count records from the first; after it nothing may be added. Returns 0, or -1 with one line in *message. */
int journal_read(const struct journal *journal, const struct journal_file *file, int64_t first, int64_t count,
                 double *records, struct message *message);

/** Closes the files and leaves them where they are; harmless on a journal that is not open. */
void journal_close(struct journal *journal);
/** Closes and removes them and the folder, as far as they are this program's: if another has locked them they stay. */
void journal_remove(struct journal *journal);

#endif
