// SPDX-License-Identifier: Apache-2.0
// A 64-bit hash of bytes, to compare states and texts; not for secrets.
//
// Source: FNV-1a (Fowler, Noll & Vo) taken eight bytes at a time, each mixed by SplitMix64.
#ifndef QN_BASE_HASH_H
#define QN_BASE_HASH_H

#include "base/random.h"

#include <stddef.h>
#include <string.h>

#define QN_HASH_START 0xcbf29ce484222325u

/// The hash of `size` bytes, continued from `hash` (QN_HASH_START at first).
static inline uint64_t qn_hash(uint64_t hash, const void *bytes, size_t size)
{
    const unsigned char *p = bytes;
    for (; size >= 8; size -= 8, p += 8) {
        uint64_t word;
        memcpy(&word, p, 8);
        hash = qn_mix((hash ^ word) * 0x100000001b3u);
    }
    for (; size > 0; size--, p++) hash = (hash ^ *p) * 0x100000001b3u;
    return hash;
}

#endif
