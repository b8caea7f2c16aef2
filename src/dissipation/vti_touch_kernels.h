/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The table of the kernels that do many touches, or drag on many bodies, at once. The files vti_touch_*.c include this
 * and nothing else: each is compiled for vector units of its own, and defines TOUCH_KERNELS, the name of its table. */
#include "../contacts/vti_near_kernels.h"
#include "../contacts/vti_onset_kernels.h"
#include "../contacts/vti_press_kernels.h"
#include "vti_bond_kernels.h"
#include "vti_dashpot_kernels.h"
#include "vti_drag_kernels.h"
#include "../friction/vti_carry_kernels.h"
#include "../friction/vti_push_kernels.h"

const struct vti_touch_kernels TOUCH_KERNELS = {near_pairs,    near_wall,     push_springs, push_springs_at_wall,
                                                carry,         carry_at_wall, soon,         flow_pairs,
                                                flow_at_wall,  flow_bonds,    drag,         press_pairs,
                                                press_at_wall, crossing_pair, crossing_body};
