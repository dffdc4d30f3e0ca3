// SPDX-License-Identifier: Apache-2.0
// Random numbers by counter: the same number for the same (seed, stream, index), in any order.
//
// Source: the finaliser of SplitMix64, Steele, Lea & Flood (2014), OOPSLA, doi:10.1145/2660193.2660195.
#ifndef QN_BASE_RANDOM_H
#define QN_BASE_RANDOM_H

#include <stdint.h>

static inline uint64_t qn_mix(uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

static inline uint64_t qn_random_bits(uint64_t seed, uint64_t stream, uint64_t index)
{
    return qn_mix(qn_mix(qn_mix(seed) ^ stream) ^ index);
}

/// Uniform in [0, 1[.
static inline double qn_random(uint64_t seed, uint64_t stream, uint64_t index)
{
    return (double)(qn_random_bits(seed, stream, index) >> 11) * 0x1p-53;
}

#endif
