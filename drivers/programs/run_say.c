/* SPDX-License-Identifier: BSD-3-Clause */
#include "run_say.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "shape.h"
#include "stable_text.h"

/* ---- before ------------------------------------------------------------------------------------------------------ */

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
        pairs |= strcmp(effect->name, "contact") == 0;
    }
    if (m->effects_count == 0)
        fputs("none", file);
    if (shape_bonds(m) > 0)
        fprintf(file, "; %lld bonds", (long long)shape_bonds(m));
    fprintf(file, "; %s\n", pairs ? "pairs in contact are searched for" : "no pairs are searched for");
}

static void say_step(const struct run *run, FILE *file)
{
    const double h = run->scene.h, degrees = 180.0 / acos(-1.0);
    const vti_stepper *stepper = run->scene.stepper;
    struct model_limits limits;
    struct message trouble = {""};
    if (!run->resumable)
        fprintf(file, "note: %s keeps what no checkpoint holds: this run cannot be resumed if it is interrupted\n",
                stepper->name);
    fprintf(file, "%s, h = %s: %lld steps to t = %.10g", stepper->name, NUMBER(h), (long long)run->steps,
            (double)run->steps * h);
    if (run->record.frames.turns)
        fprintf(file, "; at most %.3g degrees per step at t = %.10g", degrees * vti_max_turn(h, &run->model.bodies),
                (double)run->from * h);
    fputc('\n', file);
    if (model_find_limits(&run->model, &limits, &trouble) != 0) {
        fprintf(file, "warning: the stable step is not known: %s\n", trouble.text);
        return;
    }
    stable_say(&limits, stepper, h, file);
    if (h > stable_least(&limits, stepper))
        fprintf(file, "warning: h = %s is above the stable step %.4g: the run may blow up\n", NUMBER(h),
                stable_least(&limits, stepper));
}

static void say_warnings(const struct run *run, FILE *file)
{
    struct message lines[2];
    const int n = run->from == 0 ? verdict_warnings(&run->verdict, &run->model.bodies, lines) : 0;
    for (int k = 0; k < n; ++k)
        fprintf(file, "warning: %s\n", lines[k].text);
}

void run_say_start(const struct run *run, FILE *file)
{
    const double wanted = run->scene.t_end, h = run->scene.h;
    say_bodies(run, file);
    say_effects(run, file);
    say_step(run, file);
    say_warnings(run, file);
    if (fabs((double)run->steps * h - wanted) > 1e-9 * wanted)
        fprintf(file, "note: t_end = %s is not a multiple of h: the run ends at t = %.10g\n", NUMBER(wanted),
                (double)run->steps * h);
    fprintf(file, "a row every %lld steps (%.6g of time) and a frame every %lld (%.6g)\n",
            (long long)run->checkpoint.record_every, (double)run->checkpoint.record_every * h,
            (long long)run->checkpoint.frames_every, (double)run->checkpoint.frames_every * h);
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

void run_say_done(const struct run *run, FILE *file)
{
    fprintf(file, "%s: the run is complete, to t = %.10g; there is nothing to do (a later --t-end prolongs it)\n",
            run->output, (double)run->steps * run->scene.h);
}

/* ---- after ------------------------------------------------------------------------------------------------------- */

void run_say_end(const struct run *run, FILE *file)
{
    const double scale = run->energy0 != 0.0 ? fabs(run->energy0) : 1.0;
    const int xdmf = run_files_has_xdmf(&run->files, &run->record);
    fprintf(file, "energy: %.10g at t = 0, %.10g at t = %.10g; change %.3g, at most %.3g%s\n", run->energy0,
            run->energy1, run->t, (run->energy1 - run->energy0) / scale, run->drift / scale,
            run->energy0 != 0.0 ? " of it" : "");
    fprintf(file, "%lld rows and %lld frames in %.2f s, written to %s, and beside it .csv%s%s%s\n",
            (long long)run->journal.rows.mark.count, (long long)run->journal.frames.mark.count, run->seconds,
            run->output, xdmf ? ", .xdmf" : "", run->files.dump ? ", .dump" : "",
            run->end == RUN_COMPLETE ? "" : ", up to where it broke off");
    if (!xdmf)
        fprintf(file,
                "no .xdmf of so many frames, 1 to 8 kB for each: ParaView reads %s itself, and --xdmf writes it\n",
                run->output);
    fprintf(file, "%s\n", run->judgement.text);
}
