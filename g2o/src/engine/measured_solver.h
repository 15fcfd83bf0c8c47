// SPDX-License-Identifier: BSD-3-Clause
// A wrapper for a linear solver of the engine. It converts the tolerance of the g2o API, and adds the times
// of the solver to the statistics of the g2o API.
#pragma once

#include <memory>
#include <utility>

#include "boxplus/linear/linear_solver.h"
#include "g2o/core/linear_engine.h"

namespace g2o {
namespace internal {

/// Forwards all calls to `solver`. Converts EngineSettings::tolerance to a relative tolerance, because the
/// conversion needs the right-hand side of the system that remains after the elimination, which only this
/// solver receives.
class MeasuredSolver final : public boxplus::LinearSolver {
 public:
  MeasuredSolver(std::unique_ptr<boxplus::LinearSolver> solver, const EngineSettings& settings)
      : solver_(std::move(solver)), settings_(settings) {}

  std::string_view name() const override { return solver_->name(); }
  Needs needs() const override { return solver_->needs(); }
  void analyze(const boxplus::BlockStructure& structure, const boxplus::AnalyzeHints& hints,
               const boxplus::StopToken& stop) override;
  boxplus::FactorResult factorize(const boxplus::BlockSystem& system, const boxplus::Damping& damping,
                                  const boxplus::SolveControl& control) override;
  boxplus::SolveResult solve(const double* b, int columns, double* x,
                             const boxplus::SolveControl& control) override;
  bool selected_inverse(std::span<const boxplus::BlockCoordinate> blocks, double* out,
                        const boxplus::StopToken& stop) override {
    return solver_->selected_inverse(blocks, out, stop);
  }
  boxplus::LinearStatistics statistics() const override { return solver_->statistics(); }

  void set_settings(const EngineSettings& settings) { settings_ = settings; }
  /// The seconds that factorize() took since the last call of this function.
  double take_factorize_seconds() { return std::exchange(factorize_seconds_, 0); }

 private:
  std::unique_ptr<boxplus::LinearSolver> solver_;
  EngineSettings settings_;
  std::size_t scalars_ = 0;
  double factorize_seconds_ = 0;
};

}  // namespace internal
}  // namespace g2o
