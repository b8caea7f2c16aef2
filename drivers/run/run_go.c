/* SPDX-License-Identifier: BSD-3-Clause
 * A run while it goes: who looks at the bodies, and what happens at the end. */
#include "run.h"

#include <math.h>
#include <stdlib.h>

#include "clock.h"
#include "number.h"
#include "signals.h"
#include "state.h"
#include "step_errors.h"
#include "touch_forces.h"

static int stop(struct run *run, enum run_end end)
{
    run->end = end;
    return 1;
}

/* ---- NaN and infinities ------------------------------------------------------------------------------------------ */

/** The first column that should be a number and is none, of all columns but energies of what is not known, which are
 *  NaN; -1 if there is none. Momenta may be infinite where energies are not. */
static int first_broken(const struct columns *columns, const double *row)
{
    for (int c = 0; c < columns->count; ++c)
        if (c <= columns->total ? !isfinite(row[c]) : isinf(row[c]) != 0)
            return c;
    return -1;
}

/** Ends the run at a state that is not finite, or whose energies or momenta are not; row may be NULL. */
static int broken(struct run *run, int64_t step, double t, const vti_bodies *bodies, const double *row)
{
    const struct columns *columns = &run->record.columns;
    const double square_root_of_infinity = 1e154;
    struct message what;
    if (state_watch(run_shown(run, bodies), square_root_of_infinity, &what) == 0) {
        const int c = row != NULL ? first_broken(columns, row) : -1;
        message_set(&what, "all bodies are finite, but '%s' is %g", columns->name[c < 0 ? columns->total : c],
                    c < 0 ? 0.0 : number_plain(row[c]));
    }
    if (step == 0)
        message_set(run->message,
                    "%s: the start (t = 0): %.200s; the scene begins with numbers too large: smaller ones",
                    run->scene.name, what.text);
    else
        message_set(run->message, "%s at h = %s: step %lld (t = %.10g): %.200s; reduce %s", run->scene.stepper->name,
                    NUMBER(run->scene.h), (long long)step, t, what.text,
                    run->scene.tolerance > 0.0 ? "the tolerance" : "h");
    return stop(run, RUN_BROKEN);
}

/* ---- observers --------------------------------------------------------------------------------------------------- */

static int save(struct run *run, int64_t step, double t, const vti_bodies *bodies)
{
    struct message ignored = {""};
    int64_t count;
    if (state_watch(bodies, INFINITY, &ignored) != 0)
        return broken(run, step, t, bodies, NULL);
    const double *more = travel_state(&run->travel, &count);
    run->checkpoint.step = step;
    run->saved = clock_now();
    if (checkpoint_write(&run->journal, &run->checkpoint, bodies, &run->verdict, more, count, run->message) != 0)
        return stop(run, RUN_FAILED);
    run->kept = 1;
    return 0;
}

struct poll {
    struct run *run;
    const struct run_watch *watch;
    int looks;     /* at this step */
    int64_t asked; /* poll_wants */
};

/** Signals come at any time: what is decided here holds until poll is called. */
static int poll_looks(void *self, int64_t step)
{
    struct poll *p = self;
    const struct run *run = p->run;
    p->looks = step == run->steps || signals_seen() != NULL || step % run->poll_every == 0;
    return p->looks;
}

/** Of steps of variable length: rows and frames may be far away. */
static int poll_wants(void *self)
{
    enum { SELDOM = 16 }; /* a step of one body takes as long as a few looks at the clock */
    struct poll *p = self;
    const struct run *run = p->run;
    return signals_seen() != NULL ||
           (++p->asked % SELDOM == 0 && clock_now() - run->saved >= run->request->checkpoint_seconds);
}

/** Saves on the way, and says so. */
static int save_by_the_way(const struct poll *p, int64_t step, double t, const vti_bodies *bodies)
{
    struct run *run = p->run;
    if (save(run, step, t, bodies) != 0)
        return 1;
    const double seconds = run->saved - run->began, done = (double)(step - run->from);
    p->watch->saved(step, run->steps, t, done > 0.0 ? seconds * (double)(run->steps - step) / done : INFINITY, seconds);
    return 0;
}

/** Sees the bodies before the recorders do, so that the checkpoint's step is the first that is not yet in the journal;
 *  see_step has looked. */
static int poll(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    const struct poll *p = self;
    struct run *run = p->run;
    if (!p->looks)
        return 0;
    if (step == run->steps)
        return save(run, step, t, bodies);
    if (signals_seen() != NULL && step == 0)
        return stop(run, RUN_ENDED);
    if (signals_seen() != NULL) {
        if (save(run, step, t, bodies) != 0)
            return 1;
        message_set(run->message,
                    "%s: stopped at step %lld of %lld (t = %.10g); the same command with --resume goes on",
                    signals_seen(), (long long)step, (long long)run->steps, t);
        return stop(run, RUN_STOPPED);
    }
    if (step % run->poll_every != 0)
        return 0;
    p->watch->progress(step - run->from, run->steps - run->from, clock_now() - run->began);
    return clock_now() - run->saved >= run->request->checkpoint_seconds ? save_by_the_way(p, step, t, bodies) : 0;
}

static int see_row(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct run *run = self;
    double row[COLUMNS];
    verdict_row(&run->verdict, t, bodies, row);
    if (first_broken(&run->record.columns, row) >= 0)
        return broken(run, step, t, bodies, row);
    if (run->model.errors != NULL)
        step_errors_row(run->model.errors);
    return journal_add(&run->journal, &run->journal.rows, row, run->message) != 0 ? stop(run, RUN_FAILED) : 0;
}

/** The bodies with forces and moments of their own, which are those at their positions: what a stepper has left in the
 *  model's are, for some steppers, those of other positions. */
static int with_loads(struct run *run, const vti_bodies *bodies, struct fork *fork)
{
    const struct frame_layout *layout = &run->record.frames;
    const int wanted = layout->force != 0 || layout->moment != 0;
    if (state_fork_create(fork, bodies, wanted ? OWN_FORCE | OWN_MOMENT : 0) != 0)
        return scene_no_memory(&run->scene, run->message);
    const int status = wanted ? model_forces(&run->model, &fork->bodies) : VTI_OK;
    return status == VTI_OK ? 0 : message_set(run->message, "%s: %s", run->scene.name, model_text(&run->model, status));
}

/** What touches in the frame that comes next, while bodies and springs are as they are. */
static int add_touches(struct run *run, const vti_bodies *bodies)
{
    struct touch_list list = {0, 0, NULL};
    struct journal *journal = &run->journal;
    double row[TOUCH_DOUBLES];
    if (!run->request->contacts)
        return 0;
    const int status = model_find_pairs(&run->model, bodies);
    if (status != VTI_OK)
        return message_set(run->message, "%s: %s", run->scene.name, model_text(&run->model, status));
    int failed = touch_forces_find(&run->model, bodies, &list);
    if (failed != 0)
        scene_no_memory(&run->scene, run->message);
    for (int64_t k = 0; k < list.count && failed == 0; ++k) {
        record_touch(journal->frames.mark.count, &list.touch[k], row);
        failed = journal_add(journal, &journal->touches, row, run->message);
    }
    touch_forces_free(&list);
    return failed;
}

static int see_frame(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct run *run = self;
    struct message ignored = {""};
    struct fork fork;
    if (state_watch(bodies, INFINITY, &ignored) != 0)
        return broken(run, step, t, bodies, NULL);
    double *frame = malloc(sizeof *frame * (size_t)run->record.frames.doubles); /* not beside a checkpoint's state */
    int failed = with_loads(run, bodies, &fork);
    if (frame == NULL)
        failed = scene_no_memory(&run->scene, run->message);
    if (failed == 0)
        failed = add_touches(run, &fork.bodies);
    if (failed == 0) {
        frame_take(&run->record.frames, step, t, &fork.bodies, frame);
        failed = journal_add(&run->journal, &run->journal.frames, frame, run->message);
    }
    free(fork.memory);
    free(frame);
    return failed != 0 ? stop(run, RUN_FAILED) : 0;
}

/** It looks at no velocities: what bonds turn by, verdict_step, is seen by the attitudes. */
static int look_at_step(struct run *run, double t, const vti_bodies *bodies)
{
    struct travel_tally tally;
    if (travel_tally(&run->travel, &tally))
        verdict_longest(&run->verdict, tally.longest);
    verdict_step(&run->verdict, t, bodies);
    return 0;
}

/** Before the checkpoint, so that a run that goes on from it does not look again: the forces that a stepper leaves may
 *  be those of other positions, and the run finds those of its positions as it begins. */
static int see_step(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct run *run = self;
    const int seen = step == run->from && step > 0;
    return step % run->look_every == 0 && !seen ? look_at_step(run, t, bodies) : 0;
}

/** After it, an end between two looks, which a run with a later end does not have. */
static int see_end(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct run *run = self;
    return step % run->look_every != 0 ? look_at_step(run, t, bodies) : 0;
}

/* ---- the end ----------------------------------------------------------------------------------------------------- */

static int measure_drift(void *self, int64_t first, int64_t count, const double *rows)
{
    struct run *run = self;
    const int columns = run->record.columns.count, total = run->record.columns.total;
    for (int64_t k = 0; k < count; ++k) {
        const double energy = rows[k * columns + total];
        if (first + k == 0)
            run->energy0 = energy;
        run->energy1 = energy;
        run->drift = fmax(run->drift, fabs(energy - run->energy0));
        run->t = rows[k * columns];
    }
    return 0;
}

static enum run_end write_files(struct run *run)
{
    struct message problem;
    run->record.complete = run->end == RUN_COMPLETE;
    run->record.judgement = verdict_judge(&run->verdict, run->end == RUN_BROKEN, &run->judgement);
    verdict_destroy(&run->verdict); /* its bodies' memory serves the files */
    if (journal_flush(&run->journal, run->message) != 0)
        return RUN_FAILED;
    if (record_rows(&run->record, measure_drift, run, &problem) == 0 &&
        run_files_write(&run->files, &run->record, &problem) == 0) {
        run->kept = 0;
        return run->end;
    }
    if (run->journal.keep.holds)
        message_set(run->message, "%.600s; the run is kept in %.300s: when that is mended go on with --resume",
                    problem.text, run->journal.keep.path);
    else
        message_set(run->message, "%.600s; when that is mended start anew", problem.text);
    return RUN_FAILED;
}

/** Steps between looks: each, or, where a look ends a step that would be longer, what rows and frames both need. */
static int64_t find_look_every(const struct run *run)
{
    struct travel_tally tally;
    int64_t every = run->checkpoint.record_every, other = run->checkpoint.frames_every;
    if (!travel_tally(&run->travel, &tally))
        return 1;
    while (other != 0) {
        const int64_t rest = every % other;
        every = other;
        other = rest;
    }
    return every;
}

enum run_end run_go(struct run *run, const struct run_watch *watch, struct message *message)
{
    enum { POLL_BODIES = 8192, OBSERVERS = 5 };
    struct poll poller = {run, watch, 1, 0};
    const int64_t every = run->look_every = find_look_every(run);
    const struct observer observers[OBSERVERS] = {{see_step, run, every, 1, loop_never_looks, NULL},
                                                  {poll, &poller, every, 1, poll_looks, poll_wants},
                                                  {see_end, run, every, 1, loop_never_looks, NULL},
                                                  {see_row, run, run->checkpoint.record_every, 0, NULL, NULL},
                                                  {see_frame, run, run->checkpoint.frames_every, 0, NULL, NULL}};
    run->message = message;
    run->end = RUN_COMPLETE;
    run->began = run->saved = clock_now();
    run->poll_every = travel_pause(&run->travel, POLL_BODIES);
    if (travel_show(&run->travel, run->steps - run->from, observers, OBSERVERS, message) < 0)
        run->end = RUN_BROKEN;
    if (run->end == RUN_BROKEN && run->journal.rows.mark.count == 0) {
        run->end = RUN_FAILED; /* nothing has happened that files could tell of */
        run->kept = 0;
    }
    if (run->end == RUN_ENDED)
        run->kept = 0;
    if (run->end == RUN_FAILED && run->journal.rows.mark.count > 0)
        run->kept = 1; /* --resume begins it again, whatever run the files are of */
    if (run->end == RUN_COMPLETE || run->end == RUN_BROKEN)
        run->end = write_files(run);
    run->seconds = clock_now() - run->began;
    return run->end;
}
