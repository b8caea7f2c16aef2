/* SPDX-License-Identifier: BSD-3-Clause */
#include "version.h"

#include <stdio.h>

#include "commit.h"
#include "vti.h"

void version_print(const char *program)
{
#if defined(__clang__)
    static const char compiler[] = __VERSION__;
#else
    static const char compiler[] = "gcc " __VERSION__;
#endif
    printf("%s %s\ncommit: %s\ncompiler: %s\nflags: %s\nvector units: %s; the bits do not depend on them\n", program,
           vti_version(), VTI_COMMIT, compiler, VTI_FLAGS, vti_vector_units());
}
