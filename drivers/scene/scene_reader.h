/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A scene as text: what the file and the --set arguments say, merged, and which of them said it. */
#ifndef VTI_SCENE_READER_H
#define VTI_SCENE_READER_H

#include "scene_source.h"

struct scene_reader {
    struct scene_schema schema;
    struct scene_slot root;
    struct scene_source *sources; /* the file, then the --set arguments */
    int sources_count;
    struct message *message;
};

/** Reads the file and the n --set arguments. Returns 0, or -1 with one line in *message, which must live as long as the
 *  reader. In either case scene_reader_close must follow. */
int scene_reader_open(struct scene_reader *reader, const char *path, const char *const *sets, int n,
                      struct message *message);
void scene_reader_close(struct scene_reader *reader);

/** The value at a path of the table, NULL if it is not given: of type char for single values, char *const [3] for
 *  vectors, char *const *const [items] for lists of rows; of a section only whether it is NULL counts. */
const void *scene_reader_value(const struct scene_reader *reader, const char *path);
/** Whether the value or section at a path of the table is given. */
int scene_reader_has(const struct scene_reader *reader, const char *path);
/** The length of a list of rows. */
int64_t scene_reader_items(const struct scene_reader *reader, const char *path);

/** Writes one line about the value at path and returns -1. Its place is that of the value (of the key, if it is a
 *  section); for a value that is not given, of the section that lacks it. */
int scene_reader_fail(const struct scene_reader *reader, const char *path, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
