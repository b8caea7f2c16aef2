/* SPDX-License-Identifier: BSD-3-Clause */
#include "sampled_pair.h"

#include "sampled_stream.h"

enum { TAG_SPREAD = 3 };

static int lead(struct stream *stream, const struct watch *watch, struct message *message)
{
    struct sampled *s = stream->sampled;
    const int failed = sampled_lead(stream, watch, message);
    stream_close(stream);
    MPI_Send(&s->energy_error, 1, MPI_DOUBLE, 1, TAG_SPREAD, stream->comm);
    MPI_Recv(&s->spread, 1, MPI_DOUBLE, 1, TAG_SPREAD, stream->comm, MPI_STATUS_IGNORE);
    return failed;
}

/** Takes all states whatever happens to its own solution. */
static int follow(struct stream *stream, const struct watch *watch, struct message *message)
{
    struct sampled *s = stream->sampled;
    const int failed = sampled_follow(stream, watch, message);
    stream_close(stream);
    MPI_Recv(&s->energy_error, 1, MPI_DOUBLE, 0, TAG_SPREAD, stream->comm, MPI_STATUS_IGNORE);
    MPI_Send(&s->spread, 1, MPI_DOUBLE, 0, TAG_SPREAD, stream->comm);
    return stream->states < s->count ? 0 : failed; /* why nothing more comes rank 0 says */
}

int pair_integrate(struct sampled *s, MPI_Comm comm, const struct watch *watch, struct message *message)
{
    struct stream stream;
    stream_open(&stream, s, comm, 2);
    return stream.rank == 0 ? lead(&stream, watch, message) : follow(&stream, watch, message);
}
