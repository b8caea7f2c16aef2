/* SPDX-License-Identifier: BSD-3-Clause
 * vti-run: one scene over time. Arguments in, files out; the work is in run/, sim/ and io/. */
#include <stdio.h>
#include <stdlib.h>

#include "options.h"
#include "run.h"
#include "run_text.h"
#include "scene.h"
#include "signals.h"
#include "terminal.h"
#include "travel.h"

static struct option_list sets;
static const char *fields, *list;
static struct run_request request = {.sets = sets.text, .checkpoint_seconds = 60.0, .dump = 1};

static const struct option_row rows[] = {
    OPTION_PARAGRAPH(
        "Runs a scene and writes OUT.h5 (trajectory as VTKHDF, energies and momenta over time), OUT.csv\n"
        "(the latter), OUT.xdmf (index of the trajectory) and OUT.dump (LAMMPS text dump, for OVITO); of bodies\n"
        "that are clumps also OUT-spheres.h5 (their spheres as VTKHDF), and with --contacts OUT-contacts.h5 (what\n"
        "touches, with its forces).\n"),
    {"-o", "OUT.h5", OPTION_TEXT, &request.output, OPTION_ANY, "where to write (default: the scene's name)"},
    {"--stepper", "NAME", OPTION_KEY, &sets, OPTION_ANY, "integrator, one of --list steppers (default: the scene's)"},
    {"--h", "H", OPTION_KEY, &sets, OPTION_ANY,
     "step (default: the scene's); numbers may be written 0.01, 1/64 or 2^-6"},
    {"--tolerance", "TOL", OPTION_KEY, &sets, OPTION_ANY,
     "choose steps whose estimated error in velocity and angular velocity is at most TOL; for srkn11, srkn14 and "
     "srkn6. H is then the unit of --record and --frames and the first step that is tried, and the shortest step is "
     "2^-26 H. Each row costs one more step, so the default is about 100 rows"},
    {"--control", "HOW", OPTION_KEY, &sets, OPTION_ANY,
     "integrating: steps that follow how fast bodies turn, for reversible steppers such as srkn6, whose energy keeps "
     "without drift; naive: the same without that, to compare with; H is the step at rest and the unit of --record, "
     "and turning (--set) the angular velocity at which a step is 0.7 of it"},
    {"--t-end", "T", OPTION_KEY, &sets, OPTION_ANY, "end time (default: the scene's)"},
    {"--set", "PATH=VALUE", OPTION_EACH, &sets, OPTION_ANY, "override a value of the scene; may be repeated"},
    {"--record", "EVERY", OPTION_WHOLE, &request.record_every, 1, 0x1p53, "50 or 1e3",
     "steps between rows of energies and momenta (default: about 1000 rows; from 1000 bodies on one row per ten steps "
     "or so, but at least 100 rows)"},
    {"--frames", "EVERY", OPTION_WHOLE, &request.frames_every, 1, 0x1p53, "50 or 1e3",
     "steps between frames of the trajectory (default: about 100 frames, or as many as 500 MB of files hold); the "
     "states at t = 0 and at the end are always recorded"},
    {"--fields", "force,moment,lost", OPTION_TEXT, &fields, OPTION_ANY,
     "one or more of each body in OUT.h5 and OUT.xdmf too, in every frame; force and moment: of all effects but drag "
     "and dashpots, which are flows of velocities; lost: the energy that it has lost so far, in all and by the columns "
     "of OUT.csv"},
    {"--contacts", NULL, OPTION_ON, &request.contacts, OPTION_ANY,
     "OUT-contacts.h5 too: in every frame each two spheres that touch, or sphere and wall, as a line with the force on "
     "the first (elastic and of friction, without dashpots) and the overlap: the force network, for ParaView"},
    {"--errors", NULL, OPTION_ON, &request.errors, OPTION_ANY,
     "the columns error_velocity and error_omega: the largest estimated error of a step since the row before; for "
     "srkn6, srkn11, srkn14 and an4 to an10-fine"},
    {"--no-dump", NULL, OPTION_OFF, &request.dump, OPTION_ANY,
     "no OUT.dump, the largest of the files; one that an earlier run has left under that name is removed"},
    {"--xdmf", NULL, OPTION_ON, &request.xdmf, OPTION_ANY,
     "OUT.xdmf for more than 2000 frames too: 1-8 kB for each; ParaView reads OUT.h5 itself"},
    {"--force", NULL, OPTION_ON, &request.force, OPTION_ANY,
     "replace files that are no results of vti, or write-protected, too; what the scene is read from is never "
     "replaced"},
    {"--checkpoint", "SECONDS", OPTION_NUMBER, &request.checkpoint_seconds, 0, 0, "60 or 1e3",
     "time between checkpoints (default 60); where no terminal shows a bar, they are told on the standard error, a "
     "minute or more apart"},
    {"--threads", "N", OPTION_WHOLE, &request.threads, 1, 1024, "2 or 8",
     "threads that work on the scene (default: all cores from 1000 bodies on, 1 under mpirun); the bytes are the same "
     "for any number, and a resumed run may have another one"},
    {"--renumber", NULL, OPTION_ON, &request.renumber, OPTION_ANY,
     "work on the bodies and bonds of tables in an order in which neighbours are near each other: faster where tables "
     "have them in any order; files have the tables' numbers, and sums over bonds differ in their last digits, results "
     "with dashpots, which act pair after pair, by as much as a step errs"},
    {"--resume", NULL, OPTION_ON, &request.resume, OPTION_ANY,
     "go on from the last checkpoint, or with a later --t-end from the end of a complete run; if there is neither, "
     "start"},
    {"--list", "WHAT", OPTION_TEXT, &list, OPTION_ANY, "steppers, effects or keys of scenes, with what they are"},
    OPTION_PARAGRAPH(
        "While it runs everything is kept in the file OUT.run. After SIGTERM, SIGUSR1, SIGHUP, SIGXCPU or\n"
        "Ctrl-C it saves a checkpoint and ends with code 75; the same command with --resume goes on, after\n"
        "any other end too, and gives the same bytes as if nothing had happened. A run that is resumed may\n"
        "be given a later --t-end; all else must be as it was.\n"
        "\n"
        "The last line is the verdict: good, doubtful or bad, and why. Where it is bad (the energy grew by\n"
        "more than a quarter of its scale, or bodies come by more than a diameter per step towards what they\n"
        "touch) all files are written and the code is 3."),
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
    static const struct run_watch watch = {progress_show, log_step};
    static struct run run;
    enum run_end end = RUN_FAILED;
    const int opened = run_open(&request, &run, message) == 0;
    if (opened && run.done) {
        run_text_done(&run, stdout);
        end = options_output_end(message) == 0 ? RUN_COMPLETE : RUN_FAILED;
    } else if (opened) {
        run_text_start(&run, stdout);
        end = run_go(&run, &watch, message);
        progress_clear();
        if (end == RUN_COMPLETE || end == RUN_BROKEN)
            run_text_end(&run, stdout);
        if (end == RUN_COMPLETE && options_output_end(message) != 0)
            end = RUN_FAILED;
    }
    run_close(&run);
    if (end == RUN_ENDED)
        signals_obey();
    return exit_code(end, run.record.judgement.verdict);
}

int main(int argc, char **argv)
{
    struct message message = {""};
    const char *const *scenes;
    int count, code = EXIT_FAILURE;
    method_admit();
    log_as(options.program);
    const enum options_end asked = options_read(&options, argc, argv, 1, &scenes, &count, &message);
    if (asked == OPTIONS_TOLD) {
        code = options_output_end(&message) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    } else if (asked == OPTIONS_GO && list != NULL && count > 0) {
        message_set(&message, "%.300s: --list lists, and runs no scene; leave one of them out", scenes[0]);
    } else if (asked == OPTIONS_GO && list != NULL) {
        if (scene_list(list, stdout, &message) == 0 && options_output_end(&message) == 0)
            code = EXIT_SUCCESS;
    } else if (asked == OPTIONS_GO && count == 0)
        message_set(&message, "a scene is needed: vti-run SCENE.yaml; see vti-run --help");
    else if (asked == OPTIONS_GO && (fields == NULL || record_fields_read(fields, &request.fields, &message) == 0)) {
        request.scene = scenes[0];
        request.sets_count = sets.count;
        code = run_scene(&message);
    }
    if (code != EXIT_SUCCESS && code != EXIT_BAD)
        fprintf(stderr, "vti-run: %s\n", message.text);
    return code;
}
