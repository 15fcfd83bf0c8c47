// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/simulate_bundle.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/redescending.h"

namespace boxplus {
namespace {

constexpr std::array kAllIntrinsics{BundleIntrinsics::kWithPose, BundleIntrinsics::kSeparate,
                                    BundleIntrinsics::kShared};

BundleOptions small_problem() {
  return {.cameras = 40, .points = 1500, .seed = 3};
}

std::string text_of(const BundleSimulation& simulation) {
  GraphFile file;
  file.graph = simulation.graph;
  return format_graph(file, {.format = "BAL"});
}

double chi2_at_truth(const BundleSimulation& simulation) {
  Graph truth = simulation.graph;
  simulation.set_to_truth(truth);
  return truth.chi2();
}

double mean_track_length(const BundleSimulation& simulation) {
  return static_cast<double>(simulation.is_outlier.size()) /
         static_cast<double>(simulation.true_points.size());
}

/// Requires that `chi2` is a likely value of a χ² variable, which has mean n and variance 2n.
void expect_chi2(double chi2, double degrees_of_freedom) {
  EXPECT_NEAR(chi2, degrees_of_freedom, 4.5 * std::sqrt(2 * degrees_of_freedom));
}

TEST(SimulateBundle, AddsNoiseOfOnePixelToTheTruth) {
  for (BundleShape shape : kBundleShapes) {
    SCOPED_TRACE(to_string(shape));
    const BundleSimulation simulation = simulate_bundle(shape, small_problem());
    const double rows = 2 * static_cast<double>(simulation.graph.edge_count());
    expect_chi2(chi2_at_truth(simulation), rows);
  }
}

TEST(SimulateBundle, ScalesTheNoiseOfPixels) {
  BundleOptions options = small_problem();
  const double chi2 = chi2_at_truth(simulate_bundle(BundleShape::kCity, options));
  options.noise = 3;
  EXPECT_NEAR(chi2_at_truth(simulate_bundle(BundleShape::kCity, options)) / chi2, 9, 1e-9);
}

TEST(SimulateBundle, WithoutNoiseStartsAtTheTruth) {
  for (BundleShape shape : kBundleShapes) {
    for (BundleIntrinsics intrinsics : kAllIntrinsics) {
      BundleOptions options = small_problem();
      options.noise = options.pose_noise = options.point_noise = options.intrinsics_noise = 0;
      options.intrinsics = intrinsics;
      const BundleSimulation simulation = simulate_bundle(shape, options);
      EXPECT_LT(simulation.graph.chi2(), 1e-12) << to_string(shape);
      EXPECT_LT(chi2_at_truth(simulation), 1e-12) << to_string(shape);
    }
  }
}

TEST(SimulateBundle, EachNoiseOfTheStartMovesOnlyItsOwnEstimates) {
  BundleOptions exact = small_problem();
  exact.noise = exact.pose_noise = exact.point_noise = exact.intrinsics_noise = 0;
  exact.intrinsics = BundleIntrinsics::kSeparate;
  const auto largest_errors = [](const BundleOptions& options) {
    const BundleSimulation simulation = simulate_bundle(BundleShape::kStreet, options);
    std::array<double, 3> errors{};
    const auto note = [](double& largest, double error) { largest = std::max(largest, error); };
    Id id = 0;
    for (const SE3& pose : simulation.true_poses)
      note(errors[0], (simulation.graph.estimate(simulation.graph.vertex<SE3>(id++)).vector() - pose.vector())
                          .cwiseAbs()
                          .maxCoeff());
    for (const BalCamera& camera : simulation.true_intrinsics)
      note(errors[1], (simulation.graph.estimate(simulation.graph.vertex<BalCamera>(id++)).parameters -
                       camera.parameters)
                          .norm());
    for (const Vector3& point : simulation.true_points)
      note(errors[2], (simulation.graph.estimate(simulation.graph.vertex<Vector3>(id++)) - point).norm());
    return errors;
  };
  BundleOptions poses = exact, intrinsics = exact, points = exact;
  poses.pose_noise = intrinsics.intrinsics_noise = points.point_noise = 1;
  using ::testing::AllOf, ::testing::DoubleNear, ::testing::ElementsAre, ::testing::Gt, ::testing::Lt;
  const auto none = DoubleNear(0, 1e-12);
  EXPECT_THAT(largest_errors(exact), ElementsAre(none, none, none));
  EXPECT_THAT(largest_errors(poses), ElementsAre(AllOf(Gt(0.15), Lt(0.6)), none, none));
  EXPECT_THAT(largest_errors(intrinsics), ElementsAre(none, AllOf(Gt(6), Lt(35)), none));
  EXPECT_THAT(largest_errors(points), ElementsAre(none, none, AllOf(Gt(0.3), Lt(0.7))));
}

TEST(SimulateBundle, TheOptimumExplainsTheNoise) {
  for (BundleShape shape : kBundleShapes) {
    for (BundleIntrinsics intrinsics : kAllIntrinsics) {
      SCOPED_TRACE(to_string(shape));
      BundleOptions options = small_problem();
      options.intrinsics = intrinsics;
      BundleSimulation simulation = simulate_bundle(shape, options);
      const Report report = optimize(simulation.graph, {.max_iterations = 100});
      EXPECT_TRUE(report.converged()) << report.message;
      const double rows = 2 * static_cast<double>(simulation.graph.edge_count());
      constexpr double kGauge = 7;  // position, orientation and scale of the world
      const double unknowns =
          6 * 40 + 3 * 1500 - kGauge + 3.0 * static_cast<double>(simulation.true_intrinsics.size());
      expect_chi2(report.chi2_final, rows - unknowns);
    }
  }
}

/// The largest angle between two of these directions, in degrees.
double parallax(const std::vector<Vector3>& directions) {
  double largest = 0;
  for (const Vector3& a : directions) {
    for (const Vector3& b : directions) largest = std::max(largest, std::acos(std::min(1.0, a.dot(b))));
  }
  return largest * 180 / kPi;
}

TEST(SimulateBundle, AtLeastTwoCamerasSeeEachPointInTheirImagesFromDifferentDirections) {
  for (BundleShape shape : kBundleShapes) {
    BundleOptions options = small_problem();
    options.noise = 0;
    const BundleSimulation simulation = simulate_bundle(shape, options);
    std::vector<std::vector<Id>> cameras(simulation.true_points.size());
    std::vector<std::vector<Vector3>> directions(simulation.true_points.size());
    for (const EdgeRef& edge : simulation.graph.all_edges()) {
      const std::vector<VertexRef> ends = simulation.graph.vertices(edge);
      const auto camera = static_cast<std::size_t>(simulation.graph.id(ends[0]));
      const auto point =
          static_cast<std::size_t>(simulation.graph.id(ends[1])) - simulation.true_poses.size();
      cameras[point].push_back(simulation.graph.id(ends[0]));
      directions[point].push_back(
          (simulation.true_poses[camera].translation() - simulation.true_points[point]).normalized());
      const Vector3 seen = simulation.true_poses[camera].inverse_times(simulation.true_points[point]);
      EXPECT_LT(seen[2], -2 + 1e-9);  // BAL's cameras look along −z
      const Vector2 pixel = simulation.true_intrinsics[camera].project(seen);
      EXPECT_LE(std::abs(pixel[0]), 500);
      EXPECT_LE(std::abs(pixel[1]), 375);
    }
    for (std::vector<Id>& seen_by : cameras) {
      EXPECT_GE(seen_by.size(), 2u) << to_string(shape);
      EXPECT_EQ(std::adjacent_find(seen_by.begin(), seen_by.end(), std::greater_equal<>()), seen_by.end());
    }
    for (const std::vector<Vector3>& from : directions) EXPECT_GE(parallax(from), 3.0) << to_string(shape);
  }
}

TEST(SimulateBundle, EveryCameraObservesPoints) {
  for (BundleShape shape : kBundleShapes) {
    const BundleSimulation simulation = simulate_bundle(shape, small_problem());
    for (Id camera = 0; camera < 40; ++camera)
      EXPECT_GE(simulation.graph.edges(*simulation.graph.find_vertex(camera)).size(), 20u)
          << to_string(shape) << ": camera " << camera;
  }
}

TEST(SimulateBundle, TracksHaveTheRequestedLengthOnAverage) {
  for (BundleShape shape : kBundleShapes) {
    for (const double length : {2.5, 5.0, 12.0}) {
      const BundleSimulation simulation =
          simulate_bundle(shape, {.cameras = 200, .points = 4000, .track_length = length});
      EXPECT_NEAR(mean_track_length(simulation), length, 0.05 * length) << to_string(shape);
    }
  }
}

TEST(SimulateBundle, TwoCamerasAreEnough) {
  for (BundleShape shape : kBundleShapes) {
    const BundleSimulation simulation = simulate_bundle(shape, {.cameras = 2, .points = 10});
    EXPECT_EQ(simulation.graph.edge_count(), 20u) << to_string(shape);
  }
}

/// The greatest difference between the numbers of two cameras that observe the same point.
std::int64_t longest_loop(const BundleSimulation& simulation) {
  const std::size_t cameras = simulation.true_poses.size();
  std::int64_t longest = 0;
  for (std::size_t k = 0; k < simulation.true_points.size(); ++k) {
    const auto edges = simulation.graph.edges(*simulation.graph.find_vertex(static_cast<Id>(cameras + k)));
    std::vector<Id> seen_by;
    for (const EdgeRef& edge : edges)
      seen_by.push_back(simulation.graph.id(simulation.graph.vertices(edge)[0]));
    const auto [first, last] = std::minmax_element(seen_by.begin(), seen_by.end());
    longest = std::max(longest, *last - *first);
  }
  return longest;
}

TEST(SimulateBundle, TracksCloseLoopsInTheCityButNotInTheStreet) {
  const BundleOptions options{.cameras = 400, .points = 4000};
  EXPECT_LT(longest_loop(simulate_bundle(BundleShape::kStreet, options)), 40);
  EXPECT_GT(longest_loop(simulate_bundle(BundleShape::kCity, options)), 150);
}

/// The cameras that observe each point.
std::vector<std::vector<std::size_t>> cameras_of_points(const BundleSimulation& simulation) {
  std::vector<std::vector<std::size_t>> cameras(simulation.true_points.size());
  for (const EdgeRef& edge : simulation.graph.all_edges()) {
    const std::vector<VertexRef> ends = simulation.graph.vertices(edge);
    const auto point = static_cast<std::size_t>(simulation.graph.id(ends[1])) - simulation.true_poses.size();
    cameras[point].push_back(static_cast<std::size_t>(simulation.graph.id(ends[0])));
  }
  return cameras;
}

/// The fraction of all pairs of cameras that share points. This is the fill of the Schur complement.
double covisible_pairs(const BundleSimulation& simulation) {
  const std::size_t count = simulation.true_poses.size();
  std::vector<bool> share(count * count, false);
  for (const std::vector<std::size_t>& cameras : cameras_of_points(simulation)) {
    for (const std::size_t a : cameras) {
      for (const std::size_t b : cameras) share[a * count + b] = a < b || share[a * count + b];
    }
  }
  const auto pairs = static_cast<double>(std::count(share.begin(), share.end(), true));
  return pairs / (0.5 * static_cast<double>(count) * static_cast<double>(count - 1));
}

TEST(SimulateBundle, ACollectionHasManyShortTracksAndAFewThatAreAHundredTimesAsLong) {
  const BundleSimulation simulation =
      simulate_bundle(BundleShape::kCollection, {.cameras = 600, .points = 20'000, .track_length = 8});
  std::vector<std::size_t> lengths;
  for (const auto& cameras : cameras_of_points(simulation)) lengths.push_back(cameras.size());
  std::sort(lengths.begin(), lengths.end());
  EXPECT_EQ(lengths.front(), 2u);
  EXPECT_LE(lengths[lengths.size() / 2], 5u) << "the median is below the mean of 8";
  EXPECT_GE(lengths[lengths.size() * 99 / 100], 50u);
  EXPECT_GE(lengths.back(), 200u);
}

TEST(SimulateBundle, InACollectionAlmostHalfOfAllPairsOfCamerasSharePoints) {
  const BundleOptions options{.cameras = 300, .points = 30'000};
  EXPECT_NEAR(covisible_pairs(simulate_bundle(BundleShape::kCollection, options)), 0.45, 0.08);
  EXPECT_LT(covisible_pairs(simulate_bundle(BundleShape::kCity, options)), 0.15);
}

TEST(SimulateBundle, OutliersAreFarFromTheTruthAndChangeNothingElse) {
  for (BundleShape shape : kBundleShapes) {
    BundleOptions options = small_problem();
    const BundleSimulation clean = simulate_bundle(shape, options);
    options.outliers = 0.1;
    const BundleSimulation wrong = simulate_bundle(shape, options);
    Graph clean_truth = clean.graph, wrong_truth = wrong.graph;
    clean.set_to_truth(clean_truth);
    wrong.set_to_truth(wrong_truth);
    const auto clean_edges = clean_truth.all_edges(), wrong_edges = wrong_truth.all_edges();
    ASSERT_EQ(wrong.is_outlier.size(), wrong_edges.size());
    ASSERT_EQ(wrong_edges.size(), clean_edges.size());
    EXPECT_EQ(std::count(clean.is_outlier.begin(), clean.is_outlier.end(), true), 0);
    double outliers = 0;
    for (std::size_t k = 0; k < wrong_edges.size(); ++k) {
      if (wrong.is_outlier[k]) {
        ++outliers;
        EXPECT_GE(wrong_truth.chi2(wrong_edges[k]), 20 * 20) << to_string(shape);
      } else {
        EXPECT_EQ(wrong_truth.chi2(wrong_edges[k]), clean_truth.chi2(clean_edges[k])) << to_string(shape);
      }
    }
    // A binomial variable has mean np and variance np(1 − p).
    const auto edges = static_cast<double>(wrong_edges.size());
    EXPECT_NEAR(outliers, 0.1 * edges, 4 * std::sqrt(0.09 * edges)) << to_string(shape);
  }
}

/// The largest distance of a pose from its true place at the optimum. The first and the last pose are held at
/// the truth, so that no gauge is free.
double largest_error_at_optimum(const BundleSimulation& simulation,
                                const std::shared_ptr<const RobustKernel>& kernel) {
  Graph graph = simulation.graph;
  const auto last = static_cast<Id>(simulation.true_poses.size()) - 1;
  const auto truth = [&](Id id) { return simulation.true_poses[static_cast<std::size_t>(id)]; };
  for (const Id id : {Id{0}, last}) {
    graph.set_estimate(graph.vertex<SE3>(id), truth(id));
    graph.fix(graph.vertex<SE3>(id));
  }
  for (const EdgeRef& edge : graph.all_edges()) graph.set_kernel(edge, kernel);
  std::ignore = optimize(graph, {.max_iterations = 100});
  double largest = 0;
  for (Id id = 0; id <= last; ++id) {
    const Vector3 place = graph.estimate(graph.vertex<SE3>(id)).translation();
    largest = std::max(largest, (place - truth(id).translation()).norm());
  }
  return largest;
}

TEST(SimulateBundle, ARobustKernelFindsTheTruthDespiteOutliers) {
  // Two fixed cameras hold a small collection too weakly, because a photo shares only a few points with
  // others.
  for (BundleShape shape : {BundleShape::kRing, BundleShape::kStreet, BundleShape::kCity}) {
    BundleOptions options = small_problem();
    options.intrinsics = BundleIntrinsics::kShared;
    options.outliers = 0.1;
    const BundleSimulation simulation = simulate_bundle(shape, options);
    const double robust = largest_error_at_optimum(simulation, std::make_shared<const Cauchy>(2));
    const double without_kernel = largest_error_at_optimum(simulation, nullptr);
    options.outliers = 0;
    const double without_outliers = largest_error_at_optimum(simulate_bundle(shape, options), nullptr);
    EXPECT_LT(robust, 0.25) << to_string(shape);
    EXPECT_LT(robust, 2 * without_outliers) << to_string(shape);
    EXPECT_GT(without_kernel, 5 * robust) << to_string(shape);
  }
}

TEST(SimulateBundle, TheSameSeedGivesTheSameBytes) {
  for (BundleShape shape : kBundleShapes) {
    BundleOptions options = small_problem();
    const std::string text = text_of(simulate_bundle(shape, options));
    EXPECT_EQ(text_of(simulate_bundle(shape, options)), text);
    options.seed = 4;
    EXPECT_NE(text_of(simulate_bundle(shape, options)), text);
  }
}

TEST(SimulateBundle, TheSameSeedGivesTheSameWorldOnEveryComputer) {
  struct World {
    BundleShape shape;
    std::size_t edges;
    double chi2, chi2_at_truth;
  };
  for (const World& world : {World{BundleShape::kRing, 6612, 2874988.50514, 13556.707965},
                             World{BundleShape::kStreet, 7610, 1865065.46308, 15516.8492827},
                             World{BundleShape::kCity, 7537, 1950877.11162, 15352.2990437},
                             World{BundleShape::kCollection, 7418, 1996234.2765600595, 15078.319779053798}}) {
    const BundleSimulation simulation = simulate_bundle(world.shape, small_problem());
    SCOPED_TRACE(to_string(world.shape));
    EXPECT_EQ(simulation.graph.edge_count(), world.edges);
    EXPECT_NEAR(simulation.graph.chi2() / world.chi2, 1, 1e-9);
    EXPECT_NEAR(chi2_at_truth(simulation) / world.chi2_at_truth, 1, 1e-9);
  }
}

TEST(SimulateBundle, SharedIntrinsicsAreOneVertex) {
  BundleOptions options = small_problem();
  options.intrinsics = BundleIntrinsics::kShared;
  EXPECT_EQ(simulate_bundle(BundleShape::kStreet, options).graph.vertex_count(), 40u + 1 + 1500);
  options.intrinsics = BundleIntrinsics::kSeparate;
  EXPECT_EQ(simulate_bundle(BundleShape::kStreet, options).graph.vertex_count(), 40u + 40 + 1500);
  options.intrinsics = BundleIntrinsics::kWithPose;
  EXPECT_EQ(simulate_bundle(BundleShape::kStreet, options).graph.vertex_count(), 40u + 1500);
}

TEST(SimulateBundle, RefusesInvalidOptions) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const BundleOptions& options : {BundleOptions{.cameras = 0},
                                       {.cameras = 1},
                                       {.cameras = -5},
                                       {.points = 0},
                                       {.track_length = 1.9},
                                       {.track_length = kNan},
                                       {.track_length = kInfinity},
                                       {.noise = -1},
                                       {.pose_noise = kNan},
                                       {.point_noise = -0.1},
                                       {.intrinsics_noise = kInfinity},
                                       {.outliers = -0.1},
                                       {.outliers = 1.1},
                                       {.outliers = kNan}})
    EXPECT_THROW(simulate_bundle(BundleShape::kRing, options), InvalidArgument);
  try {
    simulate_bundle(BundleShape::kRing, {.outliers = 1.5});
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "simulate_bundle: expected a fraction of outliers in [0, 1], got 1.5");
  }
}

}  // namespace
}  // namespace boxplus
