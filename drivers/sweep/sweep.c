/* SPDX-License-Identifier: BSD-3-Clause */
#include "sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"

/* ---- lists ------------------------------------------------------------------------------------------------------- */

/** The end of the value that text begins with: a comma outside brackets, or the end of the list. */
static const char *end_of_value(const char *text)
{
    int depth = 0;
    for (; *text != '\0' && (*text != ',' || depth > 0); ++text)
        depth += (*text == '[' || *text == '{') - (*text == ']' || *text == '}');
    return text;
}

static int64_t count_values(const char *list)
{
    int64_t n = 1;
    for (const char *end = end_of_value(list); *end != '\0'; end = end_of_value(end + 1))
        ++n;
    return n;
}

/** A value of a list, to be told from the others. */
struct listed {
    int is_number;
    double number;
    char text[SWEEP_VALUE]; /* without blanks */
};

/** By numbers, 0.5 like 1/2, and what is none by its text. */
static int compare_listed(const void *one, const void *other)
{
    const struct listed *a = one, *b = other;
    if (a->is_number != b->is_number)
        return a->is_number - b->is_number;
    return a->is_number ? (a->number > b->number) - (a->number < b->number) : strcmp(a->text, b->text);
}

static void take_listed(const char *value, const char *end, struct listed *listed)
{
    size_t n = 0;
    snprintf(listed->text, sizeof listed->text, "%.*s", (int)(end - value), value);
    listed->is_number = number_read(listed->text, &listed->number) == 0;
    for (const char *p = value; p < end; ++p)
        if (*p != ' ' && *p != '\t')
            listed->text[n++] = *p;
    listed->text[n] = '\0';
}

/** A value that appears twice would count twice in means and spreads. */
static int check_twice(const struct sweep_axis *axis, const char *text, struct message *message)
{
    struct listed *listed = calloc((size_t)axis->count, sizeof *listed);
    const char *value = axis->list;
    int failed = 0;
    if (listed == NULL)
        return message_set(message, "--sweep %.200s: out of memory; use fewer values", text);
    for (int64_t k = 0; k < axis->count; ++k) {
        take_listed(value, end_of_value(value), &listed[k]);
        value = end_of_value(value) + 1;
    }
    qsort(listed, (size_t)axis->count, sizeof *listed, compare_listed);
    for (int64_t k = 1; k < axis->count && failed == 0; ++k)
        if (compare_listed(&listed[k - 1], &listed[k]) == 0)
            failed =
                message_set(message, "--sweep %.200s: '%s' appears twice; name every value once", text, listed[k].text);
    free(listed);
    return failed;
}

static int read_list(struct sweep_axis *axis, const char *list, const char *text, struct message *message)
{
    axis->list = list;
    axis->count = count_values(list);
    for (const char *value = list, *end; value != NULL; value = *end != '\0' ? end + 1 : NULL) {
        end = end_of_value(value);
        if (end == value)
            return message_set(message, "--sweep %.200s: a value is empty; write a list such as 100,200", text);
        if (end - value >= SWEEP_VALUE)
            return message_set(message, "--sweep %.200s: a value is longer than %d letters", text, SWEEP_VALUE - 1);
    }
    return check_twice(axis, text, message);
}

/* ---- ranges ------------------------------------------------------------------------------------------------------ */

static int read_number(const char *from, const char *to, double *value, const char *text, struct message *message)
{
    char part[64] = "";
    const size_t n = (size_t)(to - from);
    if (n < sizeof part)
        memcpy(part, from, n);
    if (n >= sizeof part || number_read(part, value) != 0)
        return message_set(message, "--sweep %.200s: '%.*s' is not a number; write a range such as 1:1000 or 0:1:1/8",
                           text, (int)(n < sizeof part ? n : sizeof part), from);
    return 0;
}

static int read_range(struct sweep_axis *axis, const char *range, const char *text, struct message *message)
{
    const char *first = strchr(range, ':'), *second = strchr(first + 1, ':'), *end = range + strlen(range);
    double to = 0.0;
    axis->step = 1.0;
    if (read_number(range, first, &axis->from, text, message) != 0 ||
        read_number(first + 1, second != NULL ? second : end, &to, text, message) != 0 ||
        (second != NULL && read_number(second + 1, end, &axis->step, text, message) != 0))
        return -1;
    const double steps = (to - axis->from) / axis->step;
    if (!(steps >= 0.0) || isinf(steps))
        return message_set(message, "--sweep %.200s: the range is empty: steps of %s do not lead from %s to %s", text,
                           NUMBER(axis->step), NUMBER(axis->from), NUMBER(to));
    /* numbers are rounded, so that their ratio may fall short of a whole one by a few ulps */
    axis->count = (int64_t)fmin(floor(steps * (1.0 + 8.0 * 2.220446049250313e-16)) + 1.0, SWEEP_MOST + 1.0);
    return 0;
}

/* ---- axes -------------------------------------------------------------------------------------------------------- */

/** What a sweep cannot go through, and what does instead. */
static const char *other_option(const char *key)
{
    static const char *const others[][2] = {{"h", "--h"}, {"stepper", "--steppers"}, {"name", "-o"}};
    for (size_t k = 0; k < sizeof others / sizeof others[0]; ++k)
        if (strcmp(key, others[k][0]) == 0)
            return others[k][1];
    return NULL;
}

int sweep_add(struct sweep *sweep, const char *text, struct message *message)
{
    const char *equals = strchr(text, '=');
    const size_t n = equals != NULL ? (size_t)(equals - text) : 0;
    struct sweep_axis axis = {"", NULL, 0.0, 0.0, 0};
    if (n == 0 || n >= sizeof axis.key || equals[1] == '\0')
        return message_set(message,
                           "--sweep %.200s: is not KEY=VALUES; write bodies.random.seed=1:1000 or "
                           "binder.axial=100,200",
                           text);
    memcpy(axis.key, text, n);
    if (other_option(axis.key) != NULL)
        return message_set(message, "--sweep %.200s: %s is not swept; use %s", text, axis.key, other_option(axis.key));
    for (int k = 0; k < sweep->count; ++k)
        if (strcmp(sweep->axis[k].key, axis.key) == 0)
            return message_set(message, "--sweep %.200s: %s is swept twice; give all its values at once", text,
                               axis.key);
    if (sweep->count == SWEEP_AXES)
        return message_set(message, "--sweep %.200s: more than %d sweeps; use fewer", text, SWEEP_AXES);
    const int is_range = strchr(equals, ':') != NULL && strpbrk(equals, ",[{") == NULL;
    if ((is_range ? read_range : read_list)(&axis, equals + 1, text, message) != 0)
        return -1;
    sweep->axis[sweep->count++] = axis;
    return 0;
}

int sweep_check_set(const struct sweep *sweep, const char *set, struct message *message)
{
    const int option = strncmp(set, "--", 2) == 0; /* "--tolerance=1e-6" (scene.h) */
    const char *given = set + (option ? 2 : 0);
    const size_t n = strcspn(given, "=");
    for (int k = 0; k < sweep->count; ++k)
        if (strlen(sweep->axis[k].key) == n && strncmp(sweep->axis[k].key, given, n) == 0)
            return message_set(message,
                               "%s%.200s: %s is swept, and no run would have that value; leave one of them out",
                               option ? "" : "--set ", set, sweep->axis[k].key);
    return 0;
}

int64_t sweep_points(const struct sweep *sweep)
{
    int64_t n = 1;
    for (int k = 0; k < sweep->count; ++k)
        n = n * sweep->axis[k].count <= SWEEP_MOST ? n * sweep->axis[k].count : SWEEP_MOST + 1;
    return n;
}

int64_t sweep_index(const struct sweep *sweep, int64_t p, int axis)
{
    for (int k = 0; k < axis; ++k)
        p /= sweep->axis[k].count;
    return p % sweep->axis[axis].count;
}

char *sweep_value(const struct sweep_axis *axis, int64_t k, char *out, size_t size)
{
    if (axis->list == NULL) {
        snprintf(out, size, "%s", NUMBER(axis->from + (double)k * axis->step));
        return out;
    }
    const char *value = axis->list;
    for (; k > 0; --k)
        value = end_of_value(value) + 1;
    snprintf(out, size, "%.*s", (int)(end_of_value(value) - value), value);
    return out;
}

void sweep_overrides(const struct sweep *sweep, int64_t p, char out[SWEEP_AXES][SWEEP_TEXT])
{
    char value[SWEEP_VALUE];
    for (int k = 0; k < sweep->count; ++k)
        snprintf(out[k], SWEEP_TEXT, "%s=%s", sweep->axis[k].key,
                 sweep_value(&sweep->axis[k], sweep_index(sweep, p, k), value, sizeof value));
}
