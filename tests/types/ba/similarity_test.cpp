// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/similarity.h"

#include <gmock/gmock.h>

#include <random>

#include "boxplus/testing/check_manifold.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

SimilarityCamera camera_of(const Sim3& x) {
  return {LoggedSim3(x), PinholeCamera(100, 200, 30, 40), PinholeCamera(50, 60, 7, 8)};
}
/// Turned by 90° about z, twice as large.
const Sim3 kTurned(detail::RotationVectorChart::exp(0.0, 0.0, kPi / 2), Vector3(1, 2, 3), 2);
const Sim3 kOther(detail::RotationVectorChart::exp(0.3, -0.4, 0.5), Vector3(2, 1, -1), 0.7);

TEST(LoggedSim3, IsTheExponentialOfItsLogarithm) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 1000; ++trial) {
    Vector<double, 7> v;
    for (double& value : v) value = normal(random);
    const LoggedSim3 read(v), moved(read.value() * kOther);
    EXPECT_EQ(read.logarithm(), v);
    const LoggedSim3 again(moved.logarithm());
    for (int i = 0; i < 8; ++i) EXPECT_EQ(again.value().data()[i], moved.value().data()[i]);
  }
}

TEST(SimilarityCamera, IsAManifold) {
  const ManifoldCheck check = check_manifold<SimilarityCamera>({camera_of(kTurned), camera_of(kOther)});
  EXPECT_TRUE(check.ok) << check.message;
}

TEST(SimilarityCamera, KeepsItsCamerasInAStepAndEveryBitIfTheStepIsZero) {
  const double zero[7] = {}, step[] = {0.1, 0.2, 0.3, 1, 2, 3, 0.1};
  const SimilarityCamera x = camera_of(kOther);
  const SimilarityCamera same = Manifold<SimilarityCamera>::oplus(x, zero);
  EXPECT_EQ(same.similarity.logarithm(), x.similarity.logarithm());
  const SimilarityCamera moved = Manifold<SimilarityCamera>::oplus(x, step);
  EXPECT_EQ(moved.first.parameters, x.first.parameters);
  EXPECT_EQ(moved.second.parameters, x.second.parameters);
}

TEST(SimilarityCamera, KeepsItsScaleInANewFrame) {
  SimilarityCamera x = camera_of(kTurned);
  detail::FrameTrait<SimilarityCamera>::set(x, detail::FrameTrait<SE3>::get(pose(4, 5, 6, 0.1, 0.2, 0.3)));
  EXPECT_NEAR(x.pose().scale(), 2, 1e-14);
  EXPECT_LT((x.pose().translation() - Vector3(4, 5, 6)).norm(), 1e-13);
}

TEST(SimilarityBetween, IsTheLogarithmOfTheDifference) {
  // b is at (1, 0, 2) in the frame of a, with the same rotation and the scale 3/2.
  const Sim3 b(kTurned.quaternion(), Vector3(1, 4, 7), 3);
  const SimilarityBetween edge(LoggedSim3(Sim3(detail::Quaternion<double>::identity(), Vector3(1, 0, 2), 1)));
  Vector<double, 7> expected;
  expected << 0, 0, 0, 0, 0, 0, std::log(1.5);
  EXPECT_LT((edge.error(camera_of(kTurned), camera_of(b)) - expected).norm(), 1e-14);
}

TEST(SimilarityImages, AreImagesOfThePointInTheFirstCameraAndOfItsTransformInTheSecond) {
  // Y⁻¹ l for l − t = (−2, 4, 8): turned back (4, 2, 8), halved (2, 1, 4).
  const Vector3 l(-1, 6, 11);
  EXPECT_LT((SimilarityImage(Vector2(1, 2)).error(l, camera_of(kTurned)) - Vector2(79, 88)).norm(), 1e-12);
  // Y p for p = (2, 1, 0.5): doubled (4, 2, 1), turned (−2, 4, 1), shifted (−1, 6, 4).
  const Vector2 e = InverseSimilarityImage(Vector2(1, 2)).error(Vector3(2, 1, 0.5), camera_of(kTurned));
  EXPECT_LT((e - Vector2(50 * -0.25 + 6, 60 * 1.5 + 6)).norm(), 1e-12);
}

TEST(SimilarityEdges, HaveCorrectJacobians) {
  const SimilarityCamera a = camera_of(kTurned), b = camera_of(kOther);
  const Vector3 point(1, 2, 7);
  Vector<double, 7> z;
  z << 0.3, -0.1, 0.4, 2, 1, 3, 0.2;
  expect_correct_jacobians(SimilarityBetween(LoggedSim3(z)), a, b);
  for (const SimilarityCamera& Y : {a, b}) {
    expect_correct_jacobians(SimilarityImage(Vector2(10, 20)), point, Y);
    expect_correct_jacobians(InverseSimilarityImage(Vector2(10, 20)), point, Y);
  }
}

}  // namespace
}  // namespace boxplus
