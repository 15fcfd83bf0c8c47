// SPDX-License-Identifier: BSD-3-Clause
// Findings about the member jacobians() of edge types: compares it with numeric derivatives.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnose/evidence.h"
#include "diagnose/finding_table.h"
#include "diagnose/sentences.h"

namespace boxplus {
namespace {

/// The entry of a Jacobian that differs most from the numeric derivative.
struct WrongEntry {
  int row = 0, column = 0;  ///< the column counts over all vertices of the edge
  double analytic = 0, numeric = 0;
  double difference = 0;  ///< relative to the largest entry of the numeric Jacobian
};

class JacobianCheck {
 public:
  explicit JacobianCheck(const detail::EdgePool& pool) : pool_(pool) {}

  WrongEntry worst_entry(std::uint32_t edge) {
    const detail::EdgeShape shape = pool_.shape(edge);
    linearize(edge, shape, analytic_, false);
    linearize(edge, shape, numeric_, true);
    double largest = 0;
    for (const double value : numeric_) largest = std::max(largest, std::abs(value));
    for (const double value : analytic_) largest = std::max(largest, std::abs(value));
    WrongEntry worst;
    for (std::size_t k = 0; k < numeric_.size(); ++k) {
      const double difference = std::abs(analytic_[k] - numeric_[k]) / largest;
      if (!(difference > worst.difference)) continue;  // also if the numeric derivative does not exist
      const int entry = static_cast<int>(k);
      worst = {entry % shape.rows, entry / shape.rows, analytic_[k], numeric_[k], difference};
    }
    return worst;
  }

 private:
  void linearize(std::uint32_t edge, const detail::EdgeShape& shape, std::vector<double>& jacobian,
                 bool numeric) {
    error_.resize(static_cast<std::size_t>(shape.rows));
    jacobian.resize(error_.size() * static_cast<std::size_t>(shape.cols));
    detail::EdgeTile tile;
    tile.error = error_.data();
    tile.jacobian = jacobian.data();
    pool_.linearize(std::span(&edge, 1), tile, numeric);
  }

  const detail::EdgePool& pool_;
  std::vector<double> error_, analytic_, numeric_;
};

/// The vertex that a column belongs to, and its direction.
std::pair<VertexRef, int> place_of_column(const Evidence& evidence, EdgeRef edge, int column) {
  for (const VertexRef& vertex : evidence.graph.vertices(edge)) {
    const int dim = evidence.graph.tangent_dim(vertex);
    if (column < dim) return {vertex, column};
    column -= dim;
  }
  return {};
}

std::size_t position_of(const Evidence& evidence, EdgeRef edge, VertexRef vertex) {
  const std::vector<VertexRef> vertices = evidence.graph.vertices(edge);
  return static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin());
}

Finding describe(const Evidence& evidence, std::vector<EdgeRef> edges, EdgeRef worst,
                 const WrongEntry& entry) {
  const auto [vertex, direction] = place_of_column(evidence, worst, entry.column);
  Finding finding;
  finding.severity = Finding::Severity::kError;
  finding.vertices = {vertex};
  std::vector<double> tangent(static_cast<std::size_t>(evidence.graph.tangent_dim(vertex)), 0.0);
  tangent[direction] = 1;
  finding.directions = {
      {.kind = Finding::Direction::Kind::kTangent, .vertex = vertex, .tangent = std::move(tangent)}};
  finding.text = fmt::format(
      "jacobians() of {} is wrong: ∂e/∂x_{}, row {}, column {} is {:.6g} instead of {:.6g} (at {}); check it "
      "with check_jacobians(), or remove it",
      evidence.graph.edge_pools()[worst.pool]->type_name(), position_of(evidence, worst, vertex) + 1,
      entry.row + 1, direction + 1, entry.analytic, entry.numeric,
      edges_text(evidence.graph, std::span(&worst, 1)));
  finding.edges = std::move(edges);
  return finding;
}

}  // namespace

/// A single edge may be at a kink of its error, where neither derivative is right. So a type is wrong if two
/// edges show it.
void find_wrong_jacobians(const Evidence& evidence, Findings& out) {
  constexpr std::size_t kSample = 6, kEnough = 2;
  constexpr double kMost = 1e-4;
  if (evidence.options.numeric_jacobians) return;
  for (const PoolEvidence& edges : evidence.pools) {
    const detail::EdgePool& pool = *evidence.graph.edge_pools()[edges.pool];
    if (pool.jacobian_source() != detail::JacobianSource::kAnalytic) continue;
    JacobianCheck check(pool);
    std::vector<EdgeRef> wrong;
    WrongEntry worst;
    EdgeRef worst_edge;
    const std::size_t stride = (edges.edges.size() + kSample - 1) / kSample;
    for (std::size_t k = 0; k < edges.edges.size(); k += stride) {
      const WrongEntry entry = check.worst_entry(edges.edges[k]);
      if (!(entry.difference > kMost)) continue;
      wrong.push_back(evidence.edge_ref(edges.pool, edges.edges[k]));
      if (entry.difference <= worst.difference) continue;
      worst = entry;
      worst_edge = wrong.back();
    }
    if (wrong.size() >= std::min(kEnough, edges.edges.size()))
      out.push_back(describe(evidence, std::move(wrong), worst_edge, worst));
  }
}

}  // namespace boxplus
