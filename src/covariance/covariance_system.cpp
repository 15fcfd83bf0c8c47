// SPDX-License-Identifier: BSD-3-Clause
#include "covariance/covariance_system.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "linearize/double_double_system.h"
#include "linearize/stiff_edge.h"
#include "plan/active_set.h"
#include "system/planned_system.h"

namespace boxplus {
namespace {

/// Whether another plan may be needed when only the estimates change, because it may treat the gauge
/// differently. It depends on the estimates which motions of other than relative poses are free.
bool depends_on_estimates(const Graph& graph, const Plan& plan) {
  if (!plan.freedoms.empty() || !plan.held_scalars.empty() || !plan.undetermined_blocks.empty()) return true;
  const auto is_rigid = [&](const EdgeList& list) { return graph.edge_pools()[list.pool]->is_rigid(); };
  return !plan.held.empty() && !std::all_of(plan.edges.begin(), plan.edges.end(), is_rigid);
}

}  // namespace

void CovarianceSystem::plan(const Graph& graph, const Options& options, const BatchSystem* planned) {
  options_ = &options;
  stop_ = StopToken(options.stop);
  if (!has_plan_for(graph, options, planned)) make_plan(graph, options, planned);
  linearizer_->set_stop(stop_);
}

bool CovarianceSystem::has_plan_for(const Graph& graph, const Options& options,
                                    const BatchSystem* planned) const {
  if (plan_ == nullptr || graph_ != &graph) return false;
  if (!own_plan_) return planned != nullptr && plan_ == &planned->plan();
  return revision_ == graph.revision() && planned_options_.level == options.level &&
         planned_options_.vertices == options.vertices && planned_options_.edges == options.edges &&
         planned_options_.gauge == options.gauge &&
         resolved_threads(planned_options_) == resolved_threads(options);
}

void CovarianceSystem::make_plan(const Graph& graph, const Options& options, const BatchSystem* planned) {
  const bool used_once = is_used_once_;
  const StopToken stop = stop_;
  forget();
  graph_ = &graph;
  options_ = &options;
  stop_ = stop;
  is_used_once_ = used_once;
  const bool suits = planned != nullptr && planned->plan().columns == ColumnStorage::kAll &&
                     !depends_on_estimates(graph, planned->plan());
  if (suits) {
    const auto order = planned->facts().elimination_order;
    order_.assign(order.begin(), order.end());
    plan_ = &planned->plan();
  } else {
    planned_options_ = options;
    planned_options_.callback = {};
    revision_ = graph.revision();
    const PlanRequest request{.level = options.level,
                              .vertices = options.vertices,
                              .edges = options.edges,
                              .gauge = options.gauge,
                              .threads = resolved_threads(options),
                              .stop = stop_};
    own_plan_ = std::make_unique<Plan>(boxplus::make_plan(graph, request, GaugeBounds::kIgnore));
    plan_ = own_plan_.get();
  }
  list_blocks();
  linearizer_ = std::make_unique<Linearizer>(graph, *plan_);
}

void CovarianceSystem::list_blocks() {
  for (const auto& pool : graph_->vertex_pools()) blocks_.emplace_back(pool->slots(), kNoBlock);
  for (std::uint32_t block = 0; block < plan_->structure.blocks(); ++block) {
    const VertexRef& vertex = plan_->block_vertex[block];
    blocks_[vertex.pool][vertex.slot] = block;
  }
}

std::uint32_t CovarianceSystem::block_of(VertexRef vertex) const {
  return blocks_[vertex.pool][vertex.slot];
}

int CovarianceSystem::held_directions(std::uint32_t block) const {
  if (stiffness_.empty()) return 0;
  const auto own = std::span(stiffness_).subspan(plan_->structure.offset[block], plan_->structure.dim(block));
  return static_cast<int>(std::count_if(own.begin(), own.end(), [](double s) { return s > 0; }));
}

void CovarianceSystem::factorize() {
  if (plan_->structure.blocks() == 0) return;
  stop_.check();
  const LinearizeOptions options{options_->numeric_jacobians, options_->triggs_correction};
  if (is_factorized_ && inputs_.equal(*graph_, *plan_, options)) return;
  linearizer_->linearize(options);
  stop_.check();
  if (is_factorized_ && has_same_values()) return;
  const bool was_factorized = std::exchange(is_factorized_, false);
  if (was_factorized && depends_on_estimates(*graph_, *plan_)) {
    make_plan(*graph_, *options_, nullptr);
    linearizer_->set_stop(stop_);
    return factorize();
  }
  factorize_values();
  if (failure_ && !own_plan_) {
    make_plan(*graph_, *options_, nullptr);
    linearizer_->set_stop(stop_);
    return factorize();
  }
  if (is_used_once_) return;
  const auto values = linearizer_->values();
  const bool has_inputs = inputs_.take(*graph_, *plan_, options);
  factorized_values_.assign(values.begin(), has_inputs ? values.begin() : values.end());
  is_factorized_ = true;
}

bool CovarianceSystem::has_same_values() const {
  const auto values = linearizer_->values();
  if (precise_) return false;  // H has more digits than these values
  return factorized_values_.size() == values.size() &&
         std::memcmp(values.data(), factorized_values_.data(), values.size_bytes()) == 0;
}

void CovarianceSystem::analyze() {
  if (is_analyzed_) return;
  solver_ = make_linear_solver(LinearSolverKind::kBlockCholesky);
  solver_->analyze(plan_->structure,
                   {.threads = resolved_threads(*options_),
                    .last = plan_->undetermined_blocks,
                    .order = order_,
                    .may_be_singular = true},
                   stop_);
  is_analyzed_ = true;
}

void CovarianceSystem::factorize_values() {
  analyze();
  held_.clear();
  failure_.reset();
  precise_.reset();
  const AssembledSystem system(plan_->structure, linearizer_->values());
  stiffness_.assign(plan_->scalars(), 0.0);
  for (const std::uint32_t scalar : plan_->held_scalars) {
    const auto& offset = plan_->structure.offset;
    const auto next = std::upper_bound(offset.begin(), offset.end(), scalar);
    hold(static_cast<std::uint32_t>(next - offset.begin() - 1), scalar);
  }
  const SolveControl control{.stop = stop_};
  FactorResult factor = solver_->factorize(system, {1.0, stiffness_.data()}, control);
  while (factor.status == LinearStatus::kNotPositiveDefinite && hold(factor))
    factor = solver_->factorize(system, {1.0, stiffness_.data()}, control);
  stop_.check();
  if (factor.status == LinearStatus::kOk) return;
  if (factor.status == LinearStatus::kNotPositiveDefinite && compute_precise_factor(1)) return;
  const VertexRef vertex = plan_->block_vertex[factor.failed_block];
  if (factor.status == LinearStatus::kNotFinite) {
    failure_ = {Covariance::Status::kNotFinite, vertex,
                "an error, a Jacobian or a weight is NaN or infinite"};
  } else {
    failure_ = {Covariance::Status::kSingular, vertex, "the edges leave it free to move in some direction"};
  }
}

double CovarianceSystem::diagonal(std::uint32_t block, std::uint32_t direction) const {
  const std::uint32_t first = plan_->structure.value_start[plan_->structure.column_start[block]];
  return linearizer_->values()[first + direction * (plan_->structure.dim(block) + 1)];
}

bool CovarianceSystem::compute_precise_factor(std::size_t solves) {
  if (!information_is_stiff(*graph_, *plan_)) return false;
  factorize_precisely(solves);
  return true;
}

void CovarianceSystem::factorize_precisely(std::size_t solves) {
  constexpr double kMostMultiplications = 2e9;  // half a minute
  auto factor = std::make_unique<DoubleDoubleCholesky>();
  factor->analyze(plan_->structure, plan_->undetermined_blocks, stop_);
  const double work =
      factor->multiplications() + static_cast<double>(solves) * factor->multiplications_to_solve();
  if (work > kMostMultiplications) {
    failure_ = {Covariance::Status::kSingular, plan_->block_vertex[0], {}, true};
    return;
  }
  DoubleDoubleSystem system;
  linearize_in_double_double(*graph_, *plan_, {options_->numeric_jacobians, options_->triggs_correction},
                             stop_, system);
  const FactorResult result = factor->factorize(system.values, {1.0, stiffness_.data()}, stop_);
  stop_.check();
  if (result.status == LinearStatus::kOk) {
    precise_ = std::move(factor);
  } else {
    failure_ = {Covariance::Status::kSingular, plan_->block_vertex[result.failed_block],
                "the edges leave it free to move in some direction"};
  }
}

/// If the block of a vanished pivot is one of Plan::undetermined_blocks, holds the direction of the pivot,
/// because it is gauge freedom. Otherwise, returns false.
bool CovarianceSystem::hold(const FactorResult& factor) {
  const auto& loose = plan_->undetermined_blocks;
  const bool is_loose = std::find(loose.begin(), loose.end(), factor.failed_block) != loose.end();
  if (options_->gauge != GaugePolicy::kFixFirst || !is_loose || is_held(factor.failed_scalar)) return false;
  hold(factor.failed_block, factor.failed_scalar);
  return true;
}

void CovarianceSystem::hold(std::uint32_t block, std::uint32_t scalar) {
  // To hold a direction, adds this multiple of the diagonal entry of H to the entry. The variance of the
  // direction is then smaller than any rounding error.
  constexpr double kStiff = 1e30;
  const std::uint32_t dim = plan_->structure.dim(block), i = scalar - plan_->structure.offset[block];
  const double* diagonal =
      linearizer_->values().data() + plan_->structure.value_start[plan_->structure.column_start[block]];
  stiffness_[scalar] = kStiff * std::max(diagonal[i * (dim + 1)], 1e-300);
  if (held_directions(block) == static_cast<int>(dim)) held_.push_back(plan_->block_vertex[block]);
}

}  // namespace boxplus
