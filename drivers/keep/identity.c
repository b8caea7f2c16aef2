/* SPDX-License-Identifier: BSD-3-Clause */
#include "identity.h"

#include <stdint.h>
#include <string.h>

#include "digest.h"
#include "kind.h"
#include "number.h"
#include "scene_field.h"
#include "tables.h"

/* ---- writing ----------------------------------------------------------------------------------------------------- */

void identity_version(FILE *text)
{
    fprintf(text, "vti: %s\n", vti_version());
}

static void write_numbers(FILE *text, const double *number, int count)
{
    for (int k = 0; k < count; ++k)
        fprintf(text, " %s", NUMBER(number[k]));
}

/** Where none is given, its value may be none of the words'. */
static void write_word(FILE *text, const struct scene_word *word, int64_t value)
{
    while (word->word != NULL && word->value != value)
        ++word;
    fprintf(text, " %s", word->word != NULL ? word->word : "none");
}

static void write_value(FILE *text, const struct scene_field *field, const void *value)
{
    const int64_t *count = value;
    const struct scene_list *list = value;
    switch (field->kind) {
    case SCENE_SECTION:
        break;
    case SCENE_NUMBER:
    case SCENE_VECTOR:
        write_numbers(text, value, field->kind == SCENE_VECTOR ? 3 : 1);
        break;
    case SCENE_COUNTS:
        fprintf(text, " %lld %lld %lld", (long long)count[0], (long long)count[1], (long long)count[2]);
        break;
    case SCENE_WORD:
        write_word(text, field->words, *count);
        break;
    case SCENE_COUNT:
    case SCENE_YES_NO:
        fprintf(text, " %lld", (long long)*count);
        break;
    case SCENE_PLANES:
    case SCENE_CYLINDERS:
    case SCENE_SPHERES:
    case SCENE_VECTORS:
    case SCENE_NUMBERS:
        write_numbers(text, list->numbers, (int)(list->count * scene_rows_of(field->kind)->width));
        break;
    case SCENE_PATH: /* what it holds counts, not where it lies */
        fputs(*(const char *)value != '\0' ? " given" : " none", text);
        break;
    case SCENE_NAME:
        fprintf(text, " %s", (const char *)value);
        break;
    case SCENE_STEPPER:
        fprintf(text, " %s", (*(const vti_stepper *const *)value)->name);
        break;
    }
}

static void write_table(FILE *text, const char *before, const struct table *table)
{
    for (int k = 0; k < TABLE_COLUMNS; ++k)
        if (table_has(table, k))
            fprintf(
                text, "%stable of %s, %s: %lld numbers of digest %016llx\n", before, table->kind->rows,
                table_column(table->kind, k), (long long)table->rows,
                (unsigned long long)digest_add(DIGEST_START, table->column[k], sizeof(double) * (size_t)table->rows));
}

static int is_one_of(const char *word, const char *const *words)
{
    for (; *words != NULL; ++words)
        if (strcmp(*words, word) == 0)
            return 1;
    return 0;
}

void identity_scene(FILE *text, const char *before, const struct scene *scene, const char *const *without)
{
    static struct scene copy;
    const struct scene_field *field;
    copy = *scene;
    for (int k = 0; (field = scene_field_at(k)) != NULL; ++k) {
        const void *value = scene_field_place(field, &copy);
        if (value == NULL || is_one_of(field->path, without))
            continue;
        fprintf(text, "%s%s:", before, field->path);
        write_value(text, field, value);
        fputc('\n', text);
    }
    fprintf(text, "%smotion: %d %d %d\n%seffects:", before, (int)scene->arrangement, scene->translates, scene->turns,
            before);
    for (int e = 0; e < EFFECT_COUNT; ++e)
        if (scene->has[e])
            fprintf(text, " %s", kinds_at(e)->key);
    fputc('\n', text);
    if (scene->tables == NULL)
        return;
    write_table(text, before, &scene->tables->bodies);
    for (int e = 0; e < EFFECT_COUNT; ++e)
        write_table(text, before, &scene->tables->effect[e]);
}

/* ---- comparing --------------------------------------------------------------------------------------------------- */

/** A line of a text, "key: value". */
struct line {
    const char *key, *value;
    int key_size, value_size;
};

/** Takes the line at *at and moves to the next; an empty one at the end. */
static struct line next_line(const char **at, const char *end)
{
    const size_t left = (size_t)(end - *at);
    const char *stop = memchr(*at, '\n', left), *colon;
    stop = stop != NULL ? stop : end;
    colon = memchr(*at, ':', (size_t)(stop - *at));
    colon = colon != NULL ? colon : stop;
    const char *value = colon < stop ? colon + 1 : stop;
    value += value < stop && *value == ' ';
    const struct line line = {*at, value, (int)(colon - *at), (int)(stop - value)};
    *at = stop < end ? stop + 1 : end;
    return line;
}

static int is_same(const char *a, int a_size, const char *b, int b_size)
{
    return a_size == b_size && memcmp(a, b, (size_t)a_size) == 0;
}

/** Whether the text goes on with a line of this key. */
static int has_key(const char *at, const char *end, struct line want)
{
    while (at < end) {
        const struct line line = next_line(&at, end);
        if (is_same(line.key, line.key_size, want.key, want.key_size))
            return 1;
    }
    return 0;
}

/** As much of it as a message shows. */
static int shown(int size)
{
    return size < 100 ? size : 100;
}

/** Two values of one key; of long ones, from the first word on that differs. */
static void say_values(struct line a, struct line b, struct message *difference)
{
    int at = 0, word = 0;
    for (; at < a.value_size && at < b.value_size && a.value[at] == b.value[at]; ++at)
        word = a.value[at] == ' ' ? at + 1 : word;
    if (a.value_size < 40 && b.value_size < 40)
        word = 0;
    message_set(difference, "%.*s: %s%.*s there, %s%.*s here", shown(a.key_size), a.key, word > 0 ? "... " : "",
                shown(a.value_size - word), a.value + word, word > 0 ? "... " : "", shown(b.value_size - word),
                b.value + word);
}

int identity_is(const char *there, size_t size, const char *here, struct message *difference)
{
    const char *const there_end = there + size, *const here_end = here + strlen(here);
    while (there < there_end || here < here_end) {
        const struct line a = next_line(&there, there_end), b = next_line(&here, here_end);
        const int same_key = is_same(a.key, a.key_size, b.key, b.key_size);
        if (same_key && is_same(a.value, a.value_size, b.value, b.value_size))
            continue;
        const int only_there = a.key_size > 0 && !has_key(here, here_end, a);
        const struct line only = only_there ? a : b;
        if (same_key)
            say_values(a, b, difference);
        else
            message_set(difference, "%.*s: %.*s %s", shown(only.key_size), only.key, shown(only.value_size), only.value,
                        only_there ? "there, nothing here" : "here, nothing there");
        return 0;
    }
    return 1;
}

int identity_refuse(const char *path, const char *what, const struct message *difference, struct message *message)
{
    return message_set(message,
                       "%.600s: is of another %s: %s; resume with the scene, tables and options of that %s, or "
                       "start anew with -o elsewhere",
                       path, what, difference->text, what);
}
