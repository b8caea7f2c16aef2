/* SPDX-License-Identifier: BSD-3-Clause
 * vti-check: the conformance kit on a stepper of ours, a rival, or anybody's from a shared library. The work is in check/. */
#define _POSIX_C_SOURCE 200809L
#include <dlfcn.h>
#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "message.h"
#include "method_check.h"
#include "version.h"

static const char usage[] =
    "Usage: vti-check [options] [--stepper NAME | --rival NAME | --plugin FILE.so:SYMBOL]\n"
    "\n"
    "Makes a time step of rigid spheres show what it is: how it turns bodies, when and where "
    "its forces act, its orders,\n"
    "what it conserves. Without a name: all steppers and rivals, one line each.\n"
    "\n"
    "  --stepper NAME        a stepper of the library\n"
    "  --rival NAME          what other codes use\n"
    "  --plugin FILE:SYMBOL  a function vti_check_advance (vti_check.h) of a shared library\n"
    "  --translation         for steppers that do not turn bodies: positions and velocities only\n"
    "  --json                one JSON object\n"
    "  --list                names of steppers and rivals\n"
    "  -h, --help            this text\n"
    "  --version             version, commit, compiler, flags and vector units\n"
    "\n"
    "Exit status: 0 if there is no fault, 1 if there is one, 2 if nothing could be checked.\n";

enum { STEPPER = 256, RIVAL, PLUGIN, TRANSLATION, JSON, LIST };

struct arguments {
    int kind; /* STEPPER, RIVAL, PLUGIN, or 0 */
    const char *name;
    int translation, json, list, help;
};

static int read_arguments(int argc, char **argv, struct arguments *a, struct message *message)
{
    static const struct option options[] = {{"stepper", required_argument, NULL, STEPPER},
                                            {"rival", required_argument, NULL, RIVAL},
                                            {"plugin", required_argument, NULL, PLUGIN},
                                            {"translation", no_argument, NULL, TRANSLATION},
                                            {"json", no_argument, NULL, JSON},
                                            {"list", no_argument, NULL, LIST},
                                            {"help", no_argument, NULL, 'h'},
                                            {NULL, 0, NULL, 0}};
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, ":h", options, NULL)) != -1;) {
        if (c == JSON)
            a->json = 1;
        else if (c == TRANSLATION)
            a->translation = 1;
        else if (c == LIST)
            a->list = 1;
        else if (c == 'h')
            a->help = 1;
        else if (c == ':')
            return message_set(message, "%s: needs a value; see vti-check --help", argv[optind - 1]);
        else if (c == '?')
            return message_set(message, "%s: is not an option; see vti-check --help", argv[optind - 1]);
        else if (a->kind != 0)
            return message_set(message, "%s: only one stepper at a time; remove it", optarg);
        else {
            a->kind = c;
            a->name = optarg;
        }
    }
    if (optind < argc)
        return message_set(message, "%s: is not an option; see vti-check --help", argv[optind]);
    if (a->json && a->kind == 0)
        return message_set(message, "--json: needs the name of one stepper; see vti-check --help");
    return 0;
}

/* ---- what is checked --------------------------------------------------------------------------------------------------- */

static int find_method(const struct arguments *a, const struct method **method, struct message *message)
{
    const struct method *m = method_find(a->name);
    if (m == NULL || (a->kind == RIVAL) != (m->rival != NULL))
        return message_set(message, "%s: there is no %s of that name; see vti-check --list", a->name,
                           a->kind == RIVAL ? "rival" : "stepper");
    *method = m;
    return 0;
}

/** The function behind FILE:SYMBOL. The library stays open to the end of the program. */
static int open_plugin(const char *name, vti_check_advance **advance, struct message *message)
{
    char file[4096];
    const char *colon = strrchr(name, ':');
    if (colon == NULL || colon == name || colon[1] == '\0' || (size_t)(colon - name) >= sizeof file - 2)
        return message_set(message, "%s: is not FILE.so:SYMBOL", name);
    const int bare = memchr(name, '/', (size_t)(colon - name)) == NULL; /* not where the system keeps its libraries */
    snprintf(file, sizeof file, "%s%.*s", bare ? "./" : "", (int)(colon - name), name);
    void *library = dlopen(file, RTLD_NOW);
    if (library == NULL)
        return message_set(message, "%s", dlerror());
    void *symbol = dlsym(library, colon + 1);
    if (symbol == NULL)
        return message_set(message, "%s: has no symbol %s; it must not be static", file, colon + 1);
    memcpy(advance, &symbol, sizeof *advance); /* C has no conversion from objects to functions; POSIX does */
    return 0;
}

static int look_at(const char *name, vti_check_advance *advance, const struct method *method, int translation,
                   vti_check_report *report)
{
    return (translation ? vti_check_run_translation : vti_check_run)(name, advance, (void *)method, report);
}

static int show(const vti_check_report *report, int json)
{
    (json ? vti_check_print_json : vti_check_print)(report, stdout);
    return report->faults > 0 ? 1 : 0;
}

static int check_one(const struct arguments *a, struct message *message)
{
    vti_check_report report;
    vti_check_advance *advance = method_check_advance;
    const struct method *method = NULL;
    if (a->kind == PLUGIN ? open_plugin(a->name, &advance, message) != 0 : find_method(a, &method, message) != 0)
        return 2;
    look_at(a->name, advance, method, a->translation, &report);
    return show(&report, a->json);
}

/** Every method and what is said of it. */
static int check_all(int translation)
{
    int faults = 0;
    for (int64_t i = 0; i < method_count(); ++i) {
        const struct method *m = method_at(i);
        vti_check_report report;
        faults += look_at(m->name, method_check_advance, m, translation, &report);
        printf("%-24s %s\n", m->name, report.faults == 0 ? "no fault found" : report.word[0].text);
        for (int k = report.faults == 0 ? 0 : 1; k < report.words; ++k)
            printf("%-24s %s\n", "", report.word[k].text);
        fflush(stdout);
    }
    return faults > 0 ? 1 : 0;
}

static void list(void)
{
    for (int64_t i = 0; i < method_count(); ++i) {
        const struct method *m = method_at(i);
        printf("--%-8s %-24s %s\n", m->rival != NULL ? "rival" : "stepper", m->name, m->about);
    }
}

int main(int argc, char **argv)
{
    struct arguments a = {0, NULL, 0, 0, 0, 0};
    struct message message = {""};
    int result = 0;
    if (version_asked(argc, argv, "vti-check", 1))
        return 0;
    if (read_arguments(argc, argv, &a, &message) != 0)
        result = 2;
    else if (a.help)
        fputs(usage, stdout);
    else if (a.list)
        list();
    else
        result = a.kind == 0 ? check_all(a.translation) : check_one(&a, &message);
    if (message.text[0] != '\0')
        fprintf(stderr, "vti-check: %s\n", message.text);
    return result;
}
