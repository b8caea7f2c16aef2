/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_reader.h"

#include <libfyaml.h>
#include <string.h>

#include "quote.h"

/* ---- the bytes ---------------------------------------------------------------------------------------------------
 * What libfyaml (0.7, 0.8) does not look at: bytes that are not UTF-8, and 0, end the text for it without a word; and
 * line breaks or blanks in a row, a long directive and a long tag take it the square of their length in time. */

enum { RUN_MAX = 1000 };

static int is_break(char c)
{
    return c == '\n' || c == '\r';
}

static int is_control(char c)
{
    return ((unsigned char)c < 0x20 && c != '\t') || c == 0x7f;
}

/** Where a text has been read to. */
struct scan {
    struct place place;
    int breaks; /* line breaks in a row, blanks apart */
    int blanks; /* in a row, in this line */
    int marked; /* characters since a % that starts this line, or since a ! in it */
};

/** On behind the character c, which next follows. Returns what is wrong, NULL if nothing is. */
static const char *pass(struct scan *scan, char c, char next)
{
    const int starts_line = scan->place.column == 1;
    if (c == '\n' || (c == '\r' && next != '\n')) {
        const struct scan line = {{scan->place.line + 1, 1}, scan->breaks + 1, 0, 0};
        *scan = line;
        return scan->breaks > RUN_MAX ? "1000 empty lines; a scene is short, is this the right file?" : NULL;
    }
    ++scan->place.column;
    const int is_blank = c == ' ' || c == '\t' || c == '\r';
    scan->blanks = is_blank ? scan->blanks + 1 : 0;
    scan->breaks = is_blank ? scan->breaks : 0;
    if (scan->blanks > RUN_MAX)
        return "1000 blanks in a row; a scene needs fewer, remove some";
    scan->marked += scan->marked > 0 || c == '!' || (c == '%' && starts_line);
    return scan->marked > RUN_MAX ? "a directive or tag of 1000 characters; a scene needs none, remove it" : NULL;
}

/** What is wrong with the bytes, NULL if nothing is; *place is where. */
static const char *wrong_bytes(const char *text, size_t size, struct place *place)
{
    struct scan scan = {{1, 1}, 0, 0, 0};
    const char *problem = NULL;
    for (size_t k = 0, n; k < size && problem == NULL; k += n) {
        n = quote_character(text + k, size - k);
        if (n == 0)
            problem = "bytes that are no characters; give a text file in UTF-8";
        else if (is_control(text[k]) && !is_break(text[k]))
            problem = "a control character; give a text file in UTF-8";
        else
            problem = pass(&scan, text[k], k + 1 < size ? text[k + 1] : '\0');
    }
    *place = scan.place;
    return problem;
}

/* ---- refusals ---------------------------------------------------------------------------------------------------- */

static int refuse(struct yaml *yaml, const char *problem)
{
    message_set(yaml->problem, "%s", problem);
    yaml->part = YAML_REFUSED;
    return 1;
}

/** The first thing that libfyaml has found wrong, its warnings (of directives that it passes over) included. */
static const struct fy_diag_error *complaint(const struct yaml *yaml)
{
    void *start = NULL;
    return fy_diag_errors_iterate(yaml->diag, &start);
}

static void refuse_syntax(struct yaml *yaml)
{
    const struct fy_diag_error *error = complaint(yaml);
    char shown[2 * QUOTE_SIZE];
    if (error != NULL && error->line > 0) {
        yaml->place.line = (size_t)error->line;
        yaml->place.column = (size_t)error->column;
    }
    message_set(yaml->problem, "not YAML: %s; look at the brackets, quotes and indentation here and just above",
                quote(shown, sizeof shown, error != NULL ? error->msg : "it cannot be read on from here"));
    yaml->part = YAML_REFUSED;
}

/* ---- the parts --------------------------------------------------------------------------------------------------- */

/** Marks of quoted words and of aliases leave out the character in front of them. */
static void find_place(struct yaml *yaml, struct fy_event *event)
{
    const struct fy_mark *start = fy_event_start_mark(event), *end = fy_event_end_mark(event);
    const enum fy_scalar_style style = fy_token_scalar_style(fy_event_get_token(event));
    const int inside = event->type == FYET_ALIAS || style == FYSS_SINGLE_QUOTED || style == FYSS_DOUBLE_QUOTED;
    yaml->place = yaml->end;
    if (start != NULL) {
        yaml->place.line = (size_t)start->line + 1;
        yaml->place.column = (size_t)start->column + (inside ? 0 : 1);
    }
    if (end != NULL) {
        yaml->end.line = (size_t)end->line + 1;
        yaml->end.column = (size_t)end->column + 1;
    }
}

/** libfyaml 0.7 reads some words wrongly that go over several lines ("- |", then "  # a"). */
static int is_on_one_line(struct fy_event *event)
{
    const struct fy_mark *start = fy_event_start_mark(event), *end = fy_event_end_mark(event);
    const enum fy_scalar_style style = fy_token_scalar_style(fy_event_get_token(event));
    return start == NULL || (style != FYSS_LITERAL && style != FYSS_FOLDED && start->line == end->line);
}

/** Of a word in single quotes: '' twice in a row, of which libfyaml 0.7 makes three quotes. */
static int has_wrong_quotes(const struct yaml *yaml, struct fy_event *event)
{
    const struct fy_mark *start = fy_event_start_mark(event), *end = fy_event_end_mark(event);
    if (fy_token_scalar_style(fy_event_get_token(event)) != FYSS_SINGLE_QUOTED)
        return 0;
    for (size_t k = start->input_pos; k + 4 <= end->input_pos; ++k)
        if (memcmp(yaml->text + k, "''''", 4) == 0)
            return 1;
    return 0;
}

static int take_word(struct yaml *yaml, struct fy_event *event)
{
    struct fy_token *token = fy_event_get_token(event);
    size_t n = 0;
    if (!is_on_one_line(event))
        return refuse(yaml, "a line break or control character in a value; write it on one line");
    if (has_wrong_quotes(yaml, event))
        return refuse(yaml, "quotes side by side in a value; write it without them");
    const char *text = token != NULL ? fy_token_get_text(token, &n) : "";
    yaml->word = token != NULL ? fy_token_get_text0(token) : "";
    if (text == NULL || yaml->word == NULL)
        return refuse(yaml, "out of memory");
    for (size_t k = 0; k < n; ++k)
        if (is_control(text[k]))
            return refuse(yaml, "a line break or control character in a value; write it on one line");
    yaml->part = YAML_WORD;
    return 1;
}

static int take_start(struct yaml *yaml, enum yaml_part part)
{
    yaml->part = part;
    if (++yaml->depth > YAML_DEPTH)
        return refuse(yaml, "nested too deeply; a scene has sections, keys and lists and no more");
    return 1;
}

/** Returns 1 if the event is a part, or refused. */
static int take(struct yaml *yaml, struct fy_event *event)
{
    find_place(yaml, event);
    switch (event->type) {
    case FYET_DOCUMENT_START:
        return ++yaml->documents > 1 &&
               refuse(yaml, "a second document; a scene is one document, without '---' inside");
    case FYET_ALIAS:
        return refuse(yaml, "an alias; aliases are not read in scenes, write the value itself");
    case FYET_SCALAR:
        return take_word(yaml, event);
    case FYET_SEQUENCE_START:
        return take_start(yaml, YAML_LIST);
    case FYET_MAPPING_START:
        return take_start(yaml, YAML_SECTION);
    case FYET_SEQUENCE_END:
    case FYET_MAPPING_END:
        --yaml->depth;
        yaml->part = YAML_CLOSE;
        return 1;
    case FYET_STREAM_END:
        yaml->part = YAML_END;
        return 1;
    default:
        return 0;
    }
}

enum yaml_part scene_yaml_next(struct yaml *yaml)
{
    while (yaml->part != YAML_REFUSED && yaml->part != YAML_END) {
        fy_parser_event_free(yaml->parser, yaml->event);
        yaml->event = fy_parser_parse(yaml->parser);
        if (yaml->event == NULL || complaint(yaml) != NULL)
            refuse_syntax(yaml);
        else if (take(yaml, yaml->event))
            break;
    }
    return yaml->part;
}

/* ---- start and end ----------------------------------------------------------------------------------------------- */

/** With a list of its own for what is wrong: libfyaml would print it. */
static int start_parser(struct yaml *yaml, const char *text, size_t size)
{
    const struct fy_diag_cfg silent = {.level = FYET_WARNING, .module_mask = ~0U};
    yaml->diag = fy_diag_create(&silent);
    if (yaml->diag == NULL)
        return -1;
    fy_diag_set_collect_errors(yaml->diag, true);
    const struct fy_parse_cfg config = {
        .flags = FYPCF_DEFAULT_VERSION_1_2 | FYPCF_JSON_NONE | FYPCF_SLOPPY_FLOW_INDENTATION, .diag = yaml->diag};
    yaml->parser = fy_parser_create(&config);
    return yaml->parser != NULL ? fy_parser_set_string(yaml->parser, text, size) : -1;
}

void scene_yaml_open(struct yaml *yaml, const char *text, size_t size, struct message *problem)
{
    memset(yaml, 0, sizeof *yaml);
    yaml->problem = problem;
    yaml->text = text;
    yaml->part = YAML_CLOSE; /* of nothing, so far */
    const char *wrong = wrong_bytes(text, size, &yaml->place);
    yaml->end.line = yaml->end.column = 1;
    if (wrong != NULL || start_parser(yaml, text, size) != 0)
        refuse(yaml, wrong != NULL ? wrong : "out of memory");
}

void scene_yaml_close(struct yaml *yaml)
{
    if (yaml->parser != NULL) {
        fy_parser_event_free(yaml->parser, yaml->event);
        fy_parser_destroy(yaml->parser);
    }
    fy_diag_destroy(yaml->diag);
}
