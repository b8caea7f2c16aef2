/* SPDX-License-Identifier: BSD-3-Clause
 * vti-check: the conformance kit on a stepper of ours, a rival, or anybody's from a shared library. The work is in
 * check/. */
#define _POSIX_C_SOURCE 200809L
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

#include "message.h"
#include "method_check.h"
#include "options.h"

static const char *stepper, *rival, *plugin;
static int translation, inertia, json, list;

static const struct option_row rows[] = {
    OPTION_PARAGRAPH(
        "Makes a time step of rigid spheres show what it is: how it turns bodies, when and where its forces\n"
        "act, its orders, what it conserves. Without a name: all steppers and rivals, one line each.\n"),
    {"--stepper", "NAME", OPTION_TEXT, &stepper, OPTION_ANY, "a stepper of the library"},
    {"--rival", "NAME", OPTION_TEXT, &rival, OPTION_ANY, "what other codes use"},
    {"--plugin", "FILE:SYMBOL", OPTION_TEXT, &plugin, OPTION_ANY,
     "a function vti_check_advance (vti_check.h) of a shared library"},
    {"--translation", NULL, OPTION_ON, &translation, OPTION_ANY,
     "for steppers that do not turn bodies: positions and velocities only"},
    {"--inertia", NULL, OPTION_ON, &inertia, OPTION_ANY,
     "for bodies that are no spheres: omega is the angular momentum L, inertia the moments A, B, C of each"},
    {"--json", NULL, OPTION_ON, &json, OPTION_ANY, "one JSON object"},
    {"--list", NULL, OPTION_ON, &list, OPTION_ANY, "names of steppers and rivals"},
    OPTION_PARAGRAPH("Exit status: 0 if there is no fault, 1 if there is one, 2 if nothing could be checked."),
    {0}};

static const struct options options = {"vti-check", "",
                                       "[options] [--stepper NAME | --rival NAME | --plugin FILE.so:SYMBOL]", rows, 0};

/* ---- what is checked -------------------------------------------------------------------------------------------- */

static int find_method(const char *name, const vti_stepper **method, struct message *message)
{
    const vti_stepper *m = method_find(name);
    if (m == NULL || (rival != NULL) != (method_rival(m) != NULL))
        return message_set(message, "%s: there is no %s of that name; see vti-check --list", name,
                           rival != NULL ? "rival" : "stepper");
    if (!method_moves(m, inertia))
        return message_set(message,
                           inertia       ? "%s: moves spheres; leave out --inertia"
                           : translation ? "%s: moves bodies of three moments; give --inertia in place of --translation"
                                         : "%s: moves bodies of three moments; add --inertia",
                           name);
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

static void look_at(const char *name, vti_check_advance *advance, const vti_stepper *method, vti_check_report *report)
{
    (inertia       ? vti_check_run_inertia
     : translation ? vti_check_run_translation
                   : vti_check_run)(name, advance, (void *)method, report);
}

static int check_one(const char *name, struct message *message)
{
    vti_check_report report;
    vti_check_advance *advance = inertia ? method_check_advance_inertia : method_check_advance;
    const vti_stepper *method = NULL;
    if (plugin != NULL ? open_plugin(name, &advance, message) != 0 : find_method(name, &method, message) != 0)
        return 2;
    look_at(name, advance, method, &report);
    (json ? vti_check_print_json : vti_check_print)(&report, stdout);
    return report.faults > 0 ? 1 : 0;
}

/** Those that can take the bodies. */
static const vti_stepper *known_at(int64_t i)
{
    return inertia ? method_general_at(i) : method_at(i);
}

/** Every method and what is said of it. */
static int check_all(void)
{
    int faults = 0;
    for (int64_t i = 0; known_at(i) != NULL; ++i) {
        const vti_stepper *m = known_at(i);
        vti_check_report report;
        look_at(m->name, inertia ? method_check_advance_inertia : method_check_advance, m, &report);
        faults += report.faults;
        printf("%-24s %s\n", m->name,
               report.faults > 0  ? report.word[0].text
               : report.words > 0 ? "no fault found, but:"
                                  : "no fault found");
        for (int k = report.faults == 0 ? 0 : 1; k < report.words; ++k)
            printf("%-24s %s\n", "", report.word[k].text);
        fflush(stdout);
    }
    return faults > 0 ? 1 : 0;
}

static int print_names(void)
{
    for (int64_t i = 0; method_named_at(i) != NULL; ++i) {
        const vti_stepper *m = method_named_at(i);
        if (method_moves(m, inertia))
            printf("--%-8s %-24s %s\n", method_rival(m) != NULL ? "rival" : "stepper", m->name, m->about);
    }
    return 0;
}

int main(int argc, char **argv)
{
    struct message message = {""};
    const char *const *none;
    int count, result = 2;
    const enum options_end asked = options_read(&options, argc, argv, 1, &none, &count, &message);
    const char *const name = stepper != NULL ? stepper : rival != NULL ? rival : plugin;
    if (asked == OPTIONS_TOLD)
        result = 0;
    else if (asked == OPTIONS_GO && inertia && translation)
        message_set(&message, "--inertia: looks at turning bodies, --translation at others; leave out one of them");
    else if (asked == OPTIONS_GO && (stepper != NULL) + (rival != NULL) + (plugin != NULL) > 1)
        message_set(&message, "%s: only one stepper at a time; remove it", plugin != NULL ? plugin : rival);
    else if (asked == OPTIONS_GO && json && name == NULL)
        message_set(&message, "--json: needs the name of one stepper; see vti-check --help");
    else if (asked == OPTIONS_GO)
        result = list ? print_names() : name == NULL ? check_all() : check_one(name, &message);
    if (message.text[0] == '\0' && options_output_end(&message) != 0)
        result = 2;
    if (message.text[0] != '\0')
        fprintf(stderr, "vti-check: %s\n", message.text);
    return result;
}
