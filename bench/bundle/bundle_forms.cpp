// SPDX-License-Identifier: BSD-3-Clause
#include "bundle/bundle_forms.h"

#include <cmath>
#include <vector>

#include "boxplus/manifold/product.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/types/ba.h"

namespace boxplus::bench {
namespace {

/// A camera as a user would write it: T_camera_world, and f, k1, k2.
using UserCamera = Product<SE3, Vector3>;

struct UserReprojection {
  double u, v;
  template <class S>
  Vector<S, 2> error(const Product<BasicSE3<S>, Vector<S, 3>>& camera, const Vector<S, 3>& point) const {
    const Vector<S, 3> y = camera.template get<0>() * point, k = camera.template get<1>();
    const S px = -y[0] / y[2], py = -y[1] / y[2];
    const S r2 = px * px + py * py;
    const S scale = k[0] * (S(1) + r2 * (k[1] + r2 * k[2]));
    return {scale * px - S(u), scale * py - S(v)};
  }
};

/// The same with a vertex for T_camera_world and one for f, k1, k2.
struct UserReprojectionOfThree {
  double u, v;
  template <class S>
  Vector<S, 2> error(const BasicSE3<S>& pose, const Vector<S, 3>& intrinsics,
                     const Vector<S, 3>& point) const {
    const Vector<S, 3> y = pose * point;
    const S px = -y[0] / y[2], py = -y[1] / y[2];
    const S r2 = px * px + py * py;
    const S scale = intrinsics[0] * (S(1) + r2 * (intrinsics[1] + r2 * intrinsics[2]));
    return {scale * px - S(u), scale * py - S(v)};
  }
};

struct UserReprojectionWithJacobians : UserReprojection {
  template <class A, class B>
  void jacobians(const UserCamera& camera, const Vector3& point, A& J_camera, B& J_point) const {
    const SE3& T = camera.get<0>();
    const Vector3& k = camera.get<1>();
    const Vector3 y = T * point;
    const double px = -y[0] / y[2], py = -y[1] / y[2], r2 = px * px + py * py;
    const double distortion = 1 + r2 * (k[1] + r2 * k[2]), slope = 2 * (k[1] + 2 * r2 * k[2]);
    Matrix<double, 2, 2> J_plane;
    J_plane << distortion + slope * px * px, slope * px * py, slope * px * py, distortion + slope * py * py;
    Matrix<double, 2, 3> plane;
    plane << -1 / y[2], 0, -px / y[2], 0, -1 / y[2], -py / y[2];
    const Matrix<double, 2, 3> J_world = k[0] * J_plane * plane * T.rotation();
    J_point = J_world;
    J_camera.template leftCols<3>() = J_world;
    J_camera.template middleCols<3>(3) = -2 * J_world * detail::cross_matrix(point[0], point[1], point[2]);
    J_camera.template rightCols<3>() << distortion * px, k[0] * r2 * px, k[0] * r2 * r2 * px, distortion * py,
        k[0] * r2 * py, k[0] * r2 * r2 * py;
  }
};

SE3 camera_from_world(const std::array<double, 9>& c) {
  return {Vector3(c[3], c[4], c[5]), SO3::from_rotation_vector(Vector3(c[0], c[1], c[2]))};
}

/// Adds the observations. edge(camera, point, observation) adds one of them.
template <class AddEdge>
void add_observations(const BundleProblem& problem, Graph& graph, AddEdge&& edge) {
  std::vector<VertexHandle<Vector3>> points;
  for (const auto& [x, y, z] : problem.points) {
    points.push_back(graph.add_vertex(Vector3(x, y, z)));
    graph.set_eliminated(points.back(), true);
  }
  for (const BundleProblem::Observation& o : problem.observations) edge(o.camera, points[o.point], o);
}

Graph with_one_vertex_per_camera(const BundleProblem& problem) {
  Graph graph;
  std::vector<VertexHandle<Product<SE3, BalCamera>>> cameras;
  for (const auto& c : problem.cameras) {
    cameras.push_back(graph.add_vertex(
        Product<SE3, BalCamera>(camera_from_world(c).inverse(), BalCamera(c[6], c[7], c[8]))));
  }
  add_observations(problem, graph, [&](std::size_t camera, const auto& point, const auto& o) {
    graph.add_edge(Reprojection<BalCamera>(Vector2(o.x, o.y)), cameras[camera], point);
  });
  return graph;
}

Graph with_vertices_of_intrinsics(const BundleProblem& problem, bool are_shared) {
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  std::vector<VertexHandle<BalCamera>> intrinsics;
  for (const auto& c : problem.cameras) {
    poses.push_back(graph.add_vertex(camera_from_world(c).inverse()));
    if (intrinsics.empty() || !are_shared)
      intrinsics.push_back(graph.add_vertex(BalCamera(c[6], c[7], c[8])));
  }
  add_observations(problem, graph, [&](std::size_t camera, const auto& point, const auto& o) {
    graph.add_edge(Reprojection<BalCamera>(Vector2(o.x, o.y)), poses[camera], point,
                   intrinsics[are_shared ? 0 : camera]);
  });
  return graph;
}

/// The direction of a pixel of BAL, for a camera that looks along z and whose y points down.
Vector3 direction_of(double x, double y, double f, double k1, double k2) {
  const double distorted = std::hypot(x, y) / f;
  double r = distorted;  // the solution of r (1 + k1 r² + k2 r⁴) = distorted, by Newton's method
  for (int k = 0; k < 20; ++k) {
    const double r2 = r * r;
    r -= (r * (1 + r2 * (k1 + r2 * k2)) - distorted) / (1 + r2 * (3 * k1 + 5 * r2 * k2));
  }
  const double scale = distorted > 0 ? r / (distorted * f) : 0;
  return {scale * x, -scale * y, 1};
}

/// A vertex for the pose and one for the intrinsics of each camera, which camera_of(BAL's f, k1, k2) returns.
/// BAL's cameras look along −z, and their y points up. So the cameras of COLMAP are turned around x. Their
/// principal points are fixed. A camera sees its pixels in the same directions as BAL's camera.
template <class CameraOf>
Graph with_colmap_cameras(const BundleProblem& problem, CameraOf&& camera_of) {
  using Camera = decltype(camera_of(1.0, 0.0, 0.0));
  constexpr int kCenter = Camera::Model::kFocalLengths;
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  std::vector<VertexHandle<Camera>> intrinsics;
  const SE3 half_turn(Vector3(0, 0, 0), detail::Quaternion<double>{1, 0, 0, 0});
  for (const auto& c : problem.cameras) {
    poses.push_back(graph.add_vertex(camera_from_world(c).inverse() * half_turn));
    intrinsics.push_back(graph.add_vertex(camera_of(c[6], c[7], c[8])));
    graph.fix_directions(intrinsics.back(), {kCenter, kCenter + 1});
  }
  add_observations(problem, graph, [&](std::size_t camera, const auto& point, const auto& o) {
    const auto& c = problem.cameras[camera];
    const Vector2 pixel = camera_of(c[6], c[7], c[8]).project(direction_of(o.x, o.y, c[6], c[7], c[8]));
    graph.add_edge(Reprojection<Camera>(pixel), poses[camera], point, intrinsics[camera]);
  });
  return graph;
}

template <class Edge>
Graph with_custom_edges(const BundleProblem& problem) {
  Graph graph;
  std::vector<VertexHandle<UserCamera>> cameras;
  for (const auto& c : problem.cameras)
    cameras.push_back(graph.add_vertex(UserCamera(camera_from_world(c), Vector3(c[6], c[7], c[8]))));
  add_observations(problem, graph, [&](std::size_t camera, const auto& point, const auto& o) {
    graph.add_edge(Edge{o.x, o.y}, cameras[camera], point);
  });
  return graph;
}

Graph with_custom_edges_of_three(const BundleProblem& problem) {
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  std::vector<VertexHandle<Vector3>> intrinsics;
  for (const auto& c : problem.cameras) {
    poses.push_back(graph.add_vertex(camera_from_world(c)));
    intrinsics.push_back(graph.add_vertex(Vector3(c[6], c[7], c[8])));
  }
  add_observations(problem, graph, [&](std::size_t camera, const auto& point, const auto& o) {
    graph.add_edge(UserReprojectionOfThree{o.x, o.y}, poses[camera], intrinsics[camera], point);
  });
  return graph;
}

}  // namespace

std::string_view describe(BundleForm form) {
  switch (form) {
    case BundleForm::kCamera:
      return "one vertex per camera";
    case BundleForm::kSeparateIntrinsics:
      return "intrinsics of each camera as a vertex";
    case BundleForm::kSimpleRadial:
      return "the same with SIMPLE_RADIAL";
    case BundleForm::kRadial:
      return "the same with RADIAL";
    case BundleForm::kOpenCv:
      return "the same with OPENCV";
    case BundleForm::kOpenCvFisheye:
      return "the same with OPENCV_FISHEYE";
    case BundleForm::kSharedIntrinsics:
      return "shared intrinsics as a vertex";
    case BundleForm::kCustomEdge:
      return "a user's edge with automatic derivatives";
    case BundleForm::kCustomEdgeOfThree:
      return "a user's edge with automatic derivatives, intrinsics of each camera as a vertex";
    case BundleForm::kCustomJacobians:
      return "a user's edge with its own Jacobians";
  }
  return "";
}

Graph make_bundle_graph(const BundleProblem& problem, BundleForm form) {
  switch (form) {
    case BundleForm::kCustomEdge:
      return with_custom_edges<UserReprojection>(problem);
    case BundleForm::kCustomEdgeOfThree:
      return with_custom_edges_of_three(problem);
    case BundleForm::kCustomJacobians:
      return with_custom_edges<UserReprojectionWithJacobians>(problem);
    case BundleForm::kCamera:
      return with_one_vertex_per_camera(problem);
    case BundleForm::kSimpleRadial:
      return with_colmap_cameras(
          problem, [](double f, double k1, double) { return SimpleRadialCamera(f, 0.0, 0.0, k1); });
    case BundleForm::kRadial:
      return with_colmap_cameras(
          problem, [](double f, double k1, double k2) { return RadialCamera(f, 0.0, 0.0, k1, k2); });
    case BundleForm::kOpenCv:
      return with_colmap_cameras(problem, [](double f, double k1, double k2) {
        return OpenCvCamera(f, f, 0.0, 0.0, k1, k2, 0.0, 0.0);
      });
    case BundleForm::kOpenCvFisheye:
      return with_colmap_cameras(problem, [](double f, double, double) {
        return OpenCvFisheyeCamera(f, f, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
      });
    default:
      return with_vertices_of_intrinsics(problem, form == BundleForm::kSharedIntrinsics);
  }
}

}  // namespace boxplus::bench
