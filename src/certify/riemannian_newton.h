// SPDX-License-Identifier: BSD-3-Clause
// Minimizes the chordal cost over stacked poses of any rank p by Newton's method.
#pragma once

#include <vector>

#include "certify/dual_matrix.h"

namespace boxplus::certificate {

/// The Hessian of F in the tangent space of the poses is twice the projection of S. So with a basis E_i of
/// the tangent space of X_i, the blocks of the Newton system are H_ij = E_iᵀ S_ij E_j. If H is not positive
/// definite, or if a step does not lower F, H is damped.
class RiemannianNewton {
 public:
  /// For poses with `rank` columns. All arguments must outlive this object. Throws Stopped, as minimize().
  RiemannianNewton(const ChordalProblem& problem, DualMatrix& dual, int rank, const Resources& resources);

  /// Stops when a step would lower F by less than `tolerance` times F. Returns the number of steps. `dual` is
  /// then updated for the new poses.
  int minimize(StackedPoses& poses, double tolerance, int max_steps);

 private:
  void linearize(const StackedPoses& poses);
  bool find_step();
  StackedPoses moved(const StackedPoses& poses) const;

  const ChordalProblem& problem_;
  DualMatrix& dual_;
  Resources resources_;
  BlockStructure structure_;
  std::vector<Eigen::MatrixXd> basis_;  // of each block: (d + 1) p × m, its columns are stacked poses
  std::vector<double> values_, diagonal_, gradient_, step_;
  std::optional<SparseFactor> factor_;
  double lambda_ = 0;
};

/// The nearest stacked pose with orthonormal rotation rows.
void orthonormalize(StackedPose& pose);

}  // namespace boxplus::certificate
