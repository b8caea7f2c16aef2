/* SPDX-License-Identifier: BSD-3-Clause
 * vti-advise: a scene and an error in, a stepper and a step out. The work is in study/advise.c. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <unistd.h>

#include "advice_text.h"
#include "options.h"
#include "output.h"
#include "table_hdf5.h"

static struct option_list sets;
static const char *steppers;
static double target = 1e-4, t_end, budget = 120.0;
static int json;

static const struct option_row rows[] = {
    OPTION_PARAGRAPH(
        "Finds by pilot runs which stepper and step reach a given error at the end of the scene in the\n"
        "least time, and what the others would need. The error is that at the end: the largest angle\n"
        "between a body's attitude and the true one, in radians; where nothing turns, the relative error of\n"
        "the velocities.\n"),
    {"--error", "E", OPTION_NUMBER, &target, 1e-12, 0.1, "1e-4, 1/64 or 2^-7", "the error to reach (default 1e-4)"},
    {"--steppers", "A,B", OPTION_TEXT, &steppers, OPTION_ANY,
     "only these steppers (default: all of ours); rivals, what others use, are measured too and never advised"},
    {"--t-end", "T", OPTION_NUMBER, &t_end, 0, 0, "10, 1e3 or 2^7", "end time (default: the scene's)"},
    {"--budget", "SECONDS", OPTION_NUMBER, &budget, 0, 0, "60 or 1e3",
     "how long finding the solution may take (default 120)"},
    {"--set", "PATH=VALUE", OPTION_EACH, &sets, OPTION_ANY, "override a value of the scene; may be repeated"},
    {"--json", NULL, OPTION_ON, &json, OPTION_ANY,
     "one JSON object with the keys stepper, h, predicted_error, predicted_seconds, stable_h, h_max_omega, "
     "alternatives; "
     "warnings go to stderr"},
    {0}};

static const struct options options = {"vti-advise", "", "[options] SCENE.yaml", rows, 1};

/** What is being run, on a terminal. */
static void show(const char *stepper, int64_t steps)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r\033[Ktrying %s in %lld steps", stepper, (long long)steps);
}

static int give_advice(struct scene *scene, struct message *message)
{
    static const vti_stepper *list[ADVICE_MOST];
    int64_t listed = 0;
    static struct advice advice;
    if (steppers != NULL && (listed = methods_read("--steppers", steppers, list, ADVICE_MOST, message)) < 0)
        return -1;
    if (t_end == 0.0)
        t_end = scene->t_end;
    const int failed = advise(scene, target, t_end, budget, list, listed, show, &advice, message);
    if (isatty(STDERR_FILENO))
        fputs("\r\033[K", stderr);
    if (failed != 0)
        return -1;
    if (json)
        advice_json(&advice, stdout);
    else
        advice_say(scene, &advice, stdout);
    advice_warn(scene, &advice, json ? stderr : stdout);
    return 0;
}

int main(int argc, char **argv)
{
    static struct scene scene;
    static struct tables tables;
    struct message message = {""};
    const char *const *scenes;
    int count;
    method_admit();
    const enum options_end asked = options_read(&options, argc, argv, 1, &scenes, &count, &message);
    if (asked == OPTIONS_TOLD)
        return 0;
    int failed = asked == OPTIONS_WRONG ? -1 : 0;
    if (failed == 0 && count == 0)
        failed = message_set(&message, "no scene is named; see vti-advise --help");
    if (failed == 0)
        failed = scene_read(scenes[0], sets.text, sets.count, &scene, &message);
    if (failed == 0)
        failed = tables_read(&scene, &tables, &message);
    if (failed == 0)
        failed = give_advice(&scene, &message);
    if (failed == 0)
        failed = output_end(&message);
    if (failed != 0)
        fprintf(stderr, "vti-advise: %s\n", message.text);
    tables_destroy(&tables);
    return failed != 0;
}
