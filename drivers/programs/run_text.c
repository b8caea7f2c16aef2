/* SPDX-License-Identifier: BSD-3-Clause */
#include "run_text.h"

#include <math.h>

#include "number.h"
#include "record.h"
#include "run.h"
#include "shape.h"
#include "sizes.h"
#include "stable.h"
#include "step_errors.h"
#include "unused.h"

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
                "%s to t = %.10g: steps with estimated errors of at most %.4g in velocity and angular velocity; rows "
                "and frames at multiples of h = %s\n",
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
    if (run->from == 0)
        unused_say(m, &run->tables, file);
    for (int64_t e = 0; run->from == 0 && e < m->instances_count; ++e) {
        char text[256] = "";
        if (m->instances[e].kind->note != NULL)
            m->instances[e].kind->note(&m->instances[e], m, text, sizeof text);
        if (text[0] != '\0')
            fprintf(file, "note: %s\n", text);
    }
}

/** The disk that files take, where that is much, and whether it is there. */
static void say_files(struct run *run, FILE *file)
{
    const double much = 1e8;
    const struct run_sizes sizes = sizes_of(run);
    char files[32], all[32], needed[32], space[32];
    const int is_much = sizes.files + sizes.journal >= much;
    if (is_much)
        fprintf(file, "; files of some %s, %s while they are written", sizes_text(sizes.files, files),
                sizes_text(sizes.files + sizes.journal, all));
    fputc('\n', file);
    if (is_much && sizes.needed > sizes.space)
        fprintf(file,
                "warning: %s has room for %s, and the run needs some %s of it: make room there, record fewer frames "
                "(--frames), leave OUT.dump out (--no-dump), or choose another place with -o\n",
                run->files.folder, sizes_text(sizes.space, space), sizes_text(sizes.needed, needed));
}

/** "a row every step (0.01 of time)", "a frame every 50 steps (0.5 of time)"; of steps that vary "every 50 h" */
static void say_every(const char *what, int64_t every, int varies, double h, FILE *file)
{
    fprintf(file, "%s every ", what);
    if (every != 1)
        fprintf(file, "%lld ", (long long)every);
    fprintf(file, "%s (%.6g of time)", varies ? "h" : every == 1 ? "step" : "steps", (double)every * h);
}

void run_text_start(struct run *run, FILE *file)
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
    const int varies = travel_tally(&run->travel, &tally);
    say_every("a row", run->checkpoint.record_every, varies, h, file);
    say_every(" and a frame", run->checkpoint.frames_every, varies, h, file);
    say_files(run, file);
    if (run->fit > 0)
        fprintf(file,
                "note: %lld frames, as more of so many bodies would take more than 500 MB of files; --frames EVERY "
                "records one every so many steps\n",
                (long long)run->fit);
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

void run_text_done(const struct run *run, FILE *file)
{
    fprintf(file,
            "%s: the run is complete, to t = %.10g; there is nothing to do (a later --t-end extends it)\n"
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

void run_text_end(const struct run *run, FILE *file)
{
    const double scale = run->energy0 != 0.0 ? fabs(run->energy0) : 1.0;
    const int xdmf = run_files_has_xdmf(&run->files, &run->record);
    fprintf(file, "energy: %.10g at t = 0, %.10g at t = %.10g; %schange %.3g, largest %.3g\n", run->energy0,
            run->energy1, run->t, run->energy0 != 0.0 ? "relative to that at t = 0: " : "",
            (run->energy1 - run->energy0) / scale, run->drift / scale);
    struct travel_tally tally;
    if (travel_tally(&run->travel, &tally))
        fprintf(
            file,
            "%lld steps, %.3g long on the mean, %lld made again, and %lld tried to end at rows and frames: %lld force "
            "evaluations\n",
            (long long)tally.accepted, run->t / (double)(tally.accepted > 0 ? tally.accepted : 1),
            (long long)tally.rejected, (long long)tally.cut, (long long)tally.evals);
    fprintf(file, "%lld rows and %lld frames in %.2f s, written to %s, and beside it .csv%s%s%s%s%s\n",
            (long long)run->journal.rows.mark.count, (long long)run->journal.frames.mark.count, run->seconds,
            run->output, xdmf ? ", .xdmf" : "", run->files.dump ? ", .dump" : "",
            run->files.spheres ? ", -spheres.h5" : "", run->files.contacts ? ", -contacts.h5" : "",
            run->end == RUN_COMPLETE ? "" : ", up to where it broke off");
    if (!xdmf)
        fprintf(file,
                "no .xdmf of so many frames, 1 to 8 kB for each: ParaView reads %s itself, and --xdmf writes it\n",
                run->output);
    say_errors(&run->model, file);
    fprintf(file, "%s\n", run->judgement.text);
}
