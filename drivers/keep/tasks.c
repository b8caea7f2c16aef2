/* SPDX-License-Identifier: BSD-3-Clause */
#include "tasks.h"

#include <stdlib.h>
#include <string.h>

int tasks_open(struct tasks *tasks, const char *folder, const char *name, int resume, const char *identity,
               size_t bytes, struct message *message)
{
    char path[FOLDER_PATH];
    memset(tasks, 0, sizeof *tasks);
    tasks->size = sizeof(int64_t) + bytes;
    tasks->result = malloc(tasks->size);
    if (tasks->result == NULL)
        return message_set(message, "out of memory; use fewer runs");
    if (folder_path(folder, name, 0, path, message) == 0 &&
        keep_open(&tasks->keep, path, "study", identity, resume, message) == 0) {
        if (keep_check(&tasks->keep, KEEP_RESULTS, &tasks->kept, message) == 0)
            return 0;
        keep_close(&tasks->keep);
    }
    free(tasks->result);
    memset(tasks, 0, sizeof *tasks);
    return -1;
}

static int recall(void *self, int64_t task, int *rank, void *result)
{
    struct tasks *tasks = self;
    const void *bytes;
    size_t size;
    int64_t of;
    struct message ignored;
    if (keep_get(&tasks->keep, KEEP_RESULTS, task, &bytes, &size, &ignored) <= 0 || size != tasks->size)
        return 0;
    memcpy(&of, bytes, sizeof of);
    memcpy(result, (const char *)bytes + sizeof of, size - sizeof of);
    *rank = (int)of;
    return 1;
}

static int keep(void *self, int64_t task, int rank, const void *result, struct message *message)
{
    struct tasks *tasks = self;
    const int64_t of = rank;
    memcpy(tasks->result, &of, sizeof of);
    memcpy(tasks->result + sizeof of, result, tasks->size - sizeof of);
    if (keep_put(&tasks->keep, KEEP_RESULTS, task, tasks->result, tasks->size, message) != 0)
        return -1;
    ++tasks->kept;
    return keep_settle(&tasks->keep, message);
}

struct store tasks_store(struct tasks *tasks)
{
    const struct store store = {tasks, recall, keep};
    return store;
}

void tasks_settle(struct tasks *tasks)
{
    struct message later; /* the next result will say it */
    keep_settle(&tasks->keep, &later);
}

int tasks_commit(struct tasks *tasks, struct message *message)
{
    return tasks->keep.waits ? keep_commit(&tasks->keep, message) : 0;
}

void tasks_end(struct tasks *tasks, int removes)
{
    if (removes || !tasks->keep.holds)
        keep_remove(&tasks->keep);
    else
        keep_close(&tasks->keep);
    free(tasks->result);
    memset(tasks, 0, sizeof *tasks);
}
