// SPDX-License-Identifier: BSD-3-Clause
#include "outliers/gaps.h"

#include <algorithm>
#include <numeric>

#include "base/disjoint_sets.h"
#include "graph/graph_view.h"

namespace boxplus::outliers {
namespace {

/// The parts of the odometry and the other vertices, joined by other edges and by the world, which fixed
/// vertices belong to.
class Parts {
 public:
  Parts(const Graph& graph, const PoseGraph& poses, const OdometryChain& chain)
      : view_(graph), poses_(poses), sets_(view_.numbers()) {
    const std::uint32_t world = sets_.add();
    for (std::uint32_t k = 1; k < poses.poses.size(); ++k) {
      if (chain.part(k) == chain.part(k - 1)) sets_.join(number(k), number(k - 1));
    }
    for (const EdgeRef& edge : poses.others) {
      std::size_t ends = 0;
      view_.for_each_end(edge, [&](std::uint32_t) { ++ends; });
      view_.join_ends(edge.pool, edge.slot, sets_);
      if (ends == 1) sets_.join(view_.first_end(edge), world);
    }
    for (const VertexRef& vertex : graph.all_vertices()) {
      if (graph.is_fixed(vertex)) sets_.join(view_.number(vertex), world);
    }
  }

  /// Returns false if the ends of a closure are already in one part.
  bool join(const PoseEdge& edge) { return sets_.join(number(edge.from), number(edge.to)); }

 private:
  std::uint32_t number(std::uint32_t rank) const { return view_.number(poses_.poses[rank]); }

  GraphView view_;
  const PoseGraph& poses_;
  DisjointSets sets_;
};

}  // namespace

Bridges bridge_gaps(const Graph& graph, const PoseGraph& poses, const OdometryChain& chain,
                    const CycleTests& cycles, double evidence) {
  Bridges bridges;
  if (chain.parts() < 2) return bridges;
  Parts parts(graph, poses, chain);
  std::vector<std::uint32_t> order(poses.closures.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return cycles.support[a] > cycles.support[b]; });
  for (const std::uint32_t closure : order) {
    if (!parts.join(poses.closures[closure])) continue;
    (cycles.support[closure] >= evidence ? bridges.supported : bridges.unsupported).push_back(closure);
  }
  return bridges;
}

bool leaves_parts_apart(const Graph& graph, const PoseGraph& poses, const OdometryChain& chain,
                        std::span<const std::uint8_t> accepted) {
  if (chain.parts() < 2) return false;
  Parts parts(graph, poses, chain);
  for (std::size_t k = 0; k < accepted.size(); ++k) {
    if (accepted[k]) parts.join(poses.closures[k]);
  }
  return std::ranges::any_of(poses.closures, [&](const PoseEdge& edge) { return parts.join(edge); });
}

}  // namespace boxplus::outliers
