/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A checkpoint of a run, in the journal's folder: what run it is, how far it is, and the state of the bodies. It is
 * written under a temporary name, brought to the disk and renamed, so that there is always a whole one. */
#ifndef VTI_CHECKPOINT_H
#define VTI_CHECKPOINT_H

#include "journal.h"
#include "scene.h"
#include "verdict.h"

/** What a run is; a checkpoint goes on only as the same run. The end time is no part of it: a run may be prolonged. */
struct identity {
    char version[16];   /* of vti */
    uint64_t scene;     /* digest of the text of the scene file */
    uint64_t overrides; /* of the values from --set, --h and --stepper, in their order */
    uint64_t bodies;    /* of their numbers at t = 0, wherever the scene has them from */
    uint64_t tables;    /* those of effects */
};

struct checkpoint {
    struct identity identity;
    int64_t step;                       /* not yet recorded */
    int64_t record_every, frames_every; /* steps between rows and between frames */
    struct journal_mark rows, frames;   /* of the journal */
    int64_t state_doubles;              /* of the bodies and of the verdict so far */
};

/** Brings the journal and then a checkpoint of the bodies and of the verdict so far to the disk; lengths and sizes in
 *  *checkpoint are set from them. Returns 0, or -1 with one line in *message and the checkpoint before it as it was. */
int checkpoint_write(struct journal *journal, struct checkpoint *checkpoint, const vti_bodies *bodies,
                     const struct verdict *verdict, struct message *message);

/** Reads the checkpoint in the journal's folder for these bodies and their verdict, which get its state, or stay as they are if that is of
 *  step 0: they are at t = 0 already. Returns 1, 0 if there is none, or -1 with one line in *message: it is damaged, or of
 *  another run than *identity, that of *scene. */
int checkpoint_read(const struct journal *journal, const struct identity *identity, const struct scene *scene,
                    struct checkpoint *checkpoint, const vti_bodies *bodies, struct verdict *verdict,
                    struct message *message);

/** The bytes of the checkpoint in the journal's folder, from malloc; returns likewise. */
int checkpoint_bytes(const struct journal *journal, unsigned char **bytes, size_t *size, struct message *message);
/** The same as checkpoint_read from these bytes, which messages call path; folder is what is to be deleted if they are damaged, or
 *  NULL. Returns 0 or -1. */
int checkpoint_take(const unsigned char *bytes, size_t size, const char *path, const char *folder,
                    const struct identity *identity, const struct scene *scene, struct checkpoint *checkpoint,
                    const vti_bodies *bodies, struct verdict *verdict, struct message *message);

#endif
