// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SOLVER_SLAM2D_LINEAR_H
#define G2O_SOLVER_SLAM2D_LINEAR_H

#include <memory>

#include "g2o/core/optimization_algorithm_gauss_newton.h"

#define G2O_SOLVER_SLAM2D_LINEAR_API G2O_API_EXPORT

namespace g2o {

/// A linear start for pose graphs in the plane. It computes the headings that fit the measured rotations best
/// and sets the translations to zero. The first iteration of Gauss-Newton then finds the translations.
///
/// All active edges must be of type EdgeSE2, and a fixed vertex must reach all others. Otherwise the first
/// iteration fails with a message.
class G2O_SOLVER_SLAM2D_LINEAR_API SolverSLAM2DLinear : public OptimizationAlgorithmGaussNewton {
 public:
  explicit SolverSLAM2DLinear(std::unique_ptr<Solver> solver);
  /// For clients that pass a raw pointer. Takes ownership.
  explicit SolverSLAM2DLinear(Solver* solver);
  ~SolverSLAM2DLinear() override;

  SolverResult solve(int iteration, bool online = false) override;

 protected:
  bool solveOrientation();
};

}  // namespace g2o

#endif  // G2O_SOLVER_SLAM2D_LINEAR_H
