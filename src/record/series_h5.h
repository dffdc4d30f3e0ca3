// SPDX-License-Identifier: Apache-2.0
// series.h5: the time series of series.csv, column by column, with units and meanings.
#ifndef QN_RECORD_SERIES_H5_H
#define QN_RECORD_SERIES_H5_H

#include "measure/series.h"

/// Makes series.h5 in `folder` from series.csv, which must be synced.
QN_NODISCARD qn_status qn_series_h5_write(const char *folder, const qn_series *series);

/// The first line of series.csv; release with free().
QN_NODISCARD qn_status qn_series_header(const qn_series *series, char **header);

#endif
