/* SPDX-License-Identifier: BSD-3-Clause */
#include "version.h"

#include <stdio.h>
#include <string.h>

#include "commit.h"
#include "vti.h"

/** The kernels of bonds that the library picks here (src/vti_bond.c); all else is for any processor of the build's. */
static const char *units(void)
{
#if defined(__x86_64__) && defined(__GNUC__)
    __builtin_cpu_init();
    if (VTI_WIDE_BUILT && __builtin_cpu_supports("avx2"))
        return "AVX2 for bonds";
#endif
    return "those of the flags";
}

int version_asked(int argc, char **argv, const char *program, int print)
{
    int k = 1;
    while (k < argc && strcmp(argv[k], "--version") != 0)
        k = strcmp(argv[k], "--") == 0 ? argc : k + 1;
    if (k >= argc)
        return 0;
    if (print) {
#if defined(__clang__)
        static const char compiler[] = __VERSION__;
#else
        static const char compiler[] = "gcc " __VERSION__;
#endif
        printf("%s %s\ncommit: %s\ncompiler: %s\nflags: %s\nvector units: %s; the bits do not depend on them\n",
               program, vti_version(), VTI_COMMIT, compiler, VTI_FLAGS, units());
    }
    return 1;
}
