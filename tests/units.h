/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Test cases of a file whose kernels exist for wider vector units too: skipped where the library has none or the
 * machine cannot run them. */
#ifndef VTI_TESTS_UNITS_H
#define VTI_TESTS_UNITS_H

#include "support.h"

#define RUNS_AVX2 __builtin_cpu_supports("avx2")
#define RUNS_AVX512 (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))

/* ON_UNIT(name, runs, call): the test case of that name */
#define ON_UNIT(name, runs, call)                                                                                      \
    TEST(name)                                                                                                         \
    {                                                                                                                  \
        if (!(runs))                                                                                                   \
            skip();                                                                                                    \
        call;                                                                                                          \
    }

#ifdef VTI_HAS_AVX2
#define ON_AVX2(call) ON_UNIT(avx2, RUNS_AVX2, call)
#else
#define ON_AVX2(call) ON_UNIT(avx2, 0, )
#endif
#ifdef VTI_HAS_AVX512
#define ON_AVX512(call) ON_UNIT(avx512, RUNS_AVX512, call)
#else
#define ON_AVX512(call) ON_UNIT(avx512, 0, )
#endif

#endif
