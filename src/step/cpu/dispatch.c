// SPDX-License-Identifier: Apache-2.0
// Picks the contact kernel for this processor, and owns what the kernels work in.
#include "step/cpu/block.h"

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

typedef qn_status kernel(qn_world *, qn_share *, const qn_pose *, qn_mode);

#define I(name, supported) kernel qn_kernel_contacts_##name;
QN_ISAS(I)
#undef I

static const char *chosen;
static kernel *contacts;

// The best kernel the processor has, or the one the environment asks for if the processor has it.
static void choose(void)
{
    const char *wanted = getenv("QUERN_ISA");
    bool found = false;
#define I(name, supported)                                 \
    if (!found && (supported)) {                           \
        chosen = #name, contacts = qn_kernel_contacts_##name; \
        found = wanted && !strcmp(wanted, #name);          \
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
    workspace *work;
    if (!chosen) choose();
    QN_TRY(QN_ALLOCATE(work, 1));
    share->workspace = work;
    QN_TRY(QN_ALLOCATE(work->pairs, w->class_count * w->class_count));
    QN_TRY(QN_ALLOCATE(work->walls, w->surface_count * w->class_count));
    QN_TRY(QN_ALLOCATE(share->sums, 1));
    return QN_ALLOCATE(share->sums->torque, w->walls.part_count);
}

void qn_kernel_release(qn_share *share)
{
    workspace *work = share->workspace;
    if (work) free(work->pairs), free(work->walls);
    if (share->sums) free(share->sums->torque);
    free(share->sums), free(work);
    share->sums = NULL, share->workspace = NULL;
}

qn_status qn_kernel_contacts(qn_world *w, qn_share *share, const qn_pose *pose, qn_mode mode)
{
    return contacts(w, share, pose, mode);
}

double qn_torque_unit(const qn_world *w)
{
    double unit = 0;
    for (int i = 0; i < w->class_count; i++) unit = qn_max(unit, w->classes[i].torque_unit);
    return unit;
}
