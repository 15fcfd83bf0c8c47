// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "boxplus/algorithm/algorithm.h"

namespace boxplus {

/// Levenberg-Marquardt with Nielsen's damping update (Nielsen, "Damping parameter in Marquardt's method",
/// 1999), which lowers the damping faster as long as this leads to no rejected steps.
class LevenbergMarquardt final : public Algorithm {
 public:
  std::string_view name() const override { return "Levenberg-Marquardt"; }
  void reset(const Options& options, std::size_t scalars) override;
  IterationOutcome iterate(System& system, double chi2, IterationRecord& record) override;

 private:
  double default_damping(const System& system) const;
  void start_damping(const System& system);
  void raise_damping();
  double damping_factor(double gain, bool at_once);
  double damping_of_step(const System& system, double lambda) const;
  LinearStatus find_step(System& system, double lambda, IterationRecord& record);
  LinearStatus find_first_step(System& system, double chi2, IterationRecord& record);
  bool take_step(System& system, double chi2, IterationRecord& record);

  Options::DampingScale scale_ = Options::DampingScale::kDiagonal;
  double user_lambda_ = 0;
  double lambda_ = 0, growth_ = 2;
  bool started_ = false;
  bool was_eager_ = false;       // whether the last step made the damping lower than by Nielsen's rule
  int patience_ = 1, wait_ = 0;  // the length of the last wait, and how many steps of it are left
  std::vector<double> step_;
  double predicted_ = 0;    // the predicted decrease of chi2 by step_
  bool cut_short_ = false;  // whether damping has shortened step_
};

}  // namespace boxplus
