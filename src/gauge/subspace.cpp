// SPDX-License-Identifier: BSD-3-Clause
#include "gauge/subspace.h"

#include <Eigen/Jacobi>
#include <cmath>
#include <limits>

namespace boxplus {

Eigen::MatrixXd kernel_of(Eigen::MatrixXd A, double least) {
  constexpr double kOrthogonal = 4 * std::numeric_limits<double>::epsilon();
  constexpr int kMostSweeps = 40;
  const Eigen::Index count = A.cols();
  Eigen::MatrixXd V = Eigen::MatrixXd::Identity(count, count);
  bool is_done = false;
  for (int sweep = 0; sweep < kMostSweeps && !is_done; ++sweep) {
    is_done = true;
    for (Eigen::Index p = 0; p < count; ++p) {
      for (Eigen::Index q = p + 1; q < count; ++q) {
        const double pp = A.col(p).squaredNorm(), qq = A.col(q).squaredNorm(), pq = A.col(p).dot(A.col(q));
        if (std::abs(pq) <= kOrthogonal * std::sqrt(pp * qq)) continue;
        is_done = false;
        Eigen::JacobiRotation<double> rotation;
        rotation.makeJacobi(pp, pq, qq);
        A.applyOnTheRight(p, q, rotation);
        V.applyOnTheRight(p, q, rotation);
      }
    }
  }
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    if (A.col(i).norm() <= least) V.col(kept++) = V.col(i);
  }
  return V.leftCols(kept);
}

}  // namespace boxplus
