// SPDX-License-Identifier: BSD-3-Clause
// Findings about the structure of the graph: which vertices have edges, which vertices move, which edges
// occur twice.
#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "diagnose/evidence.h"
#include "diagnose/finding_table.h"
#include "diagnose/sentences.h"
#include "graph/graph_view.h"
#include "plan/fixed_directions.h"

namespace boxplus {
namespace {

template <class F>
void for_each_edge(const Evidence& evidence, F&& f) {
  for (const PoolEvidence& pool : evidence.pools) {
    for (std::size_t k = 0; k < pool.edges.size(); ++k) f(pool, k);
  }
}

bool has_moving_vertex(const Evidence& evidence, const GraphView& view, std::uint32_t p, std::uint32_t edge) {
  bool moves = false;
  view.for_each_vertex(p, edge, [&](std::uint32_t pool, std::uint32_t slot, std::size_t) {
    moves = moves || evidence.find(pool, slot) != nullptr;
  });
  return moves;
}

/// The errors of two edges with the same vertices are equal.
bool has_equal_errors(const detail::EdgePool& pool, std::uint32_t a, std::uint32_t b) {
  const auto vertices_a = pool.vertex_slots(a), vertices_b = pool.vertex_slots(b);
  if (!std::equal(vertices_a.begin(), vertices_a.end(), vertices_b.begin(), vertices_b.end())) return false;
  const int rows = pool.shape(a).rows;
  if (rows != pool.shape(b).rows) return false;
  std::vector<double> error_a(static_cast<std::size_t>(rows)), error_b = error_a;
  pool.errors(std::span(&a, 1), error_a.data());
  pool.errors(std::span(&b, 1), error_b.data());
  return error_a == error_b;
}

/// A hash table of edges by their signature, with linear probing.
class EdgeTable {
 public:
  explicit EdgeTable(const PoolEvidence& edges) : edges_(edges) {
    places_.assign(std::bit_ceil(2 * edges.edges.size() + 1), kFree);
  }
  /// Adds the k-th edge. If there is an edge with this signature, returns its position instead.
  std::size_t add(std::size_t k) {
    const std::size_t mask = places_.size() - 1;
    for (std::size_t at = edges_.signatures[k] & mask;; at = (at + 1) & mask) {
      if (places_[at] == kFree) {
        places_[at] = static_cast<std::uint32_t>(k);
        return k;
      }
      if (edges_.signatures[places_[at]] == edges_.signatures[k]) return places_[at];
    }
  }

 private:
  static constexpr std::uint32_t kFree = 0xFFFFFFFFu;
  const PoolEvidence& edges_;
  std::vector<std::uint32_t> places_;
};

/// The edges of a pool that repeat an edge before them. Two measurements with the same vertices are equal if
/// their errors are equal, unless the errors do not depend on the vertices at all.
void append_duplicates(const Evidence& evidence, const PoolEvidence& edges, std::vector<EdgeRef>& out) {
  EdgeTable table(edges);
  for (std::size_t k = 0; k < edges.edges.size(); ++k) {
    if (edges.signatures[k] == 0) continue;
    const std::size_t first = table.add(k);
    if (first != k &&
        has_equal_errors(*evidence.graph.edge_pools()[edges.pool], edges.edges[first], edges.edges[k]))
      out.push_back(evidence.edge_ref(edges.pool, edges.edges[k]));
  }
}

}  // namespace

void find_nothing_moves(const Evidence& evidence, Findings& out) {
  if (!evidence.vertices.empty() || evidence.graph.vertex_count() == 0) return;
  Finding finding;
  finding.severity = Finding::Severity::kError;
  if (evidence.pools.empty()) {
    finding.text =
        "no edge takes part, so there is nothing to optimize: add or enable edges, or check the level";
  } else {
    finding.text =
        "all vertices of the edges are fixed, so there is nothing to optimize: unfix all but the first";
    for (const VertexRef& vertex : evidence.graph.all_vertices()) {
      if (evidence.graph.is_fixed(vertex)) finding.vertices.push_back(vertex);
    }
  }
  out.push_back(std::move(finding));
}

void find_isolated_vertices(const Evidence& evidence, Findings& out) {
  if (!evidence.options.vertices.empty() || !evidence.options.edges.empty()) return;
  const GraphView view(evidence.graph);
  std::vector<std::uint8_t> has_edge(view.numbers(), 0);
  for_each_edge(evidence, [&](const PoolEvidence& edges, std::size_t k) {
    view.for_each_end(edges.pool, edges.edges[k], [&](std::uint32_t number) { has_edge[number] = 1; });
  });
  std::vector<VertexRef> isolated = evidence.graph.all_vertices();
  std::erase_if(isolated, [&](const VertexRef& vertex) {
    return has_edge[view.number(vertex)] || evidence.graph.is_fixed(vertex);
  });
  if (isolated.empty()) return;
  Finding finding;
  finding.severity = Finding::Severity::kWarning;
  finding.text =
      fmt::format("{} {} no edge that takes part, so optimize() leaves {} alone: add an edge, or remove {}",
                  vertices_text(evidence.graph, isolated), by_count(isolated.size(), "has", "have"),
                  by_count(isolated.size(), "it", "them"), by_count(isolated.size(), "it", "them"));
  finding.vertices = std::move(isolated);
  out.push_back(std::move(finding));
}

void find_fixed_edges(const Evidence& evidence, Findings& out) {
  if (evidence.vertices.empty()) return;  // find_nothing_moves() says it
  const GraphView view(evidence.graph);
  std::vector<EdgeRef> edges;
  for_each_edge(evidence, [&](const PoolEvidence& pool, std::size_t k) {
    if (!has_moving_vertex(evidence, view, pool.pool, pool.edges[k]))
      edges.push_back(evidence.edge_ref(pool.pool, pool.edges[k]));
  });
  if (edges.empty()) return;
  Finding finding;
  finding.text =
      fmt::format("all vertices of {} are fixed, so {} only a constant to chi2: unfix a vertex, or remove {}",
                  edges_text(evidence.graph, edges), by_count(edges.size(), "it adds", "they add"),
                  by_count(edges.size(), "the edge", "these edges"));
  finding.edges = std::move(edges);
  out.push_back(std::move(finding));
}

void find_duplicate_edges(const Evidence& evidence, Findings& out) {
  std::vector<EdgeRef> duplicates;
  std::size_t total = 0;
  for (const PoolEvidence& pool : evidence.pools) {
    append_duplicates(evidence, pool, duplicates);
    total += pool.edges.size();
  }
  if (duplicates.empty()) return;
  Finding finding;
  finding.severity = severity_by_share(duplicates.size(), total);
  finding.text = fmt::format(
      "{} {} the vertices and the measurement of an earlier edge, so the measurement counts twice: remove {}",
      edges_text(evidence.graph, duplicates), by_count(duplicates.size(), "repeats", "repeat"),
      by_count(duplicates.size(), "the edge, or halve its Ω", "these edges, or halve their Ω"));
  finding.edges = std::move(duplicates);
  out.push_back(std::move(finding));
}

}  // namespace boxplus
