/* SPDX-License-Identifier: BSD-3-Clause
 * Moves of bodies for processors with AVX2. */
#define MOVE_KERNELS vti_move_avx2
#include "move/vti_move_kernels.h"
