// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/reprojection_lanes.h"

#include <gtest/gtest.h>

#include <random>

#include "boxplus/graph/graph.h"
#include "kernels/every_isa.h"
#include "types/ba/example_cameras.h"

namespace boxplus {
namespace {

class ReprojectionLanes : public EveryIsa {};

/// Random poses at about 5 m from random points, and cameras with some distortion.
struct Scene {
  std::mt19937 random{7};

  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  Vector3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  SE3 pose(double z) {
    return {Vector3(number(-1, 1), number(-1, 1), z), SO3::from_rotation_vector(vector(0.3))};
  }
  template <class Camera>
  Camera camera() {
    Camera camera = example_camera<Camera>();
    for (double& parameter : camera.parameters) parameter *= number(0.9, 1.1);
    return camera;
  }
};

/// Expects that errors and Jacobians in lanes are those of the plain functions of the edges. If `is_exact`,
/// errors must have the same bits with and without Jacobians.
void expect_plain_values(const Graph& graph, bool is_exact = true) {
  const detail::EdgePool& pool = *graph.edge_pools().front();
  for (const std::uint32_t count : {1u, 3u, 8u, 13u, 64u}) {
    std::vector<std::uint32_t> edges(count);
    for (std::uint32_t k = 0; k < count; ++k) edges[k] = (7 * k) % pool.slots();
    const detail::EdgeShape shape = pool.shape(0);
    const auto values = static_cast<std::size_t>(shape.rows * shape.cols);
    std::vector<double> plain_error(2 * 64), plain_jacobian(values * 64);
    std::vector<double> error(2 * 64), jacobian(values * 64), only_error(2 * 64);
    detail::EdgeTile plain, lanes;
    plain.error = plain_error.data();
    plain.jacobian = plain_jacobian.data();
    lanes.error = error.data();
    lanes.jacobian = jacobian.data();
    lanes.in_lanes = true;
    pool.linearize(edges, plain, false);
    pool.linearize(edges, lanes, false);
    ASSERT_TRUE(lanes.in_lanes);
    ASSERT_FALSE(plain.in_lanes);
    ASSERT_TRUE(pool.errors_in_lanes(edges, only_error.data()));
    if (is_exact) {
      EXPECT_EQ(only_error, error);
    }
    for (std::size_t m = 0; m < error.size(); ++m)
      ASSERT_NEAR(only_error[m], error[m], 1e-14 * (1000 + std::abs(error[m])));
    const auto expect_near = [&](const std::vector<double>& in_lanes, const std::vector<double>& expected,
                                 std::size_t size) {
      for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t m = 0; m < size; ++m) {
          const double value = in_lanes[(k / 8 * size + m) * 8 + k % 8], plain_value = expected[k * size + m];
          ASSERT_NEAR(value, plain_value, 1e-12 * (1000 + std::abs(plain_value))) << k << ' ' << m;
        }
      }
    };
    expect_near(error, plain_error, 2);
    expect_near(jacobian, plain_jacobian, values);
  }
}

/// The forms of an edge with a camera.
template <class Camera>
struct Forms {
  Graph apart, together, calibrated;

  void add(const Vector2& pixel, const SE3& pose, const Vector3& point, const Camera& camera) {
    apart.add_edge(Reprojection<Camera>(pixel), apart.add_vertex(pose), apart.add_vertex(point),
                   apart.add_vertex(camera));
    together.add_edge(Reprojection<Camera>(pixel), together.add_vertex(Product<SE3, Camera>(pose, camera)),
                      together.add_vertex(point));
    calibrated.add_edge(CalibratedReprojection<Camera>(pixel, camera), calibrated.add_vertex(pose),
                        calibrated.add_vertex(point));
  }
  void expect_plain_values() const {
    SCOPED_TRACE(Camera::kName);
    // Without derivatives, the compiler contracts other products and sums of this model to one rounding.
    constexpr bool kIsExact = !std::is_same_v<Camera, ThinPrismFisheyeCamera>;
    boxplus::expect_plain_values(apart, kIsExact);
    boxplus::expect_plain_values(together, kIsExact);
    boxplus::expect_plain_values(calibrated, kIsExact);
  }
};

TEST_P(ReprojectionLanes, ComputeThePlainValuesOfEveryCameraAndFormOfTheEdge) {
  detail::CameraList::for_each([]<class Camera>() {
    Scene scene;
    Forms<Camera> forms;
    for (int k = 0; k < 20; ++k) {
      const SE3 pose = scene.pose(-5 * kForward<Camera>);
      const Camera camera = scene.camera<Camera>();
      const Vector3 point = scene.vector(1);
      forms.add({scene.number(0, 600), scene.number(0, 600)}, pose, point, camera);
    }
    forms.expect_plain_values();
  });
}

TEST_P(ReprojectionLanes, ComputeThePlainValuesOnEveryBranchOfTheFormulas) {
  detail::CameraList::for_each([]<class Camera>() {
    Forms<Camera> forms;
    const auto camera = example_camera<Camera>();
    std::vector<Vector3> points = points_seen_by(camera);
    for (const double z : {0.1, 0.5, 0.9, 1.2}) points.emplace_back(1, 0.5, z);
    for (const Vector3& point : points) {
      forms.add(Vector2(320, 240), SE3(), point, camera);
      forms.add(Vector2(320, 240), SE3(), -point, camera);
    }
    forms.expect_plain_values();
  });
}

TEST_P(ReprojectionLanes, AreFiniteForAPointInTheCenterOfTheCamera) {
  Graph graph;
  const SE3 pose(Vector3(1, 2, 3), SO3());
  graph.add_edge(Reprojection<PinholeCamera>(Vector2(5, 6)), graph.add_vertex(pose),
                 graph.add_vertex(Vector3(1, 2, 3)), graph.add_vertex(PinholeCamera(500, 500, 320, 240)));
  expect_plain_values(graph);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, ReprojectionLanes, ::testing::ValuesIn(dense::usable_kernels()),
                         name_of_isa);

}  // namespace
}  // namespace boxplus
