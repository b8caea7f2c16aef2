/* SPDX-License-Identifier: BSD-3-Clause
 * The kernels of bonds for processors with AVX-512. */
#define BOND_KERNELS vti_bond_avx512
#include "vti_bond_kernels.h"
