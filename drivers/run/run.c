/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "run.h"

#include <stdlib.h>
#include <string.h>

#include "record.h"
#include "hdf5_sink.h"
#include "identity.h"
#include "interval.h"
#include "left.h"
#include "loop.h"
#include "number.h"
#include "signals.h"
#include "sizes.h"
#include "slices.h"
#include "step_errors.h"
#include "threads.h"

/* ---- opening ----------------------------------------------------------------------------------------------------- */

/* Bodies; for fewer, waking threads up is taken to cost more than they save. */
enum { MANY = 1000 };

/** How many threads a run of so many bodies gets if nobody says: all cores where they pay, one among the ranks of an
 *  MPI launcher, which has given the cores away already. */
static int64_t choose_threads(int64_t bodies)
{
    static const char *const launched[] = {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_SIZE", "PMI_RANK"};
    for (size_t k = 0; k < sizeof launched / sizeof launched[0]; ++k)
        if (getenv(launched[k]) != NULL)
            return 1;
    return bodies >= MANY ? threads_most() : 1;
}

static int start_threads(struct run *run, struct message *message)
{
    const int64_t asked = run->request->threads;
    run->threads = asked > 0 ? asked : choose_threads(run->model.bodies.count);
    threads_use(run->threads);
    return slices_create(&run->model, message);
}

const vti_bodies *run_shown(struct run *run, const vti_bodies *bodies)
{
    if (!run->request->renumber)
        return bodies;
    renumber_back(run->renumbering.number, bodies, &run->unsorted.bodies);
    return &run->unsorted.bodies;
}

/** The model, and what of it is shown. What is wrong with tables is said of these as they are. */
static int make_models(struct run *run, struct message *message)
{
    run->shown = run->request->renumber ? &run->unsorted : &run->model;
    if (model_create(&run->scene, run->shown, message) != 0)
        return -1;
    if (!run->request->renumber)
        return 0;
    if (renumber(run->shown, &run->tables, &run->renumbering, message) != 0)
        return -1;
    run->sorted = run->scene;
    run->sorted.tables = &run->renumbering.tables;
    return model_create(&run->sorted, &run->model, message);
}

/** Of steppers that have an estimate, what steps err by is recorded if it is asked for. */
static int open_errors(struct run *run, struct message *message)
{
    if (!run->request->errors)
        return 0;
    if (!method_estimates(run->scene.stepper))
        return message_set(message,
                           "%s: --errors: the stepper %s has no estimate of its error; take srkn6, srkn11, srkn14, "
                           "an4, an7, an9, an10-mid or an10-fine, or leave --errors out",
                           run->scene.name, run->scene.stepper->name);
    run->model.errors = step_errors_create(run->model.bodies.count);
    return run->model.errors != NULL ? 0 : scene_no_memory(&run->scene, message);
}

static int open_scene(struct run *run, struct message *message)
{
    const struct run_request *r = run->request;
    if (scene_read(r->scene, r->sets, r->sets_count, &run->scene, message) != 0)
        return -1;
    run->scene.by_body = (r->fields & FIELD_LOST) != 0;
    if (tables_read(&run->scene, &run->tables, message) != 0 || make_models(run, message) != 0)
        return -1;
    run->steps = loop_steps(run->scene.t_end, run->scene.h);
    if (record_fields_check(r->fields, &run->model, message) != 0)
        return -1;
    if (r->contacts && !touch_forces_may(&run->model))
        return message_set(message, "%s: --contacts: nothing touches; give contact or wall, or leave --contacts out",
                           run->scene.name);
    if (run->steps < 1)
        return message_set(message, "h = %s is longer than t_end = %s: no step fits; give a smaller h or a later t_end",
                           NUMBER(run->scene.h), NUMBER(run->scene.t_end));
    if (start_threads(run, message) != 0)
        return -1;
    if (method_for(&run->scene, run->scene.stepper) != NULL)
        run->scene.stepper = method_for(&run->scene, run->scene.stepper);
    if (open_errors(run, message) != 0)
        return -1;
    return travel_create(&run->travel, run->scene.stepper, &run->model, run->scene.h, message);
}

/** What the run is. The end time is no part of it: a run may be prolonged. */
static int identify(struct run *run, struct message *message)
{
    static const char *const without[] = {"t_end", NULL};
    const struct columns *columns = &run->record.columns;
    size_t size;
    FILE *text = open_memstream(&run->record.identity, &size);
    if (text == NULL)
        return scene_no_memory(&run->scene, message);
    identity_version(text);
    identity_scene(text, "", &run->scene, without);
    if (run->request->fields != 0) {
        fputs("fields of bodies: --fields ", text);
        record_fields_say(run->request->fields, text);
        fputc('\n', text);
    }
    if (run->request->contacts)
        fputs("touches of frames: --contacts\n", text);
    fputs("columns:", text);
    for (int c = 0; c < columns->count; ++c)
        fprintf(text, " %s", columns->name[c]);
    fprintf(text, "\nnumbers of a frame: %lld\n", (long long)run->record.frames.doubles);
    if (run->request->renumber)
        fputs("bodies: renumbered\n", text);
    return fclose(text) != 0 ? scene_no_memory(&run->scene, message) : 0;
}

static int open_journal(struct run *run, const char *path, struct message *message)
{
    if (identify(run, message) != 0)
        return -1;
    signals_catch(); /* until here a signal ends the program, and nothing has to be cleared away */
    if (keep_open(&run->journal.keep, path, "run", run->record.identity, run->request->resume, message) != 0)
        return -1;
    run->kept = run->journal.keep.there;
    run->files.left = 1;
    return 0;
}

static int open_files(struct run *run, struct message *message)
{
    char path[FOLDER_PATH];
    const char *const asked = run->request->output;
    snprintf(run->output, sizeof run->output, "%s%s", asked != NULL ? asked : run->scene.name,
             asked != NULL ? "" : ".h5");
    /* by what is asked for, which may be too long for output */
    if (run_files_name(&run->files, asked != NULL ? asked : run->output, run->request->dump, message) != 0)
        return -1;
    run->files.spheres = model_has_clumps(&run->model);
    run->files.contacts = run->request->contacts;
    run->files.force = run->request->force;
    run->files.xdmf = run->request->xdmf;
    run->files.inputs = run->inputs;
    run->files.inputs_count = overwrite_inputs(run->request->scene, &run->scene, run->inputs);
    const int stem = (int)(strlen(run->output) - strlen(run->files.hdf5) + strlen(run->files.stem));
    snprintf(path, sizeof path, "%.*s.run", stem, run->output);
    run->files.left = left_is_there(path);
    if (run_files_check(&run->files, message) != 0)
        return -1;
    /* before hours of computing, not after */
    return folder_create(run->files.folder, message) != 0 ? -1 : open_journal(run, path, message);
}

/** Steps between records: as asked for, as in the run that is resumed, or so that there are about so many. */
static int choose_every(const char *option, int64_t asked, int64_t resumed, int64_t otherwise, int64_t *every,
                        struct message *message)
{
    if (asked > 0 && resumed > 0 && asked != resumed)
        return message_set(message, "%s: %lld is not the %lld of the run that is resumed; leave it out", option,
                           (long long)asked, (long long)resumed);
    *every = resumed > 0 ? resumed : asked > 0 ? asked : otherwise;
    return 0;
}

static int take_bytes(struct run *run, const unsigned char *bytes, size_t size)
{
    int64_t count;
    double *more = travel_state(&run->travel, &count);
    return checkpoint_take(bytes, size, &run->checkpoint, &run->model.bodies, &run->verdict, more, count);
}

/** The end of a complete run, in its HDF5 file. Returns 1, 0 if there is no such file, or -1. */
static int open_restart(struct run *run, char path[FOLDER_PATH], struct message *message)
{
    struct run_restart restart;
    struct message difference;
    if (folder_output(run->files.folder, run->files.hdf5, 0, path, message) != 0)
        return -1;
    int result = run_restart_find(path, &restart, message);
    if (result > 0 && !identity_is(restart.identity, strlen(restart.identity), run->record.identity, &difference))
        result = identity_refuse(path, "run", &difference, message);
    else if (result > 0 && take_bytes(run, restart.bytes, restart.size) != 0)
        result = message_set(message,
                             "%.600s: is damaged; start anew without --resume, or choose another place with -o", path);
    run->record.judgement.verdict = restart.verdict; /* of the end that it has */
    run_restart_free(&restart);
    return result;
}

/** That of a run that was interrupted. Returns 1 or -1. */
static int take_checkpoint(struct run *run, struct message *message)
{
    size_t size;
    unsigned char *bytes = checkpoint_read(&run->journal, &size, message);
    if (bytes == NULL)
        return -1;
    const int taken = take_bytes(run, bytes, size) == 0;
    free(bytes);
    return taken ? 1 : keep_damaged(&run->journal.keep, "is damaged: its checkpoint is of other bodies", message);
}

/** How many rows a run has if nobody says: where steps have to be ended for them, as many as frames. A row costs as
 *  much as three to six steps, and one thread does it: of many bodies a step in ten is enough. */
static int64_t about_rows(const struct run *run)
{
    enum { FEW = 100, USUAL = 1000, STEPS = 10 };
    struct travel_tally tally;
    const int64_t tenth = run->steps / STEPS < USUAL ? run->steps / STEPS : USUAL;
    if (travel_tally(&run->travel, &tally))
        return FEW;
    return run->model.bodies.count < MANY ? USUAL : tenth > FEW ? tenth : FEW;
}

/** Whether the files of a complete run are all that are asked for: a file may have been removed, or OUT.xdmf be wanted
 *  now. */
static int has_files(const struct run *run)
{
    const int64_t frames = run->checkpoint.frames.count + 1; /* that of the end follows the checkpoint */
    return run_files_are_there(&run->files, frames);
}

/** A complete run goes on from its file at path. What it is has to be in the journal at once: if it is killed before
 *  the first checkpoint, another run would else be taken for it, and replace its files. */
static int go_on(struct run *run, const char *path, struct message *message)
{
    int64_t count;
    char contacts[FOLDER_PATH];
    const double *more = travel_state(&run->travel, &count);
    if (run_files_contacts(&run->files, contacts, message) != 0 ||
        run_restart_fill(path, contacts, &run->record, &run->checkpoint, message) != 0)
        return -1;
    return checkpoint_write(&run->journal, &run->checkpoint, &run->model.bodies, &run->verdict, more, count, message);
}

/** Where the run begins, and with what in its journal. */
static int open_checkpoint(struct run *run, struct message *message)
{
    char path[FOLDER_PATH];
    struct checkpoint *c = &run->checkpoint;
    const struct journal_marks none = {journal_mark_start(run->record.columns.count),
                                       journal_mark_start(run->record.frames.doubles),
                                       journal_mark_start(run->request->contacts ? TOUCH_DOUBLES : 0)};
    int found = 0;
    if (run->journal.keep.holds)
        found = take_checkpoint(run, message);
    else if (run->request->resume)
        found = run->restored = open_restart(run, path, message);
    /* a run that came to no checkpoint has begun to replace whatever is there; but what is taken in part is no start */
    if (found < 0 && !run->journal.keep.holds && run->journal.keep.there && c->step == 0)
        found = run->restored = 0;
    if (found < 0)
        return -1;
    run->from = c->step;
    travel_resume(&run->travel, run->from);
    run->done = run->restored && run->from == run->steps && has_files(run);
    if (run->steps < run->from)
        return message_set(message, "--t-end: %s lies before the %s at t = %.10g; give that or more",
                           NUMBER(run->scene.t_end), run->restored ? "end of the run" : "checkpoint",
                           (double)run->from * run->scene.h);
    if (choose_every("--record", run->request->record_every, c->record_every,
                     interval_choose(run->scene.h, run->steps, about_rows(run)), &c->record_every, message) != 0)
        return -1;
    const struct journal_marks there = {c->rows, c->frames, c->touches};
    const int nobody_says = run->request->frames_every == 0 && c->frames_every == 0;
    if (choose_every("--frames", run->request->frames_every, c->frames_every,
                     nobody_says ? sizes_frames(run, &run->fit) : 0, &c->frames_every, message) != 0 ||
        journal_start(&run->journal, run->restored || !found ? &none : &there, message) != 0)
        return -1;
    return run->restored && !run->done ? go_on(run, path, message) : 0;
}

int run_open(const struct run_request *request, struct run *run, struct message *message)
{
    memset(run, 0, sizeof *run);
    run->request = request;
    hdf5_start();
    if (open_scene(run, message) != 0)
        return -1;
    run->record.model = run->shown;
    run->record.stepper = run->scene.stepper;
    run->record.h = run->scene.h;
    run->record.journal = &run->journal;
    columns_of(&run->model, run->scene.stepper, &run->record.columns);
    if (verdict_create(&run->verdict, &run->model, run->scene.stepper, run->scene.h, &run->record.columns, message) !=
        0)
        return -1;
    frame_layout_of(run->shown, request->fields, &run->record.frames);
    run->record.frames.number = run->renumbering.number;
    run->record.frames.booking = &run->model;
    if (open_files(run, message) != 0 || open_checkpoint(run, message) != 0)
        return -1;
    run->kept = run->journal.keep.holds;
    return 0;
}

void run_close(struct run *run)
{
    journal_end(&run->journal, !run->kept);
    free(run->record.identity);
    verdict_destroy(&run->verdict);
    travel_destroy(&run->travel);
    model_destroy(&run->model);
    model_destroy(&run->unsorted);
    renumber_destroy(&run->renumbering);
    tables_destroy(&run->tables);
}
