// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/simulate_bundle.h"
#include "diagnose/findings.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(DiagnosePoints, NamesAPointBehindAllItsCameras) {
  HealthyCameras world;
  const Vector3 point = world.graph.estimate(world.points[4]);
  world.graph.set_estimate(world.points[4], Vector3(point[0], point[1], -point[2]));
  const Finding finding = only(diagnose(world.graph), Kind::kBehindCameras);
  EXPECT_THAT(finding.ids, ElementsAre(104));
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_THAT(finding.text, HasSubstr("point 104 is behind all cameras that see it"));
}

TEST(DiagnosePoints, APointBehindOneOfItsCamerasIsNotNamed) {
  HealthyCameras world;
  world.graph.set_estimate(world.cameras[3], SE3(Vector3(3, 0, 30), SO3()));
  EXPECT_THAT(diagnose(world.graph), Not(HasFinding(Kind::kBehindCameras)));
}

TEST(DiagnosePoints, CamerasOfBalLookAlongTheNegativeAxis) {
  BundleSimulation bundle = simulate_bundle(BundleShape::kRing, {.cameras = 8, .points = 60});
  EXPECT_THAT(diagnose(bundle.graph), Not(HasFinding(Kind::kBehindCameras)));
  const auto point = bundle.graph.vertex<Vector3>(8);
  bundle.graph.set_estimate(point, Vector3(1000 * bundle.graph.estimate(point)));
  // The cameras look at an object inside of their ring, and the point is now far outside, behind those that
  // saw it.
  EXPECT_THAT(only(diagnose(bundle.graph), Kind::kBehindCameras).ids, ElementsAre(8));
}

TEST(DiagnosePoints, NamesAPointThatRunsToInfinity) {
  HealthyCameras world;
  world.graph.set_estimate(world.points[7], Vector3(1e6, 0, 1e7));
  const Finding finding = only(diagnose(world.graph), Kind::kFarPoint);
  EXPECT_THAT(finding.ids, ElementsAre(107));
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_THAT(finding.text, HasSubstr("times as far from the cameras as most points"));
}

/// A camera whose pose is T_camera_world.
struct InversePixel {
  Vector2 measurement;
  template <class S, class Point>
  Vector<S, 2> error(const BasicSE3<S>& T_camera_world, const Point& point) const {
    const auto p = (T_camera_world * point).eval();
    return Vector<S, 2>(500 * p[0] / p[2], 500 * p[1] / p[2]) - measurement;
  }
};

TEST(DiagnosePoints, UnderstandsPosesFromWorldToCamera) {
  Graph graph;
  std::vector<VertexHandle<SE3>> cameras;
  for (int i = 0; i < 3; ++i) {
    cameras.push_back(graph.add_vertex(SE3(Vector3(-i, 0, -20), SO3())));  // at z = 20
    graph.fix(cameras.back());
  }
  for (int k = 0; k < 12; ++k) {
    const auto point = graph.add_vertex(Vector3(k, std::sin(k), k == 5 ? 12 : 30), Id{100} + k);
    for (const auto& camera : cameras) graph.add_edge(InversePixel{Vector2(0, 0)}, camera, point);
  }
  EXPECT_THAT(only(diagnose(graph), Kind::kBehindCameras).ids, ElementsAre(105));
}

TEST(DiagnosePoints, ALidarSeesPointsOnAllSides) {
  Graph graph;
  const auto pose = graph.add_vertex(SE3());
  for (int k = 0; k < 30; ++k) {
    const Vector3 point(0, std::sin(k), k < 28 ? 1 : -1);
    graph.add_edge(PointObservation3(point), pose, graph.add_vertex(point));
  }
  EXPECT_THAT(diagnose(graph), Not(HasFinding(Kind::kBehindCameras)));
}

/// Cameras at about the same place that look in all directions, each at points of its own. `read` is applied
/// to T_camera_world, as a wrong reader would.
template <class Read>
Diagnosis of_misread_cameras(Read&& read) {
  Graph graph;
  const PinholeCamera model(500, 500, 320.0, 240.0);
  for (int k = 0; k < 12; ++k) {
    const SE3 truth(Vector3(0.1 * k, 0.2, 0.3),
                    SO3::from_rotation_vector(Vector3(0.4 * k, 0.7 * k, 1 - 0.3 * k)));
    const auto camera = graph.add_vertex(read(truth.inverse()).inverse());
    for (int i = 0; i < 6; ++i) {
      const Vector3 local(3 * std::sin(1.3 * i + k), 3 * std::sin(2.1 * i), 10);
      graph.add_edge(CalibratedReprojection<PinholeCamera>(model.project(local), model), camera,
                     graph.add_vertex(Vector3(truth * local)));
    }
  }
  return diagnose(graph);
}

TEST(DiagnosePoints, NamesQuaternionsWithTheWrongOrder) {
  const auto w_last_read_as_first = [](const SE3& x) {
    const SE3::Quaternion q = x.quaternion();
    return SE3(x.translation(), SE3::Quaternion{q.y, q.z, q.w, q.x});
  };
  const Finding finding = only(of_misread_cameras(w_last_read_as_first), Kind::kBehindCameras);
  EXPECT_EQ(finding.severity, Severity::kWarning);
  EXPECT_THAT(finding.text, HasSubstr("with w at the other end of the quaternions, 100 % of the points"));
}

TEST(DiagnosePoints, NamesPosesThatAreTheInverse) {
  const auto inverse = [](const SE3& x) { return x.inverse(); };
  const Finding finding = only(of_misread_cameras(inverse), Kind::kBehindCameras);
  EXPECT_THAT(finding.text, HasSubstr("check whether"));
}

TEST(DiagnosePoints, CamerasThatAreReadRightAreNotSuspected) {
  EXPECT_THAT(of_misread_cameras([](const SE3& x) { return x; }), Not(HasFinding(Kind::kBehindCameras)));
}

}  // namespace
}  // namespace boxplus
