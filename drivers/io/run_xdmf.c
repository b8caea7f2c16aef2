/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Two grids over time, "bodies" and, if there are any, "bonds", that share the points. Every array is a slab of the
 * rows of one frame in a dataset of /VTKHDF. */
#include "run_text.h"

#include "fields.h"
#include "number.h"
#include "shape.h"

struct writer {
    const struct record *record;
    FILE *file;
    const char *name; /* of the HDF5 file */
    int bonds;        /* the grid is that of the bonds */
};

static void escaped(FILE *file, const char *text)
{
    for (; *text != '\0'; ++text) {
        if (*text == '&')
            fputs("&amp;", file);
        else if (*text == '<')
            fputs("&lt;", file);
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
    const long long n = (long long)w->record->frames.n, all = n * (long long)w->record->journal->frames.mark.count;
    fprintf(w->file,
            "<DataItem ItemType=\"HyperSlab\" Dimensions=\"%lld%s %lld\">\n"
            "<DataItem Dimensions=\"3 2\" NumberType=\"Int\" Format=\"XML\">%lld 0 1 1 %lld %lld</DataItem>\n",
            n, columns == 3 ? "" : " 1", (long long)columns, n * (long long)k, n, (long long)columns);
    whole(w, path, all, columns, "Float");
    fputs("</DataItem>\n", w->file);
}

/** The bonds of frame k in a dataset of numbers of all cells: bodies before bonds, frame after frame. */
static void slab_of_bonds(const struct writer *w, const char *path, int64_t k)
{
    const long long n = (long long)w->record->frames.n, bonds = (long long)shape_bonds(w->record->model);
    fprintf(w->file,
            "<DataItem ItemType=\"HyperSlab\" Dimensions=\"%lld\">\n"
            "<DataItem Dimensions=\"3 1\" NumberType=\"Int\" Format=\"XML\">%lld 1 %lld</DataItem>\n",
            bonds, (n + bonds) * (long long)k + n, bonds);
    whole(w, path, (n + bonds) * (long long)w->record->journal->frames.mark.count, 1, "Float");
    fputs("</DataItem>\n", w->file);
}

static void bond_attribute(const struct writer *w, const char *name, int64_t k)
{
    char path[64];
    snprintf(path, sizeof path, "CellData/%s", name);
    fprintf(w->file, "<Attribute Name=\"%s\" AttributeType=\"Scalar\" Center=\"Cell\">\n", name);
    slab_of_bonds(w, path, k);
    fputs("</Attribute>\n", w->file);
}

static void attribute(const struct writer *w, const char *name, int64_t k, int64_t columns)
{
    char path[64];
    snprintf(path, sizeof path, "PointData/%s", name);
    fprintf(w->file, "<Attribute Name=\"%s\" AttributeType=\"%s\" Center=\"Node\">\n", name,
            columns == 3 ? "Vector" : "Matrix");
    slab(w, path, k, columns);
    fputs("</Attribute>\n", w->file);
}

static void fixed_attribute(const struct writer *w, const char *name, const char *type)
{
    char path[64];
    snprintf(path, sizeof path, "PointData/%s", name);
    fprintf(w->file, "<Attribute Name=\"%s\" AttributeType=\"Scalar\" Center=\"Node\">\n", name);
    whole(w, path, w->record->frames.n, 1, type);
    fputs("</Attribute>\n", w->file);
}

static void topology(const struct writer *w)
{
    const int64_t n = w->record->frames.n, bonds = shape_bonds(w->record->model);
    if (w->bonds)
        fprintf(w->file, "<Topology TopologyType=\"Polyline\" NodesPerElement=\"2\" NumberOfElements=\"%lld\">\n",
                (long long)bonds);
    else
        fprintf(w->file, "<Topology TopologyType=\"Polyvertex\" NodesPerElement=\"1\" NumberOfElements=\"%lld\">\n",
                (long long)n);
    /* a slab of everything: only where the topology is no plain dataset does ParaView's reader read each frame's
     * geometry without complaint */
    const long long points = w->bonds ? 2 * bonds : n;
    fprintf(w->file,
            "<DataItem ItemType=\"HyperSlab\" Dimensions=\"%lld\">\n"
            "<DataItem Dimensions=\"3 1\" NumberType=\"Int\" Format=\"XML\">0 1 %lld</DataItem>\n",
            points, points);
    whole(w, w->bonds ? "Lines/Connectivity" : "Vertices/Connectivity", points, 1, "Int");
    fputs("</DataItem>\n</Topology>\n", w->file);
}

static int take_frame(void *self, int64_t k, const double *frame)
{
    const struct writer *w = self;
    const struct frame_layout *layout = &w->record->frames;
    fprintf(w->file, "<Grid Name=\"%s\" GridType=\"Uniform\">\n<Time Value=\"%s\"/>\n", w->bonds ? "bonds" : "bodies",
            NUMBER(frame[1]));
    topology(w);
    fputs("<Geometry GeometryType=\"XYZ\">\n", w->file);
    slab(w, "Points", k, 3);
    fputs("</Geometry>\n", w->file);
    if (layout->translates)
        attribute(w, "velocity", k, 3);
    if (layout->turns) {
        attribute(w, "omega", k, 3);
        attribute(w, "alpha", k, 3);
        attribute(w, "attitude_xyzw", k, 4);
        attribute(w, "attitude_wxyz", k, 4);
        attribute(w, "director", k, 3);
    }
    if ((w->record->fields & FIELD_FORCE) != 0)
        attribute(w, "force", k, 3);
    if ((w->record->fields & FIELD_MOMENT) != 0)
        attribute(w, "moment", k, 3);
    if (shape_has_diameters(w->record->model))
        fixed_attribute(w, "diameter", "Float");
    fixed_attribute(w, "body", "Int");
    if (w->bonds) {
        bond_attribute(w, "bond_energy", k);
        bond_attribute(w, "bond_stretch", k);
    }
    fputs("</Grid>\n", w->file);
    return ferror(w->file) ? -1 : 0;
}

int run_xdmf_write(const struct record *record, const char *name, FILE *file, struct message *message)
{
    struct writer w = {record, file, name, 0};
    int failed = 0;
    fputs("<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n", file);
    for (; failed == 0 && w.bonds <= (shape_bonds(record->model) > 0); ++w.bonds) {
        fprintf(file, "<Grid Name=\"%s\" GridType=\"Collection\" CollectionType=\"Temporal\">\n",
                w.bonds ? "bonds over time" : "bodies over time");
        failed = record_frames(record, take_frame, &w, message);
        fputs("</Grid>\n", file);
    }
    fputs("</Domain>\n</Xdmf>\n", file);
    return failed;
}
