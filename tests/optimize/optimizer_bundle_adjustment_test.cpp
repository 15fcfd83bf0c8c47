// SPDX-License-Identifier: BSD-3-Clause
// Bundle adjustment of public problems with custom edges. A camera is one vertex or two: pose and intrinsics.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "boxplus/boxplus.h"
#include "boxplus/manifold/product.h"
#include "boxplus/robust/huber.h"

namespace boxplus {
namespace {

/// A problem of the data set "Bundle adjustment in the large" (Agarwal, Snavely, Seitz & Szeliski, 2010).
struct BundleProblem {
  struct Observation {
    std::size_t camera, point;
    double u, v;
  };
  std::vector<std::array<double, 9>> cameras;  // rotation vector, translation, f, k1, k2
  std::vector<Vector3> points;
  std::vector<Observation> observations;
};

BundleProblem read_problem(std::istream& in) {
  BundleProblem problem;
  std::size_t cameras = 0, points = 0, observations = 0;
  in >> cameras >> points >> observations;
  problem.observations.resize(observations);
  for (auto& o : problem.observations) in >> o.camera >> o.point >> o.u >> o.v;
  problem.cameras.resize(cameras);
  for (auto& camera : problem.cameras) {
    for (double& value : camera) in >> value;
  }
  problem.points.resize(points);
  for (auto& point : problem.points) in >> point[0] >> point[1] >> point[2];
  return problem;
}

/// The camera model of that data set. The camera looks along −z. Its radial distortion is 1 + k1 r² + k2 r⁴.
template <class Pose, class Intrinsics, class Point>
auto reprojection_error(const Pose& T_camera_world, const Intrinsics& k, const Point& x, double u, double v) {
  const auto y = T_camera_world * x;
  const auto px = -y[0] / y[2], py = -y[1] / y[2];
  const auto r2 = px * px + py * py;
  const auto scale = k[0] * (1.0 + r2 * (k[1] + r2 * k[2]));
  return Vector<std::remove_const_t<decltype(r2)>, 2>(scale * px - u, scale * py - v);
}

using Camera = Product<SE3, Vector3>;

struct ByCamera {
  double u, v;
  template <class C, class X>
  auto error(const C& camera, const X& x) const {
    return reprojection_error(camera.template get<0>(), camera.template get<1>(), x, u, v);
  }
};

struct ByPoseAndIntrinsics {
  double u, v;
  template <class P, class K, class X>
  auto error(const P& pose, const K& intrinsics, const X& x) const {
    return reprojection_error(pose, intrinsics, x, u, v);
  }
};

SE3 pose_of(const std::array<double, 9>& camera) {
  return {Vector3(camera[3], camera[4], camera[5]),
          SO3::from_rotation_vector(Vector3(camera[0], camera[1], camera[2]))};
}

enum class Form { kCamera, kPoseAndIntrinsics };
enum class Fixed { kNothing, kFirstPose, kFirstCamera };

/// The graph of a problem. Its points are eliminated.
Graph make_graph(const BundleProblem& problem, Form form, Fixed fixed,
                 const std::shared_ptr<const RobustKernel>& kernel = nullptr) {
  Graph graph;
  std::vector<VertexHandle<Camera>> cameras;
  std::vector<VertexHandle<SE3>> poses;
  std::vector<VertexHandle<Vector3>> intrinsics, points;
  for (const auto& camera : problem.cameras) {
    const Vector3 k(camera[6], camera[7], camera[8]);
    if (form == Form::kCamera) {
      cameras.push_back(graph.add_vertex(Camera(pose_of(camera), k)));
    } else {
      poses.push_back(graph.add_vertex(pose_of(camera)));
      intrinsics.push_back(graph.add_vertex(k));
    }
  }
  for (const Vector3& x : problem.points) {
    points.push_back(graph.add_vertex(x));
    graph.set_eliminated(points.back(), true);
  }
  for (const auto& [camera, point, u, v] : problem.observations) {
    EdgeRef edge;
    if (form == Form::kCamera) {
      edge = graph.add_edge(ByCamera{u, v}, cameras[camera], points[point]);
    } else {
      edge = graph.add_edge(ByPoseAndIntrinsics{u, v}, poses[camera], intrinsics[camera], points[point]);
    }
    if (kernel) graph.set_kernel(edge, kernel);
  }
  if (fixed == Fixed::kNothing) return graph;
  if (form == Form::kCamera && fixed == Fixed::kFirstPose) {
    graph.fix_directions(cameras[0], std::vector{0, 1, 2, 3, 4, 5});
  } else if (form == Form::kCamera) {
    graph.fix(cameras[0]);
  } else {
    graph.fix(poses[0]);
    if (fixed == Fixed::kFirstCamera) graph.fix(intrinsics[0]);
  }
  return graph;
}

/// The number of iterations until ½ chi2 ≤ (1 + 1e-6) cost, or a very large number if this is never reached.
int iterations_to(const Report& report, double cost) {
  for (const IterationRecord& record : report.records) {
    if (record.chi2 / 2 <= cost * (1 + 1e-6)) return record.iteration;
  }
  return 1 << 20;
}

struct PublicProblem {
  const char* file;
  double best_cost;               ///< the best known ½ chi2 if no intrinsics are fixed
  double best_with_fixed_camera;  ///< the best known ½ chi2 if the first camera is fixed with its intrinsics
  int iterations;                 ///< the limit: 1.3 times the iterations of Ceres with DENSE_SCHUR
};

class PublicBundle : public testing::TestWithParam<PublicProblem> {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("BOXPLUS_DATA");
    std::ifstream in(std::string(folder ? folder : "") + "/bal/" + GetParam().file);
    if (!in) GTEST_SKIP() << GetParam().file << " is not in BOXPLUS_DATA";
    problem_ = read_problem(in);
  }
  BundleProblem problem_;
};

TEST_P(PublicBundle, ReachesItsOptimumInEveryFormWithFewIterations) {
  for (const Form form : {Form::kCamera, Form::kPoseAndIntrinsics}) {
    for (const Fixed fixed : {Fixed::kNothing, Fixed::kFirstPose, Fixed::kFirstCamera}) {
      Graph graph = make_graph(problem_, form, fixed);
      const Report report = optimize(graph, {.threads = 2});
      EXPECT_TRUE(report.converged()) << report;
      const double best =
          fixed == Fixed::kFirstCamera ? GetParam().best_with_fixed_camera : GetParam().best_cost;
      EXPECT_LE(iterations_to(report, best), GetParam().iterations)
          << "form " << static_cast<int>(form) << ", fixed " << static_cast<int>(fixed) << "\n"
          << report;
    }
  }
}

TEST_P(PublicBundle, ReportsThatTheScaleIsFreeIfOnlyOnePoseIsFixed) {
  Graph graph = make_graph(problem_, Form::kPoseAndIntrinsics, Fixed::kFirstPose);
  const Report report = optimize(graph, {.max_iterations = 0});
  ASSERT_EQ(report.gauge.free.size(), 1u);
  EXPECT_EQ(to_string(report.gauge.free[0]), "scale");
  EXPECT_EQ(report.gauge.free[0].directions, 1);
}

TEST_P(PublicBundle, ConvergesWithRobustKernels) {
  Graph graph = make_graph(problem_, Form::kCamera, Fixed::kNothing, std::make_shared<const Huber>(2.0));
  // Some points move toward infinity, so the last decreases of chi2 are small, and rounding errors decide how
  // many there are.
  const Report report = optimize(graph, {.max_iterations = 200});
  EXPECT_TRUE(report.converged()) << report;
}

INSTANTIATE_TEST_SUITE_P(BundleAdjustment, PublicBundle,
                         testing::Values(PublicProblem{"problem-16-22106-pre.txt", 18033.904, 59100.4540, 7},
                                         PublicProblem{"problem-21-11315-pre.txt", 30378.638, 46804.5951, 9},
                                         PublicProblem{"problem-49-7776-pre.txt", 13344.317, 13747.3817, 40}),
                         [](const auto& problem) {
                           return std::string(problem.param.file).substr(8, 2) + "Cameras";
                         });

}  // namespace
}  // namespace boxplus
