/* SPDX-License-Identifier: BSD-3-Clause
 * What tests look at of effects in scenes and models: by the keys and names that users write. */
#ifndef VTI_SETTINGS_H
#define VTI_SETTINGS_H

#include "kind.h"
#include "model.h"

/** The value that a scene has at a path of its table of keys, to be read or changed. */
static inline void *setting(const struct scene *scene, const char *path)
{
    return scene_field_place(scene_field_find(path), (struct scene *)scene);
}

static inline double *number_setting(const struct scene *scene, const char *path)
{
    return setting(scene, path);
}

static inline int calls_for(const struct scene *scene, const char *key)
{
    return scene->has[kinds_find(key)->number];
}

/** What the library's effect of that name acts with (vti_bonds and so on); NULL if the model has none. */
static inline const void *acting(const struct model *model, const char *name)
{
    for (int64_t e = 0; e < model->effects_count; ++e)
        if (model->effects[e].name != NULL && strcmp(model->effects[e].name, name) == 0)
            return model->effects[e].self;
    return NULL;
}

/** Count 0 where there are none. */
static inline vti_bonds bonds_of(const struct model *model)
{
    const vti_bonds none = {0}, *bonds = acting(model, "binder");
    return bonds != NULL ? *bonds : none;
}

#endif
