/* SPDX-License-Identifier: BSD-3-Clause
 * What the effects of a model remember and have booked: into a checkpoint and out of it, and body by body. */
#include "model_parts.h"

#include <string.h>

/* ---- what a checkpoint holds of the effects ---------------------------------------------------------------------- */

enum { BOOKS = 2 * VTI_TERMS }; /* doubles */

/** Sums of all bodies of effect k. */
static int64_t sums_of_bodies(const struct model *model, int64_t k)
{
    const struct effect *e = &model->instances[k];
    return e->by_body != NULL ? model_acted_on(model, e) * model->effects[k].of_body : 0;
}

static double *get_sums(const vti_sum *sum, int64_t n, double *memory)
{
    for (int64_t j = 0; j < n; ++j) {
        *memory++ = sum[j].high;
        *memory++ = sum[j].low;
    }
    return memory;
}

static const double *put_sums(vti_sum *sum, int64_t n, const double *memory)
{
    for (int64_t j = 0; j < n; ++j) {
        sum[j].high = *memory++;
        sum[j].low = *memory++;
    }
    return memory;
}

int64_t model_memory_size(const struct model *model)
{
    int64_t size = 0;
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        size += model->effects[k].books > 0 ? BOOKS : 0;
        size += 2 * sums_of_bodies(model, k);
        size += e->kind->memory != NULL ? e->kind->memory->size(e) : 0;
    }
    return size;
}

void model_memory_get(const struct model *model, double *memory)
{
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        if (model->effects[k].books > 0)
            memory = get_sums(e->booked, VTI_TERMS, memory);
        memory = get_sums(e->by_body, sums_of_bodies(model, k), memory);
        if (e->kind->memory == NULL)
            continue;
        e->kind->memory->get(e, memory);
        memory += e->kind->memory->size(e);
    }
}

int model_memory_put(struct model *model, const double *memory, int64_t size)
{
    for (int64_t k = 0; k < model->instances_count; ++k) {
        struct effect *e = &model->instances[k];
        const int64_t terms = model->effects[k].books > 0 ? VTI_TERMS : 0, sums = sums_of_bodies(model, k);
        if (size < 2 * (terms + sums))
            return -1;
        memory = put_sums(e->by_body, sums, put_sums(e->booked, terms, memory));
        size -= 2 * (terms + sums);
        if (e->kind->memory == NULL)
            continue;
        const int64_t taken = e->kind->memory->put(e, memory, size);
        if (taken < 0)
            return -1;
        memory += taken;
        size -= taken;
    }
    return size == 0 ? 0 : -1;
}

/* ---- what each body has lost ------------------------------------------------------------------------------------- */

int64_t model_body_books(const struct model *model, const char *name[EFFECT_TERMS_OF_ALL])
{
    int64_t count = 0;
    for (int64_t k = 0; k < model->instances_count; ++k)
        for (int64_t j = 0; model->instances[k].by_body != NULL && j < model->effects[k].books; ++j)
            name[count++] = model->effects[k].book[j];
    return count;
}

void model_body_booked(const struct model *model, int64_t k, const int64_t *number, double *value)
{
    int64_t of = 0;
    while (model->instances[of].by_body == NULL || k >= model->effects[of].books) {
        k -= model->instances[of].by_body != NULL ? model->effects[of].books : 0;
        ++of;
    }
    const vti_effect *const acting = &model->acting[of];
    const int64_t n = model_acted_on(model, &model->instances[of]);
    memset(value, 0, (size_t)model->bodies.count * sizeof *value);
    for (int64_t s = 0; s < n; ++s) {
        const int64_t i = model->on_spheres[of] ? model->clumps.list.body[s] - model->clumps.list.base : s;
        value[number != NULL ? number[i] : i] += vti_sum_value(&acting->by_body[acting->of_body * s + k]);
    }
}
