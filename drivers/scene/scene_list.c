/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_list.h"

#include <string.h>

#include "quote.h"
#include "scene.h"
#include "scene_field.h"
#include "scene_stepper.h"

/** In the order of enum scene_kind. */
static const char *const kinds[] = {"section",
                                    "number",
                                    "three numbers",
                                    "whole number",
                                    "three whole numbers",
                                    "list of rows of four numbers",
                                    "yes or no",
                                    "word",
                                    "path",
                                    "name",
                                    "stepper"};

static void list_steppers(FILE *file)
{
    for (int64_t k = 0; scene_stepper_at(k) != NULL; ++k)
        fprintf(file, "%s\t%s\n", scene_stepper_at(k)->name, scene_stepper_at(k)->about);
}

/** The keys at the top that stand for physics: not the bodies, and nothing about time and names. */
static int is_effect(const struct scene_field *field)
{
    return strchr(field->path, '.') == NULL && strcmp(field->path, "bodies") != 0 &&
           (field->kind == SCENE_SECTION || field->kind == SCENE_VECTOR);
}

static void list_effects(FILE *file)
{
    for (int k = 0; scene_field_at(k) != NULL; ++k)
        if (is_effect(scene_field_at(k)))
            fprintf(file, "%s\t%s\n", scene_field_at(k)->path, scene_field_at(k)->about);
}

static void list_keys(FILE *file)
{
    static const char *const ranges[] = {"", ", above 0", ", not below 0", ", not 0"};
    for (int k = 0; scene_field_at(k) != NULL; ++k) {
        const struct scene_field *f = scene_field_at(k);
        fprintf(file, "%s\t%s (%s%s%s). %s\n", f->path, f->about, kinds[f->kind], ranges[f->range],
                f->need == SCENE_MUST ? ", needed" : "", f->says);
    }
}

int scene_list(const char *what, FILE *file, struct message *message)
{
    char quoted[QUOTE_SIZE];
    if (strcmp(what, "steppers") == 0)
        list_steppers(file);
    else if (strcmp(what, "effects") == 0)
        list_effects(file);
    else if (strcmp(what, "keys") == 0)
        list_keys(file);
    else
        return message_set(message, "--list: '%s' cannot be listed; write steppers, effects or keys",
                           quote(quoted, sizeof quoted, what));
    return 0;
}
