/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Elementary functions in plain arithmetic: additions, products and quotients of doubles, which every processor rounds
 * alike. A libm picks its sin, cos, exp, log and pow by the processor's vector units, and their last bits differ; so
 * nothing that moves a body, no number that is read and none that is compared may come from there. Pairs of doubles
 * carry about 100 bits, so results are the nearest double but for cases rarer than one in 2^40
 * (tests/driver/test_plain.py). Slow: not for steps. */
#ifndef VTI_PLAIN_H
#define VTI_PLAIN_H

#include <stdint.h>

#define PLAIN_PI 3.14159265358979323846

/** r cos and r sin of k/n of a turn, 2 pi k/n, for 0 < n < 2^46 and |k| < 2^53. Mirror images are exact: k and n - k
 *  have the same cosine and opposite sines, quarter turns give 0 and +-r. */
double plain_cos_turn(double r, int64_t k, int64_t n);
double plain_sin_turn(double r, int64_t k, int64_t n);

/** log2 a for a >= 0 (-infinity at 0, NaN for a < 0); whole for powers of two. */
double plain_log2(double a);
/** 2^a; whole a gives powers of two. */
double plain_exp2(double a);
/** a^b for a >= 0 as pow has it, 0^0 = 1 among it. Whole |b| <= 64 by products, so exact wherever a double holds the
 *  power. */
double plain_power(double a, double b);

#endif
