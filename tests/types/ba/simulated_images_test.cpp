// SPDX-License-Identifier: BSD-3-Clause
// For every edge of g2o's types sba, sim3 and icp: a simulated problem, whose chi2 at the minimum agrees with
// its degrees of freedom. A wrong sign, order or information would make chi2 much larger or smaller.
#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <type_traits>

#include "boxplus/manifold/convert_to.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/ba.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {
namespace {

constexpr double kSigma = 0.5;  // pixels
constexpr int kCameras = 8, kPoints = 40;

/// Cameras on an arc around points, which look at the points.
class World {
 public:
  World() {
    for (int i = 0; i < kCameras; ++i) {
      const double angle = 0.25 * (i - 3.5);  // the camera at angle 0 is at (0, 0, −10), and looks along z
      const detail::Quaternion<double> q = detail::RotationVectorChart::exp(0.0, -angle, 0.0);
      poses.emplace_back(Vector3(10 * std::sin(angle), 0.3 * i - 1, -10 * std::cos(angle)), q);
    }
    for (int k = 0; k < kPoints; ++k) points.push_back(Vector3(2 * uniform(), 2 * uniform(), 2 * uniform()));
  }

  double uniform() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  template <int N>
  Vector<double, N> noise(double sigma) {
    Vector<double, N> n;
    for (double& value : n) value = sigma * std::normal_distribution<double>()(random_);
    return n;
  }
  /// x, moved by a random step.
  template <class T>
  T disturbed(const T& x, double sigma) {
    return Manifold<T>::oplus(x, noise<Manifold<T>::kDim>(sigma).eval().data());
  }

  std::vector<SE3> poses;
  std::vector<Vector3> points;

 private:
  std::mt19937 random_{7};
};

Information weight(double sigma) {
  return Information(1 / (sigma * sigma));
}

/// Optimizes, and compares chi2 with the degrees of freedom: rows − dimensions.
void expect_chi2_near(Graph& graph, int degrees_of_freedom) {
  ASSERT_GT(degrees_of_freedom, 50);
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << to_string(report.status);
  EXPECT_LT(std::abs(report.chi2_final - degrees_of_freedom), 5 * std::sqrt(2.0 * degrees_of_freedom))
      << "chi2 " << report.chi2_final << ", degrees of freedom " << degrees_of_freedom;
}

const StereoCamera kCamera{Vector<double, 4>(500, 320, 240, 0.2)};
const PinholeCamera kPinhole(500, 510, 320, 240);
const StereoIntrinsics kIntrinsics{Vector<double, 4>(500, 510, 320, 240), 0.2};

/// Every camera sees every point. `camera_of` makes the vertex of a pose, and `edge_of` makes the edge of an
/// image; `extra` are its other vertices. The first two cameras are fixed.
template <int Rows, class CameraOf, class EdgeOf, class... Extra>
void expect_chi2_of_images(Graph& graph, CameraOf&& camera_of, EdgeOf&& edge_of, const Extra&... extra) {
  World world;
  using Camera = decltype(camera_of(SE3()));
  std::vector<Camera> truth;
  std::vector<VertexHandle<Camera>> cameras;
  for (const SE3& pose : world.poses) {
    truth.push_back(camera_of(pose));
    const bool is_fixed = truth.size() <= 2;
    cameras.push_back(graph.add_vertex(is_fixed ? truth.back() : world.disturbed(truth.back(), 0.01)));
    if (is_fixed) graph.fix(cameras.back());
  }
  for (const Vector3& point : world.points) {
    const auto p = graph.add_vertex(world.disturbed(point, 0.05));
    for (int i = 0; i < kCameras; ++i) {
      Vector<double, Rows> zero;
      zero.setZero();
      const Vector<double, Rows> image = edge_of(zero).error(point, truth[i], graph.estimate(extra)...);
      graph.add_edge(edge_of(image + world.noise<Rows>(kSigma)), weight(kSigma), p, cameras[i], extra...);
    }
  }
  int dims = (kCameras - 2) * Manifold<Camera>::kDim + 3 * kPoints;
  if constexpr (std::is_same_v<std::invoke_result_t<EdgeOf, Vector<double, Rows>>, SimilarityImage>) {
    // The image in the first camera does not depend on the scale of its frame.
    for (int i = 2; i < kCameras; ++i) graph.fix_directions(cameras[i], {6});
    dims -= kCameras - 2;
  }
  expect_chi2_near(graph, Rows * kCameras * kPoints - dims);
}

SE3RotationVector rotation_vector_pose(const SE3& x) {
  return convert_to<SE3RotationVector>(x);
}
StereoPose stereo_pose(const SE3& x) {
  return {x, kIntrinsics};
}

template <int Rows>
void expect_chi2_of_all_images() {
  using Z = Vector<double, Rows>;
  const auto image = [](const Z& z) { return PointImage<Rows>(z); };
  {
    Graph graph;
    const auto camera = graph.add_parameter(kCamera);
    expect_chi2_of_images<Rows>(graph, rotation_vector_pose, image, camera);
  }
  {
    Graph graph;
    const auto camera = graph.add_parameter(kCamera);
    expect_chi2_of_images<Rows>(
        graph, [](const SE3& x) { return x; }, image, camera);
  }
  {
    Graph graph;
    expect_chi2_of_images<Rows>(graph, stereo_pose, image);
  }
  {
    Graph graph;
    expect_chi2_of_images<Rows>(graph, rotation_vector_pose,
                                [](const Z& z) { return CalibratedPointImage<Rows>(z, kPinhole, 100); });
  }
}

TEST(SimulatedImages, OfOneCameraEndAtTheChi2OfTheirNoise) {
  expect_chi2_of_all_images<2>();
}

TEST(SimulatedImages, OfStereoCamerasEndAtTheChi2OfTheirNoise) {
  expect_chi2_of_all_images<3>();
}

TEST(SimulatedImages, WithIntrinsicsAsAVertexEndAtTheChi2OfTheirNoise) {
  Graph graph;
  const auto intrinsics = graph.add_parameter(kIntrinsics);
  const auto camera_of = [](const SE3& x) { return StereoPose{x, StereoIntrinsics{}}; };
  expect_chi2_of_images<2>(
      graph, camera_of, [](const Vector2& z) { return PointImage<2>(z); }, intrinsics);
}

SimilarityCamera similarity_camera(const SE3& x) {
  return {LoggedSim3(Sim3(x.quaternion(), x.translation(), 1.5)), kPinhole, kPinhole};
}

TEST(SimulatedImages, OfSimilaritiesEndAtTheChi2OfTheirNoise) {
  Graph graph;
  expect_chi2_of_images<2>(graph, similarity_camera, [](const Vector2& z) { return SimilarityImage(z); });
}

TEST(SimulatedImages, OfInverseSimilaritiesEndAtTheChi2OfTheirNoise) {
  Graph graph;
  const auto camera_of = [](const SE3& x) {
    const SE3 inverse = x.inverse();
    return SimilarityCamera{LoggedSim3(Sim3(inverse.quaternion(), inverse.translation(), 1.5)), kPinhole,
                            kPinhole};
  };
  expect_chi2_of_images<2>(graph, camera_of, [](const Vector2& z) { return InverseSimilarityImage(z); });
}

template <int Rows>
void expect_chi2_of_known_points() {
  World world;
  Graph graph;
  for (const SE3& pose : world.poses) {
    const SE3RotationVector truth = rotation_vector_pose(pose);
    const auto x = graph.add_vertex(world.disturbed(truth, 0.05));
    for (const Vector3& point : world.points) {
      Vector<double, Rows> zero;
      zero.setZero();
      const Vector<double, Rows> image = KnownPointImage<Rows>(zero, point, kPinhole, 100).error(truth);
      graph.add_edge(KnownPointImage<Rows>(image + world.noise<Rows>(kSigma), point, kPinhole, 100),
                     weight(kSigma), x);
    }
  }
  expect_chi2_near(graph, kCameras * (Rows * kPoints - 6));
}

TEST(SimulatedImages, OfKnownPointsEndAtTheChi2OfTheirNoise) {
  expect_chi2_of_known_points<2>();
  expect_chi2_of_known_points<3>();
}

TEST(SimulatedImages, OfPointsWithInverseDepthEndAtTheChi2OfTheirNoise) {
  World world;
  Graph graph;
  const auto camera = graph.add_parameter(kCamera);
  std::vector<SE3RotationVector> truth;
  std::vector<VertexHandle<SE3RotationVector>> poses;
  for (const SE3& pose : world.poses) {
    truth.push_back(rotation_vector_pose(pose));
    const bool is_fixed = truth.size() <= 2;
    poses.push_back(graph.add_vertex(is_fixed ? truth.back() : world.disturbed(truth.back(), 0.01)));
    if (is_fixed) graph.fix(poses.back());
  }
  for (int k = 0; k < kPoints; ++k) {
    const int anchor = k % kCameras;
    const Vector3 p = truth[anchor].inverse_times(world.points[k]);
    const Vector3 psi_true(p[0] / p[2], p[1] / p[2], 1 / p[2]);
    const auto psi = graph.add_vertex(world.disturbed(psi_true, 0.005));
    for (int i = 0; i < kCameras; ++i) {
      if (i == anchor) continue;
      const Vector2 image =
          InverseDepthImage(Vector2(0, 0)).error(psi_true, truth[i], truth[anchor], kCamera);
      graph.add_edge(InverseDepthImage(image + world.noise<2>(kSigma)), weight(kSigma), psi, poses[i],
                     poses[anchor], camera);
    }
  }
  expect_chi2_near(graph, 2 * (kCameras - 1) * kPoints - 6 * (kCameras - 2) - 3 * kPoints);
}

/// `sigma` is the noise of the third value.
template <class E>
void expect_chi2_of_depth_images(double sigma) {
  World world;
  Graph graph;
  const Product<SE3, PinholeCamera> mounted(SE3(Vector3(0.1, 0.2, -0.3), world.poses[3].quaternion()),
                                            kPinhole);
  const auto camera = graph.add_parameter(mounted);
  std::vector<SE3> truth;
  std::vector<VertexHandle<SE3>> robots;
  for (const SE3& pose : world.poses) {
    truth.push_back(pose * mounted.get<0>().inverse());
    robots.push_back(graph.add_vertex(robots.empty() ? truth.back() : world.disturbed(truth.back(), 0.01)));
  }
  graph.fix(robots[0]);
  const double pixel = 1 / (kSigma * kSigma);
  const auto omega = Information::diagonal(std::vector{pixel, pixel, 1 / (sigma * sigma)});
  for (const Vector3& point : world.points) {
    const auto p = graph.add_vertex(world.disturbed(point, 0.05));
    for (int i = 0; i < kCameras; ++i) {
      const Vector3 image = E(Vector3(0, 0, 0)).error(truth[i], point, mounted);
      const Vector2 noise = world.noise<2>(kSigma);
      const double third = world.noise<1>(sigma)[0];
      graph.add_edge(E(image + Vector3(noise[0], noise[1], third)), omega, robots[i], p, camera);
    }
  }
  expect_chi2_near(graph, 3 * kCameras * kPoints - 6 * (kCameras - 1) - 3 * kPoints);
}

TEST(SimulatedImages, WithDepthEndAtTheChi2OfTheirNoise) {
  expect_chi2_of_depth_images<DepthImage>(0.05);
  expect_chi2_of_depth_images<DisparityImage>(0.001);
}

/// A loop of kCount poses with all relative measurements up to two poses apart. `measure(a, b, noise)` makes
/// the edge whose error at the true poses is `noise`.
template <class Vertex, class VertexOf, class Measure>
void expect_chi2_of_motions(VertexOf&& vertex_of, Measure&& measure) {
  constexpr int kDim = Manifold<Vertex>::kDim, kCount = 30;
  constexpr double kSmall = 0.01;
  World world;
  Graph graph;
  std::vector<Vertex> truth;
  std::vector<VertexHandle<Vertex>> vertices;
  for (int i = 0; i < kCount; ++i) {
    const double angle = 2 * kPi * i / kCount;
    truth.push_back(vertex_of(SE3(Vector3(5 * std::cos(angle), 5 * std::sin(angle), 0.1 * i),
                                  detail::RotationVectorChart::exp(0.1, -0.2, angle))));
    vertices.push_back(graph.add_vertex(i == 0 ? truth.back() : world.disturbed(truth.back(), 0.05)));
  }
  graph.fix(vertices[0]);
  for (int i = 0; i < kCount; ++i) {
    for (const int j : {(i + 1) % kCount, (i + 2) % kCount}) {
      const Vector<double, kDim> noise = world.noise<kDim>(kSmall);
      const auto edge = measure(truth[i], truth[j], noise);
      ASSERT_LT((edge.error(truth[i], truth[j]) - noise).norm(), 1e-12);
      graph.add_edge(edge, weight(kSmall), vertices[i], vertices[j]);
    }
  }
  expect_chi2_near(graph, kDim * (2 * kCount - (kCount - 1)));
}

TEST(SimulatedMotions, WithTwistsEndAtTheChi2OfTheirNoise) {
  using Pose = SE3RotationVector;
  expect_chi2_of_motions<Pose>(
      rotation_vector_pose, [](const Pose& a, const Pose& b, const Vector<double, 6>& noise) {
        Vector<double, 6> step;
        step << noise.tail<3>(), noise.head<3>();
        return TwistBetween(convert_to<SE3>(a.inverse() * Pose::exp(step).inverse() * b));
      });
}

TEST(SimulatedMotions, OfStereoCamerasEndAtTheChi2OfTheirNoise) {
  expect_chi2_of_motions<StereoPose>(
      stereo_pose, [](const StereoPose& a, const StereoPose& b, const Vector<double, 6>& noise) {
        const SE3 step = Manifold<SE3>::oplus(SE3(), noise.data());
        return CameraBetween(a.pose.inverse() * b.pose * step.inverse());
      });
}

TEST(SimulatedMotions, OfSimilaritiesEndAtTheChi2OfTheirNoise) {
  expect_chi2_of_motions<SimilarityCamera>(
      similarity_camera,
      [](const SimilarityCamera& a, const SimilarityCamera& b, const Vector<double, 7>& noise) {
        return SimilarityBetween(LoggedSim3(a.pose().inverse() * b.pose() * Sim3::exp(noise).inverse()));
      });
}

TEST(SimulatedDistances, OfStereoCamerasEndAtTheChi2OfTheirNoise) {
  constexpr double kSmall = 0.01;
  World world;
  Graph graph;
  std::vector<VertexHandle<StereoPose>> cameras;
  int rows = 0, dims = 0;
  for (const Vector3& point : world.points) {
    const auto x = graph.add_vertex(stereo_pose(SE3(point, detail::Quaternion<double>::identity())));
    graph.fix_directions(x, {3, 4, 5});  // distances say nothing about rotations
    for (const auto& other : cameras) {
      const double distance = (graph.estimate(other).translation() - point).norm();
      graph.add_edge(Range(distance + world.noise<1>(kSmall)[0]), weight(kSmall), other, x);
      ++rows;
    }
    cameras.push_back(x);
    dims += 3;
  }
  for (int i = 0; i < 3; ++i) graph.fix(cameras[i]);
  const int fixed_rows = 3;  // the distances between fixed cameras
  for (int i = 3; i < kPoints; ++i)
    graph.set_estimate(cameras[i], stereo_pose(SE3(Vector3(world.points[i] + world.noise<3>(0.02)),
                                                   detail::Quaternion<double>::identity())));
  expect_chi2_near(graph, rows - fixed_rows - (dims - 9));
}

TEST(SimulatedSurfaces, EndAtTheChi2OfTheirNoise) {
  constexpr double kScale = 0.01;
  World world;
  Graph graph;
  const SE3 first = world.poses[0], second = world.poses[1];
  const auto x0 = graph.add_vertex(first), x1 = graph.add_vertex(world.disturbed(second, 0.02));
  graph.fix(x0);
  const Vector3 z(0, 0, 1);
  for (const Vector3& point : world.points) {
    const Vector3 normal = Vector3(world.noise<3>(1)).normalized();
    const SurfaceMatch exact(Vector3(first.inverse_times(point)), normal,
                             Vector3(second.inverse_times(point)), z);
    // Noise with the covariance kScale² Ω⁻¹: in the directions of the surface, it is ten times as large.
    const Matrix<double, 3, 3> F = detail::frame_of_normal(normal);
    const Vector3 n = world.noise<3>(1);
    const Vector3 noise = kScale * F.transpose() * Vector3(10 * n[0], 10 * n[1], n[2]);
    graph.add_edge(SurfaceMatch(exact.measurement - noise, normal, exact.other_point, z),
                   Information(exact.information() / (kScale * kScale)), x0, x1);
  }
  expect_chi2_near(graph, 3 * kPoints - 6);
}

}  // namespace
}  // namespace boxplus
