// SPDX-License-Identifier: BSD-3-Clause
#include "guess/nearest_rotation.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

namespace boxplus::guess {
namespace {

template <int D>
using Square = Eigen::Matrix<double, D, D>;

/// Replaces a matrix of norm 1 and positive determinant by its orthogonal polar factor. Uses Newton's
/// iteration X ← (X + X⁻ᵀ) / 2, with scaling in the first steps (Higham, Computing the polar decomposition,
/// 1986). The iteration converges quadratically, and is far cheaper than a singular value decomposition.
/// Returns false if the matrix is nearly singular.
template <int D>
bool polar_factor(Square<D>& x) {
  constexpr int kMostSteps = 12;
  constexpr double kRegular = 1e-3, kUnscaled = 1e-2, kEnough = 1e-14;
  if (!(x.determinant() > kRegular)) return false;
  bool scaled = true;
  for (int step = 0; step < kMostSteps; ++step) {
    const Square<D> inverse = x.inverse().transpose();
    const double scale = scaled ? std::sqrt(inverse.norm() / x.norm()) : 1;
    const Square<D> next = 0.5 * (scale * x + inverse / scale);
    const double change = (next - x).norm();
    x = next;
    if (change < kEnough) return true;
    if (change < kUnscaled) scaled = false;
  }
  return false;
}

template <int D>
std::optional<SmallMatrix> nearest(const SmallMatrix& m) {
  constexpr double kUnique = 1e-9;
  if (Square<D> factor = m / m.norm(); polar_factor<D>(factor)) return SmallMatrix(factor);
  const Eigen::JacobiSVD<Square<D>> svd(Square<D>(m), Eigen::ComputeFullU | Eigen::ComputeFullV);
  const auto& s = svd.singularValues();
  const double sign = svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1 : 1;
  if (!(s[D - 2] + sign * s[D - 1] > kUnique * s[0])) return std::nullopt;
  Square<D> u = svd.matrixU();
  u.col(D - 1) *= sign;
  return SmallMatrix(u * svd.matrixV().transpose());
}

}  // namespace

std::optional<SmallMatrix> nearest_rotation(const SmallMatrix& m) {
  if (!m.allFinite()) return std::nullopt;
  return m.rows() == 2 ? nearest<2>(m) : nearest<3>(m);
}

}  // namespace boxplus::guess
