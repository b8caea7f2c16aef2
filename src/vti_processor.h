/* SPDX-License-Identifier: BSD-3-Clause
 * Which vector units the processor has, and who made it. */
#ifndef VTI_PROCESSOR_H
#define VTI_PROCESSOR_H

/** No kernel has more lanes. */
enum { VTI_LANES_MOST = 8 };

/** Whether the kernels for these vector units were compiled, and serve here. */
static inline int vti_serves_avx2(void)
{
#ifdef VTI_HAS_AVX2
    return __builtin_cpu_supports("avx2") != 0;
#else
    return 0;
#endif
}

static inline int vti_serves_avx512(void)
{
#ifdef VTI_HAS_AVX512
    return __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
#else
    return 0;
#endif
}

/** Whether the processor is AMD's, for what costs time only. */
static inline int vti_is_amd(void)
{
#if (defined(__x86_64__) || defined(__i386__)) && defined(__GNUC__)
    return __builtin_cpu_is("amd") != 0;
#else
    return 0;
#endif
}

#endif
