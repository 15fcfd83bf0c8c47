// SPDX-License-Identifier: BSD-3-Clause
// Numeric differentiation with an automatic step: Ridders, "Accurate computation of F′(x) and F′(x)F″(x)",
// Advances in Engineering Software 4(2), 1982.
//
// Central differences with shrinking steps are extrapolated to step zero by Neville's scheme. The result for
// each component is the entry of its tableau that agrees best with its neighbors. For smooth functions the
// relative error is about 1e-11. For a single central difference it is 1e-6 to 1e-10, even with a good step.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace boxplus::detail {

struct NumericOptions {
  double initial_step = 0.1;  ///< first (largest) step, in the units of the argument
  double shrink = 2;          ///< ratio of consecutive steps, > 1
  int max_rows = 14;          ///< maximum number of steps; each takes two evaluations
  double tolerance = 1e-13;   ///< stops when the estimated error, relative to the derivative, is below this
};

/// Differentiates vector-valued functions of one real variable at 0. Keeps its memory between calls.
class NumericDerivative {
 public:
  explicit NumericDerivative(const NumericOptions& options = {}) : options_(options) {}

  /// Fills derivative[0 … size) with df/dh at h = 0, for f(double h, double* values). Returns the largest
  /// estimated error of any component. The estimated error is infinite if f was not finite anywhere near 0.
  template <class F>
  double operator()(const F& f, int size, double* derivative) {
    start(size);
    double step = options_.initial_step;
    for (int row = 0; row < options_.max_rows; ++row, step /= options_.shrink) {
      f(step, plus_.data());
      f(-step, minus_.data());
      for (int i = 0; i < size; ++i) extrapolate(i, row, step);
      if (row > 0 && converged(step)) break;
    }
    std::copy(best_.begin(), best_.end(), derivative);
    return size == 0 ? 0 : *std::max_element(error_.begin(), error_.end());
  }

 private:
  void start(int size) {
    plus_.resize(size);
    minus_.resize(size);
    best_.assign(size, std::numeric_limits<double>::quiet_NaN());
    error_.assign(size, std::numeric_limits<double>::infinity());
    row_.assign(static_cast<std::size_t>(size) * options_.max_rows, 0.0);
  }

  /// Appends one row to the tableau of component i. Before the call, tableau[k] is the entry of order k of
  /// the previous row. After the call, it is the entry of order k of the new row.
  void extrapolate(int i, int row, double step) {
    double* tableau = row_.data() + static_cast<std::size_t>(i) * options_.max_rows;
    double entry = (plus_[i] - minus_[i]) / (2 * step);
    double factor = 1;
    for (int order = 0; order < row; ++order) {
      factor *= options_.shrink * options_.shrink;
      const double above = tableau[order];
      const double higher = entry + (entry - above) / (factor - 1);
      const double error = std::max(std::abs(higher - entry), std::abs(higher - above));
      if (error <= error_[i]) {
        error_[i] = error;
        best_[i] = higher;
      }
      tableau[order] = entry;
      entry = higher;
    }
    tableau[row] = entry;
    if (row == 0) best_[i] = entry;
  }

  /// Whether the error of every component is within the tolerance, or below the rounding error of a central
  /// difference with this step.
  bool converged(double step) const {
    double slope = 0, value = 0, error = 0;
    for (std::size_t i = 0; i < best_.size(); ++i) {
      slope = std::max(slope, std::abs(best_[i]));
      value = std::max(value, std::abs(plus_[i]));
      error = std::max(error, error_[i]);
    }
    return error <=
           std::max(options_.tolerance * slope, std::numeric_limits<double>::epsilon() * value / step);
  }

  NumericOptions options_;
  std::vector<double> plus_, minus_, best_, error_, row_;
};

}  // namespace boxplus::detail
