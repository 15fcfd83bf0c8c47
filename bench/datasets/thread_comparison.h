// SPDX-License-Identifier: BSD-3-Clause
// Two threads of boxplus against one.
#pragma once

#include "boxplus/graph/graph.h"

namespace boxplus::bench {

struct ThreadComparison {
  double one_s = 0, two_s = 0;  ///< optimize() with all preparations, Start::kAutomatic
};

/// Throws std::runtime_error if the results differ in a bit of chi2.
ThreadComparison run_thread_comparison(Graph& graph);

}  // namespace boxplus::bench
