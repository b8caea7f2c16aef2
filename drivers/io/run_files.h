/* SPDX-License-Identifier: BSD-3-Clause
 * The files of a run, together. */
#ifndef VTI_RUN_FILES_H
#define VTI_RUN_FILES_H

#include "overwrite.h"
#include "record.h"

/** OUT.h5 and what stands beside it: OUT.csv, OUT.xdmf, OUT.dump, of clumps OUT-spheres.h5, and OUT-contacts.h5. */
struct run_files {
    char folder[FOLDER_PATH];
    char stem[256]; /* OUT */
    char hdf5[264]; /* OUT.h5, or with the other ending that was asked for */
    int dump;       /* whether OUT.dump is wanted */
    int spheres;    /* whether there are clumps, and so OUT-spheres.h5 */
    int contacts;   /* whether OUT-contacts.h5 is wanted */
    int xdmf;       /* whether OUT.xdmf is wanted of however many frames */
    int force;      /* replace files that are not ours */
    char run[264];  /* OUT.run, where what is done is kept */
    int left;       /* whether it is this run's, or one that was interrupted (overwrite.h) */
    const struct input *inputs;
    int inputs_count;
};

/** Takes the name of the HDF5 file apart. Returns 0, or -1 with one line in *message. */
int run_files_name(struct run_files *files, const char *output, int dump, struct message *message);

/** The most frames for which OUT.xdmf is written unasked: it takes 1 to 8 kB of text for each, as much as the frame
 *  itself in OUT.h5 where bodies are few. */
enum { RUN_XDMF_FRAMES = 2000 };

/** The path of OUT-contacts.h5. Returns 0, or -1 with one line in *message. */
int run_files_contacts(const struct run_files *files, char path[FOLDER_PATH], struct message *message);

/** Whether OUT.xdmf is written. */
int run_files_has_xdmf(const struct run_files *files, const struct record *record);
/** How many touches so many frames may have, if they are recorded: three of each sphere, as spheres in a dense packing
 *  touch six others. */
double run_files_touches(const struct run_files *files, const struct record *record, int64_t frames);
/** About how many bytes the files of so many rows and frames take, to a fifth where there are 100 MB. */
double run_files_bytes(const struct run_files *files, const struct record *record, int64_t rows, int64_t frames);
/** Whether all that would be written of so many frames is there. */
int run_files_are_there(const struct run_files *files, int64_t frames);
/** Whether they may be written (overwrite.h). Returns 0, or -1 with one line in *message. */
int run_files_check(const struct run_files *files, struct message *message);

/** Checks again and writes the files: all under temporary names, to the disk, then all under their real ones, so that a
 *  failure leaves what was there before. Returns 0, or -1 with one line in *message. */
int run_files_write(const struct run_files *files, const struct record *record, struct message *message);

#endif
