// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/simulate_bundle.h"

#include <gmock/gmock.h>

#include <map>

#include "boxplus/base/error.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/huber.h"

namespace boxplus {
namespace {

using ::testing::Each;
using ::testing::Ge;
using ::testing::HasSubstr;

/// The number of cameras that see each point.
std::vector<int> track_lengths(const BundleSimulation& simulation) {
  std::map<Id, int> lengths;
  for (const VertexRef& point : simulation.points) lengths[simulation.graph.id(point)] = 0;
  for (const EdgeRef& edge : simulation.edges)
    ++lengths[simulation.graph.id(simulation.graph.vertices(edge)[1])];
  std::vector<int> result;
  for (const auto& [_, length] : lengths) result.push_back(length);
  return result;
}

class SimulateBundle : public ::testing::TestWithParam<BundleWorld> {};
INSTANTIATE_TEST_SUITE_P(Worlds, SimulateBundle, ::testing::ValuesIn(kBundleWorlds),
                         [](const auto& world) { return std::string(to_string(world.param)).substr(3); });

TEST_P(SimulateBundle, DrawsPixelsAroundThoseOfTheTruth) {
  BundleSimulation simulation = simulate_bundle(GetParam(), {.cameras = 60, .points = 2000, .seed = 3});
  EXPECT_EQ(simulation.cameras.size(), 60u);
  EXPECT_EQ(simulation.points.size(), 2000u);
  EXPECT_EQ(simulation.kinds.size(), simulation.edges.size());
  EXPECT_THAT(simulation.kinds, Each(EdgeKind::kRecognition));
  const double at_start = simulation.graph.chi2(), rows = 2 * static_cast<double>(simulation.edges.size());
  simulation.set_to_truth();
  // A χ² variable with n degrees of freedom has mean n and standard deviation √(2n).
  EXPECT_NEAR(simulation.graph.chi2(), rows, 5 * std::sqrt(2 * rows));
  EXPECT_GT(at_start, 10 * rows);
}

TEST_P(SimulateBundle, WithoutNoiseStartsAtTheTruth) {
  const BundleSimulation simulation = simulate_bundle(GetParam(), {.cameras = 20, .points = 300, .noise = 0});
  EXPECT_LT(simulation.graph.chi2(), 1e-12);
}

TEST_P(SimulateBundle, ShowsEveryPointToSeveralCamerasAndToAboutTheRequestedNumber) {
  for (const double wanted : {4.0, 8.0}) {
    const std::vector<int> lengths =
        track_lengths(simulate_bundle(GetParam(), {.cameras = 300, .points = 3000, .track_length = wanted}));
    EXPECT_THAT(lengths, Each(Ge(2)));
    double sum = 0;
    for (const int length : lengths) sum += length;
    EXPECT_NEAR(sum / 3000, wanted, 0.35 * wanted);
  }
}

TEST_P(SimulateBundle, MakesProblemsWhoseOptimumExplainsTheNoise) {
  BundleSimulation simulation = simulate_bundle(GetParam(), {.cameras = 40, .points = 1500, .seed = 5});
  const Report report = optimize(simulation.graph);
  EXPECT_EQ(report.eliminated, 1500u);
  const double rows = 2 * static_cast<double>(simulation.edges.size()), unknowns = 40 * 9 + 1500 * 3 - 7;
  EXPECT_NEAR(report.chi2_final, rows - unknowns, 5 * std::sqrt(2 * (rows - unknowns)));
}

TEST_P(SimulateBundle, MarksOutliersAndChangesNoOtherObservation) {
  const BundleOptions options{.cameras = 40, .points = 2000, .seed = 2};
  BundleOptions wrong = options;
  wrong.outliers = 0.1;
  BundleSimulation without = simulate_bundle(GetParam(), options), with = simulate_bundle(GetParam(), wrong);
  ASSERT_EQ(with.edges.size(), without.edges.size());
  without.set_to_truth();
  with.set_to_truth();
  double outliers = 0;
  int near = 0;
  for (std::size_t k = 0; k < with.edges.size(); ++k) {
    const double chi2 = with.graph.chi2(with.edges[k]);
    if (with.kinds[k] == EdgeKind::kOutlier) {
      ++outliers;
      near += chi2 < 100;
    } else {
      EXPECT_EQ(chi2, without.graph.chi2(without.edges[k]));
    }
  }
  EXPECT_NEAR(outliers / static_cast<double>(with.edges.size()), 0.1, 0.02);
  EXPECT_LT(near, 0.01 * outliers + 3);
}

TEST_P(SimulateBundle, MakesTheSameProblemForTheSameSeed) {
  const auto chi2 = [](std::uint64_t seed) {
    return simulate_bundle(GetParam(), {.cameras = 20, .points = 200, .seed = seed}).graph.chi2();
  };
  EXPECT_EQ(chi2(9), chi2(9));
  EXPECT_NE(chi2(9), chi2(10));
}

TEST_P(SimulateBundle, WorksForTwoCameras) {
  const BundleSimulation simulation =
      simulate_bundle(GetParam(), {.cameras = 2, .points = 50, .track_length = 2});
  EXPECT_EQ(simulation.edges.size(), 100u);
}

TEST(SimulateBundleOptions, AreRefusedIfTheyMakeNoSense) {
  const auto message = [](const BundleOptions& options) -> std::string {
    try {
      std::ignore = simulate_bundle(BundleWorld::kRing, options);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "nothing was thrown";
  };
  EXPECT_THAT(message({.cameras = 1}), HasSubstr("expected at least 2 cameras, got 1"));
  EXPECT_THAT(message({.points = 0}), HasSubstr("expected at least 1 point, got 0"));
  EXPECT_THAT(message({.cameras = 3}), HasSubstr("a track length of at most the number of cameras, got 5"));
  EXPECT_THAT(message({.track_length = 1.5}), HasSubstr("a track length from 2 to 1000, got 1.5"));
  EXPECT_THAT(message({.noise = -1}), HasSubstr("a noise factor ≥ 0, got -1"));
  EXPECT_THAT(message({.outliers = 1.5}), HasSubstr("a fraction of outliers in [0, 1], got 1.5"));
}

}  // namespace
}  // namespace boxplus
