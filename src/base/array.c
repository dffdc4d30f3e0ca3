// SPDX-License-Identifier: Apache-2.0
#include "base/array.h"

#include <stdlib.h>
#include <string.h>

enum { LINE = 64 };  // bytes   one cache line

qn_status qn_allocate(void **block, int64_t count, size_t size)
{
    size_t bytes = (size_t)(count > 0 ? count : 1) * size;
    bytes = (bytes + LINE - 1) / LINE * LINE;
    void *fresh = aligned_alloc(LINE, bytes);
    if (!fresh)
        return qn_fail(QN_MEMORY, "no memory for %lld elements of %zu bytes", (long long)count,
                       size);
    memset(fresh, 0, bytes);
    *block = fresh;
    return QN_OK;
}

qn_status qn_reserve(void **block, int64_t *capacity, int64_t wanted, size_t size)
{
    if (wanted <= *capacity) return QN_OK;
    int64_t room = *capacity * 2 > wanted ? *capacity * 2 : wanted;
    void *fresh;
    QN_TRY(qn_allocate(&fresh, room, size));
    if (*block) memcpy(fresh, *block, (size_t)*capacity * size);
    free(*block);
    *block = fresh;
    *capacity = room;
    return QN_OK;
}
