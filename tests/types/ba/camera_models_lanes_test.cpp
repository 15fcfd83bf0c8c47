// SPDX-License-Identifier: BSD-3-Clause
// The formulas of the cameras work with packs of SIMD lanes as scalars.
#include <gtest/gtest.h>

#include <cmath>

#include "types/ba/example_cameras.h"

namespace boxplus {
namespace {

struct Mask {
  bool lane[2];
};

/// Two doubles, with the operations that types/ba/distortion.h lists.
struct Pack {
  double lane[2];

  Pack() = default;
  Pack(double value) : lane{value, value} {}  // NOLINT: implicit
  Pack(double a, double b) : lane{a, b} {}

  friend Pack operator-(const Pack& a) { return {-a.lane[0], -a.lane[1]}; }
  friend Pack operator+(const Pack& a, const Pack& b) {
    return {a.lane[0] + b.lane[0], a.lane[1] + b.lane[1]};
  }
  friend Pack operator-(const Pack& a, const Pack& b) {
    return {a.lane[0] - b.lane[0], a.lane[1] - b.lane[1]};
  }
  friend Pack operator*(const Pack& a, const Pack& b) {
    return {a.lane[0] * b.lane[0], a.lane[1] * b.lane[1]};
  }
  friend Pack operator/(const Pack& a, const Pack& b) {
    return {a.lane[0] / b.lane[0], a.lane[1] / b.lane[1]};
  }
  friend Mask operator>(const Pack& a, const Pack& b) {
    return {a.lane[0] > b.lane[0], a.lane[1] > b.lane[1]};
  }
  friend Mask operator<(const Pack& a, const Pack& b) { return b > a; }
  friend Mask operator>=(const Pack& a, const Pack& b) {
    return {a.lane[0] >= b.lane[0], a.lane[1] >= b.lane[1]};
  }
  friend Mask operator<=(const Pack& a, const Pack& b) { return b >= a; }
  friend Pack choose(const Mask& mask, const Pack& a, const Pack& b) {
    return {mask.lane[0] ? a.lane[0] : b.lane[0], mask.lane[1] ? a.lane[1] : b.lane[1]};
  }
  friend Pack sqrt(const Pack& a) { return {std::sqrt(a.lane[0]), std::sqrt(a.lane[1])}; }
  friend Pack tan(const Pack& a) { return {std::tan(a.lane[0]), std::tan(a.lane[1])}; }
  friend Pack atan2(const Pack& y, const Pack& x) {
    return {std::atan2(y.lane[0], x.lane[0]), std::atan2(y.lane[1], x.lane[1])};
  }
};

TEST(CameraModels, ComputeTheSameInLanes) {
  for_each_camera([](const auto& camera) {
    using Camera = std::remove_cvref_t<decltype(camera)>;
    constexpr int kSize = Camera::kSize;
    const double z = kForward<Camera>;
    const Vector3 a(0.3, -0.2, 2 * z), b(0, 0, z);  // different branches of the fisheyes
    Pack point[3], parameters[kSize], pixel[2], J_point[6], J_parameters[2 * kSize];
    for (int i = 0; i < 3; ++i) point[i] = {a[i], b[i]};
    for (int i = 0; i < kSize; ++i) parameters[i] = camera.parameters[i];
    Camera::project(point, parameters, pixel, J_point, J_parameters);
    for (int lane = 0; lane < 2; ++lane) {
      Matrix<double, 2, 3> expected_point;
      Matrix<double, 2, kSize> expected_parameters;
      const Vector2 expected = camera.project(lane == 0 ? a : b, expected_point, expected_parameters);
      for (int i = 0; i < 2; ++i) EXPECT_DOUBLE_EQ(pixel[i].lane[lane], expected[i]) << Camera::kName;
      for (int i = 0; i < 6; ++i)
        EXPECT_DOUBLE_EQ(J_point[i].lane[lane], expected_point.data()[i]) << Camera::kName;
      for (int i = 0; i < 2 * kSize; ++i)
        EXPECT_DOUBLE_EQ(J_parameters[i].lane[lane], expected_parameters.data()[i]) << Camera::kName;
    }
  });
}

}  // namespace
}  // namespace boxplus
