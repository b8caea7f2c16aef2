/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A YAML text, read once by libfyaml, part by part. What no scene may hold, whatever its keys, is refused on the way:
 * bytes that are not UTF-8, control characters, several documents, aliases, nesting deeper than YAML_DEPTH, line breaks
 * inside a value. Anchors and tags are passed over. */
#ifndef VTI_SCENE_YAML_H
#define VTI_SCENE_YAML_H

#include <stddef.h>

#include "message.h"

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

/** Starts on a text, which must stay until yaml_close; problem gets the reason of a refusal. The first part follows by
 *  yaml_next. yaml_close must follow in any case. */
void yaml_open(struct yaml *yaml, const char *text, size_t size, struct message *problem);
/** Goes on to the next part and returns it. A YAML_REFUSED stays one. */
enum yaml_part yaml_next(struct yaml *yaml);
void yaml_close(struct yaml *yaml);

#endif
