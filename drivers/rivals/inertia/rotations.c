/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Turns by angles, with sines and cosines.
 *
 * NO_SQUISH (T. F. Miller, M. Eleftheriou, P. Pattnaik, A. Ndirango, D. Newns, G. J. Martyna, Symplectic quaternion
 * scheme for biophysical molecular dynamics, J. Chem. Phys. 116, 8649 (2002)), as LAMMPS has it in fix rigid/nve: turns
 * about the body's axes 3, 2, 1, 2, 3 by 1/2, 1/2, 1, 1/2, 1/2 of h p_i/I_i, each exact. On unit quaternions and L
 * that is the same map as on its quaternions of momentum.
 *
 * Buss (S. R. Buss, Accurate and efficient simulation of rigid-body rotations, J. Comput. Phys. 164, 377 (2000)), the
 * augmented second-order method: a turn in space by
 *
 *     h w + (h^2/2) a + (h^3/12) a x w,   w = R_p w_b,  a = R_p diag(k) (p x w_b) = w' */
#include "general.h"

/** q <- q exp(phi e_i/2), and p as the body's axes then see it. */
VTI_INLINE void turn_about(int i, double phi, double q[4], double p[3])
{
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    double s, c, u[3] = {0.0, 0.0, 0.0}, r[4];
    vti_sin_cos(0.5 * phi, &s, &c);
    u[i] = s;
    general_turned(c, u, q, r);
    for (int n = 0; n < 4; ++n)
        q[n] = r[n];
    const double C = (c - s) * (c + s), S = 2.0 * c * s, p_j = C * p[j] + S * p[k];
    p[k] = C * p[k] - S * p[j];
    p[j] = p_j;
}

VTI_INLINE int no_squish(double h, const double I[3], const double k[3], const double L[3], double q[4])
{
    double p[3];
    (void)I;
    vti_pair_rotate(q, -1.0, L, p);
    turn_about(2, 0.5 * h * k[2] * p[2], q, p);
    turn_about(1, 0.5 * h * k[1] * p[1], q, p);
    turn_about(0, h * k[0] * p[0], q, p);
    turn_about(1, 0.5 * h * k[1] * p[1], q, p);
    turn_about(2, 0.5 * h * k[2] * p[2], q, p);
    return 0;
}

VTI_INLINE int buss(double h, const double I[3], const double k[3], const double L[3], double q[4])
{
    static const double no_moment[3] = {0.0, 0.0, 0.0};
    double w[3], a[3], x[3], u[3];
    general_body_omega(k, L, q, w);
    euler_body_rate(I, w, no_moment, a);
    vti_pair_rotate(q, 1.0, w, w);
    vti_pair_rotate(q, 1.0, a, a);
    vti_cross(a, w, x);
    for (int n = 0; n < 3; ++n)
        u[n] = h * (w[n] + h * (0.5 * a[n] + h * (1.0 / 12.0) * x[n]));
    quat_turn_exactly(u, q);
    return 0;
}

GENERAL_RIVAL(rival_no_squish, no_squish, 2, "no-squish",
              "velocity Verlet by L, five exact turns about the body's axes (NO_SQUISH, Miller et al. 2002; LAMMPS fix "
              "rigid/nve); bodies of three moments")
GENERAL_RIVAL(rival_buss, buss, 2, "buss",
              "velocity Verlet by L, turn by the augmented second-order rotation vector (Buss 2000); bodies of three "
              "moments")
