/* SPDX-License-Identifier: BSD-3-Clause
 * The kernels of bonds, for the vector units that there may be. */
#ifndef VTI_BINDER_TABLE_H
#define VTI_BINDER_TABLE_H

#include "vti_internal.h"

enum { TERM_MOMENT = 1, TERM_AXIAL = 2, TERM_SHEAR = 4, TERMS = 3 };

struct bond_kernel {
    void (*apply)(const void *self, const vti_bodies *b);
    void (*energy)(const void *self, const vti_bodies *b, double *energies);
};

/** [form of shear, 0 for none][moment + 2 axial]; the same bits from each. */
extern const struct bond_kernel vti_binder_baseline[4][4], vti_binder_avx2[4][4], vti_binder_avx512[4][4];

#endif
