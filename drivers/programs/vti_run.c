/* SPDX-License-Identifier: BSD-3-Clause
 * vti-run: one scene over time. Arguments in, files out; the work is in run/, sim/ and io/. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "record.h"
#include "number.h"
#include "options.h"
#include "terminal.h"
#include "run.h"
#include "signals.h"
#include "step_errors.h"
#include "scene.h"
#include "shape.h"
#include "sizes.h"
#include "travel.h"
#include "unused.h"

enum { EXIT_BAD = 3, EXIT_RESUME = 75 /* EX_TEMPFAIL of sysexits.h */ };

static struct option_list sets;
static const char *fields, *list;
static struct run_request request = {.sets = sets.text, .checkpoint_seconds = 60.0, .dump = 1};

static const struct option_row rows[] = {
    OPTION_PARAGRAPH(
        "Runs a scene and writes OUT.h5 (trajectory as VTKHDF, energies and momenta over time), OUT.csv\n"
        "(the latter), OUT.xdmf (index of the trajectory) and OUT.dump (LAMMPS text dump, for OVITO); of bodies\n"
        "that are clumps also OUT-spheres.h5 (their spheres as VTKHDF).\n"),
    {"-o", "OUT.h5", OPTION_TEXT, &request.output, OPTION_ANY, "where to write (default: the scene's name)"},
    {"--stepper", "NAME", OPTION_KEY, &sets, OPTION_ANY, "integrator, one of --list steppers (default: the scene's)"},
    {"--h", "H", OPTION_KEY, &sets, OPTION_ANY,
     "step (default: the scene's); numbers may be written 0.01, 1/64 or 2^-6"},
    {"--tolerance", "TOL", OPTION_KEY, &sets, OPTION_ANY,
     "choose steps whose estimated error in velocity and spin is at most that; for srkn11, srkn14 and srkn6, and H is "
     "then only the unit of --record and --frames; each row takes a further step, so there are about 100"},
    {"--control", "HOW", OPTION_KEY, &sets, OPTION_ANY,
     "integrating: steps that follow how fast bodies turn, for reversible steppers such as srkn6, whose energy keeps "
     "without drift; naive: the same without that, to compare with; H is the step at rest and the unit of --record, "
     "and turning (--set) the angular velocity at which a step is 0.7 of it"},
    {"--t-end", "T", OPTION_KEY, &sets, OPTION_ANY, "end time (default: the scene's)"},
    {"--set", "PATH=VALUE", OPTION_EACH, &sets, OPTION_ANY, "override a value of the scene; may be repeated"},
    {"--record", "EVERY", OPTION_WHOLE, &request.record_every, 1, 0x1p53, "50 or 1e3",
     "steps between rows of energies and momenta (default: about 1000 rows; from 1000 bodies on a row for some ten "
     "steps, but 100)"},
    {"--frames", "EVERY", OPTION_WHOLE, &request.frames_every, 1, 0x1p53, "50 or 1e3",
     "steps between frames of the trajectory (default: about 100 frames); the state at the end is always recorded"},
    {"--fields", "force,moment,lost", OPTION_TEXT, &fields, OPTION_ANY,
     "one or more of each body in OUT.h5 and OUT.xdmf too, in every frame; force and moment: of all effects but drag "
     "and dashpots, which are flows of velocities; lost: the energy that it has lost so far, in all and by the columns "
     "of OUT.csv"},
    {"--errors", NULL, OPTION_ON, &request.errors, OPTION_ANY,
     "the columns error_velocity and error_omega: the largest estimated error of a step since the row before; for "
     "srkn6, srkn11, srkn14 and an4 to an10-fine"},
    {"--no-dump", NULL, OPTION_OFF, &request.dump, OPTION_ANY, "no OUT.dump, the largest of the files"},
    {"--xdmf", NULL, OPTION_ON, &request.xdmf, OPTION_ANY,
     "OUT.xdmf for more than 2000 frames too: 1-8 kB for each; ParaView reads OUT.h5 itself"},
    {"--force", NULL, OPTION_ON, &request.force, OPTION_ANY,
     "replace files that are no results of vti too; what the scene is read from is never replaced"},
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

/* ---- before ----------------------------------------------------------------------------------------------------- */

static void say_bodies(const struct run *run, FILE *file)
{
    static const char *const motions[2][2][2] = {
        {{"does nothing", "do nothing"}, {"turns and does not translate", "turn and do not translate"}},
        {{"translates and does not turn", "translate and do not turn"},
         {"translates and turns", "translate and turn"}}};
    const struct frame_layout *f = &run->record.frames;
    fprintf(file, "%s: %lld %s that %s\n", run->scene.name, (long long)f->n, f->n == 1 ? "body" : "bodies",
            motions[f->translates][f->turns][f->n != 1]);
}

static void say_effects(const struct run *run, FILE *file)
{
    const struct model *m = &run->model;
    int pairs = 0;
    fputs("effects: ", file);
    for (int64_t e = 0; e < m->effects_count; ++e) {
        const vti_effect *effect = &m->effects[e];
        fprintf(file, "%s%s", e > 0 ? ", " : "", effect->name);
        for (int64_t j = 0; effect->terms > 1 && j < effect->terms; ++j)
            fprintf(file, "%s%s%s", j > 0 ? ", " : " (", effect->term[j], j + 1 == effect->terms ? ")" : "");
    }
    if (m->effects_count == 0)
        fputs("none", file);
    for (int64_t e = 0; e < m->instances_count; ++e) {
        const struct effect_kind *kind = m->instances[e].kind;
        char text[80] = "";
        if (kind->say != NULL)
            kind->say(&m->instances[e], text, sizeof text);
        fprintf(file, "%s%s", text[0] != '\0' ? "; " : "", text);
        pairs |= kind->find_pairs != NULL;
    }
    fprintf(file, "; %s\n", pairs ? "pairs in contact are searched for" : "no pairs are searched for");
}

static void say_step(struct run *run, FILE *file)
{
    const double h = run->scene.h, degrees = 180.0 / acos(-1.0);
    const vti_stepper *stepper = run->scene.stepper;
    struct model_limits limits;
    struct travel_tally tally;
    struct message trouble = {""};
    if (travel_tally(&run->travel, &tally) && run->scene.control != 0) {
        fprintf(file,
                "%s to t = %.10g: steps of %s where bodies are at rest and 0.7 of that where they turn by %.4g a unit "
                "of time; rows and frames at multiples of h = %s\n",
                stepper->name, (double)run->steps * h, NUMBER(h), scene_unit(run->scene.turning), NUMBER(h));
        return;
    }
    if (travel_tally(&run->travel, &tally)) {
        fprintf(file,
                "%s to t = %.10g: steps with estimated errors of at most %.4g in velocity and spin; rows and frames at "
                "multiples of h = %s\n",
                stepper->name, (double)run->steps * h, tally.tolerance, NUMBER(h));
        return;
    }
    fprintf(file, "%s, h = %s: %lld steps to t = %.10g", stepper->name, NUMBER(h), (long long)run->steps,
            (double)run->steps * h);
    if (run->record.frames.turns)
        fprintf(file, "; at most %.3g degrees per step at t = %.10g", degrees * vti_max_turn(h, &run->model.bodies),
                (double)run->from * h);
    fputc('\n', file);
    (void)run_shown(run, &run->model.bodies);
    if (model_find_limits(run->shown, &limits, &trouble) != 0) {
        fprintf(file, "warning: the stable step is not known: %s\n", trouble.text);
        return;
    }
    stable_say(&limits, stepper, h, file);
    if (limits.at.overlap > VERDICT_MUCH_OVERLAP)
        fputs("warning: bodies are fast or heavy enough to pass through what they meet; make contacts and walls "
              "stiffer\n",
              file);
    if (h > stable_least(&limits, stepper))
        fprintf(file, "warning: h = %s is above the stable step %.4g: the run may blow up\n", NUMBER(h),
                stable_least(&limits, stepper));
}

static void say_warnings(const struct run *run, FILE *file)
{
    struct message lines[VERDICT_WARNINGS];
    const int n = run->from == 0 ? verdict_warnings(&run->verdict, &run->model.bodies, lines) : 0;
    for (int k = 0; k < n; ++k)
        fprintf(file, "warning: %s\n", lines[k].text);
}

/** What is given for nothing, and what effects want to have said of the start. */
static void say_notes(const struct run *run, FILE *file)
{
    const struct model *m = run->shown;
    struct message unused[RUN_UNUSED];
    const int n = run->from == 0 ? run_unused(m, &run->tables, unused) : 0;
    for (int k = 0; k < n; ++k)
        fprintf(file, "note: %s\n", unused[k].text);
    for (int64_t e = 0; run->from == 0 && e < m->instances_count; ++e) {
        char text[256] = "";
        if (m->instances[e].kind->note != NULL)
            m->instances[e].kind->note(&m->instances[e], m, text, sizeof text);
        if (text[0] != '\0')
            fprintf(file, "note: %s\n", text);
    }
}

/** The disk that files take, where that is much, and whether it is there. */
static void say_files(const struct run *run, FILE *file)
{
    const double much = 1e8;
    const struct run_sizes sizes = run_sizes(run);
    char files[32], all[32], needed[32], space[32];
    const int is_much = sizes.files + sizes.journal >= much;
    if (is_much)
        fprintf(file, "; files of some %s, %s while they are written", size_text(sizes.files, files),
                size_text(sizes.files + sizes.journal, all));
    fputc('\n', file);
    if (is_much && sizes.needed > sizes.space)
        fprintf(file,
                "warning: %s has room for %s, and the run needs some %s of it: make room there, record fewer frames "
                "(--frames), leave OUT.dump out (--no-dump), or choose another place with -o\n",
                run->files.folder, size_text(sizes.space, space), size_text(sizes.needed, needed));
}

/** What will be computed, from where, and h against the bound of the stable step. */
static void say_start(struct run *run, FILE *file)
{
    const double wanted = run->scene.t_end, h = run->scene.h;
    struct travel_tally tally;
    say_bodies(run, file);
    say_effects(run, file);
    say_step(run, file);
    say_warnings(run, file);
    say_notes(run, file);
    if (fabs((double)run->steps * h - wanted) > 1e-9 * wanted)
        fprintf(file, "note: t_end = %s is not a multiple of h: the run ends at t = %.10g\n", NUMBER(wanted),
                (double)run->steps * h);
    fprintf(file, "a row every %lld %s (%.6g of time) and a frame every %lld (%.6g)",
            (long long)run->checkpoint.record_every, travel_tally(&run->travel, &tally) ? "h" : "steps",
            (double)run->checkpoint.record_every * h, (long long)run->checkpoint.frames_every,
            (double)run->checkpoint.frames_every * h);
    say_files(run, file);
    if (run->request->resume && run->from > 0)
        fprintf(file, "goes on from step %lld, t = %.10g\n", (long long)run->from, (double)run->from * h);
    if (run->restored && run->from > 0)
        fprintf(file,
                "rows and frames stay as far apart as they are: the files will be those of one run with --record %lld "
                "--frames %lld\n",
                (long long)run->checkpoint.record_every, (long long)run->checkpoint.frames_every);
    if (run->request->resume && run->from == 0)
        fputs("no steps were done yet: starts at t = 0\n", file);
    fflush(file);
}

/** That the run was complete before. */
static void say_done(const struct run *run, FILE *file)
{
    fprintf(file,
            "%s: the run is complete, to t = %.10g; there is nothing to do (a later --t-end prolongs it)\n"
            "verdict: %s\n",
            run->output, (double)run->steps * run->scene.h, verdict_word(run->record.judgement.verdict));
}

/* ---- after ------------------------------------------------------------------------------------------------------ */

/** The largest of all steps, and where the estimate jumped. */
static void say_errors(const struct model *model, FILE *file)
{
    static const char *const of[2] = {"velocity", "angular velocity"};
    const int there[2] = {model->translates, model->turns};
    const char *before = "largest estimated error of a step:";
    if (model->errors == NULL)
        return;
    const struct step_errors_found *f = &model->errors->found;
    for (int k = 0; k < 2; ++k)
        if (there[k]) {
            fprintf(file, "%s %.3g in %s (t = %.10g)", before, f->most[k], of[k], f->most_t[k]);
            before = ",";
        }
    fputs("; that is of one step, and no measure of the error at the end, which vti-study tells\n", file);
    if (f->jumps > 0.0)
        fprintf(
            file,
            "warning: the estimate grew tenfold in %.0f step%s, first in the one to t = %.10g: something touched or "
            "jumped there; reduce h if that matters\n",
            f->jumps, f->jumps > 1.0 ? "s" : "", f->jump_t);
}

/** Energy drift, time and files. */
static void say_end(const struct run *run, FILE *file)
{
    const double scale = run->energy0 != 0.0 ? fabs(run->energy0) : 1.0;
    const int xdmf = run_files_has_xdmf(&run->files, &run->record);
    fprintf(file, "energy: %.10g at t = 0, %.10g at t = %.10g; change %.3g, at most %.3g%s\n", run->energy0,
            run->energy1, run->t, (run->energy1 - run->energy0) / scale, run->drift / scale,
            run->energy0 != 0.0 ? " of it" : "");
    struct travel_tally tally;
    if (travel_tally(&run->travel, &tally))
        fprintf(
            file,
            "%lld steps, %.3g long on the mean, %lld made again, and %lld tried to end at rows and frames: %lld force "
            "evaluations\n",
            (long long)tally.accepted, run->t / (double)(tally.accepted > 0 ? tally.accepted : 1),
            (long long)tally.rejected, (long long)tally.cut, (long long)tally.evals);
    fprintf(file, "%lld rows and %lld frames in %.2f s, written to %s, and beside it .csv%s%s%s%s\n",
            (long long)run->journal.rows.mark.count, (long long)run->journal.frames.mark.count, run->seconds,
            run->output, xdmf ? ", .xdmf" : "", run->files.dump ? ", .dump" : "",
            run->files.spheres ? ", -spheres.h5" : "", run->end == RUN_COMPLETE ? "" : ", up to where it broke off");
    if (!xdmf)
        fprintf(file,
                "no .xdmf of so many frames, 1 to 8 kB for each: ParaView reads %s itself, and --xdmf writes it\n",
                run->output);
    say_errors(&run->model, file);
    fprintf(file, "%s\n", run->judgement.text);
}

/** Runs the scene of the request. */
static int run_scene(struct message *message)
{
    static const struct run_watch watch = {progress_show, log_step};
    static struct run run;
    enum run_end end = RUN_FAILED;
    const int opened = run_open(&request, &run, message) == 0;
    if (opened && run.done) {
        say_done(&run, stdout);
        end = output_end(message) == 0 ? RUN_COMPLETE : RUN_FAILED;
    } else if (opened) {
        say_start(&run, stdout);
        end = run_go(&run, &watch, message);
        progress_clear();
        if (end == RUN_COMPLETE || end == RUN_BROKEN)
            say_end(&run, stdout);
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
    log_as(options.program);
    const enum options_end asked = options_read(&options, argc, argv, 1, &scenes, &count, &message);
    if (asked == OPTIONS_TOLD) {
        code = output_end(&message) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    } else if (asked == OPTIONS_GO && list != NULL && count > 0) {
        message_set(&message, "%.300s: --list lists, and runs no scene; leave one of them out", scenes[0]);
    } else if (asked == OPTIONS_GO && list != NULL) {
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
