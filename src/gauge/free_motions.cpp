// SPDX-License-Identifier: BSD-3-Clause
#include "gauge/free_motions.h"

#include "gauge/subspace.h"

namespace boxplus {
namespace {

using Eigen::MatrixXd;

constexpr double kZero = 1e-6;

/// The axes of the space that the orthonormal columns of Q span.
std::vector<FreeMotions::Axis> axes_of(const MatrixXd& Q) {
  std::vector<FreeMotions::Axis> axes;
  if (Q.cols() == 0) return axes;
  for (Eigen::Index i = 0; i < Q.rows(); ++i) {
    if (Q.row(i).squaredNorm() < 1 - kZero) continue;  // the coordinate axis is not in the space
    axes.emplace_back()[i] = 1;
  }
  if (axes.size() == static_cast<std::size_t>(Q.cols())) return axes;
  axes.clear();
  for (Eigen::Index c = 0; c < Q.cols(); ++c) {
    FreeMotions::Axis& axis = axes.emplace_back();
    for (Eigen::Index i = 0; i < Q.rows(); ++i) axis[i] = Q(i, c);
  }
  return axes;
}

/// An orthonormal basis of the space that the columns of A span.
MatrixXd range_of(const MatrixXd& A) {
  if (A.cols() == 0) return A;
  return eigenvectors_of(A * A.transpose(), [](double squared) { return squared > kZero * kZero; });
}

}  // namespace

FreeMotions all_rigid_motions(int dimension) {
  FreeMotions motions;
  motions.dimension = dimension;
  motions.along = axes_of(MatrixXd::Identity(dimension, dimension));
  motions.about = dimension == 2 ? std::vector<FreeMotions::Axis>{{0, 0, 1}} : motions.along;
  motions.count = static_cast<int>(motions.along.size() + motions.about.size());
  return motions;
}

FreeMotions free_motions_of(const SimilarityFreedom& freedom) {
  FreeMotions motions;
  motions.dimension = freedom.motions.dimension;
  motions.count = freedom.directions();
  motions.scale = freedom.scale().norm() > kZero;
  // Translations are the motions that neither rotate nor scale.
  MatrixXd others(freedom.motions.rotations() + 1, freedom.directions());
  others << freedom.rotations(), freedom.scale();
  motions.along = axes_of(range_of(freedom.translations() * kernel_of(others, kZero)));
  const MatrixXd turns = range_of(freedom.rotations());
  if (motions.dimension == 3) {
    motions.about = axes_of(turns);
  } else if (turns.cols() > 0) {
    motions.about = {{0, 0, 1}};
  }
  return motions;
}

}  // namespace boxplus
