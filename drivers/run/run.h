/* SPDX-License-Identifier: BSD-3-Clause
 *
 * One scene from t = 0 or a checkpoint to its end, recorded in a journal (journal.h) and then in files
 * (run_files.h). However a run ends, its files are the same bytes as those of one that was never interrupted, or
 * those of an earlier run. */
#ifndef VTI_RUN_H
#define VTI_RUN_H

#include "checkpoint.h"
#include "record.h"
#include "renumber.h"
#include "run_files.h"
#include "table_hdf5.h"
#include "travel.h"

struct run_request {
    const char *scene;       /* path of the file */
    const char *const *sets; /* overrides, see scene_read */
    int sets_count;
    const char *output;                 /* path of the HDF5 file; NULL: the scene's name and .h5 */
    int64_t record_every, frames_every; /* steps; 0: about_rows of run.c, sizes_frames */
    double checkpoint_seconds;
    int64_t threads; /* 0: all cores where they pay */
    int resume;      /* go on from the checkpoint, if there is one */
    int dump;        /* write the LAMMPS dump */
    int xdmf;        /* write the XDMF index of however many frames */
    int force;       /* replace files that are not ours */
    int fields;      /* FIELD_ (record.h) */
    int contacts;    /* record what touches in each frame (touch_forces.h) */
    int errors;      /* record what single steps err by (step_errors.h) */
    int renumber;    /* work on the bodies of the table in another order (renumber.h) */
};

/** How a run has ended. */
enum run_end {
    RUN_COMPLETE,
    RUN_STOPPED, /* by a signal; it can be resumed */
    RUN_ENDED,   /* by a signal, before the first step: it leaves nothing */
    RUN_BROKEN,  /* a step was refused or a number is not finite; what was recorded before is in the files */
    /** It did not start, or files cannot be written; what was recorded up to a checkpoint is in the journal. */
    RUN_FAILED
};

struct run {
    const struct run_request *request;
    struct scene scene;
    struct tables tables;
    struct model model;
    struct model *shown; /* in the scene's numbers, at t = 0: model, or that of the tables as they are */
    struct scene sorted; /* where bodies are renumbered: the scene of model */
    struct renumbering renumbering;
    struct model unsorted;                /* where bodies are renumbered: what is shown */
    struct input inputs[INPUTS_OF_SCENE]; /* the scene and its tables */
    struct run_files files;
    char output[FOLDER_PATH]; /* path of the HDF5 file */
    struct journal journal;
    struct checkpoint checkpoint;
    struct record record;
    struct verdict verdict;
    int64_t from, steps, threads;
    struct travel travel;
    int done;     /* it was complete before: there is nothing to do */
    int restored; /* it goes on from the files of a complete run */
    int kept;     /* the journal is to stay */
    int64_t fit;  /* frames, where nobody says how many and the usual ones would take much disk (sizes.h); else 0 */

    /* while it goes */
    enum run_end end;
    double began, saved;            /* clock: this program's start, the last checkpoint */
    int64_t poll_every, look_every; /* steps */
    struct message *message;

    /* after it */
    double seconds, energy0, energy1, drift; /* drift: the largest |E - E_0| recorded */
    double t;                                /* of the last row */
    struct message judgement;                /* the line of the verdict, record.judgement */
};

/** Reads the scene, makes the model and opens the journal; with request->resume from where it was. request must
 *  outlive the run. Returns 0, or -1 with one line in *message. run_close is due after either. */
int run_open(const struct run_request *request, struct run *run, struct message *message);

/** The bodies, with the views of run->model, as people number them, until the next call. */
const vti_bodies *run_shown(struct run *run, const vti_bodies *bodies);

/** Who watches a run. */
struct run_watch {
    void (*progress)(int64_t done, int64_t all, double seconds); /* as in terminal.h, every now and then */
    /** At each checkpoint on the way: log_step of terminal.h. */
    void (*saved)(int64_t step, int64_t steps, double t, double left, double seconds);
};

/** Runs and writes the files. The line in *message is that of all ends but RUN_COMPLETE. */
enum run_end run_go(struct run *run, const struct run_watch *watch, struct message *message);

void run_close(struct run *run);

/* ---- from the end of a complete run ------------------------------------------------------------------------------ */

/* A complete run goes on from its HDF5 file: /restart there holds its identity and the checkpoint at its end, byte for
 * byte, and rows and frames are those of /energies and /VTKHDF; what touches in these is in OUT-contacts.h5. */

struct run_restart {
    char *identity;       /* text (identity.h) */
    unsigned char *bytes; /* of the checkpoint */
    size_t size;
    int64_t verdict; /* enum verdict_grade */
};

/** What the file of the run says of its end; run_restart_free is due. Returns 1, 0 if there is no such file, or -1 with
 *  one line in *message: the file holds no run that can go on. */
int run_restart_find(const char *path, struct run_restart *restart, struct message *message);
void run_restart_free(struct run_restart *restart);

/** Adds the records that *checkpoint counts to the open, empty journal of *record, from the file at path and, if they
 *  are recorded, touches from that at contacts. Returns 0, or -1 with one line in *message: they are not those of the
 *  checkpoint. */
int run_restart_fill(const char *path, const char *contacts, const struct record *record,
                     const struct checkpoint *checkpoint, struct message *message);

#endif
