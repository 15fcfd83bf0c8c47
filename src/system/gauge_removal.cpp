// SPDX-License-Identifier: BSD-3-Clause
#include "system/gauge_removal.h"

#include <Eigen/QR>
#include <algorithm>
#include <iterator>
#include <vector>

namespace boxplus {
namespace {

/// GaugePolicy::kDamp, and bounds, increase each diagonal entry by this fraction of itself. This is enough to
/// lift pivots that are only rounding errors, but too little to change a step noticeably.
constexpr double kGaugeDamping = 1e-10;

}  // namespace

double GaugeRemoval::fraction() const {
  const bool is_free = !plan_->freedoms.empty() || !plan_->undetermined_blocks.empty();
  const bool damps = policy_ == GaugePolicy::kDamp || (policy_ == GaugePolicy::kFixFirst && has_bounds_);
  return is_free && damps ? kGaugeDamping : current_.damping;
}

bool GaugeRemoval::has_other_types() const {
  detail::Frame frame;
  return std::any_of(plan_->vertices.begin(), plan_->vertices.end(), [&](const VertexList& list) {
    return !list.slots.empty() && !graph_->vertex_pools()[list.pool]->get_frame(list.slots[0], frame);
  });
}

StepResult GaugeRemoval::solve(const Solver& solver) {
  StepResult result = solver.once();
  if (result.status == LinearStatus::kOk && !solver.held_are_free()) {
    current_.lost_scalars.clear();
    current_.holds = false;
    result = solver.once();
  }
  return result.status == LinearStatus::kNotPositiveDefinite ? hold_or_damp(result, solver) : result;
}

/// Finds those of the plan's held_scalars that belong to vertices with a frame, and allocates memory for as
/// many motions.
void GaugeRemoval::prepare_to_shorten() {
  const std::vector<std::uint32_t>& offset = plan_->structure.offset;
  std::ranges::copy_if(plan_->held_scalars, std::back_inserter(turning_), [&](std::uint32_t i) {
    const auto block = std::ranges::upper_bound(offset, i) - offset.begin() - 1;
    const VertexRef vertex = plan_->block_vertex[block];
    detail::Frame frame;
    return graph_->vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame);
  });
  if (turning_.size() > kMostMotions || plan_->eliminated_blocks > 0) turning_.clear();
  if (turning_.empty()) return;
  const auto n = static_cast<Eigen::Index>(plan_->scalars());
  motions_.setZero(n, static_cast<Eigen::Index>(turning_.size()));
  weights_.setZero(n);
  unit_.setZero(n);
}

/// With H t = 0, the solution of (H + c e eᵀ) x = c e is x = t / (eᵀt).
void GaugeRemoval::shorten(std::span<const double> diagonal, double lambda,
                           detail::FunctionRef<bool(const double* b, double* x)> apply_inverse,
                           std::span<double> step) {
  if (turning_.empty() || !current_.holds_scalars_of(*plan_, lambda)) return;
  for (std::size_t k = 0; k < turning_.size(); ++k) {
    unit_[turning_[k]] = diagonal[turning_[k]];
    const bool is_solved = apply_inverse(unit_.data(), motions_.col(static_cast<Eigen::Index>(k)).data());
    unit_[turning_[k]] = 0;
    if (!is_solved) return;
  }
  for (std::uint32_t block = 0; block < plan_->structure.blocks(); ++block) {
    const std::uint32_t first = plan_->structure.offset[block], dim = plan_->structure.dim(block);
    weights_.segment(first, dim)
        .setConstant(Eigen::Map<const Eigen::VectorXd>(diagonal.data() + first, dim).mean());
  }
  Eigen::Map<Eigen::VectorXd> x(step.data(), motions_.rows());
  const Eigen::Index count = motions_.cols();
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostMotions, kMostMotions> squares(count, count);
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostMotions, 1> along(count);
  for (Eigen::Index a = 0; a < count; ++a) {
    const auto weighted = motions_.col(a).cwiseProduct(weights_);
    along[a] = weighted.dot(x);
    for (Eigen::Index b = 0; b < count; ++b) squares(a, b) = weighted.dot(motions_.col(b));
  }
  along = squares.completeOrthogonalDecomposition().solve(along).eval();
  if (!along.allFinite()) return;
  for (Eigen::Index a = 0; a < count; ++a) x -= along[a] * motions_.col(a);
}

/// Holds directions whose pivots vanish. If that does not help, damps.
StepResult GaugeRemoval::hold_or_damp(StepResult result, const Solver& solver) {
  std::vector<std::uint32_t>& lost = current_.lost_scalars;
  const std::size_t before = lost.size();
  const auto hold_lost_pivot = [&] {
    const auto [block, scalar] = solver.lost_pivot();
    return current_.hold_lost_pivot(*plan_, block, scalar);
  };
  while (result.status == LinearStatus::kNotPositiveDefinite && policy_ == GaugePolicy::kFixFirst &&
         hold_lost_pivot())
    result = solver.once();
  // Without a pivot of a loose block, hold_lost_pivot() can only guess. An edge may measure what it held.
  const bool holds_too_much = result.status == LinearStatus::kOk && !solver.held_are_free();
  if (result.status != LinearStatus::kNotPositiveDefinite && !holds_too_much) return result;
  lost.resize(before);
  const bool holds_too_little = policy_ == GaugePolicy::kFixFirst && !plan_->freedoms.empty();
  const bool damps_too_little = policy_ == GaugePolicy::kDamp && has_other_types();
  if (holds_too_much && current_.damping != 0) return {.status = LinearStatus::kNotPositiveDefinite};
  if ((!holds_too_much && !holds_too_little && !damps_too_little) || current_.damping != 0) return result;
  current_.damping = kGaugeDamping;
  return solver.once();
}

}  // namespace boxplus
