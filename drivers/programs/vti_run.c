/* SPDX-License-Identifier: BSD-3-Clause
 * vti-run: one scene over time. Arguments in, files out; the work is in sim/ and io/. */
#include <stdio.h>
#include <stdlib.h>

#include "fields.h"
#include "options.h"
#include "output.h"
#include "progress.h"
#include "run.h"
#include "run_say.h"
#include "scene_list.h"
#include "travel.h"
#include "run_signals.h"

enum { EXIT_BAD = 3, EXIT_RESUME = 75 /* EX_TEMPFAIL of sysexits.h */ };

static struct option_list sets;
static const char *fields, *list;
static struct run_request request = {.sets = sets.text, .checkpoint_seconds = 60.0, .dump = 1};

static const struct option_row rows[] = {
    OPTION_PARAGRAPH("Runs a scene and writes OUT.h5 (trajectory as VTKHDF, energies and momenta over time), OUT.csv\n"
                     "(the latter), OUT.xdmf (index of the trajectory) and OUT.dump (LAMMPS text dump, for OVITO).\n"),
    {"-o", "OUT.h5", OPTION_TEXT, &request.output, OPTION_ANY, "where to write (default: the scene's name)"},
    {"--stepper", "NAME", OPTION_KEY, &sets, OPTION_ANY, "integrator, one of --list steppers (default: the scene's)"},
    {"--h", "H", OPTION_KEY, &sets, OPTION_ANY,
     "step (default: the scene's); numbers may be written 0.01, 1/64 or 2^-6"},
    {"--t-end", "T", OPTION_KEY, &sets, OPTION_ANY, "end time (default: the scene's)"},
    {"--set", "PATH=VALUE", OPTION_EACH, &sets, OPTION_ANY, "override a value of the scene; may be repeated"},
    {"--record", "EVERY", OPTION_WHOLE, &request.record_every, 1, 0x1p53, "50 or 1e3",
     "steps between rows of energies and momenta (default: about 1000 rows)"},
    {"--frames", "EVERY", OPTION_WHOLE, &request.frames_every, 1, 0x1p53, "50 or 1e3",
     "steps between frames of the trajectory (default: about 100 frames); the state at the end is always recorded"},
    {"--fields", "force,moment", OPTION_TEXT, &fields, OPTION_ANY,
     "one or both of each body in OUT.h5 and OUT.xdmf too, in every frame"},
    {"--no-dump", NULL, OPTION_OFF, &request.dump, OPTION_ANY, "no OUT.dump, the largest of the files"},
    {"--xdmf", NULL, OPTION_ON, &request.xdmf, OPTION_ANY,
     "OUT.xdmf for more than 2000 frames too: 1-8 kB for each; ParaView reads OUT.h5 itself"},
    {"--force", NULL, OPTION_ON, &request.force, OPTION_ANY,
     "replace files that are no results of vti too; what the scene is read from is never replaced"},
    {"--checkpoint", "SECONDS", OPTION_NUMBER, &request.checkpoint_seconds, 0, 0, "60 or 1e3",
     "time between checkpoints (default 60)"},
    {"--resume", NULL, OPTION_ON, &request.resume, OPTION_ANY,
     "go on from the last checkpoint, or with a later --t-end from the end of a complete run; if there is neither, "
     "start"},
    {"--list", "WHAT", OPTION_TEXT, &list, OPTION_ANY, "steppers, effects or keys of scenes, with what they are"},
    OPTION_PARAGRAPH(
        "While it runs everything is kept in the folder OUT.run. After SIGTERM, SIGUSR1, SIGHUP, SIGXCPU or\n"
        "Ctrl-C it saves a checkpoint and ends with code 75; the same command with --resume goes on, after\n"
        "any other end too, and gives the same bytes as if nothing had happened. A run that is resumed may\n"
        "be given a later --t-end; all else must be as it was.\n"
        "\n"
        "The last line is the verdict: good, doubtful or bad, and why. Where it is bad (the energy grew by\n"
        "more than a quarter of its scale, or bodies move by more than a diameter per step) all files are\n"
        "written and the code is 3."),
    {0}};

static const struct options options = {"vti-run", "", "[options] SCENE.yaml", rows, 1};

static int exit_code(enum run_end end, int64_t verdict)
{
    if (end == RUN_COMPLETE && verdict == VERDICT_BAD)
        return EXIT_BAD;
    return end == RUN_COMPLETE ? EXIT_SUCCESS : end == RUN_STOPPED ? EXIT_RESUME : EXIT_FAILURE;
}

/** Runs the scene of the request. */
static int run_scene(struct message *message)
{
    static struct run run;
    enum run_end end = RUN_FAILED;
    const int opened = run_open(&request, &run, message) == 0;
    if (opened && run.done) {
        run_say_done(&run, stdout);
        end = output_end(message) == 0 ? RUN_COMPLETE : RUN_FAILED;
    } else if (opened) {
        run_say_start(&run, stdout);
        end = run_go(&run, progress_show, message);
        progress_clear();
        if (end == RUN_COMPLETE || end == RUN_BROKEN)
            run_say_end(&run, stdout);
        if (end == RUN_COMPLETE && output_end(message) != 0)
            end = RUN_FAILED;
    }
    run_close(&run);
    if (end == RUN_ENDED)
        run_signals_obey();
    return exit_code(end, run.record.judgement.verdict);
}

int main(int argc, char **argv)
{
    struct message message = {""};
    const char *const *scenes;
    int count, code = EXIT_FAILURE;
    method_admit();
    const enum options_end asked = options_read(&options, argc, argv, 1, &scenes, &count, &message);
    if (asked == OPTIONS_TOLD)
        return EXIT_SUCCESS;
    if (asked == OPTIONS_GO && list != NULL) {
        if (scene_list(list, stdout, &message) == 0 && output_end(&message) == 0)
            code = EXIT_SUCCESS;
    } else if (asked == OPTIONS_GO && count == 0)
        message_set(&message, "a scene is needed: vti-run SCENE.yaml; see vti-run --help");
    else if (asked == OPTIONS_GO && (fields == NULL || fields_read(fields, &request.fields, &message) == 0)) {
        request.scene = scenes[0];
        request.sets_count = sets.count;
        code = run_scene(&message);
    }
    if (code != EXIT_SUCCESS && code != EXIT_BAD)
        fprintf(stderr, "vti-run: %s\n", message.text);
    return code;
}
