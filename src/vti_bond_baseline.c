/* SPDX-License-Identifier: BSD-3-Clause
 * The kernels of bonds for any processor. */
#define BOND_KERNELS vti_bond_baseline
#include "vti_bond_kernels.h"
