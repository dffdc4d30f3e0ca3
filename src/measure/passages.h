// SPDX-License-Identifier: Apache-2.0
// Power by lifter passage: its mean, how well that is known, and whether the mill was steady.
//
// A passage is the turn from one lifter to the next, a sixteenth of a revolution for a drum without.
// At the step nearest to the end of each, the drive's work so far is noted down. Of at most
// QN_PASSAGES_MAX notes every second is dropped when they run out, and those left are then twice as
// far apart; so a window may be as long as it likes and a checkpoint has a fixed size.
//
// Error of the mean: batch means. Powers of neighbouring passages are correlated, so the error is
// estimated from batches of 1, 2, 4, ... passages while eight batches are left, and the largest
// estimate counts. Source: Flyvbjerg & Petersen (1989), J. Chem. Phys. 91, 461,
// doi:10.1063/1.457480.
// Steady: the drift over the window, the slope of the straight line through the powers times the
// window's length, is below 2 % of the mean power or below twice its own standard error, which is
// sqrt(12) times the error of the mean, estimated in the same way from what is left off the line.
// Fewer than four notes never count as steady.
#ifndef QN_MEASURE_PASSAGES_H
#define QN_MEASURE_PASSAGES_H

#include "base/column.h"
#include "measure/energy.h"

enum {
    QN_PASSAGES_MAX = 1024,   // intervals kept; even
    QN_PASSAGES_SMOOTH = 16,  // passages per revolution of a drum without lifters
};

typedef struct qn_passages {
    bool active;
    bool lifters;                   //          passages are of lifters, not sixteenths of a turn
    double angle;                   //     rad  of one passage
    int sense;                      //     1    of rotation: 1 or -1
    double dt;                      //     s
    int64_t first_step, last_step;  //       boundaries lie between them, both included
    int part_count;
    bool *turning;            //          by part; owned
    const qn_drum_def *drum;  //          not owned
    double start_angle;       //     rad  turned at the first boundary, in the sense of rotation
    // Kept in a checkpoint.
    int64_t stride;     //     1    passages between notes
    int64_t next;       //     1    number of the next boundary to note, in passages
    int64_t next_step;  //          step of that boundary
    int64_t count;      //     1    notes taken
    int64_t step[QN_PASSAGES_MAX + 1];
    double work[QN_PASSAGES_MAX + 1];  // J  of the drive, up to that step
    double lost[2], stored[2];         //     J    at the first note and at the latest
    double *part_work[2];              //     J    by part, likewise; owned
} qn_passages;

/// What the passages say. NaN where there are too few.
typedef struct qn_power {
    int64_t passages;       // 1    in the window
    double window;          // s    its length
    double torque;          // W    mean power of the drive
    double standard_error;  // W    of that mean
    double dissipated;      // W    losses, the Mindlin residue included
    double storing;         // W    change of the stored energy by time
    double drift;           // W    of the drive's power over the window
    bool steady;
} qn_power;

/// Prepares for boundaries from step `first` to step `last`, both included. Stays inactive for a world
/// without a drum that turns in the end.
QN_NODISCARD qn_status qn_passages_create(const qn_world *world, int64_t first, int64_t last,
                                          qn_passages *passages);
void qn_passages_free(qn_passages *passages);

/// The first step from which the drum has its final speed; 0 if it always does.
int64_t qn_passages_settled(const qn_world *world);

bool qn_passages_due(const qn_passages *passages, int64_t step);

/// Notes down the present step if it is a boundary.
void qn_passages_sample(qn_passages *passages, const qn_world *world, const qn_balance *balance);

qn_power qn_passages_power(const qn_passages *passages);

/// Mean power (W) of one part over the window.
double qn_passages_part_power(const qn_passages *passages, int part);

/// What must survive a checkpoint; as qn_measure_columns().
int qn_passages_columns(qn_passages *passages, qn_column *columns, int room);

#endif
