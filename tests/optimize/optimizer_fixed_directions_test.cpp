// SPDX-License-Identifier: BSD-3-Clause
// optimize() on graphs in which Graph::fix_directions() fixes some tangent directions of vertices.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>

#include "boxplus/covariance/covariance.h"
#include "boxplus/manifold/product.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/huber.h"
#include "boxplus/robust/redescending.h"
#include "boxplus/types/slam3d.h"
#include "linear/every_solver.h"
#include "optimize/table_entries.h"

namespace boxplus {
namespace {

constexpr int kOutOfPlane[] = {2, 3, 4};  // the directions that leave the plane: z, roll, pitch

SE3 planar(double x, double y, double angle, double z = 0.7) {
  return SE3(Vector3(x, y, z), detail::Quaternion<double>{0, 0, std::sin(angle / 2), std::cos(angle / 2)});
}

struct Drive {
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  std::vector<VertexHandle<Vector3>> points;
};

/// A vehicle on a plane that drives in a circle and sees points. Its measurements are tilted and noisy, so
/// that the optimum without fixed directions is not in the plane.
Drive make_drive(int count = 12) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.05);
  const auto disturb = [&](const SE3& x) {
    double delta[6];
    for (double& d : delta) d = noise(random);
    return Manifold<SE3>::oplus(x, delta);
  };
  Drive drive;
  std::vector<SE3> truth;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * kPi * k / count;
    truth.push_back(planar(5 * std::cos(angle), 5 * std::sin(angle), angle + kPi / 2));
    drive.poses.push_back(drive.graph.add_vertex(
        planar(5 * std::cos(angle) + noise(random), 5 * std::sin(angle), angle + kPi / 2 + noise(random))));
  }
  for (int k = 0; k < 6; ++k)
    drive.points.push_back(drive.graph.add_vertex(Vector3(k, 2 - k, 1.5 + 0.1 * k)));
  const auto n = static_cast<std::size_t>(count);
  for (std::size_t k = 0; k < n; ++k) {
    drive.graph.add_edge(Between<SE3>(disturb(truth[k].inverse() * truth[(k + 1) % n])), 10.0, drive.poses[k],
                         drive.poses[(k + 1) % n]);
    for (std::size_t p = k % 2; p < drive.points.size(); p += 2) {
      const Vector3 seen = truth[k].inverse_times(Vector3(drive.graph.estimate(drive.points[p])));
      drive.graph.add_edge(
          PointObservation3(Vector3(seen + Vector3(noise(random), noise(random), noise(random)))),
          drive.poses[k], drive.points[p]);
    }
  }
  for (const auto& pose : drive.poses) drive.graph.fix_directions(pose, kOutOfPlane);
  return drive;
}

void expect_in_plane(const Drive& drive) {
  for (const auto& pose : drive.poses) {
    const auto v = drive.graph.estimate(pose).vector();
    EXPECT_EQ(v[2], 0.7);
    EXPECT_EQ(v[3], 0);
    EXPECT_EQ(v[4], 0);
  }
}

/// The norm of the gradient in all directions that are not fixed.
double free_gradient(const Graph& graph) {
  std::map<VertexRef, Eigen::VectorXd> gradient;
  for (const EdgeRef& edge : graph.all_edges()) {
    const auto vertices = graph.vertices(edge);
    const auto J = graph.jacobian(edge);
    const auto error = graph.error(edge);
    const Eigen::VectorXd weighted =
        graph.weight(edge) * graph.information(edge).matrix() *
        Eigen::Map<const Eigen::VectorXd>(error.data(), static_cast<Eigen::Index>(error.size()));
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      auto& g = gradient.try_emplace(vertices[i], Eigen::VectorXd::Zero(J[i].cols())).first->second;
      g += J[i].transpose() * weighted;
    }
  }
  double sum = 0;
  for (auto& [vertex, g] : gradient) {
    if (graph.is_fixed(vertex)) continue;
    for (const int direction : graph.fixed_directions(vertex)) g[direction] = 0;
    sum += g.squaredNorm();
  }
  return std::sqrt(sum);
}

TEST(FixedDirections, KeepAVehicleInThePlaneWithEverySolver) {
  std::optional<double> chi2;
  for (const bool eliminate : {false, true}) {
    for (const detail::LinearSolverEntry& solver : every_solver()) {
      for (const AlgorithmKind algorithm : every_algorithm()) {
        Drive drive = make_drive();
        drive.graph.fix(drive.poses[0]);
        for (const auto& point : drive.points) drive.graph.set_eliminated(point, eliminate);
        Options options;
        options.linear_solver = solver.kind;
        options.algorithm = algorithm;
        const Report report = optimize(drive.graph, options);
        EXPECT_EQ(report.status, Report::Status::kConverged) << report.message;
        EXPECT_LT(report.chi2_final, report.chi2_initial);
        EXPECT_EQ(report.scalars, 11 * 3 + 6 * 3u);
        expect_in_plane(drive);
        EXPECT_LE(free_gradient(drive.graph), 1e-2);
        if (!chi2) chi2 = report.chi2_final;
        EXPECT_NEAR(report.chi2_final, *chi2, 1e-6 * *chi2);
      }
    }
  }
}

TEST(FixedDirections, ApplyWithoutAnyFixedVertex) {
  Drive anchored = make_drive(), loose = make_drive();
  anchored.graph.fix(anchored.poses[0]);
  ASSERT_EQ(optimize(anchored.graph).status, Report::Status::kConverged);
  const Report report = optimize(loose.graph);
  EXPECT_EQ(report.status, Report::Status::kConverged) << report.message;
  expect_in_plane(loose);
  EXPECT_NEAR(report.chi2_final, anchored.graph.chi2(), 1e-6 * report.chi2_final);
}

TEST(FixedDirections, ApplyWithRobustKernelsAndTheTriggsCorrection) {
  for (const bool triggs : {false, true}) {
    Drive drive = make_drive();
    drive.graph.fix(drive.poses[0]);
    for (const EdgeRef& edge : drive.graph.all_edges()) {
      if (edge.slot % 2 == 0) drive.graph.set_kernel(edge, Huber(0.1));
      if (edge.slot % 5 == 1) drive.graph.set_kernel(edge, Cauchy(0.5));
    }
    Options options;
    options.triggs_correction = triggs;
    const Report report = optimize(drive.graph, options);
    EXPECT_EQ(report.status, Report::Status::kConverged) << report.message;
    EXPECT_LT(report.chi2_final, report.chi2_initial);
    expect_in_plane(drive);
    EXPECT_LE(free_gradient(drive.graph), 5e-2);
  }
}

TEST(FixedDirections, ApplyToSubsetsAndLevels) {
  Drive drive = make_drive();
  for (const EdgeRef& edge : drive.graph.all_edges())
    drive.graph.set_level(edge, static_cast<int>(edge.pool));
  Options options;
  options.vertices = {drive.poses[3], drive.poses[4], drive.points[2]};
  options.level = -1;
  const SE3 before = drive.graph.estimate(drive.poses[5]);
  EXPECT_EQ(optimize(drive.graph, options).scalars, 3 + 3 + 3u);
  expect_in_plane(drive);
  EXPECT_EQ(before.vector(), drive.graph.estimate(drive.poses[5]).vector());
  options.vertices.clear();
  options.level = 0;
  drive.graph.fix(drive.poses[0]);
  EXPECT_EQ(optimize(drive.graph, options).status, Report::Status::kConverged);
  expect_in_plane(drive);
}

TEST(FixedDirections, HaveZeroCovariance) {
  Drive drive = make_drive();
  drive.graph.fix(drive.poses[0]);
  std::ignore = optimize(drive.graph);
  const Covariance all = covariance(drive.graph, {drive.poses[3], drive.points[1]});
  ASSERT_TRUE(all.ok()) << all.message();
  const Eigen::MatrixXd joint = all.joint();
  for (const int direction : kOutOfPlane) {
    EXPECT_EQ(joint.row(direction).norm(), 0);
    EXPECT_EQ(joint.col(direction).norm(), 0);
  }
  for (const int direction : {0, 1, 5}) EXPECT_GT(joint(direction, direction), 0);
  // Stiff priors instead of fixed directions lead to the same covariance.
  Drive stiff = make_drive();
  stiff.graph.fix(stiff.poses[0]);
  for (std::size_t k = 0; k < stiff.poses.size(); ++k) {
    const auto pose = stiff.poses[k];
    const SE3 here = drive.graph.estimate(drive.poses[k]);
    stiff.graph.set_estimate(pose, here);
    stiff.graph.fix_directions(pose, {});
    Vector<double, 6> weights;
    weights << 0, 0, 1e9, 1e9, 1e9, 0;
    stiff.graph.add_edge(Prior<SE3>(here), Eigen::MatrixXd(weights.asDiagonal()), pose);
  }
  for (std::size_t k = 0; k < stiff.points.size(); ++k)
    stiff.graph.set_estimate(stiff.points[k], drive.graph.estimate(drive.points[k]));
  const Eigen::MatrixXd expected = covariance(stiff.graph, {stiff.poses[3], stiff.points[1]}).joint();
  EXPECT_LE((joint - expected).norm(), 1e-6 * expected.norm());
}

TEST(FixedDirections, KeepTheFocalLengthWhileTheDistortionMoves) {
  // u = f (1 + k r²) x / z; intrinsics are (f, k).
  const auto pixel = [](double x) {
    return [x](const auto& intrinsics, const auto& offset) {
      return intrinsics[0] * (1.0 + intrinsics[1] * x * x) * x + offset - 400.0 * (1 + 0.03 * x * x) * x;
    };
  };
  Graph graph;
  const auto intrinsics = graph.add_vertex(Vector2(410, 0));
  const auto offset = graph.add_vertex(1.0);
  for (const double x : {-0.9, -0.5, -0.1, 0.3, 0.6, 0.8}) graph.add_edge(pixel(x), intrinsics, offset);
  graph.fix_directions(intrinsics, {0});
  ASSERT_EQ(optimize(graph).status, Report::Status::kConverged);
  EXPECT_EQ(graph.estimate(intrinsics)[0], 410);
  EXPECT_NE(graph.estimate(intrinsics)[1], 0);
  graph.fix_directions(intrinsics, {});
  ASSERT_EQ(optimize(graph).status, Report::Status::kConverged);
  EXPECT_NEAR(graph.estimate(intrinsics)[0], 400, 1e-6);
  EXPECT_NEAR(graph.estimate(intrinsics)[1], 0.03, 1e-8);
}

TEST(FixedDirections, CanBeReadReplacedAndRemoved) {
  Graph graph;
  const auto x = graph.add_vertex(Vector3(1, 2, 3));
  EXPECT_TRUE(graph.fixed_directions(x).empty());
  graph.fix_directions(x, {2, 0, 2});
  EXPECT_THAT(graph.fixed_directions(x), testing::ElementsAre(0, 2));
  const auto revision = graph.revision();
  graph.fix_directions(x, {0, 2});
  EXPECT_EQ(graph.revision(), revision);
  EXPECT_THROW(graph.fix_directions(x, {3}), InvalidArgument);
  EXPECT_THROW(graph.fix_directions(x, {-1}), InvalidArgument);
  EXPECT_THAT(graph.fixed_directions(x), testing::ElementsAre(0, 2));
  const Graph copy = graph;
  EXPECT_THAT(copy.fixed_directions(x), testing::ElementsAre(0, 2));
  graph.remove(x);
  EXPECT_TRUE(graph.fixed_directions(graph.add_vertex(Vector3(0, 0, 0))).empty());
}

TEST(FixedDirections, OfAWholeTangentHaveTheEffectOfAFixedVertex) {
  Drive drive = make_drive(), fixed = make_drive();
  drive.graph.fix_directions(drive.poses[0], {0, 1, 2, 3, 4, 5});
  fixed.graph.fix(fixed.poses[0]);
  EXPECT_EQ(optimize(drive.graph).chi2_final, optimize(fixed.graph).chi2_final);
  EXPECT_EQ(covariance(drive.graph, {drive.poses[0]}).of(drive.poses[0]), Eigen::MatrixXd::Zero(6, 6));
}

TEST(FixedDirections, ChangedAfterARunApplyInTheNextRun) {
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  for (int k = 0; k < 5; ++k) poses.push_back(graph.add_vertex(planar(k, 0, 0)));
  const SE3 tilted(Vector3(1, 0, 0.2), detail::Quaternion<double>{0.02, -0.03, 0.01, 1});
  for (std::size_t k = 0; k + 1 < poses.size(); ++k)
    graph.add_edge(Between<SE3>(tilted), poses[k], poses[k + 1]);
  graph.push();
  Optimizer optimizer(graph);
  ASSERT_EQ(optimizer.run().status, Report::Status::kConverged);
  EXPECT_NE(graph.estimate(poses[4]).vector()[2], 0.7);
  graph.pop();
  for (const auto& pose : poses) graph.fix_directions(pose, kOutOfPlane);
  EXPECT_FALSE(optimizer.run().plan_reused);
  for (const auto& pose : poses) EXPECT_EQ(graph.estimate(pose).vector()[2], 0.7);
}

TEST(FixedDirections, DisableInitialGuesses) {
  Drive drive = make_drive();
  drive.graph.fix(drive.poses[0]);
  Options options;
  options.start = Start::kChordal;
  const Report report = optimize(drive.graph, options);
  EXPECT_EQ(report.start.used, Start::kCurrent);
  EXPECT_NE(report.start.note, "");
  expect_in_plane(drive);
}

}  // namespace
}  // namespace boxplus
