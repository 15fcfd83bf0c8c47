// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "boxplus/algorithm/algorithm.h"

namespace boxplus {

/// Powell's dogleg ("A hybrid method for nonlinear equations", 1970) in the norm ‖δ‖² = δᵀDδ with D = diag H,
/// so that meters and radians are comparable. A rejected step costs no factorization. The trust region is
/// unbounded at first, so the method takes full Gauss-Newton steps as long as they decrease chi2.
class Dogleg final : public Algorithm {
 public:
  std::string_view name() const override { return "dogleg"; }
  void reset(const Options& options, std::size_t scalars) override;
  IterationOutcome iterate(System& system, double chi2, IterationRecord& record) override;
  int regularized_steps() const override { return regularized_steps_; }

 private:
  void lower_regularization();
  LinearStatus solve_gauss_newton(System& system, IterationRecord& record);
  double curvature_of_newton(System& system) const;
  void find_cauchy_step(System& system);
  double find_step(System& system);
  double find_first_step(System& system, double chi2);
  void scale_from(const System& system);
  double norm(const System& system, const std::vector<double>& step) const;
  void blend(const System& system);
  void update_radius(double gain, double step_norm);

  static constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  double radius_ = kUnbounded;
  double regularization_ = 0;  // λ of the last solve, relative to the diagonal of H
  int regularized_steps_ = 0;
  bool newton_is_exact_ = false;
  double newton_norm_ = 0, newton_curvature_ = 0, cauchy_norm_ = 0;
  bool have_cauchy_ = false;
  std::vector<double> scale_, newton_, cauchy_, step_;
};

}  // namespace boxplus
