// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/simulate.h"

#include <gmock/gmock.h>

#include "boxplus/base/error.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/redescending.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {
namespace {

using ::testing::AllOf;
using ::testing::Ge;
using ::testing::Le;

TEST(Simulate, DrawsItsNoiseFromTheInformation) {
  for (World world : kWorlds) {
    const Simulation simulation = simulate(world, {.poses = 400, .seed = 3});
    double rows = 0;
    for (const EdgeRef& edge : simulation.truth_edges) rows += simulation.truth.information(edge).rows;
    // A χ² variable with n degrees of freedom has mean n and standard deviation √(2n).
    EXPECT_NEAR(simulation.truth.chi2(), rows, 5 * std::sqrt(2 * rows)) << to_string(world);
  }
}

TEST(Simulate, WithoutNoiseStartsAtTheTruth) {
  for (World world : kWorlds) {
    const Simulation simulation = simulate(world, {.poses = 100, .noise = 0});
    EXPECT_LT(simulation.graph.chi2(), 1e-12) << to_string(world);
    EXPECT_LT(simulation.truth.chi2(), 1e-12) << to_string(world);
  }
}

TEST(Simulate, MakesGraphsWhoseOptimumIsBelowTheChi2OfTheTruth) {
  for (World world : kWorlds) {
    Simulation simulation = simulate(world, {.poses = 225, .seed = 5});
    Options options;
    options.start = Start::kAutomatic;
    const Report report = optimize(simulation.graph, options);
    EXPECT_TRUE(report.converged()) << to_string(world) << ": " << report.message;
    EXPECT_LT(report.chi2_final, simulation.truth.chi2()) << to_string(world);
  }
}

TEST(Simulate, MakesTheSameGraphForTheSameSeed) {
  const SimulationOptions options{.poses = 50, .seed = 9};
  EXPECT_EQ(simulate(World::kManhattan, options).graph.chi2(),
            simulate(World::kManhattan, options).graph.chi2());
  EXPECT_NE(simulate(World::kManhattan, options).graph.chi2(),
            simulate(World::kManhattan, {.poses = 50, .seed = 10}).graph.chi2());
}

TEST(Simulate, RevisitsStreetsAndAddsAboutFourEdgesPerPose) {
  const Simulation streets = simulate(World::kStreets, {.poses = 50'000, .seed = 2});
  EXPECT_EQ(streets.graph.vertex_count(), 50'000u);
  EXPECT_THAT(static_cast<double>(streets.edges.size()) / 50'000, AllOf(Ge(3.7), Le(4.5)));
  for (std::size_t i = 0; i < streets.kinds.size(); ++i) {
    const std::vector<VertexRef> ends = streets.truth.vertices(streets.truth_edges[i]);
    const SE2 &from = streets.truth.estimate(streets.truth.typed<SE2>(ends[0])),
              &to = streets.truth.estimate(streets.truth.typed<SE2>(ends[1]));
    EXPECT_LT((to.translation() - from.translation()).norm(), 5.5) << i;
  }
}

TEST(Simulate, SeesAFewLandmarksAheadInTheCity) {
  const Simulation city = simulate(World::kCity, {.poses = 5000, .seed = 2, .noise = 0});
  const double landmarks = static_cast<double>(city.graph.vertex_count()) - 5000;
  EXPECT_THAT(5000 / landmarks, AllOf(Ge(5), Le(10))) << "poses per landmark";
  int observations = 0;
  for (std::size_t i = 0; i < city.kinds.size(); ++i) {
    if (city.kinds[i] == EdgeKind::kOdometry) continue;
    ++observations;
    const std::vector<VertexRef> ends = city.truth.vertices(city.truth_edges[i]);
    const SE2& pose = city.truth.estimate(city.truth.typed<SE2>(ends[0]));
    const Vector2 seen = pose.inverse_times(city.truth.estimate(city.truth.typed<Vector2>(ends[1])));
    EXPECT_LT(seen.norm(), 12);
    EXPECT_LT(std::abs(std::atan2(seen[1], seen[0])), 70 * kPi / 180);
  }
  EXPECT_THAT(observations / 5000.0, AllOf(Ge(2), Le(8))) << "observations per pose";
}

// The flights pass each room many times.
TEST(Simulate, OfPlanesAndLinesEndsAtAChi2ThatNoiseExplains) {
  for (World world : {World::kPlanes, World::kLines}) {
    Simulation simulation = simulate(world, {.poses = 1000, .seed = 4});
    const Report report = optimize(simulation.graph, {.start = Start::kAutomatic});
    EXPECT_TRUE(report.converged()) << to_string(world) << ": " << report.message;
    const auto n = static_cast<double>(report.degrees_of_freedom);
    EXPECT_NEAR(report.chi2_final, n, 5 * std::sqrt(2 * n)) << to_string(world);
  }
}

TEST(Simulate, TurnsTheRequestedFractionOfRecognitionsAndNothingElseIntoOutliers) {
  for (World world : kWorlds) {
    const int poses = world == World::kStreets ? 5000 : 1500;
    const Simulation clean = simulate(world, {.poses = poses, .seed = 6});
    const Simulation spoilt = simulate(world, {.poses = poses, .seed = 6, .outliers = 0.1});
    ASSERT_EQ(spoilt.kinds.size(), clean.edges.size()) << to_string(world);
    ASSERT_EQ(spoilt.edges.size(), clean.edges.size()) << to_string(world);
    double recognitions = 0, outliers = 0;
    for (std::size_t i = 0; i < spoilt.kinds.size(); ++i) {
      EXPECT_NE(clean.kinds[i], EdgeKind::kOutlier);
      recognitions += clean.kinds[i] == EdgeKind::kRecognition;
      const double chi2 = spoilt.truth.chi2(spoilt.truth_edges[i]);
      if (spoilt.kinds[i] == EdgeKind::kOutlier) {
        ++outliers;
        EXPECT_EQ(clean.kinds[i], EdgeKind::kRecognition);
        EXPECT_GT(chi2, 100) << to_string(world) << ": edge " << i << " is an outlier, but almost correct";
      } else {
        EXPECT_EQ(chi2, clean.truth.chi2(clean.truth_edges[i])) << to_string(world);
      }
    }
    // A binomial variable has mean np and variance np(1 − p).
    EXPECT_NEAR(outliers, 0.1 * recognitions, 4 * std::sqrt(0.09 * recognitions)) << to_string(world);
  }
}

TEST(Simulate, TurnsAllRecognitionsButNoOdometryIntoOutliersIfTheFractionIsOne) {
  const Simulation simulation = simulate(World::kSphere, {.poses = 100, .outliers = 1});
  EXPECT_THAT(simulation.kinds, ::testing::Not(::testing::Contains(EdgeKind::kRecognition)));
  EXPECT_THAT(simulation.kinds, ::testing::Contains(EdgeKind::kOdometry).Times(99));
}

/// The root mean square distance of the positions from the truth. The first pose is the same in both graphs.
template <class Pose>
double error_of_positions(const Simulation& simulation) {
  double squared = 0;
  const auto vertices = simulation.graph.all_vertices(), true_vertices = simulation.truth.all_vertices();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    squared += (simulation.graph.estimate(simulation.graph.typed<Pose>(vertices[i])).translation() -
                simulation.truth.estimate(simulation.truth.typed<Pose>(true_vertices[i])).translation())
                   .squaredNorm();
  }
  return std::sqrt(squared / static_cast<double>(vertices.size()));
}

template <class Pose>
void expect_that_a_kernel_helps(World world) {
  const SimulationOptions options{.poses = 400, .seed = 8, .outliers = 0.05};
  Simulation plain = simulate(world, options), robust = simulate(world, options);
  for (std::size_t i = 0; i < robust.edges.size(); ++i) {
    if (robust.kinds[i] != EdgeKind::kOdometry) robust.graph.set_kernel(robust.edges[i], Cauchy(1));
  }
  std::ignore = optimize(plain.graph, {.start = Start::kAutomatic});
  std::ignore = optimize(robust.graph, {.start = Start::kAutomatic});
  EXPECT_LT(3 * error_of_positions<Pose>(robust), error_of_positions<Pose>(plain)) << to_string(world);
}

TEST(Simulate, MakesOutliersThatARobustKernelWithstands) {
  expect_that_a_kernel_helps<SE2>(World::kManhattan);
  expect_that_a_kernel_helps<SE3>(World::kSphere);
}

TEST(Simulate, RefusesInvalidOptions) {
  EXPECT_THROW(simulate(World::kSphere, {.outliers = -0.1}), InvalidArgument);
  EXPECT_THROW(simulate(World::kSphere, {.outliers = 1.1}), InvalidArgument);
  EXPECT_THROW(simulate(World::kSphere, {.outliers = std::nan("")}), InvalidArgument);
  EXPECT_THROW(simulate(World::kSphere, {.poses = 1}), InvalidArgument);
  EXPECT_THROW(simulate(World::kSphere, {.noise = -1}), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
