/* SPDX-License-Identifier: BSD-3-Clause
 * Loops that the compiler makes of vectors, once for each width that processors have; one is picked as the program
 * runs. Neither the width nor the compiler changes a bit: contraction is off. */
#ifndef VTI_WIDE_H
#define VTI_WIDE_H

#include "vti_rrv.h"

/** Defines void NAME PARAMETERS by the function NAME_loops ARGUMENTS, which is VTI_INLINE. */
#if defined(__GNUC__) && defined(__x86_64__)
#define WIDE(NAME, PARAMETERS, ARGUMENTS)                                                                              \
    __attribute__((target("avx512f,avx512dq,avx512vl"))) static void NAME##_avx512 PARAMETERS                          \
    {                                                                                                                  \
        NAME##_loops ARGUMENTS;                                                                                        \
    }                                                                                                                  \
    __attribute__((target("avx2"))) static void NAME##_avx2 PARAMETERS                                                 \
    {                                                                                                                  \
        NAME##_loops ARGUMENTS;                                                                                        \
    }                                                                                                                  \
    void NAME PARAMETERS                                                                                               \
    {                                                                                                                  \
        if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))                                  \
            NAME##_avx512 ARGUMENTS;                                                                                   \
        else if (__builtin_cpu_supports("avx2"))                                                                       \
            NAME##_avx2 ARGUMENTS;                                                                                     \
        else                                                                                                           \
            NAME##_loops ARGUMENTS;                                                                                    \
    }
#else
#define WIDE(NAME, PARAMETERS, ARGUMENTS)                                                                              \
    void NAME PARAMETERS                                                                                               \
    {                                                                                                                  \
        NAME##_loops ARGUMENTS;                                                                                        \
    }
#endif

#endif
