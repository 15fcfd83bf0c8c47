// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <atomic>
#include <cmath>
#include <tuple>

#include "boxplus/base/error.h"
#include "boxplus/certify/certificate.h"
#include "boxplus/testing/simulate.h"
#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

using ::testing::HasSubstr;
using Relation = Certificate::Relation;
using Verdict = Certificate::Verdict;

constexpr int kPoses = 30;

/// A circle at its optimum.
struct Circle {
  Circle() : poses(add_noisy_circle(graph, kPoses)) { EXPECT_TRUE(optimize(graph).converged()); }
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
};

/// A circle at a local minimum: on the way around it, the robot turns once more than measured.
struct WoundCircle : Circle {
  WoundCircle() : optimum(graph.chi2()) {
    for (int k = 0; k < kPoses; ++k) {
      const SE2 pose = graph.estimate(poses[static_cast<std::size_t>(k)]);
      graph.set_estimate(poses[static_cast<std::size_t>(k)],
                         SE2(pose.x(), pose.y(), pose.theta() + 2 * kPi * k / kPoses));
    }
    EXPECT_TRUE(optimize(graph).converged());
    EXPECT_GT(graph.chi2(), 10 * optimum);
  }
  double optimum;
};

std::vector<SE3> estimates(const Graph& graph, const std::vector<VertexHandle<SE3>>& poses) {
  std::vector<SE3> result;
  for (const auto& pose : poses) result.push_back(graph.estimate(pose));
  return result;
}

TEST(Certify, ProvesTheOptimumOfAGridInSpace) {
  Graph graph;
  add_noisy_grid(graph, 4);
  ASSERT_TRUE(optimize(graph).converged());
  const Certificate certificate = certify(graph);
  EXPECT_EQ(certificate.verdict, Verdict::kGlobalMinimum) << certificate;
  EXPECT_EQ(certificate.relation, Relation::kEqual);
  EXPECT_NEAR(certificate.chi2, graph.chi2(), 1e-9 * graph.chi2());
  EXPECT_LE(certificate.bound, certificate.chi2);
  EXPECT_LT(certificate.relative_gap(), 1e-6);
  EXPECT_EQ(certificate.chi2_bound(), certificate.bound);
  EXPECT_THAT(to_string(certificate), HasSubstr("no estimates have a chi2 below"));
}

TEST(Certify, DoesNotMoveAGlobalMinimum) {
  Graph graph;
  const auto poses = add_noisy_grid(graph, 3);
  ASSERT_TRUE(optimize(graph).converged());
  const std::vector<SE3> before = estimates(graph, poses);
  ASSERT_EQ(certify(graph).verdict, Verdict::kGlobalMinimum);
  const std::vector<SE3> after = estimates(graph, poses);
  for (std::size_t k = 0; k < poses.size(); ++k)
    EXPECT_TRUE(std::equal(before[k].data(), before[k].data() + 7, after[k].data()));
}

TEST(Certify, GivesALowerBoundForTheChi2OfACircleInThePlane) {
  Circle circle;
  const Certificate certificate = certify(circle.graph);
  EXPECT_EQ(certificate.verdict, Verdict::kGlobalMinimum) << certificate;
  EXPECT_EQ(certificate.relation, Relation::kBelow);
  EXPECT_EQ(certificate.chi2, circle.graph.chi2());
  EXPECT_LT(certificate.chi2_bound(), certificate.chi2);
  EXPECT_GT(certificate.chi2_bound(), 0.99 * certificate.chi2);
}

TEST(Certify, CallsAWoundCircleALocalMinimumAndUnwindsIt) {
  WoundCircle circle;
  const double local = circle.graph.chi2();
  const Certificate certificate = certify(circle.graph);
  EXPECT_EQ(certificate.verdict, Verdict::kLocalMinimum) << certificate;
  EXPECT_EQ(certificate.chi2, local);
  EXPECT_NEAR(certificate.better_chi2, circle.optimum, 1e-6 * circle.optimum);
  EXPECT_EQ(circle.graph.chi2(), certificate.better_chi2);
  EXPECT_THAT(to_string(certificate), HasSubstr("there is a better one"));
  EXPECT_EQ(certify(circle.graph).verdict, Verdict::kGlobalMinimum);
}

TEST(Certify, LeavesALocalMinimumUndecidedIfItMustNotEscape) {
  WoundCircle circle;
  const double local = circle.graph.chi2();
  const Certificate certificate = certify(circle.graph, {.max_escapes = 0});
  EXPECT_EQ(certificate.verdict, Verdict::kUndecided);
  EXPECT_THAT(to_string(certificate), HasSubstr("no better minimum was found"));
  EXPECT_EQ(circle.graph.chi2(), local);
}

TEST(Certify, SaysThatDifferentWeightsOfDirectionsAreOnlySimilar) {
  Circle circle;
  circle.graph.set_information(circle.graph.all_edges().front(),
                               Information::diagonal(std::vector{400.0, 300.0, 900.0}));
  ASSERT_TRUE(optimize(circle.graph).converged());
  const Certificate certificate = certify(circle.graph);
  EXPECT_EQ(certificate.verdict, Verdict::kGlobalMinimum);
  EXPECT_EQ(certificate.relation, Relation::kSimilar);
  EXPECT_EQ(certificate.chi2_bound(), 0);
  EXPECT_LT(certificate.relative_gap(), 1e-6);
}

TEST(Certify, JudgesSeveralComponentsTogether) {
  Graph graph;
  add_noisy_circle(graph, kPoses);
  const auto second = add_noisy_circle(graph, kPoses, 2);
  graph.fix(second[7]);
  const SE2 fixed = graph.estimate(second[7]);
  ASSERT_TRUE(optimize(graph).converged());
  EXPECT_EQ(certify(graph).verdict, Verdict::kGlobalMinimum);
  EXPECT_EQ(graph.estimate(second[7]).x(), fixed.x());
}

TEST(Certify, HasTheSameBitsForAnyNumberOfThreads) {
  std::vector<double> figures;
  for (const int threads : {1, 2, 3}) {
    Graph graph;
    add_noisy_grid(graph, 6);
    ASSERT_TRUE(optimize(graph).converged());
    const Certificate certificate = certify(graph, {.options = {.threads = threads}});
    const std::vector<double> these{certificate.chi2, certificate.chordal_cost, certificate.bound};
    if (figures.empty()) figures = these;
    EXPECT_EQ(these, figures) << threads;
  }
}

TEST(Certify, IsUndecidedIfTheTimeLimitIsReached) {
  WoundCircle circle;
  const Certificate certificate = certify(circle.graph, {.options = {.time_limit_s = 0}});
  EXPECT_EQ(certificate.verdict, Verdict::kUndecided);
  EXPECT_THAT(certificate.note, HasSubstr("time limit"));
}

TEST(Certify, CertifiesExactMeasurements) {
  Graph graph;
  const auto a = graph.add_vertex(SE2()), b = graph.add_vertex(SE2(1, 0, 0.5));
  graph.add_edge(Between(SE2(1, 0, 0.5)), a, b);
  EXPECT_EQ(certify(graph).verdict, Verdict::kGlobalMinimum);
}

TEST(Certify, IsUndecidedAndMovesNothingIfItIsStopped) {
  WoundCircle circle;
  const double local = circle.graph.chi2();
  const std::atomic<bool> stop = true;
  CertificateOptions options;
  options.options.stop = &stop;
  const Certificate certificate = certify(circle.graph, options);
  EXPECT_EQ(certificate.verdict, Verdict::kUndecided);
  EXPECT_THAT(certificate.note, HasSubstr("stopped"));
  EXPECT_EQ(circle.graph.chi2(), local);
}

TEST(Certify, RefusesOptionsOutOfRange) {
  Circle circle;
  EXPECT_THROW(static_cast<void>(certify(circle.graph, {.tolerance = 0})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(certify(circle.graph, {.max_escapes = -1})), InvalidArgument);
}

TEST(WhyNotCertifiable, IsEmptyForAPoseGraph) {
  Circle circle;
  EXPECT_EQ(why_not_certifiable(circle.graph), "");
}

TEST(WhyNotCertifiable, NamesAPrior) {
  Circle circle;
  circle.graph.add_edge(Prior(SE2()), circle.poses[5]);
  EXPECT_THAT(why_not_certifiable(circle.graph), HasSubstr("Prior<SE2> (vertex 5)"));
  EXPECT_THROW(static_cast<void>(certify(circle.graph)), InvalidArgument);
}

TEST(WhyNotCertifiable, IgnoresDisabledEdgesAndOtherLevels) {
  Circle circle;
  const auto disabled = circle.graph.add_edge(Prior(SE2()), circle.poses[5]);
  const auto other = circle.graph.add_edge(Prior(SE2()), circle.poses[6]);
  circle.graph.set_enabled(disabled, false);
  circle.graph.set_level(other, 1);
  EXPECT_EQ(why_not_certifiable(circle.graph), "");
  EXPECT_NE(why_not_certifiable(circle.graph, {.level = -1}), "");
}

TEST(WhyNotCertifiable, NamesALandmark) {
  Circle circle;
  const auto point = circle.graph.add_vertex(Vector2(1, 2));
  circle.graph.add_edge(PointObservation2(Vector2(0, 1)), circle.poses[3], point);
  EXPECT_THAT(why_not_certifiable(circle.graph), HasSubstr("(vertices 3 30)"));
}

TEST(WhyNotCertifiable, NamesAnEdgeWithAKernel) {
  Circle circle;
  circle.graph.set_kernel(circle.graph.all_edges()[4], Huber(1));
  EXPECT_THAT(why_not_certifiable(circle.graph), HasSubstr("kernel: Between<SE2> (vertices 4 5)"));
}

TEST(WhyNotCertifiable, NamesFixedVerticesOfOneComponent) {
  Circle circle;
  circle.graph.fix(circle.poses[2]);
  EXPECT_EQ(why_not_certifiable(circle.graph), "");
  circle.graph.fix(circle.poses[4]);
  EXPECT_THAT(why_not_certifiable(circle.graph), HasSubstr("such as 2 and 4"));
}

TEST(WhyNotCertifiable, NamesAVertexWithFixedDirections) {
  Circle circle;
  circle.graph.fix_directions(circle.poses[9], {1});
  EXPECT_THAT(why_not_certifiable(circle.graph), HasSubstr("vertex 9 has fixed directions"));
}

TEST(WhyNotCertifiable, NamesAnEstimateThatIsNotFinite) {
  Circle circle;
  circle.graph.set_estimate(circle.poses[9], SE2(std::nan(""), 0, 0));
  EXPECT_THAT(why_not_certifiable(circle.graph), HasSubstr("vertex 9 is not finite"));
}

TEST(WhyNotCertifiable, MissesEdges) {
  EXPECT_THAT(why_not_certifiable(Graph()), HasSubstr("no edge"));
}

TEST(Certify, AnExactFitIsGlobalAndStaysAsItIs) {
  for (const World world : {World::kManhattan, World::kSphere, World::kGrid}) {
    Graph graph = simulate(world, {.poses = 100, .noise = 0}).graph;
    std::ignore = optimize(graph);
    const double chi2 = graph.chi2();
    const Certificate certificate = certify(graph);
    EXPECT_EQ(certificate.verdict, Certificate::Verdict::kGlobalMinimum) << certificate;
    EXPECT_EQ(certificate.relative_gap(), 0);
    EXPECT_EQ(certificate.steps, 0);
    EXPECT_EQ(graph.chi2(), chi2);
  }
}

}  // namespace
}  // namespace boxplus
