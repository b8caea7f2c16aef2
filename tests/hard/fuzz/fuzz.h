/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What the fuzz targets share. A target is one function, LLVMFuzzerTestOneInput, which libFuzzer calls (./dev fuzz) and
 * which replay.c calls with the stored inputs where there is no libFuzzer. What is wrong ends the program. */
#ifndef VTI_FUZZ_H
#define VTI_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { FUZZ_PATH = 1024 };

/** Ends the program unless holds. */
static inline void fuzz_must(int holds, const char *what)
{
    if (holds)
        return;
    fprintf(stderr, "fuzz: not so: %s\n", what);
    abort();
}

/** A refusal is one line, whole and not empty. */
static inline void fuzz_one_line(const struct message *message)
{
    const size_t n = strlen(message->text);
    fuzz_must(n > 0 && n < sizeof message->text - 1, "a refusal has a text that is not cut off");
    for (size_t k = 0; k < n; ++k)
        fuzz_must((unsigned char)message->text[k] >= 0x20, "a refusal is one line");
}

/** Removes the folder of fuzz_file, which holds nothing else. */
void fuzz_leave(void);

/** The path of a file with these bytes in a folder of the process's own. */
const char *fuzz_file(const char *name, const void *bytes, size_t size);

#endif
