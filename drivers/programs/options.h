/* SPDX-License-Identifier: BSD-3-Clause
 * Options of a program as one table: the command line is read by it, --help and --version and the manual page are
 * made from it. A new option is one row, and one place where what it has set is used. */
#ifndef VTI_OPTIONS_H
#define VTI_OPTIONS_H

#include <stddef.h>
#include <stdint.h>

#include "message.h"

enum option_kind {
    OPTION_ON,     /* takes no value; *(int *)to becomes 1 */
    OPTION_OFF,    /* takes no value; *(int *)to becomes 0 */
    OPTION_TEXT,   /* *(const char **)to becomes the value */
    OPTION_EACH,   /* the value is added to *(struct option_list *)to; may be repeated */
    OPTION_KEY,    /* the scene's key of that name: --t-end 10 adds "--t-end=10" to *(struct option_list *)to */
    OPTION_NUMBER, /* *(double *)to becomes a number above 0, and from least to most (number.h) */
    OPTION_WHOLE   /* *(int64_t *)to becomes a whole number from 1 to most */
};

struct option_row {
    const char *name;  /* "--t-end" or "-o"; NULL: about is a paragraph of --help, printed as it is */
    const char *value; /* what it is called in --help, "T"; NULL if the option takes none */
    enum option_kind kind;
    void *to;            /* untouched if the option is not given */
    double least, most;  /* of a number; most = 0: no bound */
    const char *example; /* of a number, for the message: "10, 1e3 or 2^7" */
    const char *about;   /* a phrase; --help breaks it into lines */
};

/** In the place of least, most and example where there are none. */
#define OPTION_ANY 0, 0, NULL

/** A paragraph of --help, with the options of the rows below it. */
#define OPTION_PARAGRAPH(text)                                                                                         \
    {                                                                                                                  \
        NULL, NULL, OPTION_ON, NULL, OPTION_ANY, text                                                                  \
    }

enum { OPTION_LIST = 64 };

struct option_list {
    const char *text[OPTION_LIST];
    int count;
};

struct options {
    const char *program;           /* "vti-run" */
    const char *launcher;          /* in front of it in --help, "mpirun -n RANKS "; or "" */
    const char *usage;             /* what follows the program's name */
    const struct option_row *rows; /* the first is a paragraph; {0} ends them */
    int most;                      /* scenes that may be named; -1: any number */
};

enum options_end {
    OPTIONS_GO,
    OPTIONS_TOLD,  /* --help or --version was asked for and is printed */
    OPTIONS_WRONG, /* one line in *message names the option, the value and what to do */
};

/** Reads the command line. *scenes becomes what is no option and no value of one, *count of them, ended by NULL. All
 *  texts last to the end of the program. Prints only if print, so that one of several ranks does. Called once. */
enum options_end options_read(const struct options *options, int argc, char **argv, int print,
                              const char *const **scenes, int *count, struct message *message);

/** Refuses --set KEY=... where the program would pass over that value; instead says what to do. Returns 0, or -1 with
 *  one line in *message. */
int options_refuse_set(const struct option_list *sets, const char *key, const char *instead, struct message *message);

/** Besides EXIT_SUCCESS and EXIT_FAILURE: the verdict is bad; it was told to stop, and --resume goes on (EX_TEMPFAIL of
 *  sysexits.h). */
enum { EXIT_BAD = 3, EXIT_RESUME = 75 };

/** At the end of a program, after OPTIONS_TOLD too: whether all that it said has got there. Returns 0, or -1 with one
 *  line in *message. */
int options_output_end(struct message *message);

#endif
