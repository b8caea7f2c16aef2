/* SPDX-License-Identifier: BSD-3-Clause
 * The scenes of a survey at its points. Files may be edited while it runs: texts of scenes are read once, tables anew
 * at each point, as they may be many and large, and known by digests. */
#include <stdlib.h>
#include <string.h>

#include "quote.h"
#include "survey.h"

/* ---- tables ------------------------------------------------------------------------------------------------------ */

static struct survey_table *find_table(const struct survey_files *files, const char *path, int kind)
{
    for (int64_t k = 0; k < files->tables_count; ++k)
        if (files->tables[k].kind == kind && strcmp(files->tables[k].path, path) == 0)
            return &files->tables[k];
    return NULL;
}

/** The capacity doubles. */
static int add_table(struct survey_files *files, const struct survey_table *table, struct message *message)
{
    const size_t n = (size_t)files->tables_count;
    if ((n & (n - 1)) == 0) {
        struct survey_table *more = realloc(files->tables, (n == 0 ? 1 : 2 * n) * sizeof *more);
        if (more == NULL)
            return message_set(message, "out of memory; use fewer tables");
        files->tables = more;
    }
    files->tables[files->tables_count++] = *table;
    return 0;
}

/** Whether table number kind of the scene holds what it held when it was first read. */
static int check_table(struct survey_files *files, const struct scene *scene, const struct tables *tables, int kind,
                       struct message *message)
{
    char shown[QUOTE_SIZE];
    struct survey_table table = {.kind = kind, .digest = tables_digest(tables, kind)};
    memcpy(table.path, tables_path(scene, kind), strlen(tables_path(scene, kind)) + 1);
    const struct survey_table *before = find_table(files, table.path, kind);
    if (before == NULL)
        return add_table(files, &table, message);
    if (before->digest == table.digest)
        return 0;
    message_set(message,
                "%s: has changed since the study began; put back what it was and go on with --resume, or start anew "
                "with -o elsewhere",
                quote_tail(shown, sizeof shown, table.path));
    return SURVEY_CHANGED;
}

/** What cannot be read now could be when the study began. */
static int read_tables(const struct survey_plan *plan, struct scene *scene, struct tables *tables,
                       struct message *message)
{
    if (plan->read_tables(scene, tables, message) != 0)
        return SURVEY_CHANGED;
    int failed = 0;
    for (int k = 0; k < TABLES && failed == 0; ++k)
        if (tables_path(scene, k)[0] != '\0')
            failed = check_table(plan->files, scene, tables, k, message);
    if (failed != 0)
        tables_destroy(tables);
    return failed;
}

/* ---- scenes ------------------------------------------------------------------------------------------------------ */

int survey_read(const struct survey_plan *plan, int k, int64_t place, struct scene *scene, struct tables *tables,
                struct message *message)
{
    static char swept[SWEEP_AXES][SWEEP_TEXT];
    struct scene_text *text = &plan->files->scene[k];
    if (text->bytes == NULL && scene_text_read(plan->scenes[k], text, message) != 0)
        return -1;
    const char **overrides = calloc((size_t)plan->sets_count + SWEEP_AXES, sizeof *overrides);
    if (overrides == NULL)
        return message_set(message, "out of memory");
    for (int i = 0; i < plan->sets_count; ++i)
        overrides[i] = plan->sets[i];
    sweep_overrides(plan->sweep, place, swept);
    for (int i = 0; i < plan->sweep->count; ++i)
        overrides[plan->sets_count + i] = swept[i];
    const int failed =
        scene_read_text(plan->scenes[k], text, overrides, plan->sets_count + plan->sweep->count, scene, message);
    free((void *)overrides);
    return failed != 0 ? failed : read_tables(plan, scene, tables, message);
}

struct plan survey_plan_with(const struct survey_plan *plan, int k, const struct scene *scene)
{
    struct plan each = plan->each[k];
    each.scene = scene;
    each.t_end = each.t_end > 0.0 ? each.t_end : scene->t_end;
    return each;
}

/** A message that blames --set for what a sweep has set. */
static int blame_sweep(const struct survey_plan *plan, struct message *message)
{
    static const char set[] = "--set ";
    const struct message said = *message;
    const char *at = strstr(said.text, set);
    for (int i = 0; at != NULL && i < plan->sweep->count; ++i) {
        const char *key = plan->sweep->axis[i].key;
        if (strncmp(at + strlen(set), key, strlen(key)) == 0 && at[strlen(set) + strlen(key)] == '=')
            return message_set(message, "%.*s--sweep %s", (int)(at - said.text), said.text, at + strlen(set));
    }
    return -1;
}

int survey_read_first(const struct survey_plan *plan, int k, struct scene *scene, struct tables *tables,
                      struct message *message)
{
    return survey_read(plan, k, 0, scene, tables, message) != 0 ? blame_sweep(plan, message) : 0;
}

static int check_place(const struct survey_plan *plan, int k, int64_t place, struct message *message)
{
    static struct scene scene;
    static struct tables tables;
    if (survey_read(plan, k, place, &scene, &tables, message) != 0)
        return blame_sweep(plan, message);
    const struct plan each = survey_plan_with(plan, k, &scene);
    const int failed = study_check(&each, message);
    tables_destroy(&tables);
    return failed;
}

int survey_check(const struct survey_plan *plan, struct message *message)
{
    const struct sweep *sweep = plan->sweep;
    if (survey_runs(plan) > SWEEP_MOST)
        return message_set(
            message, "--sweep: more than %d runs: steppers x steps x values x scenes; use fewer, or several studies",
            SWEEP_MOST);
    for (int k = 0; k < plan->scenes_count; ++k) {
        int64_t stride = 1;
        if (check_place(plan, k, 0, message) != 0)
            return -1;
        for (int i = 0; i < k; ++i)
            if (strcmp(plan->first[i].name, plan->first[k].name) == 0)
                return message_set(message, "%s: two scenes have the name %s; give them different names",
                                   plan->scenes[k], plan->first[k].name);
        for (int i = 0; i < sweep->count; stride *= sweep->axis[i++].count)
            for (int64_t v = sweep->axis[i].list != NULL ? 1 : sweep->axis[i].count - 1; v < sweep->axis[i].count; ++v)
                if (v > 0 && check_place(plan, k, v * stride, message) != 0)
                    return -1;
    }
    return 0;
}
