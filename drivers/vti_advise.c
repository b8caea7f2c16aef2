/* SPDX-License-Identifier: BSD-3-Clause
 * vti-advise: a scene and an error in, a stepper and a step out. The work is in study/advise.c. */
#define _POSIX_C_SOURCE 200809L
#include <getopt.h>
#include <stdio.h>
#include <unistd.h>

#include "advice_text.h"
#include "number.h"
#include "output.h"
#include "study.h"
#include "table_hdf5.h"
#include "version.h"

static const char usage[] =
    "Usage: vti-advise [options] SCENE.yaml\n"
    "\n"
    "Finds by pilot runs which stepper and step reach a given error at the end of the scene in the least time, and "
    "what "
    "the\n"
    "others would need. The error is that at the end: the largest angle between a body's attitude and the true one, "
    "in\n"
    "radians; where nothing turns, the relative error of the velocities.\n"
    "\n"
    "  --error E         the error to reach (default 1e-4)\n"
    "  --steppers A,B    only these steppers (default: all)\n"
    "  --t-end T         end time (default: the scene's)\n"
    "  --budget SECONDS  how long finding the solution may take (default 120)\n"
    "  --set PATH=VALUE  override a value of the scene; may be repeated\n"
    "  --json            one JSON object with the keys stepper, h, predicted_error, predicted_seconds, stable_h,\n"
    "                    h_max_omega, alternatives; warnings go to stderr\n"
    "  -h, --help        this text\n"
    "  --version         version, commit, compiler, flags and vector units\n";

enum { SETS = 64 };

struct arguments {
    const char *scene, *steppers, *error, *t_end, *budget;
    const char *sets[SETS];
    int sets_count, json, help;
};

static int read_arguments(int argc, char **argv, struct arguments *a, struct message *message)
{
    enum { STEPPERS = 256, ERROR, T_END, BUDGET, SET, JSON };
    static const struct option options[] = {{"steppers", required_argument, NULL, STEPPERS},
                                            {"error", required_argument, NULL, ERROR},
                                            {"t-end", required_argument, NULL, T_END},
                                            {"budget", required_argument, NULL, BUDGET},
                                            {"set", required_argument, NULL, SET},
                                            {"json", no_argument, NULL, JSON},
                                            {"help", no_argument, NULL, 'h'},
                                            {NULL, 0, NULL, 0}};
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, ":h", options, NULL)) != -1;) {
        if (c == STEPPERS)
            a->steppers = optarg;
        else if (c == ERROR)
            a->error = optarg;
        else if (c == T_END)
            a->t_end = optarg;
        else if (c == BUDGET)
            a->budget = optarg;
        else if (c == JSON)
            a->json = 1;
        else if (c == 'h')
            a->help = 1;
        else if (c == SET && a->sets_count < SETS)
            a->sets[a->sets_count++] = optarg;
        else if (c == SET)
            return message_set(message, "--set: given more than %d times; put the values into a scene file", SETS);
        else if (c == ':')
            return message_set(message, "%s: needs a value; see vti-advise --help", argv[optind - 1]);
        else
            return message_set(message, "%s: is not an option; see vti-advise --help", argv[optind - 1]);
    }
    if (optind == argc && !a->help)
        return message_set(message, "no scene is named; see vti-advise --help");
    if (optind + 1 < argc)
        return message_set(message, "%s: only one scene at a time; remove it", argv[optind + 1]);
    a->scene = argv[optind];
    return 0;
}

static int read_positive(const char *option, const char *text, double *value, struct message *message)
{
    if (text == NULL)
        return 0;
    if (number_read(text, value) != 0 || !(*value > 0.0))
        return message_set(message, "%s: '%.100s' is not a positive number; write 1e-4, 1/64 or 2^7", option, text);
    return 0;
}

/** What is being run, on a terminal. */
static void show(const char *stepper, int64_t steps)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r\033[Ktrying %s in %lld steps", stepper, (long long)steps);
}

static int give_advice(const struct arguments *a, struct scene *scene, struct message *message)
{
    static struct plan plan;
    static struct advice advice;
    double target = 1e-4, t_end = scene->t_end, budget = 120.0;
    if (read_positive("--error", a->error, &target, message) != 0 ||
        read_positive("--t-end", a->t_end, &t_end, message) != 0 ||
        read_positive("--budget", a->budget, &budget, message) != 0 ||
        (a->steppers != NULL && study_read_steppers(a->steppers, &plan, message) != 0))
        return -1;
    if (target < 1e-12 || target > 0.1)
        return message_set(message, "--error: %g is out of reach; ask for something between 1e-12 and 0.1", target);
    const int failed = advise(scene, target, t_end, budget, plan.steppers, plan.steppers_count, show, &advice, message);
    if (isatty(STDERR_FILENO))
        fputs("\r\033[K", stderr);
    if (failed != 0)
        return -1;
    if (a->json)
        advice_json(&advice, stdout);
    else
        advice_say(scene, &advice, stdout);
    advice_warn(scene, &advice, a->json ? stderr : stdout);
    return 0;
}

int main(int argc, char **argv)
{
    static struct scene scene;
    static struct tables tables;
    static struct arguments arguments;
    struct message message = {""};
    if (version_asked(argc, argv, "vti-advise", 1))
        return 0;
    int failed = read_arguments(argc, argv, &arguments, &message);
    if (failed == 0 && arguments.help) {
        fputs(usage, stdout);
        return 0;
    }
    if (failed == 0)
        failed = scene_read(arguments.scene, arguments.sets, arguments.sets_count, &scene, &message);
    if (failed == 0)
        failed = tables_read(&scene, &tables, &message);
    if (failed == 0)
        failed = give_advice(&arguments, &scene, &message);
    if (failed == 0)
        failed = output_end(&message);
    if (failed != 0)
        fprintf(stderr, "vti-advise: %s\n", message.text);
    tables_destroy(&tables);
    return failed != 0;
}
