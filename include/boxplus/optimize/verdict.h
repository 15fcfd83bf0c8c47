// SPDX-License-Identifier: BSD-3-Clause
// The verdict on an edge that may be false. Programs use these names through optimize/outliers.h.
#pragma once

#include <cstdint>
#include <string_view>

#include "boxplus/graph/handle.h"

namespace boxplus::detail {

enum class Verdict : std::uint8_t {
  kInlier,   ///< the edge agrees with the estimates; it takes part in the final run
  kOutlier,  ///< the edge is false
  /// Not enough evidence. A loop closure takes no part in the final run, unless it bridges a gap. If all
  /// edges are suspects, an edge takes part if it fits; this happens if nothing else measures its vertex.
  kUndecided
};
std::string_view to_string(Verdict verdict);

/// The edges that may be false.
enum class Suspects : std::uint8_t {
  kLoopClosures,  ///< those of a pose graph; all other edges are trusted
  kAll            ///< the edges of any graph: pose graphs, landmarks, registration, bundle adjustment
};

/// The verdict on one edge.
struct EdgeVerdict {
  EdgeRef edge;
  /// The ids of the poses of a loop closure, the lower one first; of other edges, the ids of the first and
  /// the last vertex.
  Id from = 0, to = 0;
  Verdict verdict = Verdict::kUndecided;
  double weight = 0;  ///< the factor of its Ω in the final run: 1 if it takes part, otherwise 0
  double chi2 = 0;    ///< eᵀΩe at the final estimates
  /// Whether a loop closure agrees with a neighboring closure: the cycle through both closures and the
  /// odometry between their ends closes, to within the uncertainty. Always false if all edges are suspects.
  bool supported = false;
};

}  // namespace boxplus::detail
