// SPDX-License-Identifier: Apache-2.0
// Growing arrays: the one place where the library asks for memory.
//
// Blocks are aligned to a cache line. Growth doubles, so a warmed-up step allocates nothing.
#ifndef QN_BASE_ARRAY_H
#define QN_BASE_ARRAY_H

#include "base/error.h"

#include <stddef.h>
#include <stdint.h>

/// Makes room for at least `wanted` elements of `size` bytes in *block (owned by the caller, NULL
/// at first), keeping the first *capacity elements. Returns QN_MEMORY with nothing changed.
QN_NODISCARD qn_status qn_reserve(void **block, int64_t *capacity, int64_t wanted, size_t size);

/// As qn_reserve for a typed pointer and its int64_t capacity.
#define QN_RESERVE(pointer, capacity, wanted) \
    qn_reserve((void **)&(pointer), &(capacity), (wanted), sizeof *(pointer))

/// A zeroed block of `count` elements (at least one), aligned to 64 bytes; release with free().
QN_NODISCARD qn_status qn_allocate(void **block, int64_t count, size_t size);

#define QN_ALLOCATE(pointer, count) qn_allocate((void **)&(pointer), (count), sizeof *(pointer))

#endif
