// SPDX-License-Identifier: Apache-2.0
// summary.json: the figures of a run, as a person or a script wants them. docs/recording.md tells
// what each key means; numbers that do not exist (yet) are null.
#ifndef QN_RECORD_SUMMARY_H
#define QN_RECORD_SUMMARY_H

#include "measure/measure.h"
#include "record/checkpoint.h"

/// Writes the summary from the latest row of the time series (measure->series.column_count numbers;
/// NULL where there is none yet) and from what the measures know.
QN_NODISCARD qn_status qn_summary_write(const char *path, const qn_world *world,
                                        const qn_measure *measure, const qn_progress *progress,
                                        const double *row, bool finished);

/// The mean power and the energy residual as sentences for people, each ended by a newline; those that
/// are not known are left out. Returns `text`.
const char *qn_summary_text(const qn_measure *measure, const double *row, char *text, size_t room);

#endif
