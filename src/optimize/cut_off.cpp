// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/cut_off.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "graph/graph_view.h"

namespace boxplus {
namespace {

/// A node stands for a moving vertex or, if it is kWorld, for all fixed vertices.
constexpr std::uint32_t kWorld = 0, kNone = 0xFFFFFFFFu;

/// Finds the nodes that an edge connects. An edge with one moving vertex measures it relative to the world.
class EdgeNodes {
 public:
  EdgeNodes(const Graph& graph, const Plan& plan) : view_(graph), node_(view_.numbers(), kWorld) {
    for (std::uint32_t block = 0; block < plan.block_vertex.size(); ++block)
      node_[view_.number(plan.block_vertex[block])] = block + 1;
  }

  /// The result is valid until the next call.
  std::span<const std::uint32_t> of(std::uint32_t pool, std::uint32_t edge) {
    nodes_.clear();
    view_.for_each_end(pool, edge, [&](std::uint32_t number) { nodes_.push_back(node_[number]); });
    if (nodes_.size() == 1) nodes_.push_back(kWorld);
    return nodes_;
  }

 private:
  GraphView view_;
  std::vector<std::uint32_t> node_;  // by number
  std::vector<std::uint32_t> nodes_;
};

/// Calls f(position among the active edges, nodes) for each enabled edge.
template <class F>
void for_each_edge(const Graph& graph, const Plan& plan, EdgeNodes& nodes, F&& f) {
  for (const EdgeList& list : plan.edges) {
    for (std::size_t k = 0; k < list.edges.size(); ++k) {
      if (graph.edge_pools()[list.pool]->enabled(list.edges[k]))
        f(list.first + k, nodes.of(list.pool, list.edges[k]));
    }
  }
}

void join(DisjointSets& sets, std::span<const std::uint32_t> nodes) {
  for (const std::uint32_t node : nodes) sets.join(nodes.front(), node);
}

/// For each set of `components`, the largest set of `parts` in it. Both are indexed by root.
std::vector<std::uint32_t> largest_parts(DisjointSets& components, DisjointSets& parts) {
  std::vector<std::uint32_t> size(parts.size(), 0), largest(parts.size(), 0);
  for (std::uint32_t node = 1; node < parts.size(); ++node) ++size[parts.find(node)];
  for (std::uint32_t node = 1; node < parts.size(); ++node) {
    std::uint32_t& best = largest[components.find(node)];
    if (size[parts.find(node)] > (best == 0 ? 0 : size[best])) best = parts.find(node);
  }
  return largest;
}

}  // namespace

std::vector<VertexRef> find_cut_off(const Graph& graph, const Plan& plan,
                                    std::span<const std::uint8_t> rejected) {
  EdgeNodes nodes(graph, plan);
  DisjointSets components(plan.block_vertex.size() + 1), parts = components;
  for_each_edge(graph, plan, nodes, [&](std::size_t edge, std::span<const std::uint32_t> ends) {
    join(components, ends);
    if (rejected[edge] == 0) join(parts, ends);
  });
  // Parts without a rejected edge to another part are not cut off: they are as free as in the whole graph.
  std::vector<std::uint8_t> cut(parts.size(), 0);
  for_each_edge(graph, plan, nodes, [&](std::size_t, std::span<const std::uint32_t> ends) {
    const auto is_elsewhere = [&](std::uint32_t node) {
      return parts.find(node) != parts.find(ends.front());
    };
    if (std::none_of(ends.begin(), ends.end(), is_elsewhere)) return;
    for (const std::uint32_t node : ends) cut[parts.find(node)] = 1;
  });
  cut[kWorld] = 0;
  const std::vector<std::uint32_t> largest = largest_parts(components, parts);
  std::vector<std::uint32_t> first(parts.size(), kNone);  // the block with the lowest id of each part
  for (std::uint32_t block = 0; block < plan.block_vertex.size(); ++block) {
    const std::uint32_t part = parts.find(block + 1), component = components.find(part);
    if (cut[part] == 0 || (component != kWorld && part == largest[component])) continue;
    const auto id = [&](std::uint32_t b) { return graph.id(plan.block_vertex[b]); };
    if (first[part] == kNone || id(block) < id(first[part])) first[part] = block;
  }
  std::vector<VertexRef> result;
  for (const std::uint32_t block : first) {
    if (block != kNone) result.push_back(plan.block_vertex[block]);
  }
  std::sort(result.begin(), result.end(),
            [&](const VertexRef& a, const VertexRef& b) { return graph.id(a) < graph.id(b); });
  return result;
}

}  // namespace boxplus
