// SPDX-License-Identifier: BSD-3-Clause
// The pool of the priors that marginalize() leaves behind: dense priors on any vertices of a graph.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "boxplus/base/matrix.h"
#include "boxplus/graph/graph.h"
#include "boxplus/types/dense_prior.h"

namespace boxplus {

/// The error of an edge is R δ + r, where δ stacks x ⊟ mean of its vertices. The means stay at the estimates
/// at which the problem was linearized.
class MarginalPool final : public detail::EdgePool {
 public:
  /// A pool for vertices of all pools that the graph has now.
  explicit MarginalPool(const Graph& graph);

  /// The prior whose cost is δᵀHδ + 2 bᵀδ, up to a constant. The vertices must be sorted by pool. `unit` is
  /// unit_scale() of the diagonal whose rounding errors H has. `means` are
  /// pools with their means, in the same slots.
  std::uint32_t add(std::span<const VertexRef> vertices, const Eigen::MatrixXd& H, const Eigen::VectorXd& b,
                    const Eigen::VectorXd& unit, std::span<const std::unique_ptr<detail::VertexPool>> means);
  /// Whether the pool takes vertices of all pools of this graph.
  bool suits(const Graph& graph) const { return pools_.size() == graph.vertex_pools().size(); }

  std::unique_ptr<EdgePool> clone(std::span<const std::unique_ptr<detail::VertexPool>> pools) const override;
  std::string_view type_name() const override { return "MarginalPrior"; }
  detail::EdgeShape shape(std::uint32_t edge) const override;
  bool uniform_shape() const override { return false; }
  void errors(std::span<const std::uint32_t> edges, double* out) const override;
  void linearize(std::span<const std::uint32_t> edges, detail::EdgeTile& tile,
                 bool force_numeric) const override;
  detail::JacobianSource jacobian_source() const override { return detail::JacobianSource::kNumeric; }
  void reserve(std::size_t edges) override;

 private:
  struct Prior {
    dense_prior::Rows rows;
    std::vector<std::unique_ptr<detail::SavedEstimates>> means;  // per vertex pool
  };
  MarginalPool(const MarginalPool& other, std::span<const std::unique_ptr<detail::VertexPool>> pools);

  /// Calls f(pool, slot, means, index of the mean, first entry of δ) for each vertex of an edge.
  template <class F>
  void for_each_vertex(std::uint32_t edge, F&& f) const;

  std::vector<const detail::VertexPool*> pools_;
  std::vector<Prior> priors_;
};

}  // namespace boxplus
