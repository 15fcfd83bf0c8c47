// SPDX-License-Identifier: BSD-3-Clause
// A run is converged only at a minimum: from nearly singular starts, far from the minimum, and among rounding
// errors.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>
#include <tuple>
#include <vector>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/simulate_bundle.h"
#include "boxplus/types/ba/bundle_parts.h"
#include "boxplus/types/range.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

/// The chi2 that runs from the present estimates reach with all algorithms and scales of damping.
double best_of_others(const Graph& graph) {
  double best = graph.chi2();
  for (const AlgorithmKind algorithm : {AlgorithmKind::kDogleg, AlgorithmKind::kLevenbergMarquardt}) {
    for (const auto damping : {Options::DampingScale::kIdentity, Options::DampingScale::kDiagonal}) {
      Graph copy = graph;
      best = std::min(best, optimize(copy, {.algorithm = algorithm, .damping = damping}).chi2_final);
    }
  }
  return best;
}

/// A run that is converged leaves nothing to gain for other runs from its result.
void expect_nothing_to_gain(const Graph& graph, const Report& report) {
  if (!report.converged()) return;
  constexpr double kExact = 1e-12;
  EXPECT_LE(report.chi2_final, 1.01 * best_of_others(graph) + kExact) << report;
}

/// Anchors at nearly the same height, and a point with a noisy distance to each of them, which starts at
/// their center. There, its height is nearly unobservable.
Graph ranges_to_coplanar_anchors(int anchors, double heights, std::mt19937_64& random) {
  std::uniform_real_distribution<double> wide(-10, 10), middle(-5, 5);
  std::normal_distribution<double> normal;
  constexpr double kSigma = 0.02;
  const Vector3 truth(middle(random), middle(random), -2);
  std::vector<Vector3> positions;
  Vector3 center = Vector3::Zero();
  for (int k = 0; k < anchors; ++k) {
    positions.emplace_back(wide(random), wide(random), heights * normal(random));
    center += positions.back() / anchors;
  }
  Graph graph;
  const auto point = graph.add_vertex(center);
  for (const Vector3& position : positions) {
    const auto anchor = graph.add_vertex(SE3(position, SO3()));
    graph.fix(anchor);
    graph.add_edge(Range((position - truth).norm() + kSigma * normal(random)), 1 / (kSigma * kSigma), anchor,
                   point);
  }
  return graph;
}

TEST(EndOfRun, IsAtAMinimumAlsoIfTheFirstStepIsNearlySingular) {
  std::mt19937_64 random(3);
  for (const double heights : {1e-8, 1e-6, 1e-5, 1e-4}) {
    int converged = 0;
    constexpr int kTrials = 50;
    for (int trial = 0; trial < kTrials; ++trial) {
      Graph graph = ranges_to_coplanar_anchors(4, heights, random);
      const double start = graph.chi2();
      const Report report = optimize(graph);
      expect_nothing_to_gain(graph, report);
      converged += report.converged() && report.chi2_final < 0.1 * start;
    }
    EXPECT_GE(converged, kTrials * 9 / 10) << heights;
  }
}

TEST(EndOfRun, IsAtAMinimumIfBearingsAreTakenAlongTheMotion) {
  Graph graph;
  const auto landmark = graph.add_vertex(Vector2(5, 1e-6));
  const double bearings[] = {0.5424195002705842, 0.6415011087932845, 0.7873981633974483};
  for (int k = 0; k < 3; ++k) {
    const auto pose = graph.add_vertex(SE2(k, 0, 0));
    graph.fix(pose);
    graph.add_edge(BearingObservation2(bearings[k]), 10000.0, pose, landmark);
  }
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_NEAR(report.chi2_final, 0.1046, 1e-3);
}

TEST(EndOfRun, IsAtAMinimumIfOneDirectionOfADistanceVanishesAtTheStart) {
  for (const double height : {0.0, 1e-9, 1e-6, 1e-3}) {
    Graph graph;
    const auto x = graph.add_vertex(Vector3(1.0 / 3, -1.0 / 3, 1 - height));
    for (const Vector3& anchor : {Vector3(1, 1, 1), Vector3(1, -1, 1), Vector3(-1, -1, 1)}) {
      graph.add_edge(
          [anchor](const auto& v) {
            using std::sqrt;
            using S = std::decay_t<decltype(v[0])>;
            const Vector<S, 3> d = v - anchor.template cast<S>();
            return sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - std::sqrt(3.0);
          },
          x);
    }
    const Report report = optimize(graph);
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_LT(report.chi2_final, 1e-12) << height;
  }
}

/// A square with sides of 20 km, whose Ω is that of 2 µm.
TEST(EndOfRun, IsConvergedIfOnlyRoundingErrorsRemain) {
  Graph graph;
  const double half = 1.5707963267948966;
  std::vector<VertexHandle<SE2>> poses;
  for (const SE2& pose : {SE2(138, 329, 0.03), SE2(19478, 362, -0.05), SE2(39785, -214, 1.6),
                          SE2(40110, 20120, 3.1), SE2(19850, 20230, -1.5)})
    poses.push_back(graph.add_vertex(pose));
  const double prior[] = {1.1111111e11, 1.1111111e11, 1e6}, odometry[] = {2.5e11, 2.5e11, 1e6};
  graph.add_edge(Prior(SE2()), Information::diagonal(prior), poses[0]);
  for (int k = 0; k < 5; ++k) {
    const double turn = k == 0 ? 0 : half;
    graph.add_edge(Between(SE2(20000, 0, turn)), Information::diagonal(odometry), poses[k],
                   poses[k < 4 ? k + 1 : 1]);
  }
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_LT(report.chi2_final, 1e-8);
  EXPECT_EQ(report.chi2_remark(), "");
}

/// The parameters are the shape, and whether intrinsics are held.
class EndOfBundleRun : public ::testing::TestWithParam<std::tuple<BundleShape, bool>> {};

TEST_P(EndOfBundleRun, IsAtAMinimumIfItIsConverged) {
  const BundleShape shape = std::get<0>(GetParam());
  const bool is_held = std::get<1>(GetParam());
  int early = 0;
  std::ostringstream reports;
  const auto run = [&](std::uint64_t seed, double pose_noise, double point_noise) {
    Graph graph = simulate_bundle(shape, {.cameras = 10,
                                          .points = 200,
                                          .seed = seed,
                                          .pose_noise = pose_noise,
                                          .point_noise = point_noise,
                                          .intrinsics_noise = 0})
                      .graph;
    if (is_held) hold(graph, BundlePart::kIntrinsics);
    const Report report = optimize(graph);
    if (!report.converged() || report.chi2_final <= 1.01 * optimize(graph).chi2_final) return;
    ++early;
    reports << "seed " << seed << ", noise " << pose_noise << " and " << point_noise << ": " << report;
  };
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    for (const double pose_noise : {3.0, 15.0}) {
      for (const double point_noise : {15.0, 30.0}) run(seed, pose_noise, point_noise);
    }
  }
#ifdef __aarch64__
  constexpr int kMostEarly = 1;  // a run from far away ends elsewhere if numbers are rounded differently
#else
  constexpr int kMostEarly = 0;
#endif
  EXPECT_LE(early, kMostEarly) << reports.str();
}

INSTANTIATE_TEST_SUITE_P(Optimize, EndOfBundleRun,
                         testing::Combine(testing::Values(BundleShape::kRing, BundleShape::kStreet),
                                          testing::Bool()));

TEST(EndOfRun, IsAtTheBestKnownMinimumForMostRunsFromFarAway) {
  int good = 0;
  constexpr int kSeeds = 10;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Graph graph = simulate_bundle(BundleShape::kRing, {.cameras = 10,
                                                       .points = 200,
                                                       .seed = seed,
                                                       .pose_noise = 15,
                                                       .point_noise = 15,
                                                       .intrinsics_noise = 0})
                      .graph;
    hold(graph, BundlePart::kIntrinsics);
    const Report report = optimize(graph);
    good += report.converged() && report.chi2_final < 2 * static_cast<double>(report.degrees_of_freedom);
  }
  EXPECT_GE(good, kSeeds / 2);
}

TEST(EndOfRun, NeverNamesACallbackIfThereIsNone) {
  // In each of these problems, a few edges have most of chi2, so that a run gives up and begins anew.
  for (const std::uint64_t seed : {1, 4, 6}) {
    Graph graph = simulate_bundle(BundleShape::kStreet, {.cameras = 20,
                                                         .points = 400,
                                                         .seed = seed,
                                                         .pose_noise = 3,
                                                         .point_noise = 20,
                                                         .outliers = 0.02})
                      .graph;
    const Report report = optimize(graph, {.threads = 1});
    EXPECT_NE(report.reason, Report::Reason::kCallback) << seed;
    EXPECT_LE(report.iterations, 100) << seed;
  }
}

}  // namespace
}  // namespace boxplus
