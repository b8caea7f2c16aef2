/* SPDX-License-Identifier: BSD-3-Clause
 * Reads the command line by a table of options (options.h); prints --help and --version. */
#include "options.h"

#include <assert.h>
#include <errno.h>
#include <math.h>
#include <popt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commit.h"
#include "number.h"
#include "stream.h"
#include "vti.h"

enum { ROWS = 48, HELP = ROWS + 1, VERSION };

static int is_end(const struct option_row *row)
{
    return row->name == NULL && row->about == NULL;
}

/* ---- values ----------------------------------------------------------------------------------------------------- */

static int add(struct option_list *list, const struct option_row *row, const char *text, struct message *message)
{
    if (list->count == OPTION_LIST)
        return message_set(message, "%s: more than %d values are given; put them into a scene file", row->name,
                           OPTION_LIST);
    list->text[list->count++] = text;
    return 0;
}

/** "--t-end=10" for --t-end 10. */
static int add_key(const struct option_row *row, const char *value, struct message *message)
{
    char *text = malloc(strlen(row->name) + strlen(value) + 2);
    if (text == NULL)
        return message_set(message, "%s: there is no memory left", row->name);
    sprintf(text, "%s=%s", row->name, value);
    const int result = add(row->to, row, text, message);
    if (result != 0)
        free(text);
    return result; /* NOLINT(clang-analyzer-unix.Malloc): the list keeps it as long as the program runs */
}

static int read_number(const struct option_row *row, const char *text, struct message *message)
{
    const int whole = row->kind == OPTION_WHOLE;
    const double least = whole ? 1.0 : row->least;
    double value;
    if (number_read(text, &value) == 0 && value > 0.0 && value >= least && (row->most == 0.0 || value <= row->most) &&
        (!whole || value == floor(value))) {
        if (whole)
            *(int64_t *)row->to = (int64_t)value;
        else
            *(double *)row->to = value;
        return 0;
    }
    if (row->most == 0.0)
        return message_set(message, "%s: '%.100s' is not a positive number; write %s", row->name, text, row->example);
    return message_set(message, "%s: '%.100s' is not a %s from %s to %s; write %s", row->name, text,
                       whole ? "whole number" : "number", NUMBER(least), NUMBER(row->most), row->example);
}

static int take(const struct option_row *row, const char *value, struct message *message)
{
    switch (row->kind) {
    case OPTION_ON:
    case OPTION_OFF:
        *(int *)row->to = row->kind == OPTION_ON;
        return 0;
    case OPTION_TEXT:
        *(const char **)row->to = value;
        return 0;
    case OPTION_EACH:
        return add(row->to, row, value, message);
    case OPTION_KEY:
        return add_key(row, value, message);
    default:
        return read_number(row, value, message);
    }
}

/* ---- --version -------------------------------------------------------------------------------------------------- */

static void print_version(const char *program)
{
#if defined(__clang__)
    static const char compiler[] = __VERSION__;
#else
    static const char compiler[] = "gcc " __VERSION__;
#endif
    printf("%s %s\ncommit: %s\ncompiler: %s\nflags: %s\nvector units: %s; the bits do not depend on them\n", program,
           vti_version(), VTI_COMMIT, compiler, VTI_FLAGS, vti_vector_units());
}

/* ---- popt's tables ---------------------------------------------------------------------------------------------- */

/** A row as popt has it; code is what poptGetNextOpt returns for it. */
static struct poptOption popt_row(const struct option_row *row, int code)
{
    const int is_long = row->name[1] == '-';
    const struct poptOption made = {is_long ? row->name + 2 : NULL,
                                    is_long ? '\0' : row->name[1],
                                    row->value != NULL ? POPT_ARG_STRING : POPT_ARG_NONE,
                                    NULL,
                                    code,
                                    row->about,
                                    row->value};
    return made;
}

/** One table for each paragraph, which popt prints above its options, and all of them in top. */
static void make_tables(const struct option_row *rows, struct poptOption *top, struct poptOption *tables)
{
    static const struct poptOption end = POPT_TABLEEND;
    static const struct poptOption own[] = {
        {"help", 'h', POPT_ARG_NONE, NULL, HELP, "this text", NULL},
        {"version", '\0', POPT_ARG_NONE, NULL, VERSION, "version, commit, compiler, flags and vector units", NULL}};
    int told = 0; /* of --help: they close the first options */
    for (const struct option_row *row = rows;; ++row) {
        assert(row - rows < ROWS); /* then neither list has more than it can hold, and no code is HELP's */
        if (row->name != NULL) {
            *tables++ = popt_row(row, (int)(row - rows) + 1);
            continue;
        }
        if (row != rows && !told++) {
            *tables++ = own[0];
            *tables++ = own[1];
        }
        if (row != rows)
            *tables++ = end;
        if (is_end(row))
            break;
        const struct poptOption paragraph = {NULL, '\0', POPT_ARG_INCLUDE_TABLE, tables, 0, row->about, NULL};
        *top++ = paragraph;
    }
    *top = end;
}

static enum options_end refuse(const struct options *options, poptContext context, int code, struct message *message)
{
    const char *what = code == POPT_ERROR_NOARG         ? "needs a value"
                       : code == POPT_ERROR_BADOPT      ? "is not an option"
                       : code == POPT_ERROR_UNWANTEDARG ? "takes no value"
                                                        : poptStrerror(code);
    message_set(message, "%.200s: %s; see %s --help", poptBadOption(context, 0), what, options->program);
    return OPTIONS_WRONG;
}

enum options_end options_read(const struct options *options, int argc, char **argv, int print,
                              const char *const **scenes, int *count, struct message *message)
{
    static struct poptOption top[ROWS], tables[2 * ROWS];
    static const char *const none[] = {NULL};
    make_tables(options->rows, top, tables);
    poptContext context = poptGetContext(NULL, argc, (const char **)argv, top, 0); /* stays: it owns the scenes */
    poptSetOtherOptionHelp(context, options->usage);
    int code, help = 0;
    while ((code = poptGetNextOpt(context)) > 0)
        if (code == VERSION) {
            if (print)
                print_version(options->program);
            return OPTIONS_TOLD;
        } else if (code == HELP)
            help = 1;
        else if (take(&options->rows[code - 1], poptGetOptArg(context), message) != 0)
            return OPTIONS_WRONG;
    if (code < -1)
        return refuse(options, context, code, message);
    if (help) {
        static char name[128];
        snprintf(name, sizeof name, "%s%s", options->launcher, options->program);
        argv[0] = name; /* what popt calls the program */
        if (print)
            poptPrintHelp(context, stdout, 0);
        return OPTIONS_TOLD;
    }
    *scenes = (const char *const *)poptGetArgs(context);
    *scenes = *scenes != NULL ? *scenes : none;
    for (*count = 0; (*scenes)[*count] != NULL;)
        ++*count;
    if (options->most >= 0 && *count > options->most) {
        const char *more = (*scenes)[options->most];
        return options->most == 0
                   ? (message_set(message, "%s: is not an option; see %s --help", more, options->program),
                      OPTIONS_WRONG)
                   : (message_set(message, "%s: only one scene at a time; remove it", more), OPTIONS_WRONG);
    }
    return OPTIONS_GO;
}

int options_refuse_set(const struct option_list *sets, const char *key, const char *instead, struct message *message)
{
    const size_t n = strlen(key);
    for (int k = 0; k < sets->count; ++k)
        if (strncmp(sets->text[k], key, n) == 0 && sets->text[k][n] == '=')
            return message_set(message, "--set %.200s: does nothing here; %s", sets->text[k], instead);
    return 0;
}

int options_output_end(struct message *message)
{
    if (stream_end(stdout, fflush) == 0)
        return 0;
    return message_set(message, "standard output: cannot be written: %s; send it to another place", strerror(errno));
}
