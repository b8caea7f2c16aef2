/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Grids over time that share the points: "bodies" and one for the lines of each effect that has any, "bonds". Every
 * array is a slab of the rows of one frame in a dataset of /VTKHDF. Of clumps "spheres" is such a grid of
 * OUT-spheres.h5. Another grid for the planes of an effect, "walls", has a square for each: one of all times, or where
 * planes move one of each frame. */
#include "run_formats.h"

#include <math.h>
#include <string.h>

#include "record.h"
#include "number.h"
#include "shape.h"

struct writer {
    const struct record *record;
    FILE *file;
    const char *name;                /* of the HDF5 file */
    const char *points;              /* of the grid: "bodies", "spheres" */
    int64_t n;                       /* how many */
    const struct shape_group *group; /* the grid is that of these lines; NULL: of the points */
};

static void escaped(FILE *file, const char *text)
{
    for (; *text != '\0'; ++text) {
        if (*text == '&')
            fputs("&amp;", file);
        else if (*text == '<')
            fputs("&lt;", file);
        else if (*text == '>') /* of ]]> */
            fputs("&gt;", file);
        else
            fputc(*text, file);
    }
}

/** All of a dataset. */
static void whole(const struct writer *w, const char *path, int64_t rows, int64_t columns, const char *type)
{
    fprintf(w->file, "<DataItem Dimensions=\"%lld", (long long)rows);
    if (columns > 1)
        fprintf(w->file, " %lld", (long long)columns);
    fprintf(w->file, "\" NumberType=\"%s\" Precision=\"8\" Format=\"HDF\">", type);
    escaped(w->file, w->name);
    fprintf(w->file, ":/VTKHDF/%s</DataItem>\n", path);
}

/** The rows of frame k in a dataset of floating-point rows: vectors of three, or matrices of one row, which is how
 *  four components are written so that every version of ParaView's reader takes them for what they are. */
static void slab(const struct writer *w, const char *path, int64_t k, int64_t columns)
{
    const long long n = (long long)w->n, all = n * (long long)w->record->journal->frames.mark.count;
    fprintf(w->file,
            "<DataItem ItemType=\"HyperSlab\" Dimensions=\"%lld%s %lld\">\n"
            "<DataItem Dimensions=\"3 2\" NumberType=\"Int\" Format=\"XML\">%lld 0 1 1 %lld %lld</DataItem>\n",
            n, columns == 3 ? "" : " 1", (long long)columns, n * (long long)k, n, (long long)columns);
    whole(w, path, all, columns, "Float");
    fputs("</DataItem>\n", w->file);
}

/** Of a dataset with so many numbers a frame, count from the first on in frame k. */
static void slab_of_numbers(const struct writer *w, const char *path, int64_t k, int64_t all, int64_t first,
                            int64_t count)
{
    fprintf(w->file,
            "<DataItem ItemType=\"HyperSlab\" Dimensions=\"%lld\">\n"
            "<DataItem Dimensions=\"3 1\" NumberType=\"Int\" Format=\"XML\">%lld 1 %lld</DataItem>\n",
            (long long)count, (long long)all * (long long)k + (long long)first, (long long)count);
    whole(w, path, all * w->record->journal->frames.mark.count, 1, "Float");
    fputs("</DataItem>\n", w->file);
}

/** The lines of frame k in a dataset of numbers of all cells: bodies before lines, frame after frame. */
static void slab_of_lines(const struct writer *w, const char *path, int64_t k)
{
    const int64_t n = w->record->frames.n;
    slab_of_numbers(w, path, k, n + shape_lines(w->record->model), n + w->group->first, w->group->count);
}

static void line_attribute(const struct writer *w, const char *name, int64_t k)
{
    char path[64];
    snprintf(path, sizeof path, "CellData/%s", name);
    fprintf(w->file, "<Attribute Name=\"%s\" AttributeType=\"Scalar\" Center=\"Cell\">\n", name);
    slab_of_lines(w, path, k);
    fputs("</Attribute>\n", w->file);
}

static void attribute(const struct writer *w, const char *name, int64_t k, int64_t columns)
{
    const char *const type = columns == 1 ? "Scalar" : columns == 3 ? "Vector" : columns == 9 ? "Tensor" : "Matrix";
    char path[64];
    snprintf(path, sizeof path, "PointData/%s", name);
    fprintf(w->file, "<Attribute Name=\"%s\" AttributeType=\"%s\" Center=\"Node\">\n", name, type);
    if (columns == 1)
        slab_of_numbers(w, path, k, w->n, 0, w->n);
    else
        slab(w, path, k, columns);
    fputs("</Attribute>\n", w->file);
}

static void fixed_attribute(const struct writer *w, const char *name, const char *type)
{
    char path[64];
    snprintf(path, sizeof path, "PointData/%s", name);
    fprintf(w->file, "<Attribute Name=\"%s\" AttributeType=\"Scalar\" Center=\"Node\">\n", name);
    whole(w, path, w->n, 1, type);
    fputs("</Attribute>\n", w->file);
}

static void topology(const struct writer *w)
{
    const long long n = (long long)w->n, count = w->group != NULL ? (long long)w->group->count : n;
    if (w->group != NULL)
        fprintf(w->file, "<Topology TopologyType=\"Polyline\" NodesPerElement=\"2\" NumberOfElements=\"%lld\">\n",
                count);
    else
        fprintf(w->file, "<Topology TopologyType=\"Polyvertex\" NodesPerElement=\"1\" NumberOfElements=\"%lld\">\n",
                count);
    /* a slab even where it is everything: only where the topology is no plain dataset does ParaView's reader read each
     * frame's geometry without complaint */
    const long long size = w->group != NULL ? 2 : 1, first = w->group != NULL ? 2 * (long long)w->group->first : 0;
    fprintf(w->file,
            "<DataItem ItemType=\"HyperSlab\" Dimensions=\"%lld\">\n"
            "<DataItem Dimensions=\"3 1\" NumberType=\"Int\" Format=\"XML\">%lld 1 %lld</DataItem>\n",
            size * count, first, size * count);
    if (w->group != NULL)
        whole(w, "Lines/Connectivity", 2 * shape_lines(w->record->model), 1, "Int");
    else
        whole(w, "Vertices/Connectivity", n, 1, "Int");
    fputs("</DataItem>\n</Topology>\n", w->file);
}

/** The lines of the group, the spheres of clumps, or the bodies: "bonds", "spheres", "bodies". */
static void write_name(const struct writer *w)
{
    fprintf(w->file, "<Grid Name=\"%s%s", w->group != NULL ? w->group->effect->kind->lines->name : w->points,
            w->group != NULL ? "s" : "");
}

/** What every grid of a frame begins with: its time, and where its points are. */
static void begin_frame(const struct writer *w, int64_t k, double t)
{
    write_name(w);
    fprintf(w->file, "\" GridType=\"Uniform\">\n<Time Value=\"%s\"/>\n", NUMBER(t));
    topology(w);
    fputs("<Geometry GeometryType=\"XYZ\">\n", w->file);
    slab(w, "Points", k, 3);
    fputs("</Geometry>\n", w->file);
}

static int take_spheres(void *self, int64_t k, const double *frame)
{
    const struct writer *w = self;
    begin_frame(w, k, frame[1]);
    attribute(w, "velocity", k, 3);
    fixed_attribute(w, "diameter", "Float");
    fixed_attribute(w, "body", "Int");
    fputs("</Grid>\n", w->file);
    return ferror(w->file) ? -1 : 0;
}

static int take_frame(void *self, int64_t k, const double *frame)
{
    const struct writer *w = self;
    struct frame_quantity list[FRAME_QUANTITIES];
    const int count = frame_quantities(w->record, list);
    begin_frame(w, k, frame[1]);
    for (int q = 0; q < count; ++q)
        attribute(w, list[q].name, k, list[q].components);
    if (shape_has_diameters(w->record->model))
        fixed_attribute(w, "diameter", "Float");
    fixed_attribute(w, "body", "Int");
    for (int q = 0; w->group != NULL && q < shape_quantities(w->group->effect); ++q)
        line_attribute(w, w->group->effect->kind->lines->quantity[q], k);
    fputs("</Grid>\n", w->file);
    return ferror(w->file) ? -1 : 0;
}

/* ---- planes ------------------------------------------------------------------------------------------------------ */

/** A square in the plane n.x = d, in front of the box and as wide as it is long from corner to corner; n sees the
 *  corners counterclockwise. */
static void corners_of(const double plane[4], const double low[3], const double high[3], double corner[4][3])
{
    static const double at[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
    const double size[3] = {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
    const double middle[3] = {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2])};
    const double reach = size[0] + size[1] + size[2] > 0.0 ? 0.5 * sqrt(vti_dot(size, size)) : 0.5;
    const double distance = vti_dot(plane, middle) - plane[3];
    double axis[3] = {0.0, 0.0, 0.0}, u[3], v[3];
    int least = 0;
    for (int c = 1; c < 3; ++c)
        least = fabs(plane[c]) < fabs(plane[least]) ? c : least;
    axis[least] = 1.0;
    vti_cross(axis, plane, u);
    vti_cross(plane, u, v);
    for (int k = 0; k < 4; ++k)
        for (int c = 0; c < 3; ++c)
            corner[k][c] =
                middle[c] - distance * plane[c] + reach / sqrt(vti_dot(u, u)) * (at[k][0] * u[c] + at[k][1] * v[c]);
}

/** The planes of an effect, and the box of all bodies at all times. */
struct squares {
    const struct writer *w;
    const struct effect *effect;
    const vti_wall_motion *motion; /* NULL: none moves */
    double low[3], high[3];
};

/** The grid of all planes as they are at time t. */
static void write_squares(const struct squares *s, double t)
{
    const struct writer *w = s->w;
    const char *name = s->effect->kind->planes->name;
    const double *plane;
    const long long count = (long long)s->effect->kind->planes->get(s->effect, &plane);
    fprintf(w->file, "<Grid Name=\"%ss\" GridType=\"Uniform\">\n", name);
    if (s->motion != NULL)
        fprintf(w->file, "<Time Value=\"%s\"/>\n", NUMBER(t));
    fprintf(w->file,
            "<Topology TopologyType=\"Quadrilateral\" NumberOfElements=\"%lld\">\n"
            "<DataItem Dimensions=\"%lld 4\" NumberType=\"Int\" Precision=\"8\" Format=\"XML\">",
            count, count);
    for (long long k = 0; k < 4 * count; ++k)
        fprintf(w->file, "%lld%s", k, k % 4 == 3 ? "\n" : " ");
    fprintf(w->file,
            "</DataItem>\n</Topology>\n<Geometry GeometryType=\"XYZ\">\n"
            "<DataItem Dimensions=\"%lld 3\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">",
            4 * count);
    for (long long k = 0; k < count; ++k) {
        double corner[4][3], at[4];
        memcpy(at, plane + 4 * k, sizeof at);
        if (s->motion != NULL)
            at[3] += vti_dot(at, s->motion[k].velocity) * t;
        corners_of(at, s->low, s->high, corner);
        for (int c = 0; c < 4; ++c)
            fprintf(w->file, "%s %s %s\n", NUMBER(corner[c][0]), NUMBER(corner[c][1]), NUMBER(corner[c][2]));
    }
    fprintf(w->file,
            "</DataItem>\n</Geometry>\n<Attribute Name=\"%s\" AttributeType=\"Scalar\" Center=\"Cell\">\n"
            "<DataItem Dimensions=\"%lld\" NumberType=\"Int\" Precision=\"8\" Format=\"XML\">",
            name, count);
    for (long long k = 0; k < count; ++k)
        fprintf(w->file, "%lld%s", k, k + 1 < count ? " " : "");
    fputs("</DataItem>\n</Attribute>\n</Grid>\n", w->file);
}

static int take_squares(void *self, int64_t k, const double *frame)
{
    const struct squares *s = self;
    (void)k;
    write_squares(s, frame[1]);
    return ferror(s->w->file) ? -1 : 0;
}

static int write_planes(const struct writer *w, const struct effect *effect, struct message *message)
{
    const struct effect_planes *planes = effect->kind->planes;
    const double *plane;
    struct squares s = {w, effect, planes->motion != NULL ? planes->motion(effect) : NULL, {0.0}, {0.0}};
    if (planes->get(effect, &plane) == 0)
        return 0;
    if (record_box(w->record, s.low, s.high, message) != 0)
        return -1;
    if (s.motion == NULL) {
        write_squares(&s, 0.0);
        return ferror(w->file) ? -1 : 0;
    }
    fprintf(w->file, "<Grid Name=\"%ss over time\" GridType=\"Collection\" CollectionType=\"Temporal\">\n",
            planes->name);
    const int failed = record_frames(w->record, take_squares, &s, message);
    fputs("</Grid>\n", w->file);
    return failed;
}

static int write_over_time(struct writer *w, int (*take)(void *self, int64_t k, const double *frame),
                           struct message *message)
{
    write_name(w);
    fputs(" over time\" GridType=\"Collection\" CollectionType=\"Temporal\">\n", w->file);
    const int failed = record_frames(w->record, take, w, message);
    fputs("</Grid>\n", w->file);
    return failed;
}

int run_xdmf_write(const struct record *record, const char *name, const char *spheres, FILE *file,
                   struct message *message)
{
    const struct model *model = record->model;
    struct writer w = {record, file, name, "bodies", record->frames.n, NULL};
    struct writer of_clumps = {record, file, spheres, "spheres", model->clumps.list.count, NULL};
    struct shape_group list[MODEL_EFFECTS];
    const int groups = shape_groups(model, list);
    fputs("<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n", file);
    int failed = write_over_time(&w, take_frame, message);
    if (failed == 0 && of_clumps.n > 0)
        failed = write_over_time(&of_clumps, take_spheres, message);
    for (int g = 0; g < groups && failed == 0; ++g) {
        w.group = &list[g];
        failed = write_over_time(&w, take_frame, message);
    }
    for (int64_t k = 0; k < model->instances_count && failed == 0; ++k)
        if (model->instances[k].kind->planes != NULL)
            failed = write_planes(&w, &model->instances[k], message);
    fputs("</Domain>\n</Xdmf>\n", file);
    return failed;
}

double run_xdmf_bytes(const struct record *record, int64_t frames)
{
    enum { GRID = 1150, ATTRIBUTE = 340 }; /* characters */
    struct frame_quantity list[FRAME_QUANTITIES];
    struct shape_group group[MODEL_EFFECTS];
    const int groups = shape_groups(record->model, group);
    int64_t bytes = (1 + groups) * (GRID + ATTRIBUTE * frame_quantities(record, list));
    for (int g = 0; g < groups; ++g)
        bytes += ATTRIBUTE * shape_quantities(group[g].effect);
    bytes += model_has_clumps(record->model) ? GRID + ATTRIBUTE : 0;
    return (double)bytes * (double)frames;
}
