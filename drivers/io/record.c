/* SPDX-License-Identifier: BSD-3-Clause */
#include "record.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "shape.h"

static double *memory(int64_t doubles, const struct record *record, struct message *message)
{
    double *p = malloc(sizeof *p * (size_t)doubles);
    if (p == NULL)
        scene_no_memory(record->model->scene, message);
    return p;
}

/** All records of a stream, in blocks. */
static int read_blocks(const struct record *record, struct journal_file *file,
                       int (*take)(void *self, int64_t first, int64_t count, const double *rows), void *self,
                       struct message *message)
{
    enum { BLOCK = 4096 };
    double *rows = memory(BLOCK * file->mark.doubles, record, message);
    int failed = rows == NULL;
    for (int64_t first = 0; !failed && first < file->mark.count; first += BLOCK) {
        const int64_t count = file->mark.count - first < BLOCK ? file->mark.count - first : BLOCK;
        failed = journal_read(record->journal, file, first, count, rows, message) != 0 ||
                 take(self, first, count, rows) != 0;
    }
    free(rows);
    return failed ? -1 : 0;
}

int record_rows(const struct record *record, int (*take)(void *self, int64_t first, int64_t count, const double *rows),
                void *self, struct message *message)
{
    return read_blocks(record, &record->journal->rows, take, self, message);
}

int record_touches(const struct record *record,
                   int (*take)(void *self, int64_t first, int64_t count, const double *touches), void *self,
                   struct message *message)
{
    return read_blocks(record, &record->journal->touches, take, self, message);
}

int record_frames(const struct record *record, int (*take)(void *self, int64_t k, const double *frame), void *self,
                  struct message *message)
{
    struct journal_file *file = &record->journal->frames;
    double *frame = memory(file->mark.doubles, record, message);
    int failed = frame == NULL;
    for (int64_t k = 0; !failed && k < file->mark.count; ++k)
        failed = journal_read(record->journal, file, k, 1, frame, message) != 0 || take(self, k, frame) != 0;
    free(frame);
    return failed ? -1 : 0;
}

void record_touch(int64_t frame, const struct touch *touch, double row[TOUCH_DOUBLES])
{
    row[TOUCH_FRAME] = (double)frame;
    row[TOUCH_I] = (double)touch->i;
    row[TOUCH_J] = (double)touch->j;
    for (int c = 0; c < 3; ++c) {
        row[TOUCH_FROM + c] = touch->from[c];
        row[TOUCH_TO + c] = touch->to[c];
        row[TOUCH_FORCE + c] = touch->normal[c] + touch->tangential[c];
    }
    row[TOUCH_NORMAL] = vti_norm(touch->normal);
    row[TOUCH_TANGENTIAL] = vti_norm(touch->tangential);
    row[TOUCH_OVERLAP] = touch->overlap;
}

struct box {
    const struct record *record;
    double *low, *high;
};

/** By a sphere; it may be the first. */
static void widen(const struct box *box, int first, const double centre[3], double r)
{
    for (int c = 0; c < 3; ++c) {
        box->low[c] = first || centre[c] - r < box->low[c] ? centre[c] - r : box->low[c];
        box->high[c] = first || centre[c] + r > box->high[c] ? centre[c] + r : box->high[c];
    }
}

/** How far body i reaches from its centre, whichever way an ellipsoid is turned. */
static double radius_of(const struct model *model, int64_t i)
{
    double axes[3];
    if (!shape_has_axes(model))
        return 0.5 * shape_diameter(model, i);
    shape_axes(model, i, axes);
    return 0.5 * fmax(fmax(axes[0], axes[1]), axes[2]);
}

static int widen_box(void *self, int64_t k, const double *frame)
{
    struct box *box = self;
    const struct frame_layout *layout = &box->record->frames;
    const struct clumps *clumps = &box->record->model->clumps;
    const int64_t spheres = clumps->list.count;
    for (int64_t i = 0; i < (spheres > 0 ? spheres : layout->n); ++i) {
        double centre[3], v[3];
        if (spheres > 0)
            frame_sphere(layout, frame, i, centre, v);
        else
            memcpy(centre, frame + layout->x + 3 * i, sizeof centre);
        const double r = spheres > 0 ? 0.5 * clumps->diameter.p[i] : radius_of(box->record->model, i);
        widen(box, k == 0 && i == 0, centre, r);
    }
    return 0;
}

int record_box(const struct record *record, double low[3], double high[3], struct message *message)
{
    struct box box = {record, low, high};
    return record_frames(record, widen_box, &box, message);
}

/* ---- fields that are asked for ----------------------------------------------------------------------------------- */

static const struct {
    const char *name;
    int field;
} all[] = {{"force", FIELD_FORCE}, {"moment", FIELD_MOMENT}, {"lost", FIELD_LOST}};

enum { ALL = sizeof all / sizeof all[0] };

int record_fields_read(const char *text, int *fields, struct message *message)
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
            return message_set(message, "--fields: '%.*s' is not a field; there are force, moment and lost",
                               length < 100 ? (int)length : 100, at);
        *fields |= field;
    }
    return 0;
}

void record_fields_say(int fields, FILE *file)
{
    int said = 0;
    for (int k = 0; k < ALL; ++k)
        if ((fields & all[k].field) != 0)
            fprintf(file, "%s%s", said++ > 0 ? "," : "", all[k].name);
}

int record_fields_check(int fields, const struct model *model, struct message *message)
{
    const vti_bodies *b = &model->bodies;
    const char *name[EFFECT_TERMS_OF_ALL];
    const int there = (b->force.c[0] != NULL ? FIELD_FORCE : 0) | (b->moment.c[0] != NULL ? FIELD_MOMENT : 0);
    if ((fields & FIELD_LOST) != 0 && model_body_books(model, name) == 0)
        return message_set(message, "--fields: no effect of %s takes energy that bodies lose; leave lost out",
                           model->scene->name);
    for (int k = 0; k < ALL; ++k)
        if ((fields & FIELD_LOADS & ~there & all[k].field) != 0)
            return message_set(message, "--fields: no effect of %s gives a %s; leave it out", model->scene->name,
                               all[k].name);
    return 0;
}
