// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boxplus/graph/handle.h"

namespace boxplus::detail {

/// An entry of an estimate that is at one of its limits (Graph::set_bounds()) at the end of the run,
/// although chi2 would be lower beyond the limit.
struct ActiveBound {
  VertexRef vertex;
  Id id = 0;  ///< of the vertex
  int entry = 0;
  bool is_upper = false;
  double limit = 0;
  /// The decrease of F per unit by which the limit is loosened, to first order; positive.
  double multiplier = 0;
};

}  // namespace boxplus::detail
