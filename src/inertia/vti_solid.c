/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Mass, centre and principal moments of the solid that spheres make (EQUATIONS 7.5): S = int x x^T dV of disjoint
 * spheres exactly, of overlapping ones along lines parallel to z, exact along each and by the midpoint rule across. */
#include "../vti_internal.h"

/** Volume, int x dV and int x x^T dV (xx, yy, zz, xy, xz, yz), about a place near the spheres. */
struct integrals {
    vti_sum volume, first[3], second[6];
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

static int are_disjoint(int64_t n, const double *centre, const double *diameter)
{
    for (int64_t s = 0; s < n; ++s)
        for (int64_t other = 0; other < s; ++other) {
            const double *a = centre + 3 * s, *b = centre + 3 * other;
            const double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
            if (vti_norm(d) < 0.5 * (diameter[s] + diameter[other]))
                return 0;
        }
    return 1;
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

/** V = pi/6 D^3, S = V (c c^T + D^2/20) of each sphere. */
static void add_spheres(int64_t n, const double *centre, const double *diameter, const double about[3],
                        struct integrals *sum)
{
    for (int64_t s = 0; s < n; ++s) {
        const double d = diameter[s], volume = 0.52359877559829887 * d * d * d;
        const double c[3] = {centre[3 * s] - about[0], centre[3 * s + 1] - about[1], centre[3 * s + 2] - about[2]};
        vti_sum_add(&sum->volume, volume);
        for (int k = 0; k < 3; ++k)
            vti_sum_add(&sum->first[k], volume * c[k]);
        for (int k = 0; k < 6; ++k)
            vti_sum_add(&sum->second[k], volume * (c[row_of[k]] * c[column_of[k]] + (k < 3 ? d * d / 20.0 : 0.0)));
    }
}

/* ---- lines ------------------------------------------------------------------------------------------------------- */

/** Where the line through x, y passes sphere s; 0 if it does not. */
static int pass(const double *centre, double diameter, const double about[3], double x, double y, double ends[2])
{
    const double dx = x - (centre[0] - about[0]), dy = y - (centre[1] - about[1]), z = centre[2] - about[2];
    const double half2 = 0.25 * diameter * diameter - dx * dx - dy * dy;
    if (!(half2 > 0.0))
        return 0;
    ends[0] = z - sqrt(half2);
    ends[1] = z + sqrt(half2);
    return 1;
}

/** The next piece of the line inside of any sphere, beyond from: 0 if there is none. */
static int next_piece(int64_t n, const double *centre, const double *diameter, const double about[3], double x,
                      double y, double from, double piece[2])
{
    double ends[2];
    piece[0] = piece[1] = INFINITY;
    for (int64_t s = 0; s < n; ++s)
        if (pass(centre + 3 * s, diameter[s], about, x, y, ends) && ends[0] > from && ends[0] < piece[0]) {
            piece[0] = ends[0];
            piece[1] = ends[1];
        }
    for (int grows = 1; grows && piece[0] < INFINITY;) {
        grows = 0;
        for (int64_t s = 0; s < n; ++s)
            if (pass(centre + 3 * s, diameter[s], about, x, y, ends) && ends[0] <= piece[1] && ends[1] > piece[1]) {
                piece[1] = ends[1];
                grows = 1;
            }
    }
    return piece[0] < INFINITY;
}

/** A piece of the line through x, y that stands for the area. */
static void add_piece(double x, double y, double area, const double piece[2], struct integrals *sum)
{
    const double a = piece[0], b = piece[1], length = area * (b - a), z = 0.5 * (a + b);
    const double first[3] = {x, y, z}, z2 = (a * a + a * b + b * b) / 3.0;
    vti_sum_add(&sum->volume, length);
    for (int k = 0; k < 3; ++k)
        vti_sum_add(&sum->first[k], length * first[k]);
    for (int k = 0; k < 6; ++k)
        vti_sum_add(&sum->second[k], length * (k == 2 ? z2 : first[row_of[k]] * first[column_of[k]]));
}

static void add_lines(int64_t n, const double *centre, const double *diameter, int64_t lines, const double about[3],
                      const double half[3], struct integrals *sum)
{
    const double dx = 2.0 * half[0] / (double)lines, dy = 2.0 * half[1] / (double)lines;
    for (int64_t i = 0; i < lines; ++i)
        for (int64_t j = 0; j < lines; ++j) {
            const double x = -half[0] + ((double)i + 0.5) * dx, y = -half[1] + ((double)j + 0.5) * dy;
            double piece[2] = {0.0, -INFINITY};
            while (next_piece(n, centre, diameter, about, x, y, piece[1], piece))
                add_piece(x, y, dx * dy, piece, sum);
        }
}

/* ---- principal axes ---------------------------------------------------------------------------------------------- */

/** Turns rows and columns p and q of the symmetric J so that J_pq = 0 (Jacobi), and the axes, columns of V, with them.
 *  */
static void annul(double J[3][3], double V[3][3], int p, int q)
{
    if (J[p][q] == 0.0)
        return;
    const double theta = 0.5 * (J[q][q] - J[p][p]) / J[p][q];
    const double t = copysign(1.0, theta) / (fabs(theta) + sqrt(theta * theta + 1.0));
    const double c = 1.0 / sqrt(t * t + 1.0), s = t * c;
    for (int k = 0; k < 3; ++k) {
        const double a = J[k][p], b = J[k][q], v = V[k][p], w = V[k][q];
        J[k][p] = c * a - s * b;
        J[k][q] = s * a + c * b;
        V[k][p] = c * v - s * w;
        V[k][q] = s * v + c * w;
    }
    for (int k = 0; k < 3; ++k) {
        const double a = J[p][k], b = J[q][k];
        J[p][k] = c * a - s * b;
        J[q][k] = s * a + c * b;
    }
    J[p][q] = J[q][p] = 0.0;
}

/** Axis k of V as a vector whose largest component is positive. */
static void axis_of(double V[3][3], int k, double axis[3])
{
    int largest = 0;
    for (int j = 0; j < 3; ++j) {
        axis[j] = V[j][k];
        largest = fabs(axis[j]) > fabs(axis[largest]) ? j : largest;
    }
    const double sign = axis[largest] < 0.0 ? -1.0 : 1.0;
    for (int j = 0; j < 3; ++j)
        axis[j] *= sign;
}

/** Moments ascending; right-handed axes, largest components of the first two positive; w >= 0. */
static void principal_of(double J[3][3], vti_solid *solid)
{
    double V[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}, first[3], second[3], third[3];
    int order[3] = {0, 1, 2};
    for (int sweep = 0; sweep < 32; ++sweep)
        for (int pair = 3; pair < 6; ++pair)
            annul(J, V, row_of[pair], column_of[pair]);
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 2; ++j)
            if (J[order[j]][order[j]] > J[order[j + 1]][order[j + 1]]) {
                const int swap = order[j];
                order[j] = order[j + 1];
                order[j + 1] = swap;
            }
    axis_of(V, order[0], first);
    axis_of(V, order[1], second);
    vti_cross(first, second, third);
    const double R[9] = {first[0], second[0], third[0], first[1], second[1], third[1], first[2], second[2], third[2]};
    double q[4];
    vti_rrv_pair_from_matrix(R, q);
    const double norm = copysign(sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]), q[3]);
    for (int k = 0; k < 4; ++k)
        solid->principal[k] = q[k] / norm;
    for (int k = 0; k < 3; ++k)
        solid->moments[k] = J[order[k]][order[k]];
}

/** J = tr C - C, C = S - V c c^T. */
static void weigh(const struct integrals *sum, double density, const double about[3], vti_solid *solid)
{
    const double volume = vti_sum_value(&sum->volume);
    double c[3], C[6], J[3][3];
    for (int k = 0; k < 3; ++k)
        c[k] = vti_sum_value(&sum->first[k]) / volume;
    for (int k = 0; k < 6; ++k)
        C[k] = density * (vti_sum_value(&sum->second[k]) - volume * c[row_of[k]] * c[column_of[k]]);
    for (int k = 0; k < 6; ++k)
        J[row_of[k]][column_of[k]] = J[column_of[k]][row_of[k]] = (k < 3 ? C[0] + C[1] + C[2] : 0.0) - C[k];
    solid->mass = density * volume;
    for (int k = 0; k < 3; ++k)
        solid->centre[k] = about[k] + c[k];
    principal_of(J, solid);
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
    struct integrals sum = {{0.0, 0.0}, {{0.0, 0.0}}, {{0.0, 0.0}}};
    double low[3], high[3], about[3], half[3];
    box_of(n, centre, diameter, low, high);
    for (int k = 0; k < 3; ++k) {
        about[k] = 0.5 * low[k] + 0.5 * high[k];
        half[k] = 0.5 * (high[k] - low[k]);
    }
    if (are_disjoint(n, centre, diameter))
        add_spheres(n, centre, diameter, about, &sum);
    else
        add_lines(n, centre, diameter, lines, about, half, &sum);
    weigh(&sum, density, about, solid);
    return VTI_OK;
}
