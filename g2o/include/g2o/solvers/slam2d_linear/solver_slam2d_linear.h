// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SOLVER_SLAM2D_LINEAR_H
#define G2O_SOLVER_SLAM2D_LINEAR_H

#include <memory>

#include "g2o/core/optimization_algorithm_gauss_newton.h"

#define G2O_SOLVER_SLAM2D_LINEAR_API G2O_API_EXPORT

namespace g2o {

/// A linear start for graphs of poses of the plane: the headings that fit the measured turns best,
/// translations of zero, and from there Gauss-Newton, whose first iteration finds the translations.
///
/// For active edges that are EdgeSE2, with a fixed vertex from which all others are reached; else the first
/// iteration fails, with a message.
class G2O_SOLVER_SLAM2D_LINEAR_API SolverSLAM2DLinear : public OptimizationAlgorithmGaussNewton {
 public:
  explicit SolverSLAM2DLinear(std::unique_ptr<Solver> solver);
  /// As clients of old write it; takes ownership.
  explicit SolverSLAM2DLinear(Solver* solver);
  ~SolverSLAM2DLinear() override;

  SolverResult solve(int iteration, bool online = false) override;

 protected:
  bool solveOrientation();
};

}  // namespace g2o

#endif  // G2O_SOLVER_SLAM2D_LINEAR_H
