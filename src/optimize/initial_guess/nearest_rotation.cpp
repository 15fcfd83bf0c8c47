// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/initial_guess/nearest_rotation.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace boxplus::guess {
namespace {

template <int D>
std::optional<SmallMatrix> nearest(const SmallMatrix& m) {
  using Square = Eigen::Matrix<double, D, D>;
  constexpr double kUnique = 1e-9;
  const Eigen::JacobiSVD<Square> svd(Square(m), Eigen::ComputeFullU | Eigen::ComputeFullV);
  const auto& s = svd.singularValues();
  const double sign = svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1 : 1;
  if (!(s[D - 2] + sign * s[D - 1] > kUnique * s[0])) return std::nullopt;
  Square u = svd.matrixU();
  u.col(D - 1) *= sign;
  return SmallMatrix(u * svd.matrixV().transpose());
}

}  // namespace

std::optional<SmallMatrix> nearest_rotation(const SmallMatrix& m) {
  if (!m.allFinite()) return std::nullopt;
  return m.rows() == 2 ? nearest<2>(m) : nearest<3>(m);
}

}  // namespace boxplus::guess
