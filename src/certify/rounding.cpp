// SPDX-License-Identifier: BSD-3-Clause
#include "certify/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace boxplus::certificate {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

double length(const StackedPose& pose) {
  return pose.row(pose.rows() - 1).norm();
}

/// Of the measured translation.
double length(const ChordalEdge& edge) {
  const Eigen::Index d = edge.motion.rows() - 1;
  return edge.motion.row(d).head(d).norm();
}

}  // namespace

double rounding_of_cost(const ChordalProblem& problem, const StackedPoses& poses) {
  const int d = problem.dimension;
  double squared = 0, sum = 0;  // of the terms of first order, and of those of second order
  for (const ChordalEdge& edge : problem.edges) {
    const StackedPose D = difference(edge, poses);
    const double tau = edge.weight(d, d);
    const double of_translation =
        tau * std::pow(kEpsilon * (2 * problem.offset[edge.to] + length(poses[edge.from]) +
                                   length(poses[edge.to]) + length(edge)),
                       2);
    const double of_rotation = std::abs(edge.weight.topLeftCorner(d, d).trace()) * 4 * kEpsilon * kEpsilon;
    const double rotation =
        std::abs(D.topRows(d).cwiseProduct(edge.weight.topLeftCorner(d, d).lazyProduct(D.topRows(d))).sum());
    squared += tau * D.row(d).squaredNorm() * of_translation + rotation * of_rotation;
    sum += of_translation + of_rotation;
  }
  return 2 * std::sqrt(squared) + sum;
}

bool fits_exactly(const ChordalProblem& problem, const StackedPoses& poses) {
  constexpr double kRotation = 1e-13, kTranslation = 32 * kEpsilon;
  constexpr double kLeastStep = 1e-6;  // of the digits that positions must have for the shortest measurement
  const int d = problem.dimension;
  double farthest = 0, shortest = std::numeric_limits<double>::infinity();
  for (const StackedPose& pose : poses) farthest = std::max(farthest, length(pose));
  for (const ChordalEdge& edge : problem.edges) {
    const double step = length(edge);
    if (step > 0) shortest = std::min(shortest, step);
  }
  if (!(kEpsilon * farthest <= kLeastStep * shortest)) return false;
  return std::all_of(problem.edges.begin(), problem.edges.end(), [&](const ChordalEdge& edge) {
    const StackedPose D = difference(edge, poses);
    const double scale = length(poses[edge.from]) + length(poses[edge.to]) + length(edge);
    return D.topRows(d).norm() <= kRotation && D.row(d).norm() <= kTranslation * scale;
  });
}

}  // namespace boxplus::certificate
