/* SPDX-License-Identifier: BSD-3-Clause */
#include <stdlib.h>

#include "kind.h"
#include "model.h"

void *effect_memory(struct effect *e, size_t bytes, struct message *message)
{
    e->self = calloc(1, bytes);
    if (e->self == NULL)
        message_set(message, "%s: out of memory", e->kind->key);
    return e->self;
}

const struct effect *effect_with_friction(const struct model *model)
{
    const struct effect *found = NULL;
    for (int64_t k = 0; k < model->instances_count; ++k)
        if (model->instances[k].kind->friction != NULL)
            found = &model->instances[k];
    return found;
}

int effect_walls_match(const struct model *model, const char *path, const struct scene_numbers *numbers,
                       const vti_walls *walls, struct message *message)
{
    const int64_t count = walls != NULL ? walls->count + walls->cylinders : 0;
    if (numbers->count == 0 || numbers->count == count)
        return 0;
    return message_set(message, "%s: %s: %lld numbers for %lld walls; give one for each plane, then for each cylinder",
                       model->scene->name, path, (long long)numbers->count, (long long)count);
}

void *effect_part_room(struct effect_part *part, int64_t n)
{
    const size_t bytes = (size_t)(n > 0 ? n : 1) * sizeof(double);
    if (bytes > part->room) {
        free(part->memory);
        part->memory = malloc(bytes);
        part->room = part->memory != NULL ? bytes : 0;
    }
    return part->memory;
}
