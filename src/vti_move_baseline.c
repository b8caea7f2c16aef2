/* SPDX-License-Identifier: BSD-3-Clause
 * Moves of bodies for any processor. */
#define MOVE_KERNELS vti_move_baseline
#include "move/vti_move_kernels.h"
