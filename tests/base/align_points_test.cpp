// SPDX-License-Identifier: BSD-3-Clause
#include "base/align_points.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace boxplus {
namespace {

Eigen::MatrixXd noisy_points(int dimension, int count, unsigned seed) {
  std::srand(seed);
  return Eigen::MatrixXd::Random(dimension, count) * 3;
}

Eigen::MatrixXd as_matrix(const PointAlignment& motion) {
  const Eigen::Index d = motion.rotation.rows();
  Eigen::MatrixXd result = Eigen::MatrixXd::Identity(d + 1, d + 1);
  result.topLeftCorner(d, d) = motion.scale * motion.rotation;
  result.topRightCorner(d, 1) = motion.translation;
  return result;
}

TEST(AlignPoints, ReturnsTheSameMotionAsEigensUmeyama) {
  for (int dimension : {2, 3}) {
    for (bool with_scale : {false, true}) {
      for (int count : {dimension, dimension + 1, 50}) {  // with fewer points, the rotation is not unique
        const Eigen::MatrixXd from = noisy_points(dimension, count, 1),
                              to = noisy_points(dimension, count, 2);
        const Eigen::MatrixXd expected = Eigen::umeyama(from, to, with_scale);
        const PointAlignment motion = align_points(from, to, with_scale);
        EXPECT_TRUE(as_matrix(motion).isApprox(expected, 1e-9))
            << dimension << " " << with_scale << " " << count;
        EXPECT_EQ(motion.scale == 1, !with_scale);
      }
    }
  }
}

TEST(AlignPoints, ReturnsARotationEvenIfOnlyAReflectionMatchesThePoints) {
  const Eigen::MatrixXd from = noisy_points(3, 20, 3);
  Eigen::MatrixXd to = from;
  to.row(0) *= -1;
  const PointAlignment motion = align_points(from, to, false);
  EXPECT_NEAR(motion.rotation.determinant(), 1, 1e-12);
}

TEST(AlignPoints, MovesASinglePointByATranslation) {
  const Eigen::Vector3d from(1, 2, 3), to(-4, 0, 9);
  const PointAlignment motion = align_points(from, to, false);
  EXPECT_TRUE((motion.rotation * from + motion.translation).isApprox(to, 1e-12));
}

}  // namespace
}  // namespace boxplus
