/* SPDX-License-Identifier: BSD-3-Clause
 * As many sums and products as a core can do, in vector registers. Seven of each do not wait for one another: so many
 * are under way at once in processors that begin two of a kind in each cycle and need three or four for one. */
#include "bench.h"

#if defined(__GNUC__) && defined(__x86_64__)

enum { CHAINS = 7, TURNS = 1000 };

/** Neither a constant for the compiler nor a number that grows or dies away. */
static volatile double one = 1.0, tiny = 1e-9;

#define PEAK(NAME, TARGET, LANES)                                                                                      \
    TARGET static void NAME(void *self)                                                                                \
    {                                                                                                                  \
        typedef double lanes __attribute__((vector_size(8 * LANES)));                                                  \
        const lanes zero = {0.0}, factor = zero + one, more = zero + tiny;                                             \
        lanes sum[CHAINS], product[CHAINS], all = {0.0};                                                               \
        (void)self;                                                                                                    \
        for (int k = 0; k < CHAINS; ++k)                                                                               \
            sum[k] = product[k] = zero + one;                                                                          \
        for (int turn = 0; turn < TURNS; ++turn)                                                                       \
            for (int k = 0; k < CHAINS; ++k) {                                                                         \
                sum[k] += more;                                                                                        \
                product[k] *= factor;                                                                                  \
            }                                                                                                          \
        for (int k = 0; k < CHAINS; ++k)                                                                               \
            all += sum[k] + product[k];                                                                                \
        bench_sums[0] = all[0];                                                                                        \
    }

PEAK(peak_avx512, __attribute__((target("avx512f"))), 8)
PEAK(peak_avx2, __attribute__((target("avx2"))), 4)
PEAK(peak_baseline, , 2)

int bench_peak_cases(struct bench_case *cases, int count)
{
    const int widest = __builtin_cpu_supports("avx512f"), wide = __builtin_cpu_supports("avx2");
    const int64_t lanes = widest ? 8 : wide ? 4 : 2;
    const struct bench_case peak = {.what = "peak",
                                    .layout = "packed",
                                    .items = 2 * CHAINS * TURNS * lanes,
                                    .call = widest ? peak_avx512
                                            : wide ? peak_avx2
                                                   : peak_baseline};
    cases[count++] = peak;
    return count;
}

#else

int bench_peak_cases(struct bench_case *cases, int count)
{
    (void)cases;
    return count;
}

#endif
