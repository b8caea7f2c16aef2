/* SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "../../scratch.h" /* targets know the folders of drivers only */
#include "fuzz.h"

enum { FILES = 4 };

static char folder[FUZZ_PATH / 2];
static char path[FILES][FUZZ_PATH];

void fuzz_leave(void)
{
    for (int k = 0; k < FILES; ++k)
        if (path[k][0] != '\0')
            unlink(path[k]);
    rmdir(folder);
}

static void enter(void)
{
    fuzz_must(scratch_make(folder, sizeof folder), "there is place for a folder");
    atexit(fuzz_leave);
}

const char *fuzz_file(const char *name, const void *bytes, size_t size)
{
    char wanted[FUZZ_PATH];
    int k = 0;
    if (folder[0] == '\0')
        enter();
    snprintf(wanted, sizeof wanted, "%s/%s", folder, name);
    while (k < FILES - 1 && path[k][0] != '\0' && strcmp(path[k], wanted) != 0)
        ++k;
    memcpy(path[k], wanted, sizeof wanted);
    unlink(path[k]);
    FILE *file = fopen(path[k], "wb");
    fuzz_must(file != NULL, "a file can be made");
    const size_t written = size > 0 ? fwrite(bytes, 1, size, file) : 0;
    fuzz_must(fclose(file) == 0 && written == size, "a file can be written");
    return path[k];
}
