/* SPDX-License-Identifier: BSD-3-Clause */
#include "run_formats.h"

#include "number.h"
#include "shape.h"

struct writer {
    const struct record *record;
    FILE *file;
    double low[3], high[3]; /* the box */
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

/** What is drawn: the spheres of clumps, ellipsoids, spheres, or points. */
static int is_of_clumps(const struct writer *w)
{
    return model_has_clumps(w->record->model);
}

static int is_of_ellipsoids(const struct writer *w)
{
    return !is_of_clumps(w) && shape_has_axes(w->record->model);
}

static void write_head(const struct writer *w, const double *frame)
{
    const struct frame_layout *layout = &w->record->frames;
    const int64_t n = is_of_clumps(w) ? w->record->model->clumps.list.count : layout->n;
    fprintf(w->file, "ITEM: TIME\n%s\nITEM: TIMESTEP\n%.0f\nITEM: NUMBER OF ATOMS\n%lld\n", NUMBER(frame[1]), frame[0],
            (long long)n);
    fputs("ITEM: BOX BOUNDS ff ff ff\n", w->file);
    for (int c = 0; c < 3; ++c)
        fprintf(w->file, "%s %s\n", NUMBER(w->low[c]), NUMBER(w->high[c]));
    fprintf(w->file, "ITEM: ATOMS id type%s x y z%s%s%s\n", is_of_clumps(w) ? " mol" : "",
            layout->translates ? " vx vy vz" : "", layout->turns ? " omegax omegay omegaz quati quatj quatk quatw" : "",
            is_of_ellipsoids(w)                                        ? " shapex shapey shapez"
            : is_of_clumps(w) || shape_has_diameters(w->record->model) ? " radius"
                                                                       : "");
}

/** Angular velocity and attitude of body i, whose principal axes are drawn if it is an ellipsoid. */
static void write_turn(const struct writer *w, const double *frame, int64_t i)
{
    const struct frame_layout *layout = &w->record->frames;
    double xyzw[4];
    if (!layout->turns)
        return;
    if (is_of_ellipsoids(w))
        frame_principal(layout, frame, i, xyzw);
    else
        vti_rrv_to_quat_xyzw(frame + layout->alpha + 3 * i, xyzw);
    write_numbers(w->file, frame + layout->omega + 3 * i, 3);
    write_numbers(w->file, xyzw, 4);
}

static void write_body(const struct writer *w, const double *frame, int64_t i)
{
    const struct frame_layout *layout = &w->record->frames;
    const double radius = 0.5 * shape_diameter(w->record->model, i);
    double axes[3];
    fprintf(w->file, "%lld 1", (long long)i + 1);
    write_numbers(w->file, frame + layout->x + 3 * i, 3);
    if (layout->translates)
        write_numbers(w->file, frame + layout->v + 3 * i, 3);
    write_turn(w, frame, i);
    if (is_of_ellipsoids(w)) {
        shape_axes(w->record->model, i, axes);
        write_numbers(w->file, axes, 3);
    } else {
        write_numbers(w->file, &radius, shape_has_diameters(w->record->model));
    }
    fputc('\n', w->file);
}

static void write_sphere(const struct writer *w, const double *frame, int64_t s)
{
    const struct clumps *clumps = &w->record->model->clumps;
    const double radius = 0.5 * clumps->diameter.p[s];
    double x[3], v[3];
    frame_sphere(&w->record->frames, frame, s, x, v);
    fprintf(w->file, "%lld 1 %lld", (long long)s + 1, (long long)clumps->list.body[s] + 1);
    write_numbers(w->file, x, 3);
    write_numbers(w->file, v, 3);
    write_turn(w, frame, clumps->list.body[s]);
    write_numbers(w->file, &radius, 1);
    fputc('\n', w->file);
}

static int take_frame(void *self, int64_t k, const double *frame)
{
    const struct writer *w = self;
    const int64_t spheres = w->record->model->clumps.list.count;
    (void)k;
    write_head(w, frame);
    for (int64_t s = 0; s < spheres; ++s)
        write_sphere(w, frame, s);
    for (int64_t i = 0; spheres == 0 && i < w->record->frames.n; ++i)
        write_body(w, frame, i);
    return ferror(w->file) ? -1 : 0;
}

/** Of a number from 1 on. */
static int digits(int64_t number)
{
    return snprintf(NULL, 0, "%lld", (long long)number);
}

double run_dump_bytes(const struct record *record, int64_t frames)
{
    enum { NUMBER_BYTES = 20, SHORT = 4, HEAD = 200 }; /* of 17 digits with a blank; of radii, mostly; of a frame */
    const struct frame_layout *layout = &record->frames;
    const struct writer w = {record, NULL, {0}, {0}};
    const int64_t n = is_of_clumps(&w) ? record->model->clumps.list.count : layout->n;
    const int numbers = 3 + (layout->translates ? 3 : 0) + (layout->turns ? 7 : 0);
    double row = NUMBER_BYTES * numbers + 3.0 + digits(n);
    row += is_of_clumps(&w) ? SHORT + 1.0 + digits(layout->n) : is_of_ellipsoids(&w) ? 3.0 * SHORT : SHORT;
    return (double)frames * ((double)n * row + HEAD);
}

int run_dump_write(const struct record *record, FILE *file, struct message *message)
{
    struct writer w = {record, file, {0}, {0}};
    const int failed = record_box(record, w.low, w.high, message);
    open_box(&w);
    return failed == 0 ? record_frames(record, take_frame, &w, message) : failed;
}
