/* SPDX-License-Identifier: BSD-3-Clause
 * What outputs may replace: earlier results of ours, and never what the program reads. */
#ifndef VTI_OVERWRITE_H
#define VTI_OVERWRITE_H

#include "tables.h"

/** How a text file of ours is known: its first lines begin so, hold that, and lack the others. HDF5 files are known by
 *  the attribute of their root that holds names, vti_version without it. */
struct mark {
    const char *begins, *holds; /* holds may be NULL; begins NULL is HDF5 */
    const char *const *lacks;   /* up to NULL, none of these; may be NULL itself */
};

/** A file that is to be written into a folder. */
struct output {
    const char *name;
    struct mark mark;
};

/** A file that the program reads, and what it is, "the scene"; path "" is none. */
struct input {
    const char *path, *what;
};

/** The file of a scene, and the tables that it names. */
enum { INPUTS_OF_SCENE = 1 + TABLES };
/** Where in the folder of the outputs a program keeps what it has done (keep.h). */
struct kept {
    const char *name;
    int left; /* it is this program's, or a killed one has left it, which may have left outputs half written too */
};

/** Writes them to list[INPUTS_OF_SCENE] and returns how many there are. */
int overwrite_inputs(const char *path, const struct scene *scene, struct input *list);

/** Whether the file at path, links followed, is a result of ours; so is an empty one, in which nothing can be lost. */
int overwrite_is_ours(const char *path, const struct mark *mark);
/** Whether the file at path, links followed, is write-protected: nobody may write to it, so that it is to stay. */
int overwrite_is_protected(const char *path);

/** What a program would write and reads. */
struct overwrite {
    const char *folder;
    const struct output *outputs;
    int outputs_count;
    const struct input *inputs;
    int inputs_count;
    struct kept kept;
    int force;
};

/** Refuses outputs that are inputs or each other, whatever their names (device and inode count, links are followed),
 *  outputs whose folder is not there or not to be written to, and, but with force, files that are there and not ours,
 *  or write-protected, under the names that outputs have while they are written too. So it does where kept, or what
 *  SQLite puts beside it, would be an input. Returns 0, or -1 with one line in *message. */
int overwrite_check(const struct overwrite *o, struct message *message);

#endif
