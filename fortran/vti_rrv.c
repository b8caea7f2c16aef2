/* SPDX-License-Identifier: BSD-3-Clause
 * The inline functions of vti_rrv.h as symbols, for module vti_rrv: one copy of each formula, and the same bits. */
#include "vti_rrv.h"

void vti_rrv_compose_f(const double a[3], const double b[3], double r[3]);
void vti_rrv_inverse_f(const double a[3], double r[3]);
void vti_rrv_relative_f(const double a[3], const double b[3], double r[3]);
void vti_rrv_turn_side_f(double c, const double u[3], double side, double a[3]);
void vti_rrv_rotate_side_f(const double a[3], double side, const double p[3], double r[3]);
double vti_rrv_angle_f(const double a[3]);
double vti_rrv_distance_f(const double a[3], const double b[3]);
void vti_rrv_from_rotvec_f(const double theta[3], double a[3]);
void vti_rrv_to_rotvec_f(const double a[3], double theta[3]);
void vti_rrv_to_quat_xyzw_f(const double a[3], double q[4]);
void vti_rrv_from_quat_xyzw_f(const double q[4], double a[3]);
void vti_rrv_to_matrix_f(const double a[3], double R[9]);
void vti_rrv_from_matrix_f(const double R[9], double a[3]);

void vti_rrv_compose_f(const double a[3], const double b[3], double r[3])
{
    vti_rrv_compose(a, b, r);
}

void vti_rrv_inverse_f(const double a[3], double r[3])
{
    vti_rrv_inverse(a, r);
}

void vti_rrv_relative_f(const double a[3], const double b[3], double r[3])
{
    vti_rrv_relative(a, b, r);
}

void vti_rrv_turn_side_f(double c, const double u[3], double side, double a[3])
{
    vti_rrv_turn_side(c, u, side, a);
}

void vti_rrv_rotate_side_f(const double a[3], double side, const double p[3], double r[3])
{
    vti_rrv_rotate_side(a, side, p, r);
}

double vti_rrv_angle_f(const double a[3])
{
    return vti_rrv_angle(a);
}

double vti_rrv_distance_f(const double a[3], const double b[3])
{
    return vti_rrv_distance(a, b);
}

void vti_rrv_from_rotvec_f(const double theta[3], double a[3])
{
    vti_rrv_from_rotvec(theta, a);
}

void vti_rrv_to_rotvec_f(const double a[3], double theta[3])
{
    vti_rrv_to_rotvec(a, theta);
}

void vti_rrv_to_quat_xyzw_f(const double a[3], double q[4])
{
    vti_rrv_to_quat_xyzw(a, q);
}

void vti_rrv_from_quat_xyzw_f(const double q[4], double a[3])
{
    vti_rrv_from_quat_xyzw(q, a);
}

void vti_rrv_to_matrix_f(const double a[3], double R[9])
{
    vti_rrv_to_matrix(a, R);
}

void vti_rrv_from_matrix_f(const double R[9], double a[3])
{
    vti_rrv_from_matrix(R, a);
}
