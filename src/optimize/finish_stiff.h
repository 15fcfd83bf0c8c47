// SPDX-License-Identifier: BSD-3-Clause
// Checks and improves the end of a run whose graph may have stiff edges (linearize/stiff_edge.h).
#pragma once

#include "optimize/descent.h"

namespace boxplus {

/// Near stiff edges, neither a small step nor a small decrease of chi2 shows a minimum: rounding, damping and
/// the curved valley of a stiff row make steps far too small in all directions that the stiff rows do not
/// measure. So this function computes an undamped step, in double-double if necessary. If this step would
/// decrease chi2 noticeably, continues with Gauss-Newton steps, and keeps their estimates if chi2 falls. If
/// the end is still not at a minimum, the result says so.
///
/// `descent` has left iterations_to_finish(). It has ended with `result`, and its algorithm was `algorithm`.
/// The estimates are in the graph. `memory` is scratch memory.
RunResult finish_stiff(Descent& descent, Algorithm& algorithm, const RunResult& result, Estimates& memory);

/// The number of iterations to leave for finish_stiff() (Descent::leave()): most of many, and none of few.
/// Near stiff edges, algorithms that compare chi2 converge within a few iterations or hardly at all.
constexpr int iterations_to_finish(const Options& options) {
  return options.max_iterations >= 20 ? options.max_iterations / 4 * 3 : 0;
}

}  // namespace boxplus
