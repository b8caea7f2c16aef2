/* SPDX-License-Identifier: BSD-3-Clause */
#include "study_identity.h"

#include <stdio.h>
#include <string.h>

#include "digest.h"
#include "table.h"

static void add(struct task_identity *identity, enum task_part part, const void *bytes, size_t size)
{
    identity->part[part] = digest_add(identity->part[part], bytes, size);
}

static void add_name(struct task_identity *identity, enum task_part part, const char *name)
{
    add(identity, part, name, strlen(name) + 1);
}

static void add_table(struct task_identity *identity, enum task_part part, const struct table *table)
{
    for (int k = 0; k < TABLE_COLUMNS; ++k) {
        if (!table_has(table, k))
            continue;
        identity->part[part] = digest_integer(identity->part[part], (uint64_t)k);
        add(identity, part, table->column[k], sizeof(double) * (size_t)table->rows);
    }
}

/** Whether there is a table, but not where it lies: what it holds counts. */
static void forget_place(char *path, size_t size)
{
    memset(path, path[0] != '\0', size);
}

/** All of it but what a study has for itself. scene_read leaves zeros in what it does not set. */
static void add_scene(struct task_identity *identity, const struct scene *scene)
{
    static struct scene copy;
    memcpy(&copy, scene, sizeof copy);
    copy.tables = NULL;
    copy.stepper = NULL;
    copy.h = copy.t_end = 0.0;
    for (int k = 0; k < TABLES; ++k) {
        char *path = (char *)tables_path(&copy, k); /* in the copy, or "" */
        if (path[0] != '\0')
            forget_place(path, SCENE_PATH_SIZE);
    }
    add(identity, TASK_SCENES, &copy, sizeof copy);
    if (scene->tables != NULL) {
        add_table(identity, TASK_BODIES, &scene->tables->bodies);
        for (int e = 0; e < EFFECT_COUNT; ++e)
            add_table(identity, TASK_TABLES, &scene->tables->effect[e]);
    }
}

static struct task_identity start(int64_t tasks, size_t bytes)
{
    struct task_identity identity;
    memset(&identity, 0, sizeof identity);
    snprintf(identity.version, sizeof identity.version, "%s", vti_version());
    identity.tasks = tasks;
    identity.bytes = (int64_t)bytes;
    for (int k = 0; k < TASK_PARTS; ++k)
        identity.part[k] = DIGEST_START;
    return identity;
}

struct task_identity study_identity(const struct plan *plan)
{
    struct task_identity identity = start(plan->steppers_count * plan->h_count, sizeof(struct outcome));
    add_scene(&identity, plan->scene);
    for (int64_t k = 0; k < plan->steppers_count; ++k)
        add_name(&identity, TASK_METHODS, plan->steppers[k]->name);
    add(&identity, TASK_STEPS, plan->h, sizeof *plan->h * (size_t)plan->h_count);
    add(&identity, TASK_ENDS, &plan->t_end, sizeof plan->t_end);
    add(&identity, TASK_LIMITS, &plan->memory, sizeof plan->memory);
    return identity;
}

/** Of the scenes at their first points, and of what is swept. */
struct task_identity survey_identity(const struct survey_plan *plan)
{
    struct task_identity identity = start(survey_points(plan), (size_t)survey_bytes(plan));
    for (int k = 0; k < plan->scenes_count; ++k) {
        const struct plan *each = &plan->each[k];
        add_scene(&identity, &plan->first[k]);
        add(&identity, TASK_STEPS, each->h, sizeof *each->h * (size_t)each->h_count);
        add(&identity, TASK_ENDS, &each->t_end, sizeof each->t_end);
    }
    for (int64_t k = 0; k < plan->each[0].steppers_count; ++k)
        add_name(&identity, TASK_METHODS, plan->each[0].steppers[k]->name);
    for (int k = 0; k < plan->sweep->count; ++k) {
        const struct sweep_axis *axis = &plan->sweep->axis[k];
        add_name(&identity, TASK_SCENES, axis->key);
        add_name(&identity, TASK_SCENES, axis->list != NULL ? axis->list : "");
        add(&identity, TASK_SCENES, &axis->from, sizeof axis->from);
        add(&identity, TASK_SCENES, &axis->step, sizeof axis->step);
    }
    add(&identity, TASK_LIMITS, &plan->each[0].memory, sizeof plan->each[0].memory);
    return identity;
}

struct task_identity cost_identity(const struct cost_plan *plan)
{
    struct task_identity identity = start(plan->cases_count * plan->methods_count, sizeof(struct cost_ladder));
    for (int64_t k = 0; k < plan->cases_count; ++k) {
        add_scene(&identity, plan->cases[k].scene);
        add(&identity, TASK_ENDS, &plan->cases[k].t_end, sizeof plan->cases[k].t_end);
    }
    for (int64_t k = 0; k < plan->methods_count; ++k)
        add_name(&identity, TASK_METHODS, plan->methods[k]->name);
    add(&identity, TASK_STEPS, plan->h, sizeof *plan->h * (size_t)plan->h_count);
    add(&identity, TASK_LIMITS, &plan->most_evals, sizeof plan->most_evals);
    add(&identity, TASK_LIMITS, &plan->memory, sizeof plan->memory);
    return identity;
}
