/* SPDX-License-Identifier: BSD-3-Clause
 * The kernels of bonds, for the vector units that there may be. */
#ifndef VTI_BOND_H
#define VTI_BOND_H

#include "vti_pair.h"

static inline double stiffness(const vti_scalars *s, int64_t k)
{
    return s->p[k * s->stride];
}

struct bond_kernel {
    void (*apply)(const void *self, const vti_bodies *b);
    void (*energy)(const void *self, const vti_bodies *b, double *energies);
};

/** [form of shear, 0 for none][moment + 2 axial]; the same bits from each. */
extern const struct bond_kernel vti_bond_baseline[4][4], vti_bond_avx2[4][4];

#endif
