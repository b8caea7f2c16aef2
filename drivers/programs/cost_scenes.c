/* SPDX-License-Identifier: BSD-3-Clause
 * Reads the scenes of vti-study --cost, SCENE.yaml or SCENE.yaml@T,..., and their tables into its plan. */
#define _POSIX_C_SOURCE 200809L
#include "study_go.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "table_hdf5.h"

static int read_one(const char *name, const char *const *sets, int sets_count, const char *t_end,
                    struct cost_scenes *scenes, struct cost_plan *plan, struct message *message)
{
    /* a file may have an @ in its own name */
    const char *at = access(name, R_OK) != 0 ? strrchr(name, '@') : NULL;
    const size_t length = at != NULL ? (size_t)(at - name) : strlen(name);
    if (length >= SCENE_PATH_SIZE)
        return message_set(message, "%.64s...: is longer than %d characters; use a shorter path", name,
                           SCENE_PATH_SIZE - 1);
    if (scenes->count == COST_CASES)
        return message_set(message, "%s: more than %d scenes; use fewer at a time", name, COST_CASES);
    char *path = scenes->paths[scenes->count];
    memcpy(path, name, length);
    path[length] = '\0';
    struct scene *scene = &scenes->scenes[scenes->count];
    struct tables *tables = &scenes->tables[scenes->count];
    if (scene_read(path, sets, sets_count, scene, message) != 0)
        return -1;
    ++scenes->count;
    if (tables_read(scene, tables, message) != 0)
        return -1;
    return cost_plan_add(plan, scene, at != NULL ? at + 1 : t_end, at != NULL ? name : "--t-end", message);
}

int cost_scenes_read(const char *const *names, int n, const char *const *sets, int sets_count, const char *t_end,
                     struct cost_scenes *scenes, struct cost_plan *plan, struct message *message)
{
    memset(scenes, 0, sizeof *scenes);
    for (int k = 0; k < n; ++k)
        if (read_one(names[k], sets, sets_count, t_end, scenes, plan, message) != 0)
            return -1;
    return 0;
}

void cost_scenes_destroy(struct cost_scenes *scenes)
{
    for (int k = 0; k < scenes->count; ++k)
        tables_destroy(&scenes->tables[k]);
    scenes->count = 0;
}
