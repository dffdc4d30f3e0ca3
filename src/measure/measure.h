// SPDX-License-Identifier: Apache-2.0
// What is observed while running, without touching the world.
//
// Called between qn_step_forces() and qn_step_advance(), when positions, velocities and forces of
// step n are all at hand. Sums over particles are integer sums, so that they do not depend on the
// order of the particles; a checkpoint holds them, so that a resumed run has neither gap nor repeat:
// a checkpoint between steps n - 1 and n holds the samples of all steps before n.
#ifndef QN_MEASURE_MEASURE_H
#define QN_MEASURE_MEASURE_H

#include "base/column.h"
#include "measure/energy.h"
#include "measure/fields.h"
#include "measure/passages.h"
#include "measure/ring.h"
#include "measure/series.h"
#include "world/world.h"

typedef struct qn_measure {
    qn_measure_def def;
    int64_t series_stride, fields_stride, traces_stride;  // 1   steps; 0 for never
    int64_t fields_first, fields_last;  //     sampled from first up to, not with, last
    int64_t fields_least;               // 1   samples that make a mean; see qn_measure_charge()
    int field_count;
    qn_field *fields;  //   owned; one per grid
    qn_ring ring;      //   charge around the shell, for shoulder and toe; sampled with the fields
    qn_passages passages;  //   power by lifter passage, for its mean, error and steadiness
    qn_series series;      //   its row is the latest row
    char grid_names[QN_GRIDS_MAX][QN_FIELD_COLUMN_COUNT][QN_NAME_MAX];  // of qn_measure_columns()
} qn_measure;

/// Prepares to observe a world. Spans become steps with the world's time step and drum. Power is
/// measured while fields are; without fields, from when the drum has its final speed.
QN_NODISCARD qn_status qn_measure_create(const qn_world *world, qn_measure *measure);
void qn_measure_free(qn_measure *measure);

/// Whether one of them is due at a step.
bool qn_measure_series_due(const qn_measure *measure, int64_t step);
bool qn_measure_fields_due(const qn_measure *measure, int64_t step);
bool qn_measure_traces_due(const qn_measure *measure, int64_t step);

/// Adds the present step to fields, ring and passages where they are due, and fills series.row where
/// a row is. Once per step; nothing where nothing is due.
QN_NODISCARD qn_status qn_measure_sample(qn_measure *measure, const qn_world *world);

/// The present step's row (measure->series.column_count numbers), due or not, changing nothing: for
/// the end of a run, after qn_step_forces(world, QN_PROBE).
QN_NODISCARD qn_status qn_measure_row(const qn_measure *measure, const qn_world *world,
                                      double *row);

/// A row's number by the name of its column; NaN if there is none.
double qn_measure_value(const qn_measure *measure, const double *row, const char *name);

/// Where the charge is: NaN without fields, and as long as qn_measure_lacks_samples().
typedef struct qn_charge {
    double bulk;           // 1     solidity, of the grid whose cell is 2, else of the nearest
    double shoulder, toe;  // deg   qn_ring_edges()
} qn_charge;

QN_NODISCARD qn_status qn_measure_charge(const qn_measure *measure, qn_charge *charge);

/// Whether fields and ring have fewer samples than their means need: two lifter passages of the
/// final speed (a revolution if that is less), and qn_ring_least_samples().
/// One snapshot of scenes/pilot-mill.yaml puts the shoulder 2 degrees off, with a scatter of 5, and
/// one of scenes/tiny-mill.yaml 52 and 17: it shows where the lifters stand. Over one passage the
/// scatter is 2 and 3 degrees, over two 1 and 2.5, then as one by the square root of the time.
bool qn_measure_lacks_samples(const qn_measure *measure);

/// That in a sentence; an empty one where nothing is lacking or there are no fields.
void qn_measure_lack(const qn_measure *measure, char *sentence, size_t room);

/// Steps of a span counted from step 0: seconds, revolutions of the drum, or steps; INT64_MAX where
/// it never comes.
int64_t qn_span_steps(const qn_world *world, qn_span span);

/// Every array and number that must survive a checkpoint, as columns that point into `measure`.
/// Returns how many; writes at most `room`. Names are unique.
int qn_measure_columns(qn_measure *measure, qn_column *columns, int room);

#endif
