/* SPDX-License-Identifier: BSD-3-Clause */

#include <string.h>

#include "kind.h"
#include "quote.h"
#include "scene.h"
#include "scene_field.h"
#include "scene_stepper.h"

static const char *const kinds[SCENE_KINDS] = {[SCENE_SECTION] = "section",
                                               [SCENE_NUMBER] = "number",
                                               [SCENE_VECTOR] = "three numbers",
                                               [SCENE_COUNT] = "whole number",
                                               [SCENE_COUNTS] = "three whole numbers",
                                               [SCENE_PLANES] = "list of rows of four numbers",
                                               [SCENE_CYLINDERS] = "list of rows of seven numbers",
                                               [SCENE_SPHERES] = "list of rows of four numbers",
                                               [SCENE_VECTORS] = "list of rows of three numbers",
                                               [SCENE_NUMBERS] = "list of numbers",
                                               [SCENE_YES_NO] = "yes or no",
                                               [SCENE_WORD] = "word",
                                               [SCENE_PATH] = "path",
                                               [SCENE_NAME] = "name",
                                               [SCENE_STEPPER] = "stepper"};

static void list_steppers(FILE *file)
{
    for (int64_t k = 0; scene_stepper_at(k) != NULL; ++k)
        if (scene_stepper_at(k)->frame == VTI_FRAME_SPACE) /* others are for hosts, and refused */
            fprintf(file, "%s\t%s\n", scene_stepper_at(k)->name, scene_stepper_at(k)->about);
}

static void list_effects(FILE *file)
{
    for (int k = 0; k < EFFECT_COUNT; ++k)
        fprintf(file, "%s\t%s\n", kinds_at(k)->key, kinds_at(k)->fields[0].about);
}

static void list_keys(FILE *file)
{
    static const char *const ranges[] = {"", ", above 0", ", not below 0", ", not 0", ", from 0 to 0.5"};
    for (int k = 0; scene_field_at(k) != NULL; ++k) {
        const struct scene_field *f = scene_field_at(k);
        char words[128] = "";
        for (const struct scene_word *w = f->words; w != NULL && w->word != NULL; ++w)
            quote_append(quote_append(words, sizeof words, w == f->words ? ": " : ", "), sizeof words, w->word);
        fprintf(file, "%s\t%s (%s%s%s%s). %s\n", f->path, f->about, kinds[f->kind], words, ranges[f->range],
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
