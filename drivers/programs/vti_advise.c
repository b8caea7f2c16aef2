/* SPDX-License-Identifier: BSD-3-Clause
 * vti-advise: a scene and an error in, a stepper and a step out. The work is in cost/advise.c. */
#include <stdio.h>

#include "advise.h"
#include "advise_text.h"
#include "clock.h"
#include "options.h"
#include "table_hdf5.h"
#include "terminal.h"
#include "unused.h"

static struct option_list sets;
static const char *steppers, *measure;
static double target = 1e-4, budget;
static int json;

static const struct option_row rows[] = {
    OPTION_PARAGRAPH(
        "Finds by pilot runs which stepper and step reach a given error at the end of the scene in the\n"
        "least time, and what the others would need. Errors are those at the end: attitude, the largest\n"
        "angle between a body's attitude and the true one, in radians; position, the largest distance;\n"
        "velocity, relative, of v and Omega together; energy, the largest change on the way, of that at the\n"
        "start, or in its own unit where that is 0.\n"
        "\n"
        "Pilots take a part of the time of the run that is advised on. If that is too little for runs over\n"
        "the whole time, advice is from its first part or from coarser runs: every error comes with the\n"
        "interval in which it lies, the narrower the more pilots may take. Where trajectories part, however\n"
        "small the step, it is said from when on, and advice goes by the error of the energy.\n"),
    {"--error", "E", OPTION_NUMBER, &target, 1e-12, 0.1, "1e-4, 1/64 or 2^-7", "the error to reach (default 1e-4)"},
    {"--steppers", "A,B", OPTION_TEXT, &steppers, OPTION_ANY,
     "only these steppers (default: all of ours); rivals, what others use, are measured too and never advised"},
    {"--t-end", "T", OPTION_KEY, &sets, OPTION_ANY, "end time (default: the scene's)"},
    {"--measure", "WHAT", OPTION_TEXT, &measure, OPTION_ANY,
     "of what the error is: attitude, position, velocity or energy (default: attitude; velocity where no effect "
     "changes how bodies turn; position where drag is the only effect)"},
    {"--budget", "SECONDS", OPTION_NUMBER, &budget, 0, 0, "60 or 1e3",
     "how long pilots may take (default: 0.3 of the run that is advised on, as long as that with contacts or walls; "
     "half a second is always allowed, some seconds with clumps or friction)"},
    {"--set", "PATH=VALUE", OPTION_EACH, &sets, OPTION_ANY, "override a value of the scene; may be repeated"},
    {"--json", NULL, OPTION_ON, &json, OPTION_ANY,
     "one JSON object with the keys stepper, h, predicted_error, predicted_seconds, predicted_force_evals, source, "
     "interval, errors, stable_h, h_max_omega, measure, trajectories_until, pilots, alternatives; warnings go to "
     "stderr"},
    {0}};

static const struct options options = {"vti-advise", "", "[options] SCENE.yaml", rows, 1};

/** When the first pilot began, clock_now. */
static double begin;

/** What is being run, on a terminal; else now and then in a line. */
static void show(const char *stepper, int64_t steps)
{
    char line[80];
    snprintf(line, sizeof line, "trying %s in %lld steps", stepper, (long long)steps);
    progress_say(line, clock_now() - begin);
}

/** What of the scene says nothing to any pilot, and how long these may take. */
static void show_start(const struct model *model)
{
    FILE *file = json ? stderr : stdout;
    unused_say(model, model->scene->tables, file);
    if (budget == 0.0 && advise_share(model->scene) >= 1.0)
        fprintf(
            file,
            "note: the forces of %s have kinks, which only runs over the whole time tell: pilots may take as long as "
            "the run that is advised on; --budget sets another time\n",
            scene_first_with(model->scene, EFFECT_KINKED));
    fflush(file);
}

static int check_steppers(const vti_stepper *const *list, int64_t listed, struct message *message)
{
    for (int64_t k = 0; k < listed; ++k)
        if (method_chooses(list[k]))
            return message_set(
                message, "--steppers: %s chooses its steps itself, and advice is on steps of one length; leave it out",
                list[k]->name);
    return 0;
}

static int give_advice(struct scene *scene, struct message *message)
{
    static const vti_stepper *list[ADVICE_MOST];
    int64_t listed = 0;
    static struct advice advice;
    if (steppers != NULL && (listed = methods_read("--steppers", steppers, list, ADVICE_MOST, message)) < 0)
        return -1;
    if (check_steppers(list, listed, message) != 0)
        return -1;
    const struct advise_request request = {.scene = scene,
                                           .target = target,
                                           .t_end = scene->t_end,
                                           .measure = measure != NULL ? advise_measure(measure) : -1,
                                           .budget = budget,
                                           .steppers = list,
                                           .count = listed,
                                           .begin = show_start,
                                           .say = show};
    if (measure != NULL && request.measure < 0)
        return message_set(message, "--measure: '%s' is none; take attitude, position, velocity or energy", measure);
    begin = clock_now();
    log_as(options.program);
    const int failed = advise(&request, &advice, message);
    progress_clear();
    if (failed != 0)
        return -1;
    if (json)
        advise_json(&advice, stdout);
    else
        advise_text(scene, &advice, stdout);
    advise_warnings(scene, &advice, json ? stderr : stdout);
    return 0;
}

/** What it finds itself. */
static int check_sets(struct message *message)
{
    return options_refuse_set(&sets, "stepper", "steppers are chosen; --steppers names those to choose from", message);
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
    int failed = asked == OPTIONS_WRONG ? -1 : asked == OPTIONS_TOLD ? options_output_end(&message) : 0;
    if (asked == OPTIONS_TOLD && failed == 0)
        return 0;
    if (failed == 0 && count == 0)
        failed = message_set(&message, "no scene is named; see vti-advise --help");
    if (failed == 0)
        failed = check_sets(&message);
    if (failed == 0)
        failed = scene_read(scenes[0], sets.text, sets.count, &scene, &message);
    if (failed == 0 && scene.tolerance > 0.0)
        failed = message_set(&message, "%s: tolerance: advice is on steps of one length; leave it out", scene.name);
    if (failed == 0 && scene.control != 0)
        failed = message_set(&message, "%s: control: advice is on steps of one length; leave it out", scene.name);
    if (failed == 0)
        failed = tables_read(&scene, &tables, &message);
    if (failed == 0)
        failed = give_advice(&scene, &message);
    if (failed == 0)
        failed = options_output_end(&message);
    if (failed != 0)
        fprintf(stderr, "vti-advise: %s\n", message.text);
    tables_destroy(&tables);
    return failed != 0;
}
