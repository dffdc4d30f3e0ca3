// SPDX-License-Identifier: Apache-2.0
// Picks the contact kernel for this processor, and owns what the kernels work in.
#include "step/cpu/lanes/block.h"

#include <stdlib.h>
#include <string.h>

// clang-format off
//    name  whether this processor has it
#if defined(__x86_64__) && !defined(QN_ISA_BASE_ONLY)
#define QN_ISAS(I)                                                                              \
    I(base, true)                                                                               \
    I(v3,   __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2"))                   \
    I(v4,   __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")             \
            && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
#else
#define QN_ISAS(I) I(base, true)
#endif
// clang-format on

typedef void pairs_kernel(qn_world *, qn_share *, qn_mode);
typedef qn_status touches_kernel(qn_world *, qn_share *, const qn_pose *, qn_mode);

#define I(name, supported)              \
    pairs_kernel qn_lanes_pairs_##name; \
    touches_kernel qn_lanes_touches_##name;
QN_ISAS(I)
#undef I

static const char *chosen;
static pairs_kernel *pairs;
static touches_kernel *touches;

// The best kernel the processor has, or the one the environment asks for if the processor has it.
static void choose(void)
{
    const char *wanted = getenv("QUERN_ISA");
    bool found = false;
#define I(name, supported)                                                \
    if (!found && (supported)) {                                          \
        chosen = #name;                                                   \
        pairs = qn_lanes_pairs_##name, touches = qn_lanes_touches_##name; \
        found = wanted && !strcmp(wanted, #name);                         \
    }
    QN_ISAS(I)
#undef I
}

const char *qn_kernel_isa(void)
{
    if (!chosen) choose();
    return chosen;
}

qn_status qn_kernel_prepare(const qn_world *w, qn_share *share)
{
    if (share->workspace) return QN_OK;
    int pair_queues = w->class_count * w->class_count,
        wall_queues = w->surface_count * w->class_count;
    size_t sums = sizeof(qn_tally_sums) + (size_t)w->walls.part_count * sizeof(int64_t[4]);
    size_t bytes = sizeof(workspace) + (size_t)(pair_queues + wall_queues) * sizeof(queue);
    if (!chosen) choose();
    QN_TRY(qn_allocate((void **)&share->sums, 1, sums));
    share->sums->part = (int64_t(*)[4])(share->sums + 1);
    QN_TRY(qn_allocate(&share->workspace, 1, bytes));
    workspace *work = share->workspace;
    work->pairs = (queue *)(work + 1);
    work->walls = work->pairs + pair_queues;
    return QN_OK;
}

qn_status qn_kernel_contacts(qn_world *w, qn_share *share, const qn_pose *pose, qn_mode mode)
{
    pairs(w, share, mode);
    QN_TRY(touches(w, share, pose, mode));
    if (mode == QN_PROBE) return QN_OK;
    qn_wall_contact *walls = share->walls;
    int64_t room = share->wall_room;
    share->walls = share->walls_next, share->wall_room = share->wall_next_room;
    share->walls_next = walls, share->wall_next_room = room;
    share->wall_count = share->wall_next_count;
    return QN_OK;
}
