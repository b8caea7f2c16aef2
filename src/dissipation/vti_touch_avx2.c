/* SPDX-License-Identifier: BSD-3-Clause
 * The kernels of touches for processors with AVX2. */
#define TOUCH_KERNELS vti_touch_avx2
#include "vti_touch_kernels.h"
