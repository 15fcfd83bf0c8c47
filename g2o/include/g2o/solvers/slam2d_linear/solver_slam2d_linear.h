// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SOLVER_SLAM2D_LINEAR_H
#define G2O_SOLVER_SLAM2D_LINEAR_H

#include <memory>

#include "g2o/core/optimization_algorithm_gauss_newton.h"

#define G2O_SOLVER_SLAM2D_LINEAR_API G2O_API_EXPORT

namespace g2o {

/// Gauss-Newton for pose graphs in the plane that needs no initial estimates. First, it solves a linear
/// least-squares problem for the headings that best fit the measured rotations, and sets the translations to
/// zero. The first Gauss-Newton iteration then computes the translations.
///
/// All active edges must be of type EdgeSE2, and each vertex must be connected to a fixed vertex. Otherwise,
/// the first iteration logs an error and fails.
class G2O_SOLVER_SLAM2D_LINEAR_API SolverSLAM2DLinear : public OptimizationAlgorithmGaussNewton {
 public:
  explicit SolverSLAM2DLinear(std::unique_ptr<Solver> solver);
  /// For clients that pass a raw pointer. The algorithm takes ownership.
  explicit SolverSLAM2DLinear(Solver* solver);
  ~SolverSLAM2DLinear() override;

  SolverResult solve(int iteration, bool online = false) override;

 protected:
  bool solveOrientation();
};

}  // namespace g2o

#endif  // G2O_SOLVER_SLAM2D_LINEAR_H
