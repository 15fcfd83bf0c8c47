// SPDX-License-Identifier: BSD-3-Clause
// The graph of an iSAM file.
#pragma once

#include "io/isam/isam_reader.h"

namespace boxplus {

/// Adds the graph to `file`, with vertices that have default values.
void add_isam(const IsamMeasurements& measurements, GraphFile& file);

}  // namespace boxplus
