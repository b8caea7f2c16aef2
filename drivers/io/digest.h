/* SPDX-License-Identifier: BSD-3-Clause
 * A 64-bit digest (FNV-1a) that tells damaged or foreign bytes from the right ones. It is no protection against intent. */
#ifndef VTI_DIGEST_H
#define VTI_DIGEST_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define DIGEST_START UINT64_C(0xcbf29ce484222325)

static inline uint64_t digest_add(uint64_t digest, const void *bytes, size_t size)
{
    const unsigned char *p = bytes;
    for (size_t k = 0; k < size; ++k)
        digest = (digest ^ p[k]) * UINT64_C(0x100000001b3);
    return digest;
}

static inline uint64_t digest_integer(uint64_t digest, uint64_t value)
{
    for (int k = 0; k < 64; k += 8)
        digest = (digest ^ (value >> k & 0xff)) * UINT64_C(0x100000001b3);
    return digest;
}

/** By its bits. */
static inline uint64_t digest_number(uint64_t digest, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return digest_integer(digest, bits);
}

#endif
