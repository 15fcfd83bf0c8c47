// SPDX-License-Identifier: BSD-3-Clause
// Constraints of ready-made edges.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "edge_kinds.h"

namespace boxplus::python {

/// The constraints of one kind. Their errors and Jacobians are those of edges in a pool that is not in the
/// graph, so that constraints need no templates of their own.
class ConstraintPool final : public detail::EdgePool {
 public:
  /// `edges`: an empty pool of this kind.
  ConstraintPool(const EdgeKind& kind, std::vector<std::uint32_t> vertex_pools,
                 std::unique_ptr<detail::EdgePool> edges);

  /// Adds an edge with add(pool of the edges), which returns its slot there.
  std::uint32_t add(const Information& information, std::span<const std::uint32_t> slots,
                    detail::FunctionRef<std::uint32_t(detail::EdgePool&)> add_edge);

  const EdgeKind& kind() const { return *kind_; }
  py::object measurement(std::uint32_t edge) const { return kind_->measurement(*edges_, inner_[edge]); }
  void set_measurement(std::uint32_t edge, py::handle measurement) {
    kind_->set_measurement_in_pool(*edges_, inner_[edge], measurement);
  }

  std::unique_ptr<EdgePool> clone(
      std::span<const std::unique_ptr<detail::VertexPool>> vertex_pools) const override;
  std::string_view type_name() const override { return "Constraint"; }
  detail::EdgeShape shape(std::uint32_t edge) const override { return edges_->shape(inner_[edge]); }
  bool uniform_shape() const override { return true; }
  void errors(std::span<const std::uint32_t> edges, double* out) const override;
  void linearize(std::span<const std::uint32_t> edges, detail::EdgeTile& tile,
                 bool force_numeric) const override;
  detail::JacobianSource jacobian_source() const override { return edges_->jacobian_source(); }
  bool is_rigid() const override { return edges_->is_rigid(); }
  std::vector<double>* shift(std::uint32_t edge) override { return &shifts_[edge]; }
  void reserve(std::size_t edges) override;

 private:
  ConstraintPool(const ConstraintPool& other, std::unique_ptr<EdgePool> edges);

  const EdgeKind* kind_;
  std::unique_ptr<EdgePool> edges_;
  std::vector<std::uint32_t> inner_;         // by slot: the slot in edges_
  std::vector<std::vector<double>> shifts_;  // by slot
};

/// Adds a constraint of a kind to its pool in the graph, which is created if there is none. add(place) adds
/// the edge without the constraint.
EdgeRef add_constraint(Graph& graph, const EdgeKind& kind, std::span<const VertexRef> vertices,
                       const Information& information, detail::FunctionRef<EdgeRef(const EdgePlace&)> add);

/// The pool of an edge if it is a constraint of a ready-made edge, and otherwise nullptr.
const ConstraintPool* constraint_pool_of(const Graph& graph, EdgeRef edge);

/// Adds the shifts of constraints to their errors, one edge after the other.
void add_shifts(std::span<const std::vector<double>> shifts, std::span<const std::uint32_t> edges, int rows,
                double* errors);

}  // namespace boxplus::python
