// SPDX-License-Identifier: BSD-3-Clause
// The edges of an error function of Python, which is called once per linearization for all of them.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <span>
#include <vector>

#include "boxplus/graph/edge_pool.h"
#include "edge_function.h"

namespace boxplus::python {

/// The pool keeps the results of the last call, together with the estimates to which they belong. If a caller
/// asks for an edge whose vertices still have these estimates, it gets the result that is there. Otherwise
/// the function is called for all edges of the pool. So a function is called once per linearization and once
/// per tried step, whatever the number of edges and threads.
///
/// Several threads may use a pool, with or without Python's lock (GIL). A thread that waits for another one
/// to call the function does not hold the lock.
class BatchedPool final : public detail::EdgePool {
 public:
  /// `edge`: the object of Python. `vertex_pools`: the pools, and their indices, of the arguments. `rows`: of
  /// the error. `width`: the numbers of a measurement; 0 if the function gets none. `is_constraint`: the
  /// edges are constraints.
  BatchedPool(py::object edge, std::shared_ptr<EdgeFunction> function, std::vector<std::uint32_t> indices,
              std::vector<const detail::VertexPool*> pools, int rows, int width, bool is_constraint);

  ~BatchedPool() override;

  /// Adds an edge with a measurement of `width` numbers. Returns its slot. If the function throws, nothing
  /// has changed.
  std::uint32_t add(const double* measurement, const Information& information,
                    std::span<const std::uint32_t> slots);

  /// Forgets all results. Call it before a run, because the function may give other results than before.
  void forget() const;
  /// Between begin_fresh() and end_fresh(), the function is called for the requested edges only, and its
  /// results are not kept. For callers that ask for single edges.
  void begin_fresh() const { ++fresh_; }
  void end_fresh() const { --fresh_; }

  py::object& edge() { return edge_; }
  const py::object& edge() const { return edge_; }
  const EdgeFunction& function() const { return *function_; }
  int width() const { return width_; }
  bool is_constraint() const { return is_constraint_; }
  std::uint32_t pool_of_argument(int i) const { return argument_pool(i); }

  std::unique_ptr<EdgePool> clone(
      std::span<const std::unique_ptr<detail::VertexPool>> vertex_pools) const override;
  std::string_view type_name() const override {
    return is_constraint_ ? std::string_view("Constraint") : std::string_view(function_->name());
  }
  detail::EdgeShape shape(std::uint32_t edge) const override;
  bool uniform_shape() const override { return true; }
  void errors(std::span<const std::uint32_t> edges, double* out) const override;
  void linearize(std::span<const std::uint32_t> edges, detail::EdgeTile& tile,
                 bool force_numeric) const override;
  detail::JacobianSource jacobian_source() const override { return function_->source(); }
  std::vector<double>* shift(std::uint32_t edge) override {
    return is_constraint_ ? &shifts_[edge] : nullptr;
  }
  void reserve(std::size_t edges) override;

 private:
  using Want = EdgeFunction::Want;

  /// Results, and the estimates to which they belong, indexed by slot.
  struct Cache {
    std::vector<std::vector<double>> estimates;  // per argument: the rows of all slots
    std::vector<double> errors, jacobians;       // no Jacobians if they were not asked for
  };

  BatchedPool(const BatchedPool& other, std::vector<const detail::VertexPool*> pools);
  int cols() const;
  std::size_t block() const { return static_cast<std::size_t>(rows_) * static_cast<std::size_t>(cols()); }
  bool has(const Cache& cache, std::span<const std::uint32_t> edges, Want want) const;
  /// Calls use(cache, index) with results: those of edges[k] are at index(k).
  template <class Use>
  void with_results(std::span<const std::uint32_t> edges, Want want, const Use& use) const;
  void refresh(std::span<const std::uint32_t> edges, Want want) const;
  Cache evaluate(std::span<const std::uint32_t> edges, Want want) const;

  py::object edge_;                         // copied and destroyed with Python's lock (GIL)
  std::shared_ptr<EdgeFunction> function_;  // shared by the copies of a pool
  std::vector<const detail::VertexPool*> pools_;
  int rows_, width_;
  bool is_constraint_;
  std::vector<double> measurements_;         // width_ per slot
  std::vector<std::vector<double>> shifts_;  // by slot; empty unless the edges are constraints

  mutable std::shared_mutex mutex_;  // of the caches
  mutable std::mutex calling_;       // held by the thread that calls the function
  mutable Cache cache_, numeric_;    // numeric_: for force_numeric
  mutable std::atomic<int> fresh_ = 0;
};

}  // namespace boxplus::python
