/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What dashpots of bonds depend on, whatever the bodies: which motions they damp, and by how much (EQUATIONS 6.3). For
 * lanes of bonds, or for one, as in vti_touch_motion.h. */
#ifndef VTI_BOND_FLOW_H
#define VTI_BOND_FLOW_H

#include "../contacts/vti_touch_motion.h"

enum vti_bond_motion { VTI_AXIAL, VTI_SHEAR, VTI_BENDING, VTI_TWIST };

/** What bonds take part in. */
struct vti_bond_sweep {
    const vti_bond_dashpots *p;
    const vti_bodies *b;
    double t, drift;
};

/** Of a motion: its constant, and the stiffness that zeta counts by, an energy. */
static inline double vti_bond_constant(const vti_bond_dashpots *p, int motion)
{
    return motion == VTI_AXIAL     ? p->axial
           : motion == VTI_SHEAR   ? p->shear
           : motion == VTI_BENDING ? p->bending
                                   : p->twisting;
}

static inline const vti_scalars *vti_bond_stiffness(const vti_bond_dashpots *p, int motion)
{
    return motion == VTI_AXIAL ? &p->bonds->axial : motion == VTI_SHEAR ? &p->bonds->shear : &p->bonds->moment;
}

static inline int vti_bond_turns(int motion)
{
    return motion == VTI_BENDING || motion == VTI_TWIST;
}

/** c of a motion with that reduced mass, or moment of inertia: the constant and 2 zeta sqrt(m k), k the energy over
 *  length^2. */
VTI_INLINE lanes vti_bond_coefficient(const vti_bond_dashpots *p, int motion, lanes mass, lanes energy, lanes length)
{
    return vti_bond_constant(p, motion) + 2.0 * p->zeta * lanes_sqrt(mass * energy) / length;
}

#endif
