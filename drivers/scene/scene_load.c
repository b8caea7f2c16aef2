/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A YAML text (the file, or the value of one --set) into the values of the reader, by the table of keys. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "scene_reader.h"

enum { LIST_SIZE = 320 };

struct load {
    struct scene_reader *reader;
    const char *set;  /* the --set argument, NULL: the file */
    const char *path; /* of what the text holds, "" for the whole scene */
    struct yaml yaml;
    struct message problem; /* of yaml */
};

__attribute__((format(printf, 4, 5))) static int fail(const struct load *load, const struct place *place,
                                                      const char *path, const char *format, ...)
{
    struct message said;
    va_list arguments;
    va_start(arguments, format);
    message_set_list(&said, format, arguments);
    va_end(arguments);
    return scene_reader_say(load->reader, load->set, place, path, said.text);
}

/** On to the next part of the text. Returns 0, or -1 if there is none. */
static int step(struct load *load)
{
    if (scene_yaml_next(&load->yaml) != YAML_REFUSED)
        return 0;
    return scene_reader_say(load->reader, load->set, &load->yaml.place, load->path, load->problem.text);
}

/* ---- values ------------------------------------------------------------------------------------------------------ */

/** How deep the lists are that a value is written in. */
static int dimension_of(const struct scene_field *field)
{
    const struct scene_rows *rows = scene_rows_of(field->kind);
    if (rows != NULL)
        return rows->row != NULL ? 2 : 1;
    return field->kind == SCENE_VECTOR || field->kind == SCENE_COUNTS;
}

/** What stands there, as one can say it. Goes on to the end of it; returns -1 if it cannot be read so far. */
static int describe(struct load *load, char found[2 * QUOTE_SIZE])
{
    const struct yaml *yaml = &load->yaml;
    const enum yaml_part part = yaml->part;
    const int depth = yaml->depth;
    char shown[QUOTE_SIZE];
    unsigned long items = 0;
    if (part == YAML_WORD)
        snprintf(found, 2 * QUOTE_SIZE, "'%s'", quote(shown, sizeof shown, yaml->word));
    while (part != YAML_WORD && yaml->depth >= depth) {
        if (step(load) != 0)
            return -1;
        items += yaml->part != YAML_CLOSE && yaml->depth == depth + (yaml->part != YAML_WORD);
    }
    if (part == YAML_LIST)
        snprintf(found, 2 * QUOTE_SIZE, "a list of %lu", items);
    else if (part == YAML_SECTION)
        snprintf(found, 2 * QUOTE_SIZE, "a section");
    return 0;
}

/** A list of numbers, as one can say it, and an example. */
static const char *list_words(const struct scene_field *field, char words[SCENE_TEXT_SIZE])
{
    const struct scene_rows *rows = scene_rows_of(field->kind);
    const int counts = field->kind == SCENE_COUNTS;
    const char *what = rows == NULL ? (counts ? "three whole numbers" : "three numbers") : rows->row,
               *example = rows == NULL ? (counts ? "[4, 4, 4]" : "[0, 0, 1]") : rows->row_example;
    if (what == NULL) {
        what = rows->name;
        example = rows->example;
    }
    snprintf(words, SCENE_TEXT_SIZE, "%s; write them as in %s", what, example);
    return words;
}

/** Something else stands where a value, or a list of that dimension in it, belongs. */
static int fail_shape(struct load *load, const struct scene_field *field, int dimension, const char *path)
{
    const struct place place = load->yaml.place;
    const struct scene_rows *rows = scene_rows_of(field->kind);
    char found[2 * QUOTE_SIZE], words[SCENE_TEXT_SIZE];
    if (describe(load, found) != 0)
        return -1;
    if (dimension == 2)
        return fail(load, &place, path, "%s is not a list of %s; write them as in %s", found, rows->name,
                    rows->example);
    if (dimension == 1)
        return fail(load, &place, path, "%s is not a list of %s", found, list_words(field, words));
    if (field->kind == SCENE_COUNT || field->kind == SCENE_COUNTS)
        return fail(load, &place, path, "%s is not a whole number; " NUMBER_WRITE_COUNT, found);
    if (field->kind == SCENE_NUMBER || dimension_of(field) > 0)
        return fail(load, &place, path, "%s is not a number; " NUMBER_WRITE, found);
    return fail(load, &place, path, "%s is not a word; write a single word", found);
}

/** The capacity doubles. */
static int add_item(struct load *load, struct scene_value *value)
{
    const size_t n = (size_t)value->count, size = strlen(load->yaml.word) + 1;
    struct scene_item *items = value->items;
    if ((n & (n - 1)) == 0)
        items = realloc(items, (n == 0 ? 1 : 2 * n) * sizeof *items);
    if (items == NULL)
        return fail(load, NULL, "", "out of memory");
    value->items = items;
    items[n].place = load->yaml.place;
    items[n].text = malloc(size);
    if (items[n].text == NULL)
        return fail(load, NULL, "", "out of memory");
    memcpy(items[n].text, load->yaml.word, size);
    ++value->count;
    return 0;
}

/** A list of that dimension; 0 is a single word. */
static int load_items(struct load *load, const struct scene_field *field, struct scene_value *value, int dimension,
                      const char *path)
{
    const struct place place = load->yaml.place;
    const struct scene_rows *rows = scene_rows_of(field->kind);
    const unsigned long width = rows != NULL ? (unsigned long)rows->width : 3;
    const int any_length = rows != NULL && dimension == dimension_of(field);
    if (load->yaml.part != (dimension == 0 ? YAML_WORD : YAML_LIST))
        return fail_shape(load, field, dimension, path);
    if (dimension == 0)
        return add_item(load, value);
    for (unsigned long n = 0;; ++n) {
        char item[24], item_path[SCENE_KEYS_SIZE] = "", words[SCENE_TEXT_SIZE];
        if (step(load) != 0)
            return -1;
        if (load->yaml.part == YAML_CLOSE)
            return any_length || n == width
                       ? 0
                       : fail(load, &place, path, "%lu values in a list of %s", n, list_words(field, words));
        snprintf(item, sizeof item, "[%lu]", n);
        quote_append(quote_append(item_path, sizeof item_path, path), sizeof item_path, item);
        if (load_items(load, field, value, dimension - 1, item_path) != 0)
            return -1;
    }
}

/* ---- sections ---------------------------------------------------------------------------------------------------- */

static int load_section(struct load *load, const char *section);

/** The part at hand as the value of a row of the table. */
static int load_value(struct load *load, const struct scene_field *field, struct place key)
{
    struct scene_value *value = scene_reader_at(load->reader, field->path);
    scene_reader_clear(value);
    value->given = 1;
    value->set = load->set;
    value->key = key;
    value->place = field->kind == SCENE_SECTION ? key : load->yaml.place;
    if (field->kind == SCENE_SECTION)
        return load_section(load, field->path);
    return load_items(load, field, value, dimension_of(field), field->path);
}

/** section is the innermost one that there is. */
static int fail_unknown(struct load *load, const char *section, const char *key)
{
    char list[LIST_SIZE], shown[QUOTE_SIZE], path[SCENE_KEYS_SIZE] = "";
    quote_append(quote_append(path, sizeof path, section), sizeof path, section[0] != '\0' ? "." : "");
    quote(shown, sizeof shown, key);
    quote_append(path, sizeof path, load->set == NULL ? shown : key);
    return fail(load, &load->yaml.place, path, "unknown key '%s'; known %s%s: %s", shown,
                section[0] != '\0' ? "in " : "here", section, scene_field_list(section, list, sizeof list));
}

/** The row of a key in a section, NULL if there is none. */
static const struct scene_field *find_key(const char *section, const char *key)
{
    for (int k = 0; scene_field_at(k) != NULL; ++k) {
        const char *known = scene_field_key(scene_field_at(k), section);
        if (known != NULL && strcmp(known, key) == 0)
            return scene_field_at(k);
    }
    return NULL;
}

/** The part at hand is a key in the section; its value follows. */
static int load_key(struct load *load, const char *section)
{
    const struct place key = load->yaml.place;
    if (load->yaml.part != YAML_WORD)
        return fail(load, &key, "", "a list or section stands where a key belongs; write 'key: value'");
    const struct scene_field *field = find_key(section, load->yaml.word);
    if (field == NULL)
        return fail_unknown(load, section, load->yaml.word);
    const struct scene_value *value = scene_reader_at(load->reader, field->path);
    if (value->given)
        return fail(load, &key, field->path, "given a second time, first on line %lu; keep one of them",
                    (unsigned long)value->key.line);
    return step(load) != 0 ? -1 : load_value(load, field, key);
}

static int load_section(struct load *load, const char *section)
{
    char list[LIST_SIZE], found[2 * QUOTE_SIZE];
    const struct place place = load->yaml.place;
    if (load->yaml.part != YAML_SECTION)
        return describe(load, found) != 0
                   ? -1
                   : fail(load, &place, section, "%s is not a %s; write its keys, each on a line of its own: %s", found,
                          section[0] == '\0' ? "scene" : "section", scene_field_list(section, list, sizeof list));
    while (step(load) == 0) {
        if (load->yaml.part == YAML_CLOSE)
            return 0;
        if (load_key(load, section) != 0)
            return -1;
    }
    return -1;
}

/* ---- texts ------------------------------------------------------------------------------------------------------- */

/** A text of comments, or of '---' alone, which libfyaml 0.8 passes over and 0.7 reads as an empty word. */
static int is_nothing(const struct yaml *yaml, const struct scene_field *field)
{
    return yaml->part == YAML_END || (field == NULL && yaml->part == YAML_WORD && yaml->word[0] == '\0');
}

static int fail_nothing(const struct load *load)
{
    const struct place first = {1, 1};
    return load->set != NULL ? fail(load, NULL, load->path, "no value in it; write one")
                             : fail(load, &first, "", "no scene in it; write at least bodies, h and t_end");
}

static int load_scene(struct load *load)
{
    load->reader->start = load->yaml.place;
    return load_section(load, "");
}

/** The whole text as the value of a row of the table; NULL: as the scene. */
static int load_text(struct load *load, const char *text, size_t size, const struct scene_field *field)
{
    scene_yaml_open(&load->yaml, text, size, &load->problem);
    int result = step(load);
    if (result == 0 && is_nothing(&load->yaml, field))
        result = fail_nothing(load);
    else if (result == 0)
        result = field != NULL ? load_value(load, field, load->yaml.place) : load_scene(load);
    if (result == 0)
        result = step(load); /* the end, or a second document */
    scene_yaml_close(&load->yaml);
    return result;
}

/* ---- --set ------------------------------------------------------------------------------------------------------- */

/** No such path: named with the innermost section of it that there is. */
static int fail_unknown_path(struct load *load)
{
    char section[SCENE_KEYS_SIZE] = "";
    const struct scene_field *field;
    quote_append(section, sizeof section, load->path);
    do {
        scene_path_up(section);
        field = scene_field_find(section);
    } while (section[0] != '\0' && (field == NULL || field->kind != SCENE_SECTION));
    const size_t n = strlen(section);
    return fail_unknown(load, section, load->path + n + (n > 0));
}

/** The sections around the value are given now. */
static void give_sections(const struct load *load)
{
    char section[SCENE_KEYS_SIZE] = "";
    quote_append(section, sizeof section, load->path);
    for (scene_path_up(section); section[0] != '\0'; scene_path_up(section)) {
        struct scene_value *value = scene_reader_at(load->reader, section);
        if (value->given && value->set == NULL)
            continue;
        value->given = 1;
        value->set = load->set;
    }
}

int scene_load(struct scene_reader *reader, const char *set, const char *path, const char *text, size_t size)
{
    char list[LIST_SIZE];
    struct load load = {.reader = reader, .set = set, .path = path};
    const struct scene_field *field = scene_field_find(path);
    if (set != NULL && field == NULL)
        return fail_unknown_path(&load);
    if (field != NULL && field->kind == SCENE_SECTION)
        return fail(&load, NULL, path, "a section is not set as a whole; set one of its keys: %s",
                    scene_field_list(path, list, sizeof list));
    give_sections(&load);
    return load_text(&load, text, size, field);
}
