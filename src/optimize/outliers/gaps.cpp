// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/outliers/gaps.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "base/disjoint_sets.h"

namespace boxplus::outliers {
namespace {

/// The parts of the odometry, the world and the other vertices, joined by other edges and fixed vertices.
DisjointSets connected_parts(const Graph& graph, const PoseGraph& poses, const OdometryChain& chain) {
  DisjointSets sets(chain.parts());
  const std::uint32_t world = sets.add();
  std::map<VertexRef, std::uint32_t> set_of;
  for (std::uint32_t k = 0; k < poses.poses.size(); ++k) set_of[poses.poses[k]] = chain.part(k);
  for (const EdgeRef& edge : poses.others) {
    std::vector<std::uint32_t> ends;
    for (const VertexRef& vertex : graph.vertices(edge)) {
      if (graph.vertex_pools()[vertex.pool]->parameter(vertex.slot)) continue;
      const auto [entry, fresh] = set_of.try_emplace(vertex, 0);
      if (fresh) entry->second = sets.add();
      ends.push_back(entry->second);
    }
    if (ends.size() == 1) ends.push_back(world);
    for (std::size_t k = 1; k < ends.size(); ++k) sets.join(ends[0], ends[k]);
  }
  for (const auto& [vertex, set] : set_of) {
    if (graph.is_fixed(vertex)) sets.join(set, world);
  }
  return sets;
}

}  // namespace

Bridges bridge_gaps(const Graph& graph, const PoseGraph& poses, const OdometryChain& chain,
                    const CycleTests& cycles, double evidence) {
  Bridges bridges;
  if (chain.parts() < 2) return bridges;
  DisjointSets sets = connected_parts(graph, poses, chain);
  std::vector<std::uint32_t> order(poses.closures.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return cycles.support[a] > cycles.support[b]; });
  for (const std::uint32_t closure : order) {
    const PoseEdge& edge = poses.closures[closure];
    if (!sets.join(chain.part(edge.from), chain.part(edge.to))) continue;
    (cycles.support[closure] >= evidence ? bridges.supported : bridges.unsupported).push_back(closure);
  }
  return bridges;
}

bool leaves_parts_apart(const Graph& graph, const PoseGraph& poses, const OdometryChain& chain,
                        std::span<const std::uint8_t> accepted) {
  if (chain.parts() < 2) return false;
  DisjointSets sets = connected_parts(graph, poses, chain);
  const auto join = [&](const PoseEdge& edge) {
    return sets.join(chain.part(edge.from), chain.part(edge.to));
  };
  for (std::size_t k = 0; k < accepted.size(); ++k) {
    if (accepted[k]) join(poses.closures[k]);
  }
  return std::any_of(poses.closures.begin(), poses.closures.end(), join);
}

}  // namespace boxplus::outliers
