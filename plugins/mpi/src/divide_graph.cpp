// SPDX-License-Identifier: BSD-3-Clause
#include "divide_graph.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>

#include "graph/graph_view.h"

namespace boxplus::mpi {
namespace {

constexpr std::uint32_t kNone = GraphView::kNone;

/// Cuts a sequence so that the weights of the parts are about equal. Calls f(index, part).
template <class F>
void cut(std::span<const std::uint64_t> weights, std::uint32_t parts, F&& f) {
  const std::uint64_t all = std::accumulate(weights.begin(), weights.end(), std::uint64_t{0});
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < weights.size() && all > 0; ++i) {
    f(i, std::min(parts - 1, static_cast<std::uint32_t>(before * parts / all)));
    before += weights[i];
  }
}

/// An eliminated vertex goes to the part of most of its edges that has room, and otherwise to the smallest
/// part. A vote is (eliminated vertex << 32) + the part of one of its edges. `sizes` are the numbers of edges
/// that the parts already have, `edges` is the number of all edges. Calls f(vertex, part) in the order of the
/// vertices.
template <class F>
void place(std::vector<std::uint64_t>& votes, std::vector<std::uint64_t> sizes, std::size_t edges, F&& f) {
  std::ranges::sort(votes);
  constexpr double kExcess = 1.01;
  const auto room = static_cast<std::uint64_t>(
      kExcess * static_cast<double>(edges) / static_cast<double>(sizes.size()) + 1);
  for (auto first = votes.begin(); first != votes.end();) {
    const auto vertex = static_cast<std::uint32_t>(*first >> 32);
    const auto end =
        std::find_if(first, votes.end(), [&](std::uint64_t vote) { return vote >> 32 != vertex; });
    const auto count = static_cast<std::uint64_t>(end - first);
    std::uint64_t most = 0;
    auto best = static_cast<std::uint32_t>(std::ranges::min_element(sizes) - sizes.begin());
    for (; first != end;) {
      const auto last = std::upper_bound(first, end, *first);
      const auto part = static_cast<std::uint32_t>(*first);
      const auto agreed = static_cast<std::uint64_t>(last - first);
      if (agreed > most && sizes[part] + count <= room) {
        most = agreed;
        best = part;
      }
      first = last;
    }
    f(vertex, best);
    sizes[best] += count;
  }
}

class Division {
 public:
  Division(const Graph& graph, int parts)
      : graph_(graph),
        view_(graph),
        edges_(graph.all_edges()),
        parts_(static_cast<std::uint32_t>(parts)),
        part_(view_.numbers(), 0) {
    count_edges();
    cut_kept();
    place_eliminated();
  }

  std::uint32_t part_of(EdgeRef edge) const {
    const Ends ends = ends_of(edge);
    const std::uint32_t end = ends.eliminated != kNone ? ends.eliminated : ends.lowest;
    return end == kNone ? 0 : part_[end];
  }

 private:
  /// Vertices of an edge, by number.
  struct Ends {
    std::uint32_t eliminated = kNone;
    std::uint32_t lowest = kNone;    ///< the kept one with the lowest id
    std::uint32_t specific = kNone;  ///< the kept one with the fewest edges
  };

  Ends ends_of(EdgeRef edge) const {
    Ends ends;
    view_.for_each_end(edge, [&](std::uint32_t end) {
      const detail::VertexPool& pool = view_.vertices_of(end);
      const std::uint32_t slot = view_.slot_of(end);
      if (pool.eliminated(slot)) {
        ends.eliminated = end;
        return;
      }
      if (ends.lowest == kNone || pool.id(slot) < id(ends.lowest)) ends.lowest = end;
      if (ends.specific == kNone || degree_[end] < degree_[ends.specific]) ends.specific = end;
    });
    return ends;
  }

  Id id(std::uint32_t number) const { return view_.vertices_of(number).id(view_.slot_of(number)); }

  void count_edges() {
    degree_.resize(view_.numbers(), 0);
    for (const EdgeRef& edge : edges_) view_.for_each_end(edge, [&](std::uint32_t end) { ++degree_[end]; });
  }

  /// Cuts the kept vertices so that the parts have equal numbers of edges: each edge counts for the vertex
  /// that decides its part.
  void cut_kept() {
    std::vector<std::uint64_t> weight(view_.numbers(), 0);
    for (const EdgeRef& edge : edges_) {
      const Ends ends = ends_of(edge);
      const std::uint32_t end = ends.eliminated != kNone ? ends.specific : ends.lowest;
      if (end != kNone) ++weight[end];
    }
    std::vector<std::uint32_t> kept;
    std::vector<std::uint64_t> weights;
    for (const VertexRef& vertex : graph_.all_vertices()) {
      if (graph_.is_eliminated(vertex)) continue;
      kept.push_back(view_.number(vertex));
      weights.push_back(weight[kept.back()]);
    }
    cut(weights, parts_, [&](std::size_t i, std::uint32_t part) { part_[kept[i]] = part; });
  }

  void place_eliminated() {
    std::vector<std::uint64_t> votes;
    std::vector<std::uint64_t> sizes(parts_, 0);
    for (const EdgeRef& edge : edges_) {
      const Ends ends = ends_of(edge);
      if (ends.eliminated == kNone) {
        ++sizes[ends.lowest == kNone ? 0 : part_[ends.lowest]];
      } else {
        votes.push_back((std::uint64_t{ends.eliminated} << 32) +
                        (ends.specific == kNone ? 0 : part_[ends.specific]));
      }
    }
    place(votes, sizes, edges_.size(),
          [&](std::uint32_t vertex, std::uint32_t part) { part_[vertex] = part; });
  }

  const Graph& graph_;
  GraphView view_;
  std::vector<EdgeRef> edges_;
  std::uint32_t parts_;
  std::vector<std::uint32_t> part_, degree_;  // of each vertex, by number
};

}  // namespace

std::vector<std::uint32_t> parts_of_eliminated(std::vector<std::uint64_t>& pairs, std::uint32_t eliminated,
                                               std::uint32_t kept, int parts) {
  std::vector<std::uint64_t> weights(kept, 0);
  for (const std::uint64_t pair : pairs) ++weights[static_cast<std::uint32_t>(pair)];
  std::vector<std::uint32_t> part_of_kept(kept, 0), result(eliminated, 0);
  const auto count = static_cast<std::uint32_t>(parts);
  cut(weights, count, [&](std::size_t i, std::uint32_t part) { part_of_kept[i] = part; });
  for (std::uint64_t& pair : pairs)
    pair = (pair >> 32 << 32) + part_of_kept[static_cast<std::uint32_t>(pair)];
  place(pairs, std::vector<std::uint64_t>(count, 0), pairs.size(),
        [&](std::uint32_t vertex, std::uint32_t part) { result[vertex] = part; });
  return result;
}

std::vector<EdgeRef> edges_of_part(const Graph& graph, int part, int parts) {
  std::vector<EdgeRef> edges = graph.all_edges();
  if (parts == 1) return edges;
  const Division division(graph, parts);
  std::erase_if(
      edges, [&](const EdgeRef& edge) { return division.part_of(edge) != static_cast<std::uint32_t>(part); });
  return edges;
}

}  // namespace boxplus::mpi
