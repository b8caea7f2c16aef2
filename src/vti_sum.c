/* SPDX-License-Identifier: BSD-3-Clause
 * Apart from its callers, so that restrict keeps its worth: it stands on parameters, and inlining loses it. */
#include "vti_sum.h"

void vti_sum_compensated(double t, const vti_view *a, const vti_view *b, const vti_scalars *m, const vti_view *low,
                         int64_t begin, int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        const double k = m != NULL ? t / vti_scalar(m, i) : t;
        for (int c = 0; c < 3; ++c) {
            double *p = a->c[c] + i * a->stride;
            *p = add_compensated(*p, k * b->c[c][i * b->stride], low->c[c] + i * low->stride);
        }
    }
}

void vti_sum_packed(double *restrict a, const double *restrict b, double k, int64_t n)
{
    int64_t i = 0;
    for (; i + 8 <= n; i += 8) /* eight at a time, or counting would take as long as adding */
        for (int c = 0; c < 8; ++c)
            a[i + c] += k * b[i + c];
    for (; i < n; ++i)
        a[i] += k * b[i];
}
