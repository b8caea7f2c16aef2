/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Quaternions moved along their derivative and normalised, n(q) = q/|q|, with Omega found again from L on the way.
 * w_b(q) = diag(k) R_p^T L, along the principal axes; Omega(q) = R_p w_b.
 *
 * Richardson, as the documentation of LAMMPS names it for fix nve/asphere and fix nve/body (A. P. Thompson et al.,
 * Comput. Phys. Commun. 271, 108171 (2022)):
 *
 *     f = n(q + (h/2) Omega(q) q),  m = n(q + (h/4) Omega(q) q),  m <- n(m + (h/4) Omega(m) m),  q <- n(2 m - f)
 *
 * Fincham's leapfrog (D. Fincham, Leapfrog rotational algorithms, Mol. Simul. 8, 165 (1992)), its quaternion at the
 * half step by one explicit step:
 *
 *     m = n(q + (h/4) q w_b(q)),  q <- n(q + (h/2) m w_b(m))
 *
 * M. P. Allen and D. J. Tildesley, Computer Simulation of Liquids (1987), section 3.3, and after them YADE for
 * particles that are no spheres (V. Smilauer et al., Yade documentation 3rd ed. (2021), "Motion integration"): the
 * same with the axes of the step's start in both places,
 *
 *     m = q + (h/4) q w_b(q),  q <- n(q + (h/2) m w_b(q))
 *
 * which is of order 1 where bodies are no spheres. */
#include "general.h"

/** n(q + t q w) */
VTI_INLINE void moved(const double q[4], double t, const double w[3], double r[4])
{
    const double u[3] = {t * w[0], t * w[1], t * w[2]};
    general_turned(1.0, u, q, r);
    quat_unit_of(r, r);
}

VTI_INLINE int richardson(double h, const double I[3], const double k[3], const double L[3], double q[4])
{
    double w[3], f[4], m[4], r[4];
    (void)I;
    general_body_omega(k, L, q, w);
    moved(q, 0.5 * h, w, f);
    moved(q, 0.25 * h, w, m);
    general_body_omega(k, L, m, w);
    moved(m, 0.25 * h, w, r);
    for (int n = 0; n < 4; ++n)
        r[n] = 2.0 * r[n] - f[n];
    quat_unit_of(r, q);
    return 0;
}

/** q <- n(q + (h/2) m w) */
VTI_INLINE void step_along(double h, const double m[4], const double w[3], double q[4])
{
    const double u[3] = {0.5 * h * w[0], 0.5 * h * w[1], 0.5 * h * w[2]};
    double r[4];
    general_turned(0.0, u, m, r);
    for (int n = 0; n < 4; ++n)
        r[n] += q[n];
    quat_unit_of(r, q);
}

VTI_INLINE int fincham(double h, const double I[3], const double k[3], const double L[3], double q[4])
{
    double w[3], m[4];
    (void)I;
    general_body_omega(k, L, q, w);
    moved(q, 0.25 * h, w, m);
    general_body_omega(k, L, m, w);
    step_along(h, m, w, q);
    return 0;
}

VTI_INLINE int allen_tildesley(double h, const double I[3], const double k[3], const double L[3], double q[4])
{
    double w[3], m[4];
    (void)I;
    general_body_omega(k, L, q, w);
    const double u[3] = {0.25 * h * w[0], 0.25 * h * w[1], 0.25 * h * w[2]};
    general_turned(1.0, u, q, m);
    step_along(h, m, w, q);
    return 0;
}

GENERAL_RIVAL(rival_asphere, richardson, 2, "lammps-asphere",
              "velocity Verlet by L, quaternion by Richardson iteration (LAMMPS fix nve/asphere, nve/body; Thompson et "
              "al. 2022); bodies of three moments")
GENERAL_RIVAL(rival_fincham, fincham, 2, "fincham",
              "velocity Verlet by L, quaternion by an explicit half step (Fincham 1992); bodies of three moments")
GENERAL_RIVAL(rival_yade_aspherical, allen_tildesley, 1, "yade-aspherical",
              "velocity Verlet by L, both halves by the axes of the start (Allen and Tildesley 1987; YADE, Smilauer et "
              "al. 2021); bodies of three moments")
