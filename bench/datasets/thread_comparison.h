// SPDX-License-Identifier: BSD-3-Clause
// Our two threads against our one.
#pragma once

#include "boxplus/graph/graph.h"

namespace boxplus::bench {

struct ThreadDuel {
  double one_s = 0, two_s = 0;  ///< optimize() from nothing to convergence, Start::kAutomatic
};

/// Throws std::runtime_error where the results differ in a bit of chi2.
ThreadDuel run_thread_duel(Graph& graph);

}  // namespace boxplus::bench
