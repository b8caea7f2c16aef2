/* SPDX-License-Identifier: BSD-3-Clause
 * vti-run: one scene over time. Arguments in, files out; the work is in sim/ and io/. */
#define _POSIX_C_SOURCE 200809L
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "fields.h"
#include "number.h"
#include "output.h"
#include "progress.h"
#include "run.h"
#include "run_say.h"
#include "scene_list.h"
#include "version.h"
#include "run_signals.h"

static const char usage[] =
    "Usage: vti-run [options] SCENE.yaml [-o OUT.h5]\n"
    "\n"
    "Runs a scene and writes OUT.h5 (trajectory as VTKHDF, energies and momenta over time), OUT.csv (the latter),\n"
    "OUT.xdmf (index of the trajectory) and OUT.dump (LAMMPS text dump, for OVITO). Without -o OUT is the scene's "
    "name.\n"
    "\n"
    "  --stepper NAME        integrator (default: the scene's)\n"
    "  --h H, --t-end T      step and end time (default: the scene's); numbers may be written 0.01, 1/64 or 2^-6\n"
    "  --set PATH=VALUE      override a value of the scene; may be repeated\n"
    "  --record EVERY        steps between rows of energies and momenta (default: about 1000 rows)\n"
    "  --frames EVERY        steps between frames of the trajectory (default: about 100 frames)\n"
    "                        the state at the end is always recorded\n"
    "  --fields force,moment one or both of each body in OUT.h5 and OUT.xdmf too, in every frame\n"
    "  --no-dump             no OUT.dump, the largest of the files\n"
    "  --xdmf                OUT.xdmf for more than 2000 frames too: 1-8 kB for each; ParaView reads OUT.h5 itself\n"
    "  --force               replace files that are no results of vti too; what the scene is read from is never "
    "replaced\n"
    "  --checkpoint SECONDS  time between checkpoints (default 60)\n"
    "  --resume              go on from the last checkpoint, or with a later --t-end from the end of a complete run;\n"
    "                        if there is neither, start\n"
    "  --list WHAT           steppers, effects or keys of scenes, with what they are\n"
    "  -h, --help            this text\n"
    "  --version             version, commit, compiler, flags and vector units\n"
    "\n"
    "While it runs everything is kept in the folder OUT.run. After SIGTERM, SIGUSR1, SIGHUP, SIGXCPU or Ctrl-C it "
    "saves a checkpoint "
    "and\n"
    "ends with code 75; the same command with --resume goes on, after any other end too, and gives the same bytes as "
    "if\n"
    "nothing had happened. A run that is resumed may be given a later --t-end; all else must be as it was.\n"
    "\n"
    "The last line is the verdict: good, doubtful or bad, and why. Where it is bad (the energy grew by more than a "
    "quarter of\n"
    "its scale, or bodies move by more than a diameter per step) all files are written and the code is 3.\n";

enum { SETS = 64, OVERRIDE = 256, EXIT_BAD = 3, EXIT_RESUME = 75 /* EX_TEMPFAIL of sysexits.h */ };

struct arguments {
    const char *sets[SETS];
    char short_sets[SETS][OVERRIDE]; /* "h=0.1" of --h 0.1, and the like */
    struct run_request request;
    int help;
    const char *list;
};

/** An override of the scene; key is NULL where value already is "path=value". */
static int add_set(struct arguments *a, const char *option, const char *key, const char *value, struct message *message)
{
    const int k = a->request.sets_count;
    if (k == SETS)
        return message_set(message, "%s: more than %d values are given; put them into a scene file", option, SETS);
    a->sets[k] = value;
    if (key != NULL) {
        if (snprintf(a->short_sets[k], OVERRIDE, "%s=%s", key, value) >= OVERRIDE)
            return message_set(message, "%s: the value is longer than %d characters", option, OVERRIDE);
        a->sets[k] = a->short_sets[k];
    }
    ++a->request.sets_count;
    return 0;
}

static int read_every(const char *option, const char *text, int64_t *every, struct message *message)
{
    double value;
    if (number_read(text, &value) != 0 || value != floor(value) || !(value >= 1.0))
        return message_set(message, "%s: '%.100s' is not a whole number of steps above 0; write 50 or 1e3", option,
                           text);
    if (value > 0x1p53)
        return message_set(message, "%s: '%.100s' is too large; give at most 2^53", option, text);
    *every = (int64_t)value;
    return 0;
}

static int read_seconds(const char *text, double *seconds, struct message *message)
{
    if (number_read(text, seconds) != 0 || !(*seconds > 0.0))
        return message_set(message, "--checkpoint: '%.100s' is not a positive number of seconds; write 60 or 1e3",
                           text);
    return 0;
}

enum { H = 256, T_END, STEPPER, SET, RECORD, FRAMES, CHECKPOINT, RESUME, NO_DUMP, XDMF, FORCE, FIELDS, LIST };

static int take(struct arguments *a, int option, char **argv, struct message *message)
{
    switch (option) {
    case H:
        return add_set(a, "--h", "h", optarg, message);
    case T_END:
        return add_set(a, "--t-end", "t_end", optarg, message);
    case STEPPER:
        return add_set(a, "--stepper", "stepper", optarg, message);
    case SET:
        return add_set(a, "--set", NULL, optarg, message);
    case RECORD:
        return read_every("--record", optarg, &a->request.record_every, message);
    case FRAMES:
        return read_every("--frames", optarg, &a->request.frames_every, message);
    case CHECKPOINT:
        return read_seconds(optarg, &a->request.checkpoint_seconds, message);
    case RESUME:
        a->request.resume = 1;
        return 0;
    case NO_DUMP:
        a->request.dump = 0;
        return 0;
    case XDMF:
        a->request.xdmf = 1;
        return 0;
    case FORCE:
        a->request.force = 1;
        return 0;
    case FIELDS:
        return fields_read(optarg, &a->request.fields, message);
    case LIST:
        a->list = optarg;
        return 0;
    case 'o':
        a->request.output = optarg;
        return 0;
    case 'h':
        a->help = 1;
        return 0;
    case ':':
        return message_set(message, "%.200s: needs a value; see vti-run --help", argv[optind - 1]);
    default:
        return message_set(message, "%.200s: is not an option; see vti-run --help", argv[optind - 1]);
    }
}

static int read_arguments(int argc, char **argv, struct arguments *a, struct message *message)
{
    static const struct option options[] = {{"h", required_argument, NULL, H},
                                            {"t-end", required_argument, NULL, T_END},
                                            {"stepper", required_argument, NULL, STEPPER},
                                            {"set", required_argument, NULL, SET},
                                            {"record", required_argument, NULL, RECORD},
                                            {"frames", required_argument, NULL, FRAMES},
                                            {"checkpoint", required_argument, NULL, CHECKPOINT},
                                            {"resume", no_argument, NULL, RESUME},
                                            {"no-dump", no_argument, NULL, NO_DUMP},
                                            {"xdmf", no_argument, NULL, XDMF},
                                            {"force", no_argument, NULL, FORCE},
                                            {"fields", required_argument, NULL, FIELDS},
                                            {"list", required_argument, NULL, LIST},
                                            {"help", no_argument, NULL, 'h'},
                                            {NULL, 0, NULL, 0}};
    const struct run_request defaults = {NULL, NULL, 0, NULL, 0, 0, 60.0, 0, 1, 0, 0, 0};
    a->request = defaults;
    a->request.sets = a->sets;
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, ":ho:", options, NULL)) != -1;)
        if (take(a, c, argv, message) != 0)
            return -1;
    a->request.scene = optind < argc ? argv[optind] : NULL;
    if (optind + 1 < argc)
        return message_set(message, "%.200s: only one scene can be run at a time; remove it", argv[optind + 1]);
    if (a->request.scene == NULL && !a->help && a->list == NULL)
        return message_set(message, "a scene is needed: vti-run SCENE.yaml; see vti-run --help");
    return 0;
}

static int exit_code(enum run_end end, int64_t verdict)
{
    if (end == RUN_COMPLETE && verdict == VERDICT_BAD)
        return EXIT_BAD;
    return end == RUN_COMPLETE ? EXIT_SUCCESS : end == RUN_STOPPED ? EXIT_RESUME : EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    static struct arguments arguments;
    static struct run run;
    struct message message = {""};
    if (version_asked(argc, argv, "vti-run", 1))
        return EXIT_SUCCESS;
    if (read_arguments(argc, argv, &arguments, &message) != 0) {
        fprintf(stderr, "vti-run: %s\n", message.text);
        return EXIT_FAILURE;
    }
    if (arguments.help) {
        fputs(usage, stdout);
        return EXIT_SUCCESS;
    }
    if (arguments.list != NULL) {
        if (scene_list(arguments.list, stdout, &message) == 0 && output_end(&message) == 0)
            return EXIT_SUCCESS;
        fprintf(stderr, "vti-run: %s\n", message.text);
        return EXIT_FAILURE;
    }
    enum run_end end = RUN_FAILED;
    const int opened = run_open(&arguments.request, &run, &message) == 0;
    if (opened && run.done) {
        run_say_done(&run, stdout);
        end = output_end(&message) == 0 ? RUN_COMPLETE : RUN_FAILED;
    } else if (opened) {
        run_say_start(&run, stdout);
        end = run_go(&run, progress_show, &message);
        progress_clear();
        if (end == RUN_COMPLETE || end == RUN_BROKEN)
            run_say_end(&run, stdout);
        if (end == RUN_COMPLETE && output_end(&message) != 0)
            end = RUN_FAILED;
    }
    run_close(&run);
    if (end == RUN_ENDED)
        run_signals_obey();
    if (end != RUN_COMPLETE)
        fprintf(stderr, "vti-run: %s\n", message.text);
    return exit_code(end, run.record.judgement.verdict);
}
