/* SPDX-License-Identifier: BSD-3-Clause
 * What the tests of models share: from the text of a scene to the model, in the present directory. */
#ifndef VTI_MODEL_SUPPORT_H
#define VTI_MODEL_SUPPORT_H

#include "scene_support.h"

#include "loop.h"

#define TIME "h: 1/64\nt_end: 1\n"

static inline void write_text(const char *path, const char *text)
{
    write_bytes(path, text, strlen(text));
}

/** Returns 0, or -1 with a line, of the reader or of the model. */
static inline int try_model(const char *text, struct scene *scene, struct model *model, struct message *message)
{
    write_text("t.yaml", text);
    if (scene_read("t.yaml", NULL, 0, scene, message) != 0)
        return -1;
    return model_create(scene, model, message);
}

static inline void make_model(const char *text, struct scene *scene, struct model *model)
{
    struct message message;
    if (try_model(text, scene, model, &message) != 0)
        fail_msg("%s", message.text);
}

/** The model of a shipped scene. */
static inline void open_scene(const char *folder, const char *name, struct scene *scene, struct model *model)
{
    char path[1024];
    struct message message;
    snprintf(path, sizeof path, "%s/%s.yaml", folder, name);
    if (scene_read(path, NULL, 0, scene, &message) != 0 || model_create(scene, model, &message) != 0)
        fail_msg("%s", message.text);
}

/** The model has the effects of that list, in that order. */
static inline void assert_effects(const struct model *model, const char *names)
{
    char list[256] = "";
    for (int64_t e = 0; e < model->effects_count; ++e) {
        quote_append(list, sizeof list, e > 0 ? " " : "");
        quote_append(list, sizeof list, model->effects[e].name);
    }
    assert_string_equal(list, names);
}

static inline void assert_invariants(const struct model *model, const char *names)
{
    struct invariant invariant[MODEL_INVARIANTS];
    char list[256] = "";
    const int64_t n = model_invariants(model, invariant);
    for (int64_t k = 0; k < n; ++k) {
        quote_append(list, sizeof list, k > 0 ? " " : "");
        quote_append(list, sizeof list, invariant[k].name);
    }
    assert_string_equal(list, names);
}

#endif
