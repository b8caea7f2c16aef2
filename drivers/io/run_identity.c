/* SPDX-License-Identifier: BSD-3-Clause */
#include "run_identity.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "digest.h"
#include "shape.h"
#include "state.h"
#include "table.h"

static int digest_file(const char *path, uint64_t *digest, struct message *message)
{
    unsigned char block[4096];
    FILE *file = fopen(path, "rb");
    *digest = DIGEST_START;
    if (file == NULL)
        return message_set(message, "%s: cannot be read: %s", path, strerror(errno));
    for (size_t n; (n = fread(block, 1, sizeof block, file)) > 0;)
        *digest = digest_add(*digest, block, n);
    const int failed = ferror(file);
    fclose(file);
    return failed ? message_set(message, "%s: cannot be read to its end", path) : 0;
}

static int is_end_time(const char *override)
{
    static const char key[] = "t_end";
    override += strspn(override, " ");
    if (strncmp(override, key, strlen(key)) != 0)
        return 0;
    override += strlen(key);
    return override[strspn(override, " ")] == '=';
}

static double scalar(const vti_scalars *s, int64_t i)
{
    return s->p != NULL ? s->p[i * s->stride] : 0.0;
}

/** Of all numbers of the bodies that a table may give, as the run begins with them. */
static int digest_bodies(const struct model *model, uint64_t *digest)
{
    const vti_bodies *b = &model->bodies;
    const int64_t size = state_size(b);
    double *state = calloc((size_t)size + 1, sizeof *state);
    if (state == NULL)
        return -1;
    state_get(b, state);
    *digest = DIGEST_START;
    for (int64_t k = 0; k < size; ++k)
        *digest = digest_number(*digest, state[k]);
    free(state);
    for (int64_t i = 0; i < b->count; ++i) {
        *digest = digest_number(*digest, scalar(&b->mass, i));
        *digest = digest_number(*digest, scalar(&b->inertia, i));
        *digest = digest_number(*digest, shape_diameter(model, i));
    }
    return 0;
}

/** Of all tables of effects. */
static uint64_t digest_tables(const struct tables *tables)
{
    uint64_t digest = DIGEST_START;
    for (int e = 0; tables != NULL && e < EFFECT_COUNT; ++e)
        for (int c = 0; c < TABLE_COLUMNS; ++c) {
            const struct table *t = &tables->effect[e];
            digest = table_has(t, c) ? digest_integer(digest, (uint64_t)c) : digest;
            for (int64_t r = 0; table_has(t, c) && r < t->rows; ++r)
                digest = digest_number(digest, t->column[c][r]);
        }
    return digest;
}

int run_identity(const char *path, const char *const *overrides, int n, const struct model *model,
                 struct identity *identity, struct message *message)
{
    memset(identity, 0, sizeof *identity);
    snprintf(identity->version, sizeof identity->version, "%s", vti_version());
    identity->overrides = DIGEST_START;
    for (int k = 0; k < n; ++k)
        if (!is_end_time(overrides[k]))
            identity->overrides = digest_add(identity->overrides, overrides[k], strlen(overrides[k]) + 1);
    identity->tables = digest_tables(model->scene->tables);
    if (digest_bodies(model, &identity->bodies) != 0)
        return message_set(message, "%s: out of memory; use fewer bodies", path);
    return digest_file(path, &identity->scene, message);
}
