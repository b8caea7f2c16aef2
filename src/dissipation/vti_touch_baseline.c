/* SPDX-License-Identifier: BSD-3-Clause
 * The kernels of touches for any processor. */
#define TOUCH_KERNELS vti_touch_baseline
#include "vti_touch_kernels.h"
