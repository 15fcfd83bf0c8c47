// SPDX-License-Identifier: BSD-3-Clause
// Compares boxplus with two threads and with one thread.
#pragma once

#include "boxplus/graph/graph.h"

namespace boxplus::bench {

struct ThreadComparison {
  double one_s = 0, two_s = 0;  ///< the time of one call of optimize() with Start::kAutomatic
};

/// Throws std::runtime_error if the final chi2 with one thread and with two threads differs in any bit.
ThreadComparison run_thread_comparison(Graph& graph);

}  // namespace boxplus::bench
