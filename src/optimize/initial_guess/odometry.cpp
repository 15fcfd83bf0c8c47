// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdlib>

#include "boxplus/optimize/initial_guess.h"
#include "optimize/initial_guess/notes.h"
#include "optimize/initial_guess/propagate.h"
#include "optimize/initial_guess/restore.h"

namespace boxplus {
namespace {

using guess::FrameGraph;
using guess::Measurement;
using guess::Node;

/// The rank of every pose among all poses, sorted by id. Parameters have no rank, because they have separate
/// ids.
std::vector<std::int64_t> ranks_by_id(const FrameGraph& frames, const StopToken& stop) {
  PacedStop pace(stop);
  constexpr std::int64_t kFar = -2;
  std::vector<Node> poses;
  for (Node node = 0; node < frames.nodes(); ++node) {
    if (frames.used(node) && frames.pose(node) && !frames.parameter(node)) poses.push_back(node);
  }
  std::sort(poses.begin(), poses.end(), [&](Node a, Node b) {
    pace.step();
    return frames.id(a) < frames.id(b);
  });
  std::vector<std::int64_t> rank(frames.nodes(), kFar);
  for (std::size_t k = 0; k < poses.size(); ++k) rank[poses[k]] = static_cast<std::int64_t>(k);
  return rank;
}

/// The costs of the measurements. With these costs, the shortest paths follow the chain of poses, and bridge
/// gaps with as few other measurements as possible.
std::vector<double> costs_of_gaps(const FrameGraph& frames, const StopToken& stop) {
  const std::vector<std::int64_t> rank = ranks_by_id(frames, stop);
  const double bridge = static_cast<double>(frames.nodes()) + 1;  // costs more than any chain
  std::vector<double> cost;
  cost.reserve(frames.measurements().size());
  for (const Measurement& m : frames.measurements()) {
    const bool link =
        m.from != FrameGraph::kWorld && m.has_rotation && std::abs(rank[m.from] - rank[m.to]) == 1;
    cost.push_back(link ? 1 : bridge);
  }
  return cost;
}

}  // namespace

GuessResult guess_odometry(Graph& graph, const Plan& plan, const GuessLimits& limits) {
  return guess::guess_or_restore(graph, plan, [&]() -> GuessResult {
    FrameGraph frames(graph, plan, limits.stop);
    if (frames.measurements().empty()) return {false, guess::kNothingMeasured};
    guess::propagate(frames, costs_of_gaps(frames, limits.stop), limits.stop);
    return {true, {}};
  });
}

}  // namespace boxplus
