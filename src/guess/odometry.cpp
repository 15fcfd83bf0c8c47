// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "graph/graph_view.h"
#include "guess/initial_guess.h"
#include "guess/notes.h"
#include "guess/propagate.h"
#include "guess/restore.h"

namespace boxplus {
namespace {

using guess::FrameGraph;
using guess::Measurement;
using guess::Node;

/// The costs of the measurements. With these costs, the shortest paths follow the chain of poses, and bridge
/// gaps with as few other measurements as possible.
std::vector<double> costs_of_gaps(const FrameGraph& frames, const StopToken& stop) {
  const EdgeRoles roles(frames.graph(), stop);
  const auto is_step = [&](Node a, Node b) {
    const std::uint32_t first = roles.rank(a), second = roles.rank(b);
    return std::max(first, second) - std::min(first, second) == 1 && first != GraphView::kNone &&
           second != GraphView::kNone;
  };
  const double bridge = static_cast<double>(frames.nodes()) + 1;  // costs more than any chain
  std::vector<double> cost;
  cost.reserve(frames.measurements().size());
  for (const Measurement& m : frames.measurements()) {
    const bool link = m.from != FrameGraph::kWorld && m.has_rotation && is_step(m.from, m.to);
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
