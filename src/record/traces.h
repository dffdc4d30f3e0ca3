// SPDX-License-Identifier: Apache-2.0
// Traces: chosen particles step by step, with the parts of the force of each of their contacts.
#ifndef QN_RECORD_TRACES_H
#define QN_RECORD_TRACES_H

#include "measure/measure.h"
#include "record/series_file.h"

typedef struct qn_traces {
    qn_series_file particles, contacts;  // traces.csv, trace_contacts.csv
} qn_traces;

/// Opens both files in `folder`, cut before step `cut`; nothing where no particle is traced.
QN_NODISCARD qn_status qn_traces_open(qn_traces *traces, const char *folder,
                                      const qn_measure_def *def, int64_t cut);

/// Adds the present step. Valid between qn_step_forces() and qn_step_advance().
QN_NODISCARD qn_status qn_traces_write(qn_traces *traces, qn_world *world,
                                       const qn_measure_def *def);

QN_NODISCARD qn_status qn_traces_sync(qn_traces *traces);
void qn_traces_close(qn_traces *traces);

#endif
