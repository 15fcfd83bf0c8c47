// SPDX-License-Identifier: BSD-3-Clause
#include "base/align_points.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cassert>

namespace boxplus {
namespace {

template <int D>
PointAlignment aligned(const Points& from, const Points& to, bool with_scale) {
  using Square = Eigen::Matrix<double, D, D>;
  const auto count = static_cast<double>(from.cols());
  const Eigen::VectorXd from_mean = from.rowwise().mean(), to_mean = to.rowwise().mean();
  const Eigen::MatrixXd x = from.colwise() - from_mean, y = to.colwise() - to_mean;
  const Square covariance = y * x.transpose() / count;

  const Eigen::JacobiSVD<Square> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector<double, D> signs = Eigen::Vector<double, D>::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0) signs[D - 1] = -1;

  PointAlignment motion;
  motion.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  if (with_scale) motion.scale = svd.singularValues().dot(signs) / (x.squaredNorm() / count);
  motion.translation = to_mean - motion.scale * motion.rotation * from_mean;
  return motion;
}

}  // namespace

PointAlignment align_points(const Points& from, const Points& to, bool with_scale) {
  assert(from.rows() == to.rows() && from.cols() == to.cols() && (from.rows() == 2 || from.rows() == 3));
  return from.rows() == 2 ? aligned<2>(from, to, with_scale) : aligned<3>(from, to, with_scale);
}

}  // namespace boxplus
