/* SPDX-License-Identifier: BSD-3-Clause
 * The kernels of bonds for processors with AVX2. */
#define BOND_KERNELS vti_binder_avx2
#include "vti_binder_kernels.h"
