/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The caller's memory for a list of pairs: how many they are, how many slots the table has, the list itself, for each
 * pair the slot at which one begins to look for it and the one where it has been, and the order of each window. */
#include <string.h>

#include "vti_hertz.h"
#include "vti_touching.h"

enum { COUNT, BASE, SLOTS, HEAD };

static int64_t windows_of(int64_t pairs)
{
    return (pairs + VTI_WINDOW - 1) / VTI_WINDOW;
}

int64_t vti_touching_room(int64_t pairs)
{
    return pairs > 0 ? HEAD + 4 * pairs + windows_of(pairs) * (int64_t)(sizeof(struct vti_order) / sizeof(int64_t)) : 0;
}

static int is_for(const vti_touching *touching, const vti_contacts *list)
{
    return touching != NULL && touching->memory != NULL && list->count > 0 &&
           touching->room >= vti_touching_room(list->count);
}

static int is_of(const int64_t *memory, const vti_contacts *list)
{
    return memory[COUNT] == list->count && memory[BASE] == list->base &&
           memcmp(memory + HEAD, list->pair, (size_t)list->count * 2 * sizeof *list->pair) == 0;
}

static struct vti_list_kept in(int64_t *memory, int64_t count, const vti_history *table)
{
    int64_t *const home = memory + HEAD + 2 * count;
    const int holds = table != NULL && table->slot != NULL;
    return (struct vti_list_kept){
        .slot = holds ? home + count : NULL, .home = home, .order = (struct vti_order *)(void *)(home + 2 * count)};
}

/** Slots of another number, in which each pair has another place. */
static void find_homes(int64_t *memory, const vti_contacts *list, const vti_history *table)
{
    int64_t *const home = memory + HEAD + 2 * list->count, *const slot = home + list->count;
    memory[SLOTS] = table->slots;
    for (int64_t k = 0; k < list->count; ++k)
        slot[k] = home[k] = vti_history_home(table, 1 + vti_contact_body(list, k, 0), 1 + vti_contact_body(list, k, 1));
}

static void clear(int64_t *memory, const vti_contacts *list)
{
    struct vti_order *const order = in(memory, list->count, NULL).order;
    memory[COUNT] = list->count;
    memory[BASE] = list->base;
    memory[SLOTS] = 0;
    memcpy(memory + HEAD, list->pair, (size_t)list->count * 2 * sizeof *list->pair);
    for (int64_t w = 0; w < windows_of(list->count); ++w)
        order[w].count = 0;
}

struct vti_list_kept vti_touching_take(const vti_touching *touching, const vti_contacts *list, const vti_history *table)
{
    if (!is_for(touching, list))
        return (struct vti_list_kept){.slot = NULL};
    int64_t *const memory = touching->memory;
    if (!is_of(memory, list))
        clear(memory, list);
    if (table != NULL && table->slot != NULL && memory[SLOTS] != table->slots)
        find_homes(memory, list, table);
    return in(memory, list->count, table);
}

struct vti_list_kept vti_touching_read(const vti_touching *touching, const vti_contacts *list, const vti_history *table)
{
    if (!is_for(touching, list) || !is_of(touching->memory, list) || touching->memory[SLOTS] != table->slots)
        return (struct vti_list_kept){.slot = NULL};
    return in(touching->memory, list->count, table);
}
