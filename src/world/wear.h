// SPDX-License-Identifier: Apache-2.0
// Wear: the works of physics/wear.h, summed up on every facet of the walls since step 0.
//
// A sum is an integer of quanta in two words, high 2^61 + low, so that it neither depends on the order
// in which threads add to it nor ever overflows, and a resumed run goes on with the same bits. Only
// facets that are touched cost anything. Owned by the world.
#ifndef QN_WORLD_WEAR_H
#define QN_WORLD_WEAR_H

#include "base/array.h"
#include "physics/wear.h"

#include <stdatomic.h>

typedef struct qn_worn {
    _Atomic int64_t low[QN_WEAR_COUNT], high[QN_WEAR_COUNT];
} qn_worn;

typedef struct qn_wear {
    double unit;  // J   quantum, a power of two
    int facet_count;
    qn_worn *facets;  // owned
} qn_wear;

/// Adds works (J, none negative) to a facet; any thread may.
static inline void qn_wear_add(qn_wear *wear, int facet, const double work[QN_WEAR_COUNT])
{
    const int64_t most = (int64_t)1 << 56, carry = (int64_t)1 << 61;
    qn_worn *worn = &wear->facets[facet];
    for (int k = 0; k < QN_WEAR_COUNT; k++) {
        double quanta = rint(work[k] / wear->unit);
        int64_t more = quanta < (double)most ? (int64_t)quanta : most;
        if (more == 0) continue;
        int64_t before = atomic_fetch_add_explicit(&worn->low[k], more, memory_order_relaxed);
        if (before + more < carry) continue;
        atomic_fetch_sub_explicit(&worn->low[k], carry, memory_order_relaxed);
        atomic_fetch_add_explicit(&worn->high[k], 1, memory_order_relaxed);
    }
}

/// A sum (J).
static inline double qn_wear_value(const qn_wear *wear, int facet, int which)
{
    const qn_worn *worn = &wear->facets[facet];
    return ldexp((double)worn->high[which], 61) * wear->unit
           + (double)worn->low[which] * wear->unit;
}

/// Brings each sum into its one form, 0 <= low < 2^61, as it goes on file. Between steps.
static inline void qn_wear_settle(qn_wear *wear)
{
    const int64_t carry = (int64_t)1 << 61;
    for (int f = 0; f < wear->facet_count; f++)
        for (int k = 0; k < QN_WEAR_COUNT; k++)
            for (qn_worn *worn = &wear->facets[f]; worn->low[k] < 0; worn->high[k]--)
                worn->low[k] += carry;
}

#endif
