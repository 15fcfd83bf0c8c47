// SPDX-License-Identifier: BSD-3-Clause
// Which motions of the world change an error.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "boxplus/graph/edge_pool.h"
#include "gauge/similarity_freedom.h"
#include "gauge/subspace.h"

namespace boxplus {

/// Measures how much the errors resist each motion (see SimilarityTest). Sums the squared changes of the
/// errors over all rows of the edges' Jacobians. If the terms of a row cancel to within `tolerance`, the row
/// resists no motion.
class Resistance {
 public:
  static constexpr int kMost = WorldMotions::kMost + static_cast<int>(SimilarityTest::kMostOwn);

  explicit Resistance(int motions) : motions_(motions) {}

  /// Adds an edge. `tangents` has one row for each column of the Jacobian.
  void add(const detail::EdgeTile& edge, const double* tangents, double tolerance) {
    for (int row = 0; row < edge.rows; ++row) {
      std::array<double, kMost> change{};
      double magnitude = 0;
      for (int c = 0; c < edge.cols; ++c) {
        const double slope = edge.jacobian[c * edge.rows + row];
        const double* tangent = tangents + c * motions_;
        double squares = 0;
        for (int m = 0; m < motions_; ++m) {
          change[static_cast<std::size_t>(m)] += slope * tangent[m];
          squares += tangent[m] * tangent[m];
        }
        magnitude += std::abs(slope) * std::sqrt(squares);
      }
      add_row(change, magnitude, tolerance);
    }
  }
  /// Adds a vertex with fixed directions, which resists motions in these directions.
  void add_fixed(std::span<const int> directions, const double* tangents, double least) {
    for (const int direction : directions) {
      std::array<double, kMost> change{};
      std::copy_n(tangents + direction * motions_, motions_, change.begin());
      const Eigen::Map<const Eigen::VectorXd> motion(change.data(), motions_);
      if (motion.norm() > least) add_row(change, motion.norm(), 0);
    }
  }
  /// The linear combinations of the candidates that nothing resists. The last `own` motions have units of
  /// their own, so their resistance is 1 by definition.
  Eigen::MatrixXd unresisted(Eigen::MatrixXd candidates, Eigen::Index own) const {
    constexpr double kNothing = 1e-12;
    for (Eigen::Index i = motions_ - own; i < motions_; ++i) {
      if (sum_(i, i) > 0) candidates.row(i) /= std::sqrt(sum_(i, i));
    }
    const Eigen::MatrixXd among =
        candidates.transpose() * sum_.topLeftCorner(motions_, motions_) * candidates;
    return candidates * eigenvectors_of(among, [](double resistance) { return resistance <= kNothing; });
  }

 private:
  void add_row(const std::array<double, kMost>& change, double magnitude, double tolerance) {
    double squares = 0;
    for (const double value : change) squares += value * value;
    if (!std::isfinite(squares) || std::sqrt(squares) <= tolerance * magnitude) return;
    for (int i = 0; i < motions_; ++i) {
      for (int j = 0; j < motions_; ++j) {
        sum_(i, j) += change[static_cast<std::size_t>(i)] * change[static_cast<std::size_t>(j)] /
                      (magnitude * magnitude);
      }
    }
  }

  int motions_;
  Eigen::Matrix<double, kMost, kMost> sum_ = Eigen::Matrix<double, kMost, kMost>::Zero();
};

}  // namespace boxplus
