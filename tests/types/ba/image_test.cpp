// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/image.h"

#include <gmock/gmock.h>

#include "boxplus/manifold/convert_to.h"
#include "boxplus/testing/check_manifold.h"
#include "boxplus/types/slam3d/between_jacobians.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

// Turned by 90° about z: the camera's x axis is the world's y axis.
const SE3 kPose = pose(1, 2, 3, 0, 0, kPi / 2);
const SE3RotationVector kSamePose = convert_to<SE3RotationVector>(kPose);
/// (2, 1, 4) in the frame of kPose.
const Vector3 kPoint(0, 4, 7);
const StereoCamera kCamera{Vector<double, 4>(100, 30, 40, 0.2)};
const PinholeCamera kPinhole(100, 200, 30, 40);
const StereoIntrinsics kIntrinsics{Vector<double, 4>(100, 200, 30, 40), 0.2};
/// Another camera at the same place.
const StereoPose kStereoPose{kPose, {Vector<double, 4>(50, 60, 7, 8), 0.4}};

TEST(StereoTypes, AreManifolds) {
  const ManifoldCheck camera = check_manifold<StereoCamera>({kCamera, StereoCamera{}});
  EXPECT_TRUE(camera.ok) << camera.message;
  const ManifoldCheck intrinsics = check_manifold<StereoIntrinsics>({kIntrinsics});
  EXPECT_TRUE(intrinsics.ok) << intrinsics.message;
  const ManifoldCheck posed = check_manifold<StereoPose>({kStereoPose});
  EXPECT_TRUE(posed.ok) << posed.message;
}

TEST(StereoIntrinsics, KeepTheirBaselineInAStep) {
  const double step[] = {1, 2, 3, 4};
  const StereoIntrinsics moved = Manifold<StereoIntrinsics>::oplus(kIntrinsics, step);
  EXPECT_EQ(moved.parameters, (Vector<double, 4>(101, 202, 33, 44)));
  EXPECT_EQ(moved.baseline, kIntrinsics.baseline);
}

TEST(StereoPose, KeepsItsIntrinsicsInAStep) {
  const double step[] = {1, 2, 3, 0.1, 0.2, 0.3};
  const StereoPose moved = Manifold<StereoPose>::oplus(kStereoPose, step);
  EXPECT_EQ(moved.intrinsics.parameters, kStereoPose.intrinsics.parameters);
  EXPECT_EQ(moved.pose.vector(), Manifold<SE3>::oplus(kPose, step).vector());
}

TEST(ImageDerivatives, AreThoseOfTheCameraForEveryDepth) {
  const double bf = 20;
  for (const double depth : {4.0, -3.0, 1e-3, 4e-10, -4e-10, 0.0}) {
    const Vector3 p(2 * depth + 1e-10, depth - 1e-10, depth);
    const detail::ImageDerivatives<3> by({kPinhole, bf}, p);
    Matrix<double, 2, 3> J;
    Matrix<double, 2, 4> J_parameters;
    kPinhole.project(p, J, J_parameters);
    const double tolerance = 1e-15 * J.norm();
    EXPECT_LT((by.by_point().topRows<2>() - J).norm(), tolerance) << depth;
    EXPECT_LT((by.by_parameters().topLeftCorner<2, 4>() - J_parameters).norm(), 1e-15 * J_parameters.norm());
    const detail::Inverse<double> inverse = detail::inverse(depth);
    const Vector3 second_minus_first(0, 0, -bf * inverse.slope);
    EXPECT_LT((by.by_point().row(2) - J.row(0) - second_minus_first.transpose()).norm(), tolerance) << depth;
    EXPECT_EQ(by.by_parameters()(2, 4), -inverse.value);

    Matrix<double, 3, 3> by_rotated, J_t, J_omega;
    by.by_rotated_point(kPose.rotation(), by_rotated);
    by.by_pose(J_t, J_omega);
    const Matrix<double, 3, 3> D = by.by_point(), across = detail::cross_matrix(p[0], p[1], p[2]);
    EXPECT_LT((by_rotated - D * kPose.rotation()).norm(), 1e-15 * D.norm()) << depth;
    EXPECT_EQ(J_t, -D);
    EXPECT_LT((J_omega - D * across).norm(), 1e-15 * D.norm() * p.norm()) << depth;
  }
}

TEST(PointImage, IsThePixelOfThePointInThePairOfTheVertex) {
  // u = 100 · 2/4 + 30 = 80, v = 100 · 1/4 + 40 = 65, u in the second camera = 80 − 100 · 0.2/4 = 75.
  EXPECT_LT((PointImage<2>(Vector2(1, 2)).error(kPoint, kSamePose, kCamera) - Vector2(79, 63)).norm(), 1e-12);
  EXPECT_LT((PointImage<3>(Vector3(1, 2, 3)).error(kPoint, kPose, kCamera) - Vector3(79, 63, 72)).norm(),
            1e-12);
}

TEST(PointImage, UsesTheIntrinsicsOfThePoseUnlessThereAreOthers) {
  // 50 · 2/4 + 7 = 32, 60 · 1/4 + 8 = 23, 32 − 50 · 0.4/4 = 27.
  EXPECT_LT((PointImage<2>(Vector2(1, 2)).error(kPoint, kStereoPose) - Vector2(31, 21)).norm(), 1e-12);
  EXPECT_LT((PointImage<3>(Vector3(1, 2, 3)).error(kPoint, kStereoPose) - Vector3(31, 21, 24)).norm(), 1e-12);
  // 100 · 2/4 + 30 = 80, 200 · 1/4 + 40 = 90, 80 − 100 · 0.2/4 = 75.
  EXPECT_LT((PointImage<2>(Vector2(1, 2)).error(kPoint, kStereoPose, kIntrinsics) - Vector2(79, 88)).norm(),
            1e-12);
}

TEST(CalibratedPointImage, UsesTheCameraOfTheEdge) {
  EXPECT_LT(
      (CalibratedPointImage<2>(Vector2(1, 2), kPinhole).error(kPoint, kSamePose) - Vector2(79, 88)).norm(),
      1e-12);
  // 80 − 40/4 = 70.
  EXPECT_LT(
      (CalibratedPointImage<3>(Vector3(1, 2, 3), kPinhole, 40).error(kPoint, kSamePose) - Vector3(79, 88, 67))
          .norm(),
      1e-12);
}

TEST(KnownPointImage, UsesThePointOfTheEdge) {
  EXPECT_LT((KnownPointImage<2>(Vector2(1, 2), kPoint, kPinhole).error(kSamePose) - Vector2(79, 88)).norm(),
            1e-12);
  EXPECT_LT(
      (KnownPointImage<3>(Vector3(1, 2, 3), kPoint, kPinhole, 40).error(kSamePose) - Vector3(79, 88, 67))
          .norm(),
      1e-12);
}

template <int Rows>
void expect_correct_jacobians_of_images(const Vector<double, Rows>& z) {
  const SE3 turned = pose(1, 2, 3, 0.3, -0.4, 0.5);
  const auto turned_vector = convert_to<SE3RotationVector>(turned);
  const StereoPose posed{turned, kStereoPose.intrinsics};
  for (const Vector3& point : {kPoint, Vector3(2, 1, -3)}) {  // the second point is behind the camera
    expect_correct_jacobians(PointImage<Rows>(z), point, turned, kCamera);
    expect_correct_jacobians(PointImage<Rows>(z), point, turned_vector, kCamera);
    expect_correct_jacobians(PointImage<Rows>(z), point, posed);
    expect_correct_jacobians(PointImage<Rows>(z), point, posed, kIntrinsics);
    expect_correct_jacobians(CalibratedPointImage<Rows>(z, kPinhole, 40), point, turned);
    expect_correct_jacobians(CalibratedPointImage<Rows>(z, kPinhole, 40), point, turned_vector);
    expect_correct_jacobians(KnownPointImage<Rows>(z, point, kPinhole, 40), turned);
    expect_correct_jacobians(KnownPointImage<Rows>(z, point, kPinhole, 40), turned_vector);
  }
}

TEST(Images, HaveCorrectJacobians) {
  expect_correct_jacobians_of_images<2>(Vector2(10, 20));
  expect_correct_jacobians_of_images<3>(Vector3(10, 20, 15));
}

}  // namespace
}  // namespace boxplus
