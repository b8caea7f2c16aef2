/* SPDX-License-Identifier: BSD-3-Clause
 * What C has for the functions of module vti_rrv, in the order of test_fortran_rotation.f90. */
#include "vti_rrv.h"

void shim_rotations(const double a[3], const double b[3], double c, double r[56]);

void shim_rotations(const double a[3], const double b[3], double c, double r[56])
{
    vti_rrv_compose(a, b, r);
    vti_rrv_inverse(a, r + 3);
    vti_rrv_relative(a, b, r + 6);
    for (int k = 0; k < 3; ++k)
        r[9 + k] = r[12 + k] = a[k];
    vti_rrv_turn_side(c, b, 1.0, r + 9);
    vti_rrv_turn_side(c, b, -1.0, r + 12);
    vti_rrv_rotate(a, b, r + 15);
    vti_rrv_rotate_back(a, b, r + 18);
    r[21] = vti_rrv_angle(a);
    r[22] = vti_rrv_distance(a, b);
    vti_rrv_from_rotvec(b, r + 23);
    vti_rrv_to_rotvec(a, r + 26);
    const double q[4] = {b[0], b[1], b[2], c};
    vti_rrv_from_quat_xyzw(q, r + 29);
    vti_rrv_to_quat_xyzw(a, r + 32);
    vti_rrv_to_matrix(a, r + 36);
    vti_rrv_from_matrix(r + 36, r + 45);
    for (int k = 0; k < 3; ++k) /* R b, by the matrix */
        r[48 + k] = r[36 + 3 * k] * b[0] + r[37 + 3 * k] * b[1] + r[38 + 3 * k] * b[2];
    vti_rrv_relative_printed(a, b, r + 51);
    r[54] = r[55] = 0.0;
}
