// SPDX-License-Identifier: BSD-3-Clause
// H without damping, and its factor, from which covariances are read.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "boxplus/covariance/covariance.h"
#include "covariance/linearization_inputs.h"
#include "linear/double_double_cholesky.h"
#include "linearize/linearizer.h"
#include "system/batch_system.h"

namespace boxplus {

/// Keeps its plan as long as the structure of the graph and the options do not change, and its factor as long
/// as H does not change. A factor is never out of date: either everything that H is a function of is the same
/// (LinearizationInputs), or H is computed again and compared bit by bit.
class CovarianceSystem {
 public:
  static constexpr std::uint32_t kNoBlock = 0xFFFFFFFFu;

  /// Why there is no covariance.
  struct Failure {
    Covariance::Status status;
    VertexRef vertex;
    std::string_view why;
    bool is_weight_span = false;  ///< then not the vertex, but weight_span.h says why
  };

  /// Brings the plan up to date. `planned` has an up-to-date plan of the same graph and options, whose plan
  /// and elimination order can be used, or is null. The graph and `planned` must exist, and the plan of
  /// `planned` must not change, until forget(). Throws Stopped.
  void plan(const Graph& graph, const Options& options, const BatchSystem* planned);
  /// Brings H and its factor up to date. Call it after plan(), with the same graph and options. If the plan
  /// does not fit the current estimates, makes another plan. Throws Stopped.
  void factorize();
  /// After the next call of plan() or factorize(), nothing of the current state is used.
  void forget() { *this = CovarianceSystem(); }
  /// Does not prepare for a further call of factorize(), which saves memory.
  void use_once() { is_used_once_ = true; }

  const Plan& plan() const { return *plan_; }
  /// The block of a vertex in H. Vertices that do not move have kNoBlock.
  std::uint32_t block_of(VertexRef vertex) const;

  // Valid after factorize():

  const std::optional<Failure>& failure() const { return failure_; }
  /// The vertices of which all directions are held, without Plan::held.
  const std::vector<VertexRef>& held() const { return held_; }
  bool is_held(std::uint32_t scalar) const { return stiffness_[scalar] > 0; }
  int held_directions(std::uint32_t block) const;
  LinearSolver& solver() { return *solver_; }
  /// The diagonal entry of H without what holds a direction.
  double diagonal(std::uint32_t block, std::uint32_t direction) const;
  /// The factor of H with 32 digits, which replaces solver() if the weights span too many digits for double.
  /// Otherwise null.
  const DoubleDoubleCholesky* precise_factor() const { return precise_.get(); }
  /// Computes precise_factor(), for `solves` calls of its solve(), if the Ω of the graph span many digits.
  /// Returns false if they do not. If the factor does not exist or takes too long, there is a failure. Throws
  /// Stopped.
  bool compute_precise_factor(std::size_t solves);

 private:
  bool has_plan_for(const Graph& graph, const Options& options, const BatchSystem* planned) const;
  void make_plan(const Graph& graph, const Options& options, const BatchSystem* planned);
  void list_blocks();
  bool has_same_values() const;
  void analyze();
  void factorize_values();
  void factorize_precisely(std::size_t solves);
  bool hold(const FactorResult& factor);
  void hold(std::uint32_t block, std::uint32_t scalar);

  const Graph* graph_ = nullptr;
  const Options* options_ = nullptr;  // valid from plan() until the end of factorize()
  StopToken stop_;
  bool is_used_once_ = false;

  const Plan* plan_ = nullptr;  // own_plan_ or the plan of another system
  std::unique_ptr<Plan> own_plan_;
  Options planned_options_;                         // for which own_plan_ was made
  std::uint64_t revision_ = 0;                      // of the graph when own_plan_ was made
  std::vector<std::uint32_t> order_;                // an elimination order to use, or empty
  std::vector<std::vector<std::uint32_t>> blocks_;  // the block of each slot of each vertex pool

  std::unique_ptr<Linearizer> linearizer_;
  std::shared_ptr<LinearSolver> solver_;
  std::unique_ptr<DoubleDoubleCholesky> precise_;
  bool is_analyzed_ = false, is_factorized_ = false;
  // The members below belong to an H of these inputs or, if they are of other types, with these values.
  LinearizationInputs inputs_;
  std::vector<double> factorized_values_;
  std::vector<double> stiffness_;  // added to the diagonal of H, to hold directions
  std::vector<VertexRef> held_;
  std::optional<Failure> failure_;
};

}  // namespace boxplus
