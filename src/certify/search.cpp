// SPDX-License-Identifier: BSD-3-Clause
#include "certify/search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "certify/rounding.h"

namespace boxplus::certificate {
namespace {

constexpr int kMostSteps = 200;
constexpr double kNewtonTolerance = 1e-3;  // relative to the tolerance of the gap
constexpr int kMostExtraColumns = 3;

/// The same poses in a space of one more dimension.
void add_column(StackedPoses& poses) {
  for (StackedPose& pose : poses) {
    const Eigen::Index columns = pose.cols();
    pose.conservativeResize(Eigen::NoChange, columns + 1);
    pose.col(columns).setZero();
  }
}

/// The poses after a motion along `direction`, with d + 1 values per block, in the last column.
StackedPoses moved(const ChordalProblem& problem, const StackedPoses& poses,
                   const std::vector<double>& direction, double length) {
  StackedPoses result = poses;
  const Eigen::Index size = problem.dimension + 1;
  const double* values = direction.data();
  for (const std::uint32_t node : problem.moving) {
    result[node].rightCols(1) += length * Eigen::Map<const Eigen::VectorXd>(values, size);
    orthonormalize(result[node]);
    values += size;
  }
  return result;
}

}  // namespace

Search::Search(const ChordalProblem& problem, StackedPoses start, double tolerance,
               const Resources& resources)
    : problem_(problem),
      tolerance_(tolerance),
      resources_(resources),
      poses_(std::move(start)),
      cost_(problem.cost(poses_)),
      dual_(problem, resources) {}

bool Search::is_global() const {
  return bound_ && cost_ - *bound_ <= tolerance_ * cost_;
}

double Search::rounding() const {
  return rounding_of_cost(problem_, poses_);
}

/// Moves poses of rank d to a minimum, and keeps them if they are the best. Returns whether they are.
bool Search::settle(StackedPoses& poses) {
  RiemannianNewton newton(problem_, dual_, problem_.dimension, resources_);
  steps_ += newton.minimize(poses, kNewtonTolerance * tolerance_, kMostSteps);
  const double cost = problem_.cost(poses);
  if (cost > cost_) return false;
  poses_ = poses;
  cost_ = cost;
  return true;
}

/// Computes the lower bound at poses of any rank, for which `dual_` is up to date.
bool Search::has_bound(const StackedPoses& poses) {
  const double cost = problem_.cost(poses);
  const auto gap = dual_.gap(0.5 * tolerance_ * cost_);
  if (!gap) return false;
  bound_ = std::max({bound_.value_or(0), cost - *gap - rounding_of_cost(problem_, poses), 0.0});
  return true;
}

/// Moves poses along a direction of negative curvature, in a space of one more dimension. Returns false if
/// no step lowers F.
bool Search::leave(StackedPoses& poses) {
  constexpr double kLongest = 4;
  constexpr int kHalvings = 22;
  const auto direction = dual_.negative_direction();
  if (!direction) return false;
  add_column(poses);
  double lowest = problem_.cost(poses);
  std::optional<StackedPoses> best;
  for (int k = 0; k <= kHalvings; ++k) {
    StackedPoses trial = moved(problem_, poses, *direction, std::ldexp(kLongest, -k));
    const double cost = problem_.cost(trial);
    if (cost < lowest) {
      lowest = cost;
      best = std::move(trial);
    } else if (best) {
      break;  // shorter steps lower F less
    }
  }
  if (best) poses = std::move(*best);
  return best.has_value();
}

/// Climbs the Riemannian staircase until a minimum of higher rank is global, and projects it. Returns
/// whether this has led to better poses.
bool Search::climb() {
  StackedPoses poses = poses_;
  const int d = problem_.dimension;
  for (int rank = d + 1; rank <= d + kMostExtraColumns; ++rank) {
    if (!leave(poses)) break;
    RiemannianNewton newton(problem_, dual_, rank, resources_);
    steps_ += newton.minimize(poses, kNewtonTolerance * tolerance_, kMostSteps);
    if (has_bound(poses)) break;
  }
  poses = round_poses(poses, problem_);
  const double before = cost_;
  return settle(poses) && cost_ < before * (1 - tolerance_);
}

void Search::run(int max_escapes, const std::function<StackedPoses()>& other_start) {
  StackedPoses poses = poses_;
  settle(poses);
  has_bound(poses_);
  const auto is_over = [&] { return is_global() || cost_ <= rounding(); };
  if (!is_over() && other_start && max_escapes > 0) {
    ++escapes_;
    poses = other_start();
    if (settle(poses)) has_bound(poses_);
  }
  while (!is_over() && escapes_ < max_escapes) {
    ++escapes_;
    dual_.update(poses_);
    if (!climb()) break;
    has_bound(poses_);
  }
}

}  // namespace boxplus::certificate
