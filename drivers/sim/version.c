/* SPDX-License-Identifier: BSD-3-Clause */
#include "version.h"

#include <stdio.h>
#include <string.h>

#include "commit.h"
#include "vti.h"

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
               program, vti_version(), VTI_COMMIT, compiler, VTI_FLAGS, vti_vector_units());
    }
    return 1;
}
