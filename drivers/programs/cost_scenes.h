/* SPDX-License-Identifier: BSD-3-Clause
 * The scenes of a cost study, as they are named on the command line: SCENE.yaml, or SCENE.yaml@10,100 with their
 * ends. */
#ifndef VTI_COST_SCENES_H
#define VTI_COST_SCENES_H

#include "cost_plan.h"
#include "table.h"

/** Scenes and what their tables hold. Must not be moved while a plan looks at it. */
struct cost_scenes {
    int count;
    char paths[COST_CASES][SCENE_PATH_SIZE]; /* of the scenes' files */
    struct scene scenes[COST_CASES];
    struct tables tables[COST_CASES];
};

/** Reads n scenes, with the overrides sets, and adds them to the plan; t_end (may be NULL) holds the ends of those
 *  without "@", as --t-end has them. Returns 0, or -1 with one line in *message; cost_scenes_destroy in either case. */
int cost_scenes_read(const char *const *names, int n, const char *const *sets, int sets_count, const char *t_end,
                     struct cost_scenes *scenes, struct cost_plan *plan, struct message *message);
void cost_scenes_destroy(struct cost_scenes *scenes);

#endif
