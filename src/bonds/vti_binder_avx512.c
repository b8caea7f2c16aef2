/* SPDX-License-Identifier: BSD-3-Clause
 * The kernels of bonds for processors with AVX-512 (F, DQ, VL). */
#define BOND_KERNELS vti_binder_avx512
#include "vti_binder_kernels.h"
