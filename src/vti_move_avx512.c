/* SPDX-License-Identifier: BSD-3-Clause
 * Moves of bodies for processors with AVX-512 (F, DQ, VL). */
#define MOVE_KERNELS vti_move_avx512
#include "move/vti_move_kernels.h"
