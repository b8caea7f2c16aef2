/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_place.h"

#include <stdio.h>
#include <string.h>
#include <yaml.h>

/** A list or section that is open at the event at hand. */
struct frame {
    int is_list;
    int is_wanted;      /* is the value that place_find looks for */
    int has_key;        /* section: a key was read and its value comes next */
    size_t path_length; /* of the path to it */
    size_t items;
};

struct scan {
    const char *wanted; /* path, or NULL */
    int occurrence;     /* how many values at that path are still to come, the wanted one included */
    struct place *place;
    struct message *problem;
    struct frame frames[PLACE_DEPTH];
    int depth;
    int documents;
    yaml_mark_t key;
    char path[PLACE_PATH];
};

/* ---- paths ------------------------------------------------------------------------------------------------------- */

void place_append_key(char path[PLACE_PATH], const char *key)
{
    char shown[QUOTE_SIZE];
    append(path, PLACE_PATH, path[0] != '\0' ? "." : "");
    append(path, PLACE_PATH, quote(shown, sizeof shown, key));
}

void place_append_item(char path[PLACE_PATH], size_t index)
{
    char item[24];
    snprintf(item, sizeof item, "[%lu]", (unsigned long)index);
    append(path, PLACE_PATH, item);
}

void place_join(char path[PLACE_PATH], const char *inside)
{
    append(path, PLACE_PATH, path[0] == '\0' || inside[0] == '\0' || inside[0] == '[' ? "" : ".");
    append(path, PLACE_PATH, inside);
}

/* ---- what an event is -------------------------------------------------------------------------------------------- */

static void set_place(struct place *place, yaml_mark_t value, yaml_mark_t key)
{
    place->line = value.line + 1;
    place->column = value.column + 1;
    place->key_line = key.line + 1;
    place->key_column = key.column + 1;
}

static int refuse(struct scan *scan, yaml_mark_t mark, const char *problem)
{
    set_place(scan->place, mark, mark);
    return message_set(scan->problem, "%s", problem);
}

static const char *scalar_text(const yaml_event_t *event)
{
    return event->type == YAML_SCALAR_EVENT ? (const char *)event->data.scalar.value : "";
}

/** A 0 inside would end the text early for libcyaml, and the rest must fit on one line of a message. */
static int has_controls(const yaml_event_t *event)
{
    if (event->type != YAML_SCALAR_EVENT)
        return 0;
    for (size_t k = 0; k < event->data.scalar.length; ++k)
        if ((event->data.scalar.value[k] < 0x20 && event->data.scalar.value[k] != '\t') ||
            event->data.scalar.value[k] == 0x7f)
            return 1;
    return 0;
}

static void end_value(struct scan *scan)
{
    if (scan->depth == 0)
        return;
    struct frame *in = &scan->frames[scan->depth - 1];
    in->has_key = 0;
    scan->path[in->path_length] = '\0';
}

static int is_wanted(struct scan *scan)
{
    return scan->wanted != NULL && strcmp(scan->wanted, scan->path) == 0 && --scan->occurrence == 0;
}

static int start_value(struct scan *scan, const yaml_event_t *event)
{
    struct frame *in = scan->depth > 0 ? &scan->frames[scan->depth - 1] : NULL;
    if (in != NULL && in->is_list)
        place_append_item(scan->path, in->items++);
    const int wanted = is_wanted(scan);
    if (wanted) {
        set_place(scan->place, event->start_mark, in != NULL && !in->is_list ? scan->key : event->start_mark);
        scan->place->kind = event->type == YAML_SCALAR_EVENT           ? PLACE_VALUE
                            : event->type == YAML_SEQUENCE_START_EVENT ? PLACE_LIST
                                                                       : PLACE_SECTION;
        scan->place->items = 0;
        quote(scan->place->text, sizeof scan->place->text, scalar_text(event));
    }
    if (event->type == YAML_SCALAR_EVENT) {
        end_value(scan);
        return 0;
    }
    if (scan->depth == PLACE_DEPTH) /* also keeps libyaml from the square of the depth in time */
        return refuse(scan, event->start_mark, "nested too deeply; a scene has sections, keys and lists and no more");
    const struct frame frame = {event->type == YAML_SEQUENCE_START_EVENT, wanted, 0, strlen(scan->path), 0};
    scan->frames[scan->depth++] = frame;
    return 0;
}

static int start_node(struct scan *scan, const yaml_event_t *event)
{
    struct frame *in = scan->depth > 0 ? &scan->frames[scan->depth - 1] : NULL;
    if (has_controls(event))
        return refuse(scan, event->start_mark, "a line break or control character in a value; write it on one line");
    if (in == NULL || in->is_list || in->has_key)
        return start_value(scan, event);
    if (event->type != YAML_SCALAR_EVENT)
        return refuse(scan, event->start_mark, "a list or section stands where a key belongs; write 'key: value'");
    scan->key = event->start_mark;
    in->has_key = 1;
    place_append_key(scan->path, scalar_text(event));
    return 0;
}

static void end_node(struct scan *scan)
{
    const struct frame *ended = &scan->frames[--scan->depth];
    if (ended->is_wanted)
        scan->place->items = ended->items;
    end_value(scan);
}

static int take(struct scan *scan, const yaml_event_t *event)
{
    switch (event->type) {
    case YAML_DOCUMENT_START_EVENT:
        if (++scan->documents > 1)
            return refuse(scan, event->start_mark, "a second document; a scene is one document, without '---' inside");
        return 0;
    case YAML_ALIAS_EVENT:
        return refuse(scan, event->start_mark, "an alias; aliases are not read in scenes, write the value itself");
    case YAML_SCALAR_EVENT:
    case YAML_SEQUENCE_START_EVENT:
    case YAML_MAPPING_START_EVENT:
        return start_node(scan, event);
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
        end_node(scan);
        return 0;
    default:
        return 0;
    }
}

/* ---- the whole text ---------------------------------------------------------------------------------------------- */

/** libyaml gives no line for bytes that are no characters, only their offset. */
static yaml_mark_t mark_of_byte(const char *text, size_t size, size_t offset)
{
    yaml_mark_t mark = {offset, 0, 0};
    for (size_t k = 0; k < offset && k < size; ++k) {
        mark.column = text[k] == '\n' ? 0 : mark.column + 1;
        mark.line += text[k] == '\n';
    }
    return mark;
}

static int refuse_syntax(struct scan *scan, const yaml_parser_t *parser, const char *text, size_t size)
{
    char problem[sizeof scan->problem->text];
    const int unreadable = parser->error == YAML_READER_ERROR;
    const yaml_mark_t mark = unreadable ? mark_of_byte(text, size, parser->problem_offset) : parser->problem_mark;
    snprintf(problem, sizeof problem, "not YAML: %s; %s", parser->problem != NULL ? parser->problem : "out of memory",
             unreadable ? "give a text file in UTF-8"
                        : "look at the brackets, quotes and indentation here and just above");
    return refuse(scan, mark, problem);
}

static int scan_text(struct scan *scan, const char *text, size_t size)
{
    yaml_parser_t parser;
    int result = 0, more = 1;
    if (!yaml_parser_initialize(&parser))
        return message_set(scan->problem, "out of memory");
    yaml_parser_set_input_string(&parser, (const unsigned char *)text, size);
    while (result == 0 && more) {
        yaml_event_t event;
        if (!yaml_parser_parse(&parser, &event)) {
            result = refuse_syntax(scan, &parser, text, size);
            break;
        }
        more = event.type != YAML_STREAM_END_EVENT;
        result = take(scan, &event);
        yaml_event_delete(&event);
    }
    yaml_parser_delete(&parser);
    return result;
}

int place_check(const char *text, size_t size, struct place *place, struct message *problem)
{
    struct scan scan = {.place = place, .problem = problem};
    memset(place, 0, sizeof *place);
    place->line = place->column = 1;
    if (scan_text(&scan, text, size) != 0)
        return -1;
    return scan.documents == 0 ? message_set(problem, "no scene in it; write at least bodies, h and t_end") : 0;
}

int place_find(const char *text, size_t size, const char *path, int occurrence, struct place *place)
{
    struct message ignored = {""};
    struct scan scan = {.wanted = path, .occurrence = occurrence, .place = place, .problem = &ignored};
    memset(place, 0, sizeof *place);
    return scan_text(&scan, text, size) == 0 && scan.occurrence <= 0 ? 0 : -1;
}
