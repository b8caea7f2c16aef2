/* SPDX-License-Identifier: BSD-3-Clause */
#include "reference.h"

#include <math.h>
#include <string.h>

int reference_is_smooth(const struct model *model)
{
    enum { FEW = 256 }; /* doubles in a state: as many are interpolated at every step of every run */
    return !model->scene->has_contact && !model->scene->has_wall && equations_width(model) <= FEW;
}

/* ---- sharing ---------------------------------------------------------------------------------------------------------- */

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

static int create_smooth(struct model *model, double t_end, MPI_Comm comm, int rank, struct smooth *s,
                         struct message *message)
{
    int failed = smooth_create(s, model, message);
    if (failed == 0 && rank == 0)
        failed = smooth_integrate(s, t_end, message);
    if (anywhere(failed, comm) != 0)
        return -1;
    int64_t size[2] = {s->panels.width, s->panels.count};
    MPI_Bcast(size, 2, MPI_INT64_T, 0, comm);
    if (rank != 0 && panels_create(&s->panels, size[0], size[1], t_end) != 0)
        failed = message_set(message, "%s: out of memory for the reference solution", model->scene->name);
    if (anywhere(failed, comm) != 0)
        return -1;
    broadcast(s->panels.values, size[0] * size[1] * PANELS_NODES, comm);
    return 0;
}

static int create_sampled(struct model *model, double t_end, double interval, MPI_Comm comm, int rank,
                          struct sampled *s, struct message *message)
{
    int failed = sampled_create(s, model, interval, llrint(t_end / interval), message);
    if (anywhere(failed, comm) != 0)
        return -1;
    if (rank == 0)
        failed = sampled_integrate(s, message);
    if (anywhere(failed, comm) != 0)
        return -1;
    broadcast(s->states, s->count * s->width, comm);
    return 0;
}

int reference_create(struct model *model, double t_end, double interval, MPI_Comm comm, struct reference *r,
                     struct message *message)
{
    int rank;
    MPI_Comm_rank(comm, &rank);
    memset(r, 0, sizeof *r);
    r->interval = interval;
    const int failed = interval == 0.0 ? create_smooth(model, t_end, comm, rank, &r->smooth, message)
                                       : create_sampled(model, t_end, interval, comm, rank, &r->sampled, message);
    if (failed != 0) {
        reference_destroy(r);
        return -1;
    }
    r->energy_error = interval == 0.0 ? r->smooth.energy_error : r->sampled.energy_error;
    r->uncertainty = interval == 0.0 ? r->smooth.interpolation_error : r->sampled.spread;
    broadcast(&r->energy_error, 1, comm);
    broadcast(&r->uncertainty, 1, comm);
    return 0;
}

void reference_destroy(struct reference *r)
{
    smooth_destroy(&r->smooth);
    sampled_destroy(&r->sampled);
}

/* ---- reading ---------------------------------------------------------------------------------------------------------- */

vti_bodies reference_at(struct reference *r, double t)
{
    return r->interval == 0.0 ? smooth_at(&r->smooth, t) : sampled_state(&r->sampled, llrint(t / r->interval));
}

double reference_norm_squared(struct reference *r, double t)
{
    if (r->interval == 0.0)
        return smooth_norm_squared(&r->smooth, t);
    return r->sampled.states[(llrint(t / r->interval) + 1) * r->sampled.width - 1];
}
