/* SPDX-License-Identifier: BSD-3-Clause */
#include "run_formats.h"

#include <stdlib.h>

#include "number.h"
#include "shape.h"

struct writer {
    const struct record *record;
    FILE *file;
    double low[3], high[3]; /* the box */
    double *xyzw;
};

/** A box without volume is none. */
static void open_box(struct writer *w)
{
    for (int c = 0; c < 3; ++c)
        if (!(w->high[c] > w->low[c])) {
            w->low[c] -= 0.5;
            w->high[c] += 0.5;
        }
}

/** Of all bodies: nobody reads these, and the shortest decimals (number.h) would take four times as long. */
static void write_numbers(FILE *file, const double *p, int n)
{
    for (int k = 0; k < n; ++k)
        fprintf(file, " %.17g", p[k]);
}

static void write_head(const struct writer *w, const double *frame)
{
    const struct frame_layout *layout = &w->record->frames;
    fprintf(w->file, "ITEM: TIME\n%s\nITEM: TIMESTEP\n%.0f\nITEM: NUMBER OF ATOMS\n%lld\n", NUMBER(frame[1]), frame[0],
            (long long)layout->n);
    fputs("ITEM: BOX BOUNDS ff ff ff\n", w->file);
    for (int c = 0; c < 3; ++c)
        fprintf(w->file, "%s %s\n", NUMBER(w->low[c]), NUMBER(w->high[c]));
    fprintf(w->file, "ITEM: ATOMS id type x y z%s%s%s\n", layout->translates ? " vx vy vz" : "",
            layout->turns ? " omegax omegay omegaz quati quatj quatk quatw" : "",
            shape_has_diameters(w->record->model) ? " radius" : "");
}

static int take_frame(void *self, int64_t k, const double *frame)
{
    struct writer *w = self;
    const struct frame_layout *layout = &w->record->frames;
    (void)k;
    write_head(w, frame);
    if (layout->turns)
        frame_attitudes(layout, frame, w->xyzw);
    for (int64_t i = 0; i < layout->n; ++i) {
        const double radius = 0.5 * shape_diameter(w->record->model, i);
        fprintf(w->file, "%lld 1", (long long)i + 1);
        write_numbers(w->file, frame + layout->x + 3 * i, 3);
        if (layout->translates)
            write_numbers(w->file, frame + layout->v + 3 * i, 3);
        if (layout->turns) {
            write_numbers(w->file, frame + layout->omega + 3 * i, 3);
            write_numbers(w->file, w->xyzw + 4 * i, 4);
        }
        write_numbers(w->file, &radius, shape_has_diameters(w->record->model));
        fputc('\n', w->file);
    }
    return ferror(w->file) ? -1 : 0;
}

int run_dump_write(const struct record *record, FILE *file, struct message *message)
{
    struct writer w = {record, file, {0}, {0}, NULL};
    w.xyzw = malloc(sizeof *w.xyzw * (size_t)(4 * record->frames.n + 1));
    if (w.xyzw == NULL)
        return message_set(message, "%s: out of memory; use fewer bodies", record->model->scene->name);
    int failed = record_box(record, w.low, w.high, message);
    open_box(&w);
    if (failed == 0)
        failed = record_frames(record, take_frame, &w, message);
    free(w.xyzw);
    return failed;
}
