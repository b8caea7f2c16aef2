/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What drivers/text/plain.h gives for the lines of stdin, in hexadecimal: "cos r k n", "sin r k n", "power a b", "log2
 * a", "exp2 a". */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "plain.h"

int main(void)
{
    char line[256];
    double x, y;
    while (fgets(line, sizeof line, stdin) != NULL) {
        int64_t k, n;
        if (sscanf(line, "cos %lf %" SCNd64 " %" SCNd64, &x, &k, &n) == 3)
            printf("%a\n", plain_cos_turn(x, k, n));
        else if (sscanf(line, "sin %lf %" SCNd64 " %" SCNd64, &x, &k, &n) == 3)
            printf("%a\n", plain_sin_turn(x, k, n));
        else if (sscanf(line, "power %lf %lf", &x, &y) == 2)
            printf("%a\n", plain_power(x, y));
        else if (sscanf(line, "log2 %lf", &x) == 1)
            printf("%a\n", plain_log2(x));
        else if (sscanf(line, "exp2 %lf", &x) == 1)
            printf("%a\n", plain_exp2(x));
        else
            return 1;
    }
    return 0;
}
