/* SPDX-License-Identifier: BSD-3-Clause
 * Principal moments and axes of a symmetric matrix. */
#ifndef VTI_PRINCIPAL_H
#define VTI_PRINCIPAL_H

#include "vti.h"

/** Turns rows and columns p and q of the symmetric J so that J_pq = 0 (Jacobi), and the axes, columns of V, with it. */
static inline void annul(double J[3][3], double V[3][3], int p, int q)
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
static inline void axis_of(double V[3][3], int k, double axis[3])
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
static inline void principal_of(double J[3][3], double moments[3], double principal[4])
{
    double V[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}, first[3], second[3], third[3];
    int order[3] = {0, 1, 2};
    for (int sweep = 0; sweep < 32; ++sweep) {
        annul(J, V, 0, 1);
        annul(J, V, 0, 2);
        annul(J, V, 1, 2);
    }
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
        principal[k] = q[k] / norm;
    for (int k = 0; k < 3; ++k)
        moments[k] = J[order[k]][order[k]];
}

#endif
