// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/camera_models.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "boxplus/testing/check_manifold.h"
#include "types/ba/example_cameras.h"

namespace boxplus {
namespace {

TEST(CameraModels, AreManifolds) {
  for_each_camera([](const auto& camera) {
    const ManifoldCheck check = check_manifold(camera);
    EXPECT_TRUE(check.ok) << camera.kName << ": " << check.message;
  });
}

/// Expects that the analytic derivatives of the pixel agree with dual numbers. With `tolerance`, relative to
/// the largest derivative.
template <class Camera>
void expect_same_as_dual_numbers(const Camera& camera, const Vector3& point, double tolerance = 1e-12) {
  constexpr int kColumns = 3 + Camera::kSize;
  using D = detail::Dual<double, kColumns>;
  Vector<D, 3> p = point.cast<D>();
  for (int i = 0; i < 3; ++i) p[i] = D::variable(point[i], i);
  auto lifted = Manifold<Camera>::template cast<D>(camera);
  for (int i = 0; i < Camera::kSize; ++i) lifted.parameters[i] = D::variable(camera.parameters[i], 3 + i);
  const Vector<D, 2> pixel = lifted.project(p);

  Matrix<double, 2, 3> J_point;
  Matrix<double, 2, Camera::kSize> J_parameters;
  const Vector2 value = camera.project(point, J_point, J_parameters);
  Matrix<double, 2, kColumns> J, exact;
  J << J_point, J_parameters;
  for (int i = 0; i < 2 * kColumns; ++i)
    exact(i % 2, i / 2) = pixel[i % 2].derivative[static_cast<std::size_t>(i / 2)];
  EXPECT_EQ(value, camera.project(point)) << Camera::kName;
  EXPECT_EQ(value, Vector2(pixel[0].value, pixel[1].value)) << Camera::kName;
  EXPECT_LE((J - exact).cwiseAbs().maxCoeff(), tolerance * exact.cwiseAbs().maxCoeff())
      << Camera::kName << " at " << point.transpose() << "\n"
      << J << "\n\n"
      << exact;
}

TEST(CameraModels, HaveTheDerivativesOfDualNumbers) {
  for_each_camera([](const auto& camera) {
    for (const Vector3& point : points_seen_by(camera)) {
      EXPECT_TRUE(camera.sees(point)) << camera.kName << " at " << point.transpose();
      expect_same_as_dual_numbers(camera, point);
      // Straight behind a division camera, z + √D of its formula loses digits.
      const bool cancels = camera.kName.ends_with("DIVISION") && point.head<2>().norm() < 1e-5 * point[2];
      expect_same_as_dual_numbers(camera, -point, cancels ? 1e-10 : 1e-12);  // the continuation
    }
  });
}

TEST(CameraModels, OfFisheyesSeePointsBesideAndBehindThem) {
  const auto check = [](const auto& camera) {
    for (const Vector3& point : {Vector3(1, 0.5, 0), Vector3(1, -0.5, -0.4), Vector3(0.02, 0.01, -1)}) {
      EXPECT_TRUE(camera.sees(point));
      expect_same_as_dual_numbers(camera, point, 1e-10);
    }
    EXPECT_FALSE(camera.sees(Vector3(0, 0, -1)));
  };
  check(OpenCvFisheyeCamera(300, 310, 320, 240, 0.05, -0.01, 0.004, -0.001));
  check(RadialFisheyeCamera(300, 320, 240, 0.05, -0.01));
}

TEST(CameraModels, HaveFinitePixelsAndDerivativesForEveryPoint) {
  const std::vector<double> values{0, 1e-300, 1e-160, 1e-30, 1e-20, 1e-12, 1e-9, 1e-5, 1, 1e5};
  for_each_camera([&](const auto& camera) {
    Matrix<double, 2, 3> J_point;
    Matrix<double, 2, std::remove_cvref_t<decltype(camera)>::kSize> J_parameters;
    for (const double x : values) {
      for (const double z : values) {
        for (const Vector3& point :
             {Vector3(x, 0, z), Vector3(0, -x, -z), Vector3(x, x, z), Vector3(x, -x, -z)}) {
          const Vector2 pixel = camera.project(point, J_point, J_parameters);
          EXPECT_TRUE(pixel.allFinite() && J_point.allFinite() && J_parameters.allFinite())
              << camera.kName << " at " << point.transpose() << ": " << pixel.transpose() << "\n"
              << J_point << "\n"
              << J_parameters;
        }
      }
    }
  });
}

TEST(CameraModels, AreContinuedSmoothlyThroughThePlaneOfTheCamera) {
  // At both ends of the interval in which a polynomial replaces 1/z, values and slopes agree.
  for (const double end : {-detail::kSmallDivisor, detail::kSmallDivisor}) {
    const auto inside = detail::inverse(end * (1 - 1e-12)), outside = detail::inverse(end * (1 + 1e-12));
    EXPECT_NEAR(inside.value / outside.value, 1, 1e-11);
    EXPECT_NEAR(inside.slope / outside.slope, 1, 1e-10);
  }
  EXPECT_EQ(detail::inverse(0.0).value, 0);
}

TEST(CameraModels, OfPinholesDoNotSeePointsBehindThem) {
  EXPECT_TRUE(PinholeCamera(1, 1, 0, 0).sees(Vector3(5, 0, 0.1)));
  EXPECT_FALSE(PinholeCamera(1, 1, 0, 0).sees(Vector3(0, 0, 0)));
  EXPECT_FALSE(PinholeCamera(1, 1, 0, 0).sees(Vector3(0, 0, -1)));
  EXPECT_TRUE(BalCamera(1, 0, 0).sees(Vector3(0, 0, -1)));
  EXPECT_FALSE(BalCamera(1, 0, 0).sees(Vector3(0, 0, 1)));
  EXPECT_FALSE(FovCamera(1, 1, 0, 0, 0.9).sees(Vector3(0, 0, -1)));
  EXPECT_FALSE(FovCamera(1, 1, 0, 0, 3.2).sees(Vector3(0, 0, 1)));
}

TEST(CameraModels, WithDenominatorsDoNotSeePointsBeyondTheirPole) {
  const FullOpenCvCamera camera(1, 1, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0);  // the denominator is 1 − r²
  EXPECT_TRUE(camera.sees(Vector3(0.9, 0, 1)));
  EXPECT_FALSE(camera.sees(Vector3(1, 0, 1)));
  EXPECT_FALSE(camera.sees(Vector3(1.1, 0, 1)));
  EXPECT_TRUE(camera.project(Vector3(1, 0, 1)).allFinite());
}

TEST(CameraModels, ProjectAsTheirDefinitionsSay) {
  // BAL: p = −(X, Y)/Z, and the pixel is f (1 + k1 p² + k2 p⁴) p.
  EXPECT_EQ(BalCamera(100, 0.5, 0.25).project(Vector3(1, -2, -2)),
            Vector2(0.5, -1) * 100 * (1 + 0.5 * 1.25 + 0.25 * 1.25 * 1.25));
  EXPECT_EQ(PinholeCamera(100, 200, 10, 20).project(Vector3(1, 2, 2)), Vector2(60, 220));
  // OPENCV with u = 0.5, v = 1: r² = 1.25; radial 1 + 0.1 · 1.25 − 0.04 · 1.5625 = 1.0625;
  // tangential (2 · 0.01 · 0.5 + 0.02 · (1.25 + 0.5), 2 · 0.02 · 0.5 + 0.01 · (1.25 + 2)).
  const Vector2 pixel = OpenCvCamera(100, 200, 10, 20, 0.1, -0.04, 0.01, 0.02).project(Vector3(1, 2, 2));
  EXPECT_NEAR(pixel[0], 100 * (0.53125 + 0.01 + 0.035) + 10, 1e-12);
  EXPECT_NEAR(pixel[1], 200 * (1.0625 + 0.02 + 0.0325) + 20, 1e-12);
  // Fisheye at 45°: θ = π/4.
  const double theta = std::atan(1.0);
  EXPECT_NEAR(SimpleRadialFisheyeCamera(100, 0, 0, 0.1).project(Vector3(2, 0, 2))[0],
              100 * theta * (1 + 0.1 * theta * theta), 1e-12);
  // FOV: atan(2 r tan(ω/2))/ω. ω = 0 is the pinhole.
  EXPECT_NEAR(FovCamera(100, 100, 0, 0, 1).project(Vector3(0, 1, 2))[1], 100 * std::atan(std::tan(0.5)),
              1e-12);
  EXPECT_NEAR(FovCamera(100, 100, 0, 0, 0).project(Vector3(0, 1, 2))[1], 100 * 0.5, 1e-12);
}

TEST(CameraModels, OfTheProjectAriaProjectAsTheirDefinitionSays) {
  // At 45°, along (3, 4)/5: a = 0.6, b = 0.8.
  const double theta = std::atan(1.0), t2 = theta * theta;
  double power = 1, radius = theta;
  for (const double k : {0.1, -0.02, 0.03, 0.01, -0.05, 0.02}) radius += k * (power *= t2) * theta;
  const double u = 0.6 * radius, v = 0.8 * radius, r2 = u * u + v * v;
  const RadTanThinPrismFisheyeCamera camera(100, 200, 10, 20, 0.1, -0.02, 0.03, 0.01, -0.05, 0.02, 0.01, 0.02,
                                            0.03, 0.04, 0.05, 0.06);
  const Vector2 pixel = camera.project(Vector3(3, 4, 5));
  const double x = u + 0.01 * (2 * u * u + r2) + 2 * 0.02 * u * v + 0.03 * r2 + 0.04 * r2 * r2;
  const double y = v + 0.02 * (2 * v * v + r2) + 2 * 0.01 * u * v + 0.05 * r2 + 0.06 * r2 * r2;
  EXPECT_NEAR(pixel[0], 100 * x + 10, 1e-12);
  EXPECT_NEAR(pixel[1], 200 * y + 20, 1e-12);
}

TEST(CameraModels, OfDivisionAreInvertedByADivision) {
  for (const double k : {-0.4, -0.1, 0.0, 0.15}) {
    const Vector2 pixel = DivisionCamera(100, 200, 10, 20, k).project(Vector3(1, -2, 2));
    const Vector2 distorted((pixel[0] - 10) / 100, (pixel[1] - 20) / 200);
    EXPECT_LE((distorted / (1 + k * distorted.squaredNorm()) - Vector2(0.5, -1)).norm(), 1e-14) << k;
    EXPECT_EQ(SimpleDivisionCamera(100, 10, 20, k).project(Vector3(1, -2, 2))[0], pixel[0]);
  }
}

TEST(CameraModels, OfDivisionSeeBehindTheCameraIfTheLensIsWide) {
  const double k = -0.5;
  const DivisionCamera camera(1, 1, 0, 0, k);
  for (const double radius : {0.5, 1.4, 1.42, 2.0, 5.0}) {
    const Vector2 d(0.6 * radius, -0.8 * radius);
    for (const double distance : {0.1, 1.0, 30.0}) {
      const Vector3 point = distance * Vector3(d[0], d[1], 1 + k * radius * radius);
      EXPECT_LE((camera.project(point) - d).norm(), 1e-12 * radius) << radius << " " << distance;
      EXPECT_TRUE(camera.sees(point)) << radius;
    }
  }
}

TEST(CameraModels, OfDivisionSeeNoPointWithoutASolution) {
  const DivisionCamera camera(1, 1, 0, 0, 0.25);  // the discriminant is 1 − r²
  EXPECT_TRUE(camera.sees(Vector3(0.99, 0, 1)));
  EXPECT_FALSE(camera.sees(Vector3(1, 0, 1)));
  EXPECT_FALSE(camera.sees(Vector3(0, 1.5, 1)));
  EXPECT_FALSE(camera.sees(Vector3(0.1, 0, -1)));
  // There, the image is continued: farther points have farther images.
  double last = 0;
  for (const double r : {0.0, 0.5, 0.99, 1 - 1e-12, 1.0, 1 + 1e-12, 1.01, 1.5, 3.0, 100.0}) {
    const Vector3 point(r, 0, 1);
    const double image = camera.project(point)[0];
    EXPECT_GE(image, last) << r;
    last = image;
    if (std::abs(r - 1) > 1e-6) expect_same_as_dual_numbers(camera, point);
  }
  EXPECT_NEAR(camera.project(Vector3(1, 0, 1))[0], 2, 1e-15);
}

TEST(CameraModels, HaveASmoothRootWhereADiscriminantVanishes) {
  constexpr double kEnd = detail::kSmallDivisor * detail::kSmallDivisor;
  for (const double end : {-kEnd, kEnd}) {
    const auto inside = detail::root(end * (1 - 1e-12)), outside = detail::root(end * (1 + 1e-12));
    EXPECT_NEAR(inside.value / outside.value, 1, 1e-11);
    EXPECT_NEAR(inside.slope / outside.slope, 1, 1e-10);
    EXPECT_GT(inside.value / end, 0);
  }
  EXPECT_EQ(detail::root(0.0).value, 0);
  EXPECT_EQ(detail::root(-4.0).value, -2);
  EXPECT_EQ(detail::root(4.0).slope, 0.25);
}

TEST(CameraModels, OfEquidistantFisheyesMeasureTheAngle) {
  const double theta = std::atan2(5, 2);
  const Vector2 pixel = FisheyeCamera(100, 200, 10, 20).project(Vector3(3, 4, 2));
  EXPECT_NEAR(pixel[0], 100 * 0.6 * theta + 10, 1e-12);
  EXPECT_NEAR(pixel[1], 200 * 0.8 * theta + 20, 1e-12);
  EXPECT_EQ(SimpleFisheyeCamera(100, 10, 20).project(Vector3(3, 4, 2))[0], pixel[0]);
}

TEST(CameraModels, OfTheEnhancedUnifiedModelProjectAsTheirDefinitionSays) {
  // d = √(2 · 25 + 4).
  const double d = std::sqrt(54.0), s = 1 / (0.6 * d + 0.4 * 2);
  const Vector2 pixel = EucmCamera(100, 200, 10, 20, 0.6, 2).project(Vector3(3, 4, 2));
  EXPECT_NEAR(pixel[0], 100 * s * 3 + 10, 1e-12);
  EXPECT_NEAR(pixel[1], 200 * s * 4 + 20, 1e-12);
}

TEST(CameraModels, OfTheEnhancedUnifiedModelSeePointsWhereTheirImageGrows) {
  const Vector3 beside(1, 0, -0.1), behind(1, 0, -2);
  EXPECT_TRUE(EucmCamera(1, 1, 0, 0, 0.6, 1).sees(beside));
  EXPECT_FALSE(EucmCamera(1, 1, 0, 0, 0.6, 1).sees(behind));  // farther back, the radius decreases
  EXPECT_TRUE(EucmCamera(1, 1, 0, 0, 0.3, 1).sees(beside));
  EXPECT_FALSE(EucmCamera(1, 1, 0, 0, 0.3, 1).sees(behind));  // the denominator is negative
  EXPECT_FALSE(EucmCamera(1, 1, 0, 0, 0, 1).sees(beside));
  EXPECT_FALSE(EucmCamera(1, 1, 0, 0, 1.1, 1).sees(Vector3(0, 0, 1)));
  EXPECT_FALSE(EucmCamera(1, 1, 0, 0, 0.5, -1).sees(Vector3(0, 0, 1)));
  for (const double alpha : {0.0, 0.3, 0.6, 1.0}) {
    for (const double beta : {1.5, -1.5})
      expect_same_as_dual_numbers(EucmCamera(100, 110, 5, 6, alpha, beta), Vector3(0.7, -0.9, -0.4), 1e-11);
  }
}

TEST(CameraModels, ContainEachOther) {
  const Vector3 point(0.3, -0.4, 1.2);
  const Vector2 full = FullOpenCvCamera(500, 510, 320, 240, 0.1, 0.2, 0.01, 0.02, 0, 0, 0, 0).project(point);
  EXPECT_EQ(full, OpenCvCamera(500, 510, 320, 240, 0.1, 0.2, 0.01, 0.02).project(point));
  EXPECT_EQ(OpenCvCamera(500, 500, 320, 240, 0.1, 0.2, 0, 0).project(point),
            RadialCamera(500, 320, 240, 0.1, 0.2).project(point));
  EXPECT_EQ(ThinPrismFisheyeCamera(500, 510, 320, 240, 0.1, 0.2, 0, 0, 0.3, 0.4, 0, 0).project(point),
            OpenCvFisheyeCamera(500, 510, 320, 240, 0.1, 0.2, 0.3, 0.4).project(point));
  EXPECT_LE((RadTanThinPrismFisheyeCamera(500, 510, 320, 240, 0.1, 0.2, 0.3, 0.4, 0, 0, 0, 0, 0, 0, 0, 0)
                 .project(point) -
             OpenCvFisheyeCamera(500, 510, 320, 240, 0.1, 0.2, 0.3, 0.4).project(point))
                .norm(),
            1e-12);
  EXPECT_EQ(DivisionCamera(500, 510, 320, 240, 0).project(point),
            PinholeCamera(500, 510, 320, 240).project(point));
  EXPECT_EQ(FisheyeCamera(500, 510, 320, 240).project(point),
            OpenCvFisheyeCamera(500, 510, 320, 240, 0, 0, 0, 0).project(point));
  EXPECT_EQ(EucmCamera(500, 510, 320, 240, 0, 1).project(point),
            PinholeCamera(500, 510, 320, 240).project(point));
  EXPECT_EQ(RadialFisheyeCamera(500, 320, 240, 0.1, 0).project(point),
            SimpleRadialFisheyeCamera(500, 320, 240, 0.1).project(point));
}

TEST(CameraModels, OfFovAgreeOnBothSidesOfTheirSeries) {
  for (const double z : {1.0, 5.0, 300.0}) {
    const Vector3 point(0.3, -0.4, z);
    const Vector2 below = FovCamera(1, 1, 0, 0, 0.01 * (1 - 1e-12)).project(point);
    const Vector2 above = FovCamera(1, 1, 0, 0, 0.01 * (1 + 1e-12)).project(point);
    EXPECT_LE((below - above).norm(), 1e-13 * below.norm());
    expect_same_as_dual_numbers(FovCamera(1, 1, 0, 0, 0.001), point, 1e-11);
    expect_same_as_dual_numbers(FovCamera(1, 1, 0, 0, -0.3), point, 1e-11);
  }
}

TEST(CameraModels, HaveTheNamesOfColmap) {
  std::vector<std::string_view> names;
  for_each_camera([&](const auto& camera) { names.push_back(camera.kName); });
  EXPECT_THAT(names,
              testing::ElementsAre("BAL", "SIMPLE_PINHOLE", "PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV",
                                   "OPENCV_FISHEYE", "FULL_OPENCV", "FOV", "SIMPLE_RADIAL_FISHEYE",
                                   "RADIAL_FISHEYE", "THIN_PRISM_FISHEYE", "RAD_TAN_THIN_PRISM_FISHEYE",
                                   "SIMPLE_DIVISION", "DIVISION", "SIMPLE_FISHEYE", "FISHEYE", "EUCM"));
  EXPECT_THAT(OpenCvCamera::Model::kParameters,
              testing::ElementsAre("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2"));
}

}  // namespace
}  // namespace boxplus
