/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Random numbers of a scene: the sequence splitmix64 of its seed (Steele, Lea and Flood 2014), of which any number is
 * found by itself. They are the same bits everywhere, and a number does not depend on which others are drawn. */
#ifndef VTI_RANDOM_H
#define VTI_RANDOM_H

#include <stdint.h>

/** Number k (from 0) of the sequence. */
static inline uint64_t random_bits(uint64_t seed, uint64_t k)
{
    uint64_t z = seed + (k + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/** Uniform in [-most, most): most (2 u - 1), where u is the upper 53 bits of number k over 2^53. */
static inline double random_symmetric(uint64_t seed, uint64_t k, double most)
{
    return most * (2.0 * ((double)(random_bits(seed, k) >> 11) * 0x1p-53) - 1.0);
}

#endif
