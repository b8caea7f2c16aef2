/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "run.h"

#include <stdlib.h>
#include <string.h>

#include "fields.h"
#include "hdf5_sink.h"
#include "interval.h"
#include "loop.h"
#include "number.h"
#include "run_identity.h"
#include "run_restart.h"
#include "run_signals.h"
#include "travel.h"

/* ---- opening ----------------------------------------------------------------------------------------------------- */

static int open_scene(struct run *run, struct message *message)
{
    const struct run_request *r = run->request;
    if (scene_read(r->scene, r->sets, r->sets_count, &run->scene, message) != 0 ||
        tables_read(&run->scene, &run->tables, message) != 0 || model_create(&run->scene, &run->model, message) != 0)
        return -1;
    run->steps = loop_steps(run->scene.t_end, run->scene.h);
    run->resumable = method_rival(run->scene.stepper) == NULL;
    if (r->resume && !run->resumable)
        return message_set(message,
                           "--resume: %s keeps what no checkpoint holds, so that no run by it can go on; start it "
                           "anew without --resume",
                           run->scene.stepper->name);
    if (fields_check(r->fields, &run->model, message) != 0)
        return -1;
    if (run->steps < 1)
        return message_set(message, "h = %s is longer than t_end = %s: no step fits; give a smaller h or a later t_end",
                           NUMBER(run->scene.h), NUMBER(run->scene.t_end));
    return run_identity(r->scene, r->sets, r->sets_count, &run->model, &run->checkpoint.identity, message);
}

static int name_journal(struct run *run, struct message *message)
{
    char stem[FOLDER_PATH];
    snprintf(stem, sizeof stem, "%s", run->output);
    stem[strlen(stem) - strlen(run->files.hdf5) + strlen(run->files.stem)] = '\0';
    return journal_name(&run->journal, stem, message);
}

static int open_files(struct run *run, struct message *message)
{
    const int asked = run->request->output != NULL;
    snprintf(run->output, sizeof run->output, "%s%s", asked ? run->request->output : run->scene.name,
             asked ? "" : ".h5");
    if (run_files_name(&run->files, run->output, run->request->dump, message) != 0 || name_journal(run, message) != 0)
        return -1;
    run->files.force = run->request->force;
    run->files.xdmf = run->request->xdmf;
    run->files.inputs = run->inputs;
    run->files.inputs_count = inputs_of(run->request->scene, &run->scene, run->inputs);
    if (run_files_check(&run->files, message) != 0)
        return -1;
    const int there = journal_look(&run->journal, message);
    if (there < 0)
        return -1;
    run->kept = there == JOURNAL_RUN;
    run->early = there == JOURNAL_EARLY;
    if (run->kept && !run->request->resume)
        return message_set(
            message, "%s: holds a run that was interrupted; go on with it by --resume, or delete it to start anew",
            run->journal.folder);
    /* before hours of computing, not after */
    return folder_create(run->files.folder, message);
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

/** The end of a complete run, in its HDF5 file. Returns 1, 0 if there is no such file, or -1. */
static int open_restart(struct run *run, struct message *message)
{
    char path[FOLDER_PATH];
    unsigned char *bytes;
    size_t size = 0;
    const struct identity identity = run->checkpoint.identity;
    if (folder_output(run->files.folder, run->files.hdf5, 0, path, message) != 0)
        return -1;
    int result = run_restart_find(path, &bytes, &size, message);
    if (result > 0 && checkpoint_take(bytes, size, path, NULL, &identity, &run->scene, &run->checkpoint,
                                      &run->model.bodies, &run->verdict, message) != 0)
        result = -1;
    free(bytes);
    return result;
}

/** The journal, with what a complete run has recorded if it is that which goes on. */
static int open_journal(struct run *run, struct message *message)
{
    const struct checkpoint *c = &run->checkpoint;
    char path[FOLDER_PATH];
    if (!run->restored)
        return journal_open(&run->journal, c->rows, c->frames, message);
    if (journal_open(&run->journal, journal_mark_start(c->rows.doubles), journal_mark_start(c->frames.doubles),
                     message) != 0 ||
        folder_output(run->files.folder, run->files.hdf5, 0, path, message) != 0)
        return -1;
    return run->done ? 0 : run_restart_fill(path, &run->record, c, message);
}

static int open_checkpoint(struct run *run, struct message *message)
{
    const struct identity identity = run->checkpoint.identity;
    struct checkpoint *c = &run->checkpoint;
    int found = 0;
    if (run->request->resume && run->kept)
        found = checkpoint_read(&run->journal, &identity, &run->scene, c, &run->model.bodies, &run->verdict, message);
    else if (run->request->resume)
        found = run->restored = open_restart(run, message);
    if (found < 0 && run->early) /* that run has begun to replace whatever is there */
        found = run->restored = 0;
    if (found < 0)
        return -1;
    run->from = c->step;
    run->done = run->restored && run->from == run->steps;
    if (!found) {
        c->rows = journal_mark_start(run->record.columns.count);
        c->frames = journal_mark_start(run->record.frames.doubles);
    }
    if (found && (c->rows.doubles != run->record.columns.count || c->frames.doubles != run->record.frames.doubles))
        return message_set(message, "%s: records other quantities than this program does; delete it and start anew",
                           run->journal.folder);
    if (run->steps < run->from)
        return message_set(message, "--t-end: %s lies before the %s at t = %.10g; give that or more",
                           NUMBER(run->scene.t_end), run->restored ? "end of the run" : "checkpoint",
                           (double)run->from * run->scene.h);
    if (choose_every("--record", run->request->record_every, c->record_every,
                     interval_choose(run->scene.h, run->steps, 1000), &c->record_every, message) != 0)
        return -1;
    return choose_every("--frames", run->request->frames_every, c->frames_every,
                        interval_choose(run->scene.h, run->steps, 100), &c->frames_every, message);
}

int run_open(const struct run_request *request, struct run *run, struct message *message)
{
    memset(run, 0, sizeof *run);
    run->request = request;
    hdf5_start();
    if (open_scene(run, message) != 0)
        return -1;
    run->record.model = &run->model;
    run->record.stepper = run->scene.stepper;
    run->record.h = run->scene.h;
    run->record.journal = &run->journal;
    run->record.fields = request->fields;
    columns_of(&run->model, run->scene.stepper, &run->record.columns);
    if (verdict_create(&run->verdict, &run->model, run->scene.stepper, run->scene.h, &run->record.columns, message) !=
        0)
        return -1;
    frame_layout_of(&run->model, &run->record.frames);
    run->frame = malloc(sizeof *run->frame * (size_t)run->record.frames.doubles);
    if (run->frame == NULL)
        return message_set(message, "%s: out of memory; use fewer bodies", run->scene.name);
    if (open_files(run, message) != 0 || open_checkpoint(run, message) != 0)
        return -1;
    run_signals_catch(); /* until here a signal ends the program, and nothing has to be cleared away */
    run->begun = 1;
    return open_journal(run, message);
}

void run_close(struct run *run)
{
    if (run->begun && !run->kept)
        journal_remove(&run->journal);
    else
        journal_close(&run->journal);
    free(run->frame);
    run->frame = NULL;
    verdict_destroy(&run->verdict);
    model_destroy(&run->model);
    tables_destroy(&run->tables);
}
