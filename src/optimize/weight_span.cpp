// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/weight_span.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace boxplus {
namespace {

/// If the ratio of two terms is larger than this, their sum loses all digits of the smaller term.
constexpr double kAllDigits = 1e15;

/// The smallest and the largest positive value of a list.
struct Span {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  void add(double value) {
    if (!(value > 0)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  bool swamps() const { return most >= kAllDigits * least; }
};

template <class F>
void for_each_enabled_edge(const Graph& graph, const Plan& plan, F&& f) {
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    for (const std::uint32_t edge : list.edges) {
      if (pool.enabled(edge)) f(pool, EdgeRef{list.pool, edge, pool.generation(edge)});
    }
  }
}

/// Whether the diagonals of Ω span more digits than double precision has.
bool weights_span_all_digits(const Graph& graph, const Plan& plan) {
  Span span;
  for_each_enabled_edge(graph, plan, [&](const detail::EdgePool& pool, EdgeRef edge) {
    const int rows = pool.shape(edge.slot).rows;
    const detail::InformationView omega = pool.information(edge.slot, rows);
    for (int i = 0; i < rows; ++i) span.add(omega(i, i));
  });
  return span.swamps();
}

/// The traces of an edge's contributions to the diagonal blocks of its vertices.
class Contributions {
 public:
  std::span<const double> of(const Graph& graph, const detail::EdgePool& pool, std::uint32_t edge) {
    const detail::EdgeShape shape = pool.shape(edge);
    error_.resize(static_cast<std::size_t>(shape.rows));
    jacobian_.resize(static_cast<std::size_t>(shape.rows * shape.cols));
    detail::EdgeTile tile;
    tile.error = error_.data();
    tile.jacobian = jacobian_.data();
    pool.linearize(std::span(&edge, 1), tile, false);
    const detail::InformationView omega = pool.information(edge, shape.rows);
    traces_.clear();
    const double* column = tile.jacobian;
    const auto slots = pool.vertex_slots(edge);
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const int dim =
          graph.vertex_pools()[pool.vertex_pool(edge, static_cast<int>(i))]->tangent_dim(slots[i]);
      traces_.push_back(0);
      for (int k = 0; k < dim; ++k, column += shape.rows) traces_.back() += omega.squared_norm(column);
    }
    return traces_;
  }

 private:
  std::vector<double> error_, jacobian_, traces_;
};

}  // namespace

std::optional<SwampingEdge> find_swamping_edge(const Graph& graph, const Plan& plan) {
  if (!weights_span_all_digits(graph, plan)) return std::nullopt;
  std::vector<std::vector<std::uint8_t>> moves;
  std::vector<std::vector<Span>> spans;
  for (const auto& pool : graph.vertex_pools()) {
    moves.emplace_back(pool->slots(), 0);
    spans.emplace_back(pool->slots());
  }
  for (const VertexRef& vertex : plan.block_vertex) moves[vertex.pool][vertex.slot] = 1;
  Contributions contributions;
  const auto for_each_end = [&](const detail::EdgePool& pool, EdgeRef edge, auto&& f) {
    const auto traces = contributions.of(graph, pool, edge.slot);
    const auto slots = pool.vertex_slots(edge.slot);
    int moving = 0;
    for (std::size_t i = 0; i < slots.size(); ++i)
      moving += moves[pool.vertex_pool(edge.slot, static_cast<int>(i))][slots[i]];
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const std::uint32_t p = pool.vertex_pool(edge.slot, static_cast<int>(i));
      if (moves[p][slots[i]])
        f(VertexRef{p, slots[i], graph.vertex_pools()[p]->generation(slots[i])}, traces[i], moving);
    }
  };
  for_each_enabled_edge(graph, plan, [&](const detail::EdgePool& pool, EdgeRef edge) {
    for_each_end(pool, edge,
                 [&](VertexRef v, double trace, int /*moving*/) { spans[v.pool][v.slot].add(trace); });
  });
  std::optional<SwampingEdge> found;
  double heaviest = 0;
  for_each_enabled_edge(graph, plan, [&](const detail::EdgePool& pool, EdgeRef edge) {
    for_each_end(pool, edge, [&](VertexRef v, double trace, int moving) {
      const bool swamps = moving > 1 && trace >= kAllDigits * spans[v.pool][v.slot].least;
      if (!swamps || trace <= heaviest) return;
      heaviest = trace;
      found = SwampingEdge{edge, v};
    });
  });
  return found;
}

}  // namespace boxplus
