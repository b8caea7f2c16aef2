/* SPDX-License-Identifier: BSD-3-Clause
 * The kernels of bonds for any processor. */
#define BOND_KERNELS vti_binder_baseline
#include "vti_binder_kernels.h"
