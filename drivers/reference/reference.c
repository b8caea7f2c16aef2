/* SPDX-License-Identifier: BSD-3-Clause */
#include "reference.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sampled_pair.h"
#include "stepped.h"

int reference_is_smooth(const struct model *model)
{
    enum { FEW = 256 }; /* doubles in a state: as many are interpolated at every step of every run */
    return scene_first_with(model->scene, EFFECT_KINKED) == NULL && model_dissipates(model) == NULL &&
           equations_width(model) <= FEW;
}

/** Where a reference is made. */
struct place {
    MPI_Comm comm;
    int rank;
    const struct watch *watch;
};

/* ---- sharing ----------------------------------------------------------------------------------------------------- */

/** MPI counts are int: large arrays travel in pieces. */
static void broadcast(double *p, int64_t n, MPI_Comm comm)
{
    for (int64_t done = 0; done < n;) {
        const int64_t left = n - done;
        const int piece = left < (1 << 24) ? (int)left : 1 << 24;
        MPI_Bcast(p + done, piece, MPI_DOUBLE, 0, comm);
        done += piece;
    }
}

/** The lowest of failed over all ranks. */
static int anywhere(int failed, MPI_Comm comm)
{
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, comm);
    return failed;
}

/** What rank 0 found: the one window that there is, or where each of several starts. */
static void share_panels(struct smooth *s, MPI_Comm comm)
{
    if (s->windows == 1) {
        broadcast(s->panels.values, s->panels.count * s->panels.width * PANELS_NODES, comm);
        s->window = 0;
    } else
        broadcast(s->starts, s->windows * (SMOOTH_START + equations_width(s->model)), comm);
}

/** By rank 0, and by rank 1, if there is one, the other solution meanwhile: into other. */
static int integrate_smooth(struct smooth *s, const struct reference_span *span, const struct place *place,
                            double *other, struct message *message)
{
    enum { TAG_OTHER = 5 };
    const int size = (int)(SMOOTH_SAMPLES * equations_width(s->model));
    int ranks, failed = 0;
    MPI_Comm_size(place->comm, &ranks);
    if (place->rank == 0)
        failed = smooth_integrate(s, span->t_end, span->bytes, place->watch, message);
    if (failed == 0 && place->rank == (ranks > 1))
        failed = smooth_looser(s->model, span->t_end, other, place->watch, message);
    if ((failed = anywhere(failed, place->comm)) != 0)
        return failed;
    if (ranks > 1 && place->rank == 1)
        MPI_Send(other, size, MPI_DOUBLE, 0, TAG_OTHER, place->comm);
    if (ranks > 1 && place->rank == 0)
        MPI_Recv(other, size, MPI_DOUBLE, 1, TAG_OTHER, place->comm, MPI_STATUS_IGNORE);
    if (place->rank == 0)
        s->spread = smooth_spread(s, other);
    return 0;
}

static int create_smooth(struct model *model, const struct reference_span *span, const struct place *place,
                         struct smooth *s, struct message *message)
{
    double *const other = calloc((size_t)(SMOOTH_SAMPLES * equations_width(model)), sizeof *other);
    int failed = smooth_create(s, model, message);
    if (failed == 0 && other == NULL)
        failed = scene_no_memory(model->scene, message);
    failed = anywhere(failed, place->comm);
    if (failed == 0)
        failed = integrate_smooth(s, span, place, other, message);
    free(other);
    if (failed != 0)
        return failed;
    int64_t size[2] = {s->panels.count, s->panels.held};
    MPI_Bcast(size, 2, MPI_INT64_T, 0, place->comm);
    if (place->rank != 0 && smooth_resize(s, size[0], size[1], span->t_end) != 0)
        failed = message_set(message, "%s: out of memory for the reference solution; give less of it with --memory",
                             model->scene->name);
    if ((failed = anywhere(failed, place->comm)) != 0)
        return failed;
    share_panels(s, place->comm);
    return 0;
}

/** The states of a model without dissipation, by GSL. */
static int integrate(struct sampled *s, const struct place *place, int ranks, struct message *message)
{
    int failed = 0;
    if (ranks > 1 && place->rank < 2)
        failed = sampled_pair_integrate(s, place->comm, place->watch, message);
    else if (ranks == 1) {
        failed = sampled_solve(s, NULL, place->watch, message);
        failed = failed == 0 ? sampled_compare(s, NULL, place->watch, message) : failed;
    }
    return failed;
}

static int create_sampled(struct model *model, const struct reference_span *span, const struct place *place,
                          struct sampled *s, struct message *message)
{
    int failed = sampled_create(s, model, span->interval, llrint(span->t_end / span->interval), message);
    if ((failed = anywhere(failed, place->comm)) != 0)
        return failed;
    int ranks;
    const int dissipates = model_dissipates(model) != NULL;
    MPI_Comm_size(place->comm, &ranks);
    if (!dissipates)
        failed = integrate(s, place, ranks, message);
    else if (place->rank == 0)
        failed = stepped_solve(s, span->finest, place->watch, message);
    if ((failed = anywhere(failed, place->comm)) != 0)
        return failed;
    if (ranks > (dissipates ? 1 : 2))
        broadcast(s->states, s->count * s->width, place->comm);
    return 0;
}

/** A pass of an integration as a stage of a study. */
struct stage {
    const struct study_watch *watch;
    double start, share;
    int rank;
};

static int see_pass(void *self, double share)
{
    struct stage *stage = self;
    if (share < stage->share)
        stage->start = MPI_Wtime(); /* of the next pass */
    stage->share = share;
    if (stage->rank == 0)
        study_show(stage->watch, "reference", (int64_t)(1e6 * share), 1000000, MPI_Wtime() - stage->start);
    return study_asked(stage->watch);
}

static int create(struct model *model, const struct reference_span *span, const struct place *place,
                  struct reference *r, struct message *message)
{
    const double interval = span->interval;
    const vti_effect *dissipates = model_dissipates(model);
    memset(r, 0, sizeof *r);
    if (dissipates != NULL && !(span->finest > 0.0))
        return message_set(message,
                           "%s: %s dissipates, and price lists compare with others' methods, which have forces alone; "
                           "leave --cost out",
                           model->scene->name, dissipates->name);
    r->interval = interval;
    const int failed = interval == 0.0 ? create_smooth(model, span, place, &r->smooth, message)
                                       : create_sampled(model, span, place, &r->sampled, message);
    if (failed != 0) {
        reference_destroy(r);
        return failed;
    }
    r->energy_error = interval == 0.0 ? r->smooth.energy_error : r->sampled.energy_error;
    r->uncertainty = interval == 0.0 ? fmax(r->smooth.interpolation_error, r->smooth.spread) : r->sampled.spread;
    if (interval == 0.0 && r->smooth.rounding > r->uncertainty)
        r->uncertainty = r->rounding = r->smooth.rounding;
    broadcast(&r->energy_error, 1, place->comm);
    broadcast(&r->uncertainty, 1, place->comm);
    broadcast(&r->rounding, 1, place->comm);
    return 0;
}

int reference_create(struct model *model, const struct reference_span *span, MPI_Comm comm,
                     const struct study_watch *watch, struct reference *r, struct message *message)
{
    struct stage stage = {watch, MPI_Wtime(), 0.0, 0};
    MPI_Comm_rank(comm, &stage.rank);
    const struct watch on_pass = {see_pass, &stage};
    const struct place place = {comm, stage.rank, &on_pass};
    return create(model, span, &place, r, message);
}

int reference_alone(struct model *model, const struct reference_span *span, const struct watch *watch,
                    struct reference *r, struct message *message)
{
    const struct place place = {MPI_COMM_SELF, 0, watch};
    return create(model, span, &place, r, message);
}

void reference_destroy(struct reference *r)
{
    smooth_destroy(&r->smooth);
    sampled_destroy(&r->sampled);
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

int reference_seek(struct reference *r, double t, const struct watch *watch, struct message *message)
{
    return r->interval == 0.0 ? smooth_seek(&r->smooth, t, watch, message) : 0;
}

vti_bodies reference_at(struct reference *r, double t)
{
    return r->interval == 0.0 ? smooth_at(&r->smooth, t) : sampled_state(&r->sampled, llrint(t / r->interval));
}

const vti_bodies *reference_state(struct reference *r, double t)
{
    return sampled_step(&r->sampled, llrint(t / r->interval));
}

int reference_block(struct reference *r, double h, int64_t step, const struct watch *watch, const double **states,
                    int64_t *count, struct message *message)
{
    const int failed = smooth_seek(&r->smooth, (double)step * h, watch, message);
    if (failed == 0)
        *states = smooth_block(&r->smooth, h, step, count);
    return failed;
}

double reference_norm_squared(struct reference *r, double t)
{
    if (r->interval == 0.0)
        return smooth_norm_squared(&r->smooth, t);
    return r->sampled.states[(llrint(t / r->interval) + 1) * r->sampled.width - 1];
}
