// SPDX-License-Identifier: Apache-2.0
// fields.h5: the voxel fields and the ring along the shell, as sums and as means.
#ifndef QN_RECORD_FIELDS_FILE_H
#define QN_RECORD_FIELDS_FILE_H

#include "measure/measure.h"

/// Writes the fields of a run so far. Nothing is written before the first sample.
QN_NODISCARD qn_status qn_fields_write(const char *path, const qn_measure *measure,
                                       const qn_world *world);

#endif
