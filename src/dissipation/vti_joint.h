/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A place where bodies of any inertia act on each other: two bodies with moments, clumps where their spheres touch, one
 * of them and a wall, or one alone. With the arms a from the centres of mass to the place, L being what impulses
 * change,
 *
 *     u = v_i + Omega_i x a_i - v_j - Omega_j x a_j,      w = Omega_i - Omega_j,
 *     impulse p:          v += p/m, L += a x p of i,      v -= p/m, L -= a x p of j,
 *     moment impulse l:   L += l of i,                    L -= l of j,
 *
 * they change by u += K p, w += H l with the symmetric tensors
 *
 *     e.K f = (1/m_i + 1/m_j) e.f + sum (a x e).J^-1 (a x f),      e.H f = sum e.J^-1 f.
 *
 * A dashpot of coefficient c on the motion along some directions lets u decay as exp(-c t K) there: along the
 * eigenvectors of K among them, its modes, each by a decay of its own. For spheres these are the formulas of
 * vti_touch_motion.h (EQUATIONS 6.2, 6.3). */
#ifndef VTI_JOINT_H
#define VTI_JOINT_H

#include "vti_decay.h"
#include "vti.h"

/** The bodies that bear what acts on those of the lists: they themselves, or where these are spheres of clumps the
 *  bodies that have them. */
struct vti_bearing {
    const vti_clumps *clumps; /* NULL: they themselves */
    const vti_bodies *bodies;
};

struct vti_joint_side {
    int64_t body;              /* that bears; -1: a wall, or nothing */
    double per_m;              /* 1/m */
    double per[3], axis[3][3]; /* J^-1 = sum per_k axis_k axis_k^T */
    double arm[3];
    double v[3], w[3];
    double taken[3]; /* by L, since it was loaded */
};

/** i and j. */
struct vti_joint {
    struct vti_joint_side side[2];
};

/** Body or sphere i of the lists, acted on at `place` from its centre. */
void vti_joint_load(const struct vti_bearing *of, int64_t i, const double place[3], struct vti_joint_side *side);
/** The velocities, and L, Omega or both, of the body that bears. */
void vti_joint_store(const struct vti_bearing *of, const struct vti_joint_side *side);

/** u, or for turns w. */
void vti_joint_velocity(const struct vti_joint *at, int turns, double u[3]);
/** The impulse p, or for turns the moment impulse. */
void vti_joint_push(struct vti_joint *at, int turns, const double p[3]);

/** Motions along at most 3 orthonormal directions that decay each by itself. */
struct vti_joint_modes {
    int count;
    double along[3][3];
    double inverse_mass[3]; /* the change of the velocity by a unit impulse: eigenvalues of K, or of H */
};

/** Those along n directions `span`, 1 or 2; for turns of H. */
void vti_joint_modes_of(const struct vti_joint *at, int turns, int n, const double span[][3],
                        struct vti_joint_modes *modes);
/** The impulse by which dashpots of the coefficients c, one for each mode, let the velocity a decay for the time t:
 *  - sum (1 - exp(-c t k))/k (a.g) g over the modes g of inverse mass k. */
void vti_joint_decay(const struct vti_joint_modes *modes, const double c[3], double t, const double a[3], double p[3]);
/** The kinetic energy that an impulse p takes, - p.(a + a')/2 with the velocity a before and a' after it. */
double vti_joint_lost(const struct vti_joint_modes *modes, const double a[3], const double p[3]);

/** Two unit vectors across the unit vector n and each other. */
void vti_joint_across(const double n[3], double span[2][3]);

/** The flows of vti_dashpots on bodies with moments (clumps NULL), or on clumps by their spheres, which are in
 *  place. */
void vti_dashpots_flow_joints(const void *self, const vti_clumps *clumps, const vti_bodies *bodies, double t,
                              double drift);

#endif
