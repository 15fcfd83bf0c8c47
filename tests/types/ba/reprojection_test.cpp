// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/reprojection.h"

#include <gmock/gmock.h>

#include "boxplus/boxplus.h"
#include "boxplus/types/ba.h"
#include "types/ba/example_cameras.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

const SE3 kX = pose(1, 2, 3, 0.3, -0.4, 0.9), kP = pose(0, 0.1, 0.2, 0.1, -0.2, 0.1);
const Vector2 kPixel(12, -34);

/// Points in the world that a camera at this pose sees.
template <class Camera>
std::vector<Vector3> points_seen_from(const SE3& pose, const Camera& camera) {
  std::vector<Vector3> points = points_seen_by(camera);
  for (Vector3& point : points) point = pose * point;
  return points;
}

TEST(Reprojection, HasCorrectJacobiansForEveryModel) {
  for_each_camera([](const auto& camera) {
    using Camera = std::remove_cvref_t<decltype(camera)>;
    const Reprojection<Camera> edge(kPixel);
    for (const Vector3& point : points_seen_from(kX, camera)) {
      expect_correct_jacobians(edge, kX, point, camera);
      expect_correct_jacobians(edge, Product<SE3, Camera>(kX, camera), point);
      expect_correct_jacobians(CalibratedReprojection<Camera>(kPixel, camera), kX, point);
    }
    for (const Vector3& point : points_seen_from(kX * kP, camera))
      expect_correct_jacobians(edge, kX, point, kP, camera);
  });
}

TEST(Reprojection, HasAnalyticJacobiansForEveryModel) {
  for_each_camera([](const auto& camera) {
    using Camera = std::remove_cvref_t<decltype(camera)>;
    EXPECT_TRUE((detail::kAnalytic<Reprojection<Camera>, SE3, Vector3, Camera>));
    EXPECT_TRUE((detail::kAnalytic<Reprojection<Camera>, Product<SE3, Camera>, Vector3>));
    EXPECT_TRUE((detail::kAnalytic<Reprojection<Camera>, SE3, Vector3, SE3, Camera>));
    EXPECT_TRUE((detail::kAnalytic<CalibratedReprojection<Camera>, SE3, Vector3>));
  });
}

TEST(Reprojection, WorksWithRotationVectorsAsTangents) {
  const SE3RotationVector x(kX.translation(), kX.quaternion());
  const PinholeCamera camera(500, 510, 320, 240);
  const Vector3 point = kX * Vector3(0.1, 0.2, 2);
  EXPECT_EQ(Reprojection<PinholeCamera>(kPixel).error(x, point, camera),
            Reprojection<PinholeCamera>(kPixel).error(kX, point, camera));
  expect_correct_jacobians(Reprojection<PinholeCamera>(kPixel), x, point, camera);
}

TEST(Reprojection, IsTheProjectionMinusTheMeasuredPixel) {
  const PinholeCamera camera(100, 200, 10, 20);
  const Vector2 error(1, 2);
  const SE3 shifted = pose(5, 0, 0, 0, 0, 0);
  EXPECT_EQ(Reprojection<PinholeCamera>(Vector2(59, 218)).error(shifted, Vector3(6, 2, 2), camera), error);
  EXPECT_EQ(Reprojection<PinholeCamera>(Vector2(59, 218)).error(SE3(), Vector3(6, 2, 2), shifted, camera),
            error);
  EXPECT_EQ(CalibratedReprojection<PinholeCamera>(Vector2(59, 218), camera).error(shifted, Vector3(6, 2, 2)),
            error);
}

TEST(Reprojection, HasAFiniteErrorIfTheCameraDoesNotSeeThePoint) {
  for_each_camera([](const auto& camera) {
    using Camera = std::remove_cvref_t<decltype(camera)>;
    Graph graph;
    const auto x = graph.add_vertex(SE3());
    const auto c = graph.add_vertex(camera);
    for (const Vector3& point : {Vector3(0, 0, 0), Vector3(0, 0, -kForward<Camera>), Vector3(1, 2, 0),
                                 Vector3(0.1, 0.2, -kForward<Camera>)}) {
      const auto edge = graph.add_edge(Reprojection<Camera>(kPixel), x, graph.add_vertex(point), c);
      EXPECT_TRUE(std::isfinite(graph.chi2(edge))) << Camera::kName;
      for (const Eigen::MatrixXd& block : graph.jacobian(edge))
        EXPECT_TRUE(block.allFinite()) << Camera::kName;
    }
  });
}

TEST(Reprojection, IsNamedAfterItsCamera) {
  EXPECT_EQ(Reprojection<BalCamera>::kName, "Reprojection<BAL>");
  EXPECT_EQ(CalibratedReprojection<OpenCvCamera>::kName, "CalibratedReprojection<OPENCV>");
  EXPECT_EQ((detail::type_name<Product<SE3, BalCamera>>()), "Product<SE3, BAL>");
}

TEST(Prior, HoldsTheParametersOfACamera) {
  const Prior prior(OpenCvCamera(500, 510, 320, 240, -0.1, 0.03, 0.002, -0.003));
  const OpenCvCamera camera(501, 508, 320, 240, 0, 0, 0, 0);
  EXPECT_EQ(prior.error(camera).head<2>(), Vector2(1, -2));
  expect_correct_jacobians(prior, camera);
}

TEST(Reprojection, CalibratesACameraThatSeveralPosesShare) {
  const OpenCvCamera truth(500, 510, 320, 240, -0.1, 0.03, 0.002, -0.003);
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  std::vector<VertexHandle<Vector3>> points;
  const auto camera = graph.add_vertex(OpenCvCamera(480, 490, 310, 250, 0, 0, 0, 0));
  for (int i = 0; i < 6; ++i)
    poses.push_back(graph.add_vertex(pose(0.5 * i, 0.2 * i * i, 0, 0.05 * i, 0.1, 0.2 * i)));
  for (int k = 0; k < 60; ++k) {
    points.push_back(
        graph.add_vertex(Vector3(2 * std::sin(1.3 * k), 2 * std::sin(2.1 * k), 5 + std::sin(3.7 * k))));
    graph.set_eliminated(points.back(), true);
  }
  for (const auto pose : poses) {
    for (const auto point : points) {
      const Vector2 pixel = truth.project(graph.estimate(pose).inverse_times(graph.estimate(point)));
      graph.add_edge(Reprojection<OpenCvCamera>(pixel), pose, point, camera);
    }
  }
  for (const auto pose : poses) graph.fix(pose);
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_LT((graph.estimate(camera).parameters - truth.parameters).norm(), 1e-6) << report;
}

}  // namespace
}  // namespace boxplus
