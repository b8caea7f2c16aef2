/* SPDX-License-Identifier: BSD-3-Clause
 * A 64-bit digest that tells damaged or foreign bytes from the right ones. It is no protection against intent. */
#ifndef VTI_DIGEST_H
#define VTI_DIGEST_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define DIGEST_START UINT64_C(0xcbf29ce484222325)

/** Each word of 8 bytes goes in by a bijection of the digest before it, so that no single change is lost. Bytes that
 *  come in several pieces give the digest of the whole if all pieces but the last are whole words. */
static inline uint64_t digest_add(uint64_t digest, const void *bytes, size_t size)
{
    for (const char *p = bytes; size > 0;) {
        uint64_t word = 0;
        const size_t n = size < sizeof word ? size : sizeof word;
        memcpy(&word, p, n);
        digest = (digest ^ word) * UINT64_C(0x9e3779b97f4a7c15);
        digest ^= digest >> 32;
        p += n;
        size -= n;
    }
    return digest;
}

#endif
