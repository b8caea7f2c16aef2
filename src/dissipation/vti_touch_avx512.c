/* SPDX-License-Identifier: BSD-3-Clause
 * The kernels of touches for processors with AVX-512 (F, DQ, VL). */
#define TOUCH_KERNELS vti_touch_avx512
#include "vti_touch_kernels.h"
