/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Losses per body of what effects book (EQUATIONS 6.1). A loss of a pair is split half and half, a loss to a wall or a
 * medium is the body's alone. Halves are exact, so the bodies' sums equal the total. Each touch is booked when it is
 * worked, and touches that share a body are worked in one order whatever the layout, the vector unit and the threads:
 * so are these sums. */
#ifndef VTI_SHARES_H
#define VTI_SHARES_H

#include <stddef.h>

#include "vti.h"

/** Books a loss in entry k of the books entries of a body: half to i, half to j; all to i where j is -1. */
static inline void vti_share(vti_sum *by_body, int64_t books, int64_t k, int64_t i, int64_t j, double lost)
{
    const double share = j >= 0 ? 0.5 * lost : lost;
    vti_sum_add(&by_body[books * i + k], share);
    if (j >= 0)
        vti_sum_add(&by_body[books * j + k], share);
}

/** What one touch has lost, each a single number, joins what all have, with the same bits as if it had been booked
 *  there; and where by_body is not NULL, what its bodies have. */
static inline void vti_share_out(const vti_sum *own, int64_t books, vti_sum *all, vti_sum *by_body, int64_t i,
                                 int64_t j)
{
    for (int64_t k = 0; k < books; ++k) {
        vti_sum_add(&all[k], own[k].high);
        if (by_body != NULL)
            vti_share(by_body, books, k, i, j, own[k].high);
    }
}

#endif
