/* SPDX-License-Identifier: BSD-3-Clause */
#include "record.h"

#include <string.h>

static const struct {
    const char *name;
    int field;
} all[] = {{"force", FIELD_FORCE}, {"moment", FIELD_MOMENT}};

enum { ALL = sizeof all / sizeof all[0] };

int fields_read(const char *text, int *fields, struct message *message)
{
    *fields = 0;
    for (const char *at = text; at != NULL; at = strchr(at, ',')) {
        at += at > text; /* the comma */
        const size_t length = strcspn(at, ",");
        int field = 0;
        for (int k = 0; k < ALL; ++k)
            if (strlen(all[k].name) == length && strncmp(at, all[k].name, length) == 0)
                field = all[k].field;
        if (field == 0)
            return message_set(message, "--fields: '%.*s' is not a field; there are force and moment",
                               length < 100 ? (int)length : 100, at);
        *fields |= field;
    }
    return 0;
}

int fields_check(int fields, const struct model *model, struct message *message)
{
    const vti_bodies *b = &model->bodies;
    const int there = (b->force.c[0] != NULL ? FIELD_FORCE : 0) | (b->moment.c[0] != NULL ? FIELD_MOMENT : 0);
    for (int k = 0; k < ALL; ++k)
        if ((fields & ~there & all[k].field) != 0)
            return message_set(message, "--fields: no effect of %s gives a %s; leave it out", model->scene->name,
                               all[k].name);
    return 0;
}
