// SPDX-License-Identifier: Apache-2.0
#include "world/amounts.h"

#include <math.h>

// Numbers of each size of a group that is asked for by number, in the proportions of its fractions.
static void share_number(const qn_group_def *group, int64_t *counts)
{
    double share = 0;
    int64_t total = (int64_t)floor(group->amount + 0.5), done = 0;
    for (int s = 0; s < group->size_count; s++) {
        share += group->fraction[s];
        int64_t upto =
            s + 1 == group->size_count ? total : (int64_t)floor(share * (double)total + 0.5);
        counts[s] = upto - done;
        done = upto;
    }
}

// The same for a solid volume (m3).
static void share_volume(const qn_group_def *group, double volume, int64_t *counts)
{
    double mean = 0, left = 0;  // m3
    bool done[QN_SIZES_MAX] = {false};
    for (int s = 0; s < group->size_count; s++)
        mean += group->fraction[s] * qn_ball_volume(group->diameter[s] / 2);
    for (int k = 0; k < group->size_count; k++) {
        int s = -1;
        for (int other = 0; other < group->size_count; other++)
            if (!done[other] && (s < 0 || group->diameter[other] > group->diameter[s])) s = other;
        double ball = qn_ball_volume(group->diameter[s] / 2);
        left += volume / mean * group->fraction[s] * ball;
        counts[s] = (int64_t)qn_max(0, floor(left / ball + 0.5));
        left -= (double)counts[s] * ball;
        done[s] = true;
    }
}

void qn_amounts_of(const qn_def *def, const qn_group_def *group, const qn_walls *walls,
                   int64_t *counts)
{
    if (group->amount_kind == QN_AMOUNT_COUNT)
        share_number(group, counts);
    else if (group->amount_kind == QN_AMOUNT_FILLING)
        share_volume(group, group->amount * qn_walls_volume(walls) * def->bed_solidity, counts);
    else
        share_volume(group, group->amount / def->materials[group->material].density, counts);
}
