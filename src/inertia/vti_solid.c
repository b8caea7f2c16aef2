/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Mass, centre and principal moments of the solid that spheres make (EQUATIONS 7.5): S = int x x^T dV. Each sphere adds
 * what those before it in the list do not have, and half of that and of what those behind it do not have is the solid,
 * whatever the order. One that overlaps none is added exactly; of others lines parallel to z through their own box,
 * exact along each and by the midpoint rule across: what a line has left of a ball changes without jumps from line to
 * line, so that the rule is good, however far the spheres are spread.
 *
 * Of a thin solid, whose smallest moment is far below the largest, sums along fixed axes leave few digits of the
 * smallest: they are made again along the principal axes, across which all lengths are as short as they are. */
#include "vti_overlaps.h"
#include "vti_principal.h"
#include "../vti_ready.h"

/** Volume, int x dV and int x x^T dV (xx, yy, zz, xy, xz, yz), about a place near the spheres, along the axes to which
 *  the quaternion takes x, y and z, or along these where it is NULL. */
struct integrals {
    vti_sum volume, first[3], second[6];
    const double *axes;
};

static const int row_of[6] = {0, 1, 2, 0, 0, 1}, column_of[6] = {0, 1, 2, 1, 2, 2};

/* ---- spheres ----------------------------------------------------------------------------------------------------- */

static int spheres_check(int64_t n, const double *centre, const double *diameter, vti_fault *fault)
{
    for (int64_t s = 0; s < n; ++s) {
        if (!(isfinite(diameter[s]) && diameter[s] > 0.0))
            return vti_refuse(VTI_E_CLUMP, s, diameter[s], VTI_QUANTITY_NONE, fault);
        for (int k = 0; k < 3; ++k)
            if (!isfinite(centre[3 * s + k]))
                return vti_refuse(VTI_E_CLUMP, s, centre[3 * s + k], VTI_QUANTITY_NONE, fault);
    }
    return VTI_OK;
}

/** A box around the spheres. */
static void box_of(int64_t n, const double *centre, const double *diameter, double low[3], double high[3])
{
    for (int k = 0; k < 3; ++k) {
        low[k] = INFINITY;
        high[k] = -INFINITY;
        for (int64_t s = 0; s < n; ++s) {
            low[k] = fmin(low[k], centre[3 * s + k] - 0.5 * diameter[s]);
            high[k] = fmax(high[k], centre[3 * s + k] + 0.5 * diameter[s]);
        }
    }
}

/* ---- integrals --------------------------------------------------------------------------------------------------- */

/** From the axes of the centres to those of the sums. */
static void turn(const struct integrals *sum, double r[3])
{
    if (sum->axes != NULL)
        vti_pair_rotate(sum->axes, -1.0, r, r);
}

/** V = pi/6 D^3, S = V (c c^T + D^2/20) of a sphere with its centre at c. */
static void add_ball(const double at[3], double d, struct integrals *sum)
{
    const double volume = 0.52359877559829887 * d * d * d;
    double c[3] = {at[0], at[1], at[2]};
    turn(sum, c);
    vti_sum_add(&sum->volume, volume);
    for (int k = 0; k < 3; ++k)
        vti_sum_add(&sum->first[k], volume * c[k]);
    for (int k = 0; k < 6; ++k)
        vti_sum_add(&sum->second[k], volume * (c[row_of[k]] * c[column_of[k]] + (k < 3 ? d * d / 20.0 : 0.0)));
}

/** A piece of the line through x, y that stands for the area; its ends are counted from the height z0. */
static void add_piece(double x, double y, double z0, double area, const double piece[2], struct integrals *sum)
{
    const double a = z0 + piece[0], b = z0 + piece[1], length = area * (b - a), z = 0.5 * (a + b);
    double first[3] = {x, y, z}, half[3] = {0.0, 0.0, 0.5 * (b - a)}, second[6];
    turn(sum, first);
    turn(sum, half);
    for (int k = 0; k < 6; ++k)
        second[k] = first[row_of[k]] * first[column_of[k]] + half[row_of[k]] * half[column_of[k]] / 3.0;
    if (sum->axes == NULL)
        second[2] = (a * a + a * b + b * b) / 3.0; /* the same, of fewer roundings */
    vti_sum_add(&sum->volume, length);
    for (int k = 0; k < 3; ++k)
        vti_sum_add(&sum->first[k], length * first[k]);
    for (int k = 0; k < 6; ++k)
        vti_sum_add(&sum->second[k], length * second[k]);
}

/** Adds pieces of lines of one area, about the centre c of their sphere. */
struct adder {
    const double *c;
    double area;
    struct integrals *sum;
};

static void add_free(const struct adder *to, double x, double y, double from, double end)
{
    const double piece[2] = {from, end};
    if (from < end)
        add_piece(to->c[0] + x, to->c[1] + y, to->c[2], to->area, piece, to->sum);
}

static void add_left(const struct line *line, double x, double y, const struct adder *to)
{
    double from = line->from;
    for (int64_t k = 0; k < line->count && line->taken[k][0] < line->to; ++k) {
        add_free(to, x, y, from, line->taken[k][0]);
        from = line->taken[k][1] > from ? line->taken[k][1] : from;
    }
    add_free(to, x, y, from, line->to);
}

/** The same where the neighbours are more than there is room for. */
static void add_crowded(const struct scan *scan, double x, double y, const double ball[2], const struct adder *to)
{
    double piece[2];
    next_free(scan, x, y, ball[0], ball[1], piece);
    for (; piece[0] < piece[1]; next_free(scan, x, y, piece[1], ball[1], piece))
        add_free(to, x, y, piece[0], piece[1]);
}

/** Half of what the sphere at c has for itself: along lines x lines lines through its box. */
static void add_lines(const struct scan *scan, int64_t lines, const double c[3], struct integrals *sum)
{
    const int64_t s = scan->near->s;
    const double d = scan->diameter[s] / (double)lines;
    const struct adder to = {c, 0.5 * d * d, sum};
    struct row row;
    struct line line;
    for (int64_t i = 0; i < lines; ++i) {
        const double x = 0.5 * (double)(2 * i + 1 - lines) * d;
        find_row(scan, x, &row);
        for (int64_t j = 0; j < lines; ++j) {
            const double y = 0.5 * (double)(2 * j + 1 - lines) * d;
            double ball[2];
            if (!pass(scan->centre, scan->diameter, s, s, x, y, ball))
                continue;
            if (scan->near->count < 0)
                add_crowded(scan, x, y, ball, &to);
            else {
                find_line(&row, y, ball, &line);
                add_left(&line, x, y, &to);
            }
        }
    }
}

/** What overlaps belongs half to the sphere before and half to the one behind: so a pair is as symmetric as it is. */
static void add_spheres(int64_t n, const double *centre, const double *diameter, int64_t lines, const double about[3],
                        struct integrals *sum)
{
    for (int64_t s = 0; s < n; ++s) {
        const double c[3] = {centre[3 * s] - about[0], centre[3 * s + 1] - about[1], centre[3 * s + 2] - about[2]};
        struct neighbours near;
        struct scan scan = {n, centre, diameter, &near, 0};
        find_neighbours(n, centre, diameter, s, &near);
        if (near.count == 0)
            add_ball(c, diameter[s], sum);
        for (; near.count != 0 && scan.behind < 2; ++scan.behind)
            add_lines(&scan, lines, c, sum);
    }
}

/* ---- moments ----------------------------------------------------------------------------------------------------- */

/** C = S - V c c^T and c, V not 0. */
static void spread(const struct integrals *sum, double density, double c[3], double C[6])
{
    const double volume = vti_sum_value(&sum->volume);
    for (int k = 0; k < 3; ++k)
        c[k] = vti_sum_value(&sum->first[k]) / volume;
    for (int k = 0; k < 6; ++k)
        C[k] = density * (vti_sum_value(&sum->second[k]) - volume * c[row_of[k]] * c[column_of[k]]);
}

/** J = tr C - C */
static void weigh(const struct integrals *sum, double density, const double about[3], vti_solid *solid)
{
    double c[3], C[6], J[3][3];
    spread(sum, density, c, C);
    for (int k = 0; k < 6; ++k)
        J[row_of[k]][column_of[k]] = J[column_of[k]][row_of[k]] = (k < 3 ? C[0] + C[1] + C[2] : 0.0) - C[k];
    for (int k = 0; k < 3; ++k)
        solid->centre[k] = about[k] + c[k];
    principal_of(J, solid->moments, solid->principal);
}

/** Below that share of the largest the smallest moment has lost three digits. */
static const double thin = 0x1p-10;

/** The moments again, of sums along the axes that have been found: what these are wrong by matters to second order. */
static void weigh_thin(const struct integrals *sum, double density, double moments[3])
{
    double c[3], C[6];
    spread(sum, density, c, C);
    const double A = C[1] + C[2], B = C[2] + C[0], last = C[0] + C[1];
    moments[0] = A;
    moments[1] = fmin(B, last);
    moments[2] = fmax(B, last);
}

int vti_clump_solid(int64_t n, const double *centre, const double *diameter, double density, int64_t lines,
                    vti_solid *solid, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    if (n < 1 || lines < 1)
        return VTI_E_COUNT;
    if (centre == NULL || diameter == NULL || solid == NULL)
        return VTI_E_NULL;
    if (!vti_is_positive(density))
        return vti_refuse(VTI_E_MASS, -1, density, VTI_QUANTITY_MASS, fault);
    const int status = spheres_check(n, centre, diameter, fault);
    if (status != VTI_OK)
        return status;
    struct integrals sum = {{0.0, 0.0}, {{0.0, 0.0}}, {{0.0, 0.0}}, NULL};
    double low[3], high[3], about[3];
    box_of(n, centre, diameter, low, high);
    for (int k = 0; k < 3; ++k)
        about[k] = 0.5 * low[k] + 0.5 * high[k];
    add_spheres(n, centre, diameter, lines, about, &sum);
    vti_solid found;
    found.mass = density * vti_sum_value(&sum.volume);
    if (!vti_is_positive(found.mass))
        return vti_refuse(VTI_E_MASS, -1, found.mass, VTI_QUANTITY_MASS, fault);
    weigh(&sum, density, about, &found);
    if (isfinite(found.moments[2]) && found.moments[0] < thin * found.moments[2]) {
        struct integrals along = {{0.0, 0.0}, {{0.0, 0.0}}, {{0.0, 0.0}}, found.principal};
        add_spheres(n, centre, diameter, lines, found.centre, &along);
        weigh_thin(&along, density, found.moments);
    }
    for (int k = 0; k < 3; ++k)
        if (!vti_is_positive(found.moments[k]))
            return vti_refuse(VTI_E_CLUMP, -1, found.moments[k], VTI_QUANTITY_NONE, fault);
    *solid = found;
    return VTI_OK;
}
