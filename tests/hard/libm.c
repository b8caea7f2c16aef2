/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A digest of what libm's functions give here: it tells whether a mask of the processor's units has taken effect. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

int main(void)
{
    uint64_t hash = 1469598103934665603u; /* FNV-1a */
    for (int k = 1; k < 100000; ++k) {
        const double x = 1e-4 * k, values[] = {sin(x), cos(x), exp(-x), pow(x, 1.37), atan2(x, 2.0)};
        for (int j = 0; j < 5; ++j) {
            uint64_t bits;
            memcpy(&bits, &values[j], sizeof bits);
            hash = (hash ^ bits) * 1099511628211u;
        }
    }
    printf("%016" PRIx64 "\n", hash);
    return 0;
}
