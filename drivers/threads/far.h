/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef VTI_FAR_H
#define VTI_FAR_H

#include "vti.h"

/** Whether one of the vectors begin <= i < end of x, less from[3 i ...] and less shared, is longer than limit^{1/2}, or
 *  has no length as it has NaN. from may be NULL: zeros. */
int far_any(const vti_view *x, int64_t begin, int64_t end, const double *from, const double shared[3], double limit);

#endif
