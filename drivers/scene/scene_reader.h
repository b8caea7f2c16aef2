/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A scene as text: what the file and the --set arguments give, a value for each row of the table of keys, and which of
 * them gave it. Numbers are still text here, because --set may replace one that is wrong. */
#ifndef VTI_SCENE_READER_H
#define VTI_SCENE_READER_H

#include <stddef.h>
#include <stdint.h>

#include "message.h"
#include "quote.h"
#include "scene_field.h"

/* ---- the text ---------------------------------------------------------------------------------------------------- */

/* A YAML text, read once by libfyaml, part by part. What no scene may hold, whatever its keys, is refused on the way:
 * bytes that are not UTF-8, control characters, several documents, aliases, nesting deeper than YAML_DEPTH, line breaks
 * inside a value. Anchors and tags are passed over. */

enum { YAML_DEPTH = 16 };

struct place {
    size_t line, column; /* counted from 1, in characters */
};

enum yaml_part {
    YAML_REFUSED, /* place and problem say why; nothing follows */
    YAML_WORD,    /* a single value, or a key */
    YAML_LIST,    /* its parts follow, then YAML_CLOSE */
    YAML_SECTION, /* key, value, key, value, ..., YAML_CLOSE */
    YAML_CLOSE,
    YAML_END /* of the text */
};

struct fy_parser;
struct fy_diag;
struct fy_event;

struct yaml {
    enum yaml_part part;     /* the part at hand; the rest belongs to it */
    struct place place;      /* where it starts; for an empty value, the end of what stands before it */
    const char *word;        /* of a YAML_WORD, until the next part; no control characters but tabs */
    struct message *problem; /* one clause: what is wrong and what to do */
    const char *text;
    struct place end;
    int depth, documents;
    struct fy_parser *parser;
    struct fy_diag *diag;
    struct fy_event *event;
};

/** Starts on a text, which must stay until scene_yaml_close; problem gets the reason of a refusal. The first part
 *  follows by scene_yaml_next. scene_yaml_close must follow in any case. */
void scene_yaml_open(struct yaml *yaml, const char *text, size_t size, struct message *problem);
/** Goes on to the next part and returns it. A YAML_REFUSED stays one. */
enum yaml_part scene_yaml_next(struct yaml *yaml);
void scene_yaml_close(struct yaml *yaml);

/* ---- the values -------------------------------------------------------------------------------------------------- */

enum { SCENE_KEYS_SIZE = 256, SCENE_TEXT_SIZE = 512 }; /* of a path of keys, and of what a message says about it */

/** One word or number of a value. */
struct scene_item {
    char *text;
    struct place place;
};

/** What is given for a row of the table. */
struct scene_value {
    int given;
    const char *set; /* the --set argument that gave it, NULL: the file */
    struct place key, place;
    int64_t count; /* of items: 1, 3 of a vector, 4 of each plane, 0 of a section */
    struct scene_item *items;
};

struct scene_text; /* scene.h */
struct scene_reader {
    const char *path;           /* of the file */
    struct place start;         /* of the scene in it */
    struct scene_value *values; /* in the order of the table */
    struct message *message;
};

/** Reads the text of the file and the n --set arguments, which replace or add single values. Returns 0, or -1 with one
 *  line in *message. path, sets and *message must live as long as the reader. scene_reader_close must follow in any
 *  case. */
int scene_reader_open(struct scene_reader *reader, const char *path, const struct scene_text *text,
                      const char *const *sets, int n, struct message *message);
void scene_reader_close(struct scene_reader *reader);

/** Takes a text as the value at a path of the table, "" being the whole scene; set is the --set argument that it is
 *  from, NULL: the file. Returns likewise. */
int scene_load(struct scene_reader *reader, const char *set, const char *path, const char *text, size_t size);
/** The value is not given any more. */
void scene_reader_clear(struct scene_value *value);

/** The value of the row of the table that has this path; NULL if there is no such row. */
struct scene_value *scene_reader_at(const struct scene_reader *reader, const char *path);
/** Whether the value or section at a path of the table is given. */
int scene_reader_has(const struct scene_reader *reader, const char *path);
/** The text of a single value that is given. */
const char *scene_reader_value(const struct scene_reader *reader, const char *path);

/** Writes one line about the value at path and returns -1. Its place is that of the value (of the key, if it is a
 *  section); for a value that is not given, of the section that lacks it. */
int scene_reader_fail(const struct scene_reader *reader, const char *path, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** The same about an item of a value that is given; part is what its path has behind the field's, such as "[1]". */
int scene_reader_fail_item(const struct scene_reader *reader, const struct scene_field *field, int64_t item,
                           const char *part, const char *format, ...) __attribute__((format(printf, 5, 6)));

/** Writes the line "PLACE: PATH: TEXT" and returns -1. PLACE is the --set argument, or the file and the place, if it
 *  has one. */
int scene_reader_say(const struct scene_reader *reader, const char *set, const struct place *place, const char *path,
                     const char *text);

#endif
