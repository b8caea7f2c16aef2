/* SPDX-License-Identifier: BSD-3-Clause
 * Table of bond kernels per vector unit, and the checks before they run. */
#ifndef VTI_BINDER_TABLE_H
#define VTI_BINDER_TABLE_H

#include <stddef.h>

#include "vti.h"
#include "../vti_processor.h"

enum { TERM_MOMENT = 1, TERM_AXIAL = 2, TERM_SHEAR = 4, TERMS = 3 };

/** ALPHA: all vectors lie as x[n][3], and attitudes are alpha. QUAT: the same with quaternions as q[n][4]. ANY:
 *  whatever the views say. TURNED: that, and bonds have rotations Q0 that matter to them. CHAIN: as ALPHA, and the
 *  bonds of a block join bodies in a row, i and i + 1, i + 1 and i + 2, and so on, but for the last, which joins its
 *  first body and any other. */
enum layout { ALPHA, QUAT, ANY, TURNED, LAYOUTS, CHAIN = LAYOUTS };

struct bond_kernel {
    /** The rows of the bonds first <= k < last, VTI_BOND_LOADS numbers each; [layout]. TURNED: NULL where nothing
     *  that could be turned is a term, and of the printed shear. */
    void (*loads[LAYOUTS])(const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last, double *rows);
    /** Of bodies that lie as ALPHA: adds the loads of the bonds from first on to their bodies, in blocks that join
     *  bodies in a row, as chains and rings do, each block where the one before ends. Returns the first bond that is
     *  left, before last. */
    int64_t (*chain)(const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last);
    void (*energy)(const vti_bonds *bonds, const vti_bodies *b, double *energies);
};

struct bond_kernels {
    /** [form of shear, 0 for none][moment + 2 axial] */
    struct bond_kernel of[4][4];
    /** Adds rows to those of their bodies that are in the slice, in the order of the bonds; [layout is ANY] */
    void (*sum[2])(int terms, const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last,
                   const double *rows);
    /** What the bonds first <= k < last hold, VTI_BOND_MEASURES numbers each. */
    void (*measure)(int terms, int form, const vti_bonds *bonds, const vti_bodies *b, int64_t first, int64_t last,
                    double *rows);
};

/** Fewer bonds than a block takes, filled up with the last of them to as many. */
struct vti_few_bonds {
    int64_t pair[2 * VTI_LANES_MOST];
    double rest[4 * VTI_LANES_MOST], turn[4 * VTI_LANES_MOST], stiffness[TERMS][VTI_LANES_MOST];
};

/** The bonds first <= k < last as a block of so many, VTI_LANES_MOST at most. */
vti_bonds vti_bonds_filled(const vti_bonds *bonds, int64_t first, int64_t last, int64_t width,
                           struct vti_few_bonds *few);

/** The same bits from each. */
extern const struct bond_kernels vti_binder_baseline, vti_binder_avx2, vti_binder_avx512;

/** Whether there is such a form, and with turns, which the printed shear does not know. */
VTI_INLINE int vti_bonds_form_is_known(const vti_bonds *bonds)
{
    return bonds->shear_form >= VTI_SHEAR_OBJECTIVE &&
           bonds->shear_form <= (bonds->turn != NULL ? VTI_SHEAR_QUARTIC : VTI_SHEAR_PRINTED);
}

#endif
