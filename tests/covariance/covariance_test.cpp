// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/covariance/covariance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <tuple>
#include <vector>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "linearize/bundle.h"
#include "optimize/dense_inverse.h"
#include "optimize/random_graph.h"
#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr auto kDifference = [](const auto& x, const auto& y) { return y - x; };

void expect_close(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected, double scale) {
  ASSERT_EQ(actual.rows(), expected.rows());
  ASSERT_EQ(actual.cols(), expected.cols());
  EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), 1e-9 * scale) << actual << "\n\n" << expected;
}

/// Compares every block of covariance() and of marginal_covariances() with the dense inverse.
void expect_equal_to_dense(const Graph& graph, const std::vector<VertexRef>& asked,
                           const std::vector<VertexRef>& moving, const Options& options = {}) {
  const DenseInverse dense(graph, moving, options.level);
  const Covariance joint = covariance(graph, asked, options);
  const Covariance marginal = marginal_covariances(graph, asked, options);
  ASSERT_TRUE(joint.ok()) << joint.message();
  ASSERT_TRUE(marginal.ok()) << marginal.message();
  double scale = 0;
  for (const VertexRef& a : asked) scale = std::max(scale, dense.of(graph, a, a).cwiseAbs().maxCoeff());
  Eigen::Index row = 0;
  for (const VertexRef& a : asked) {
    Eigen::Index column = 0;
    for (const VertexRef& b : asked) {
      const Eigen::MatrixXd expected = dense.of(graph, a, b);
      expect_close(joint.of(a, b), expected, scale);
      expect_close(joint.joint().block(row, column, expected.rows(), expected.cols()), expected, scale);
      column += expected.cols();
    }
    expect_close(joint.of(a), dense.of(graph, a, a), scale);
    expect_close(marginal.of(a), dense.of(graph, a, a), scale);
    row += graph.tangent_dim(a);
  }
}

TEST(Covariance, EqualsTheDenseInverseOfRandomGraphs) {
  for (unsigned seed = 1; seed < 9; ++seed) {
    SCOPED_TRACE(seed);
    const RandomGraph random(seed, seed % 2 == 0);
    expect_equal_to_dense(random.graph, random.all, random.moving);
  }
}

TEST(Covariance, OfAFewVerticesEqualsTheDenseInverse) {
  const RandomGraph random(3, true);
  for (std::size_t k = 0; k + 9 < random.all.size(); k += 4) {
    expect_equal_to_dense(random.graph, {random.all[k + 9], random.all[k]}, random.moving);
  }
}

TEST(Covariance, IsTheSameWhetherOrNotPointsAreEliminated) {
  Bundle kept = make_bundle(5, 40, false), eliminated = make_bundle(5, 40, true);
  std::ignore = optimize(kept.graph);
  for (std::size_t k = 0; k < kept.cameras.size(); ++k)
    eliminated.graph.set_estimate(eliminated.cameras[k], kept.graph.estimate(kept.cameras[k]));
  for (std::size_t k = 0; k < kept.points.size(); ++k)
    eliminated.graph.set_estimate(eliminated.points[k], kept.graph.estimate(kept.points[k]));
  const std::vector<VertexRef> all = eliminated.graph.all_vertices();
  const Covariance expected = covariance(kept.graph, kept.graph.all_vertices()),
                   actual = covariance(eliminated.graph, all);
  ASSERT_TRUE(expected.ok() && actual.ok());
  EXPECT_TRUE(actual.joint().isApprox(expected.joint(), 1e-8));
  std::vector<VertexRef> moving = all;
  std::erase(moving, VertexRef(eliminated.cameras[0]));
  expect_equal_to_dense(eliminated.graph, {eliminated.cameras[3], eliminated.points[0], eliminated.points[7]},
                        moving);
}

TEST(Covariance, OfARandomWalkGrowsByTheCovarianceOfEachStep) {
  Graph graph;
  std::vector<VertexHandle<double>> walk{graph.add_vertex(0.0)};
  for (int k = 0; k < 4; ++k) {
    walk.push_back(graph.add_vertex(0.0));
    graph.add_edge(kDifference, 4.0, walk[walk.size() - 2], walk.back());  // a variance of 1/4
  }
  graph.fix(walk[0]);
  const Covariance result = covariance(graph, {walk[1], walk[4]});
  Eigen::MatrixXd expected(2, 2);
  expected << 0.25, 0.25, 0.25, 1;
  EXPECT_TRUE(result.joint().isApprox(expected, 1e-14)) << result.joint();
}

TEST(Covariance, OfAVertexThatDoesNotMoveIsZero) {
  Graph graph;
  const auto fixed = graph.add_vertex(1.0), free = graph.add_vertex(2.0), outside = graph.add_vertex(3.0);
  const auto parameter = graph.add_parameter(0.5);
  graph.fix(fixed);
  graph.add_edge(kDifference, 4.0, fixed, free);
  graph.add_edge(kDifference, 4.0, parameter, free);
  graph.add_edge(kDifference, 8.0, free, outside);
  Options options;
  options.vertices = {free};
  const Covariance result = covariance(graph, {fixed, free, outside, parameter}, options);
  ASSERT_TRUE(result.ok());
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(4, 4);
  expected(1, 1) = 1.0 / 16;
  EXPECT_TRUE(result.joint().isApprox(expected, 1e-14)) << result.joint();
}

TEST(Covariance, IsRelativeToTheVertexThatIsHeldToFixTheGauge) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 12);
  const std::vector<VertexRef> all = graph.all_vertices();
  const Covariance held = covariance(graph, all);
  ASSERT_TRUE(held.ok()) << held.message();
  EXPECT_THAT(held.held(), ElementsAre(VertexRef(poses[0])));
  EXPECT_TRUE(held.of(poses[0]).isZero());
  graph.fix(poses[0]);
  const Covariance fixed = covariance(graph, all);
  EXPECT_TRUE(fixed.held().empty());
  EXPECT_EQ(held.joint(), fixed.joint());
  expect_equal_to_dense(graph, all, std::vector<VertexRef>(poses.begin() + 1, poses.end()));
}

TEST(Covariance, IsRefusedIfAPriorFixesOnlyAPartOfTheGauge) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 6);
  graph.add_edge(PositionPrior(Vector2(1, 2)), 4.0, poses[0]);  // the circle can still rotate about this pose
  const Covariance open = covariance(graph, poses);
  EXPECT_EQ(open.status(), Covariance::Status::kSingular);
  EXPECT_THAT(open.message(), HasSubstr("rotation"));
  graph.add_edge(PositionPrior(Vector2(2, 2)), 4.0, poses[1]);
  EXPECT_TRUE(covariance(graph, poses).held().empty());
  expect_equal_to_dense(graph, graph.all_vertices(), graph.all_vertices());
}

/// Pinhole cameras without odometry and without a fixed camera. The gauge has seven free directions.
TEST(Covariance, OfABundleWithoutFixedCamerasIsRelativeToACameraAndAScale) {
  Bundle bundle = make_bundle(4, 30, true);
  Graph& graph = bundle.graph;
  for (const EdgeRef& edge : graph.all_edges()) {
    if (graph.vertices(edge)[1].pool == bundle.cameras[0].pool) graph.remove(edge);
  }
  const Covariance one_camera = covariance(graph, {bundle.cameras[1]});
  EXPECT_EQ(one_camera.status(), Covariance::Status::kSingular);
  EXPECT_THAT(one_camera.message(), HasSubstr("scale"));
  graph.unfix(bundle.cameras[0]);
  const Covariance free = covariance(graph, bundle.cameras);
  ASSERT_TRUE(free.ok()) << free.message();
  EXPECT_FALSE(free.held().empty());
  EXPECT_TRUE(free.joint().allFinite());
  EXPECT_TRUE(free.of(free.held()[0]).isZero(0));
}

TEST(Covariance, HoldsNothingIfTheEdgesDetermineAllVertices) {
  Graph graph;
  const auto a = graph.add_vertex(0.0), b = graph.add_vertex(1.0), c = graph.add_vertex(2.0);
  graph.add_edge(kDifference, 4.0, a, b);
  graph.add_edge(kDifference, 4.0, b, c);
  graph.add_edge([](const auto& x, const auto& y, const auto& z) { return x + y + z; }, 4.0, a, b, c);
  EXPECT_TRUE(covariance(graph, {a, b, c}).held().empty());
  expect_equal_to_dense(graph, {a, b, c}, {a, b, c});
}

TEST(Covariance, OfVerticesOfUnknownTypeIsRelativeToOneOfThemIfNothingElseFixesThem) {
  Graph graph;
  const auto a = graph.add_vertex(0.0), b = graph.add_vertex(1.0), c = graph.add_vertex(2.0);
  graph.add_edge(kDifference, 4.0, a, b);
  graph.add_edge(kDifference, 4.0, b, c);
  const Covariance result = covariance(graph, {a, b, c});
  ASSERT_TRUE(result.ok()) << result.message();
  ASSERT_EQ(result.held().size(), 1u);
  EXPECT_EQ(result.of(result.held()[0])(0, 0), 0);
  std::vector<VertexRef> others{a, b, c};
  std::erase(others, result.held()[0]);
  expect_equal_to_dense(graph, {a, b, c}, others);
}

TEST(Covariance, UsesTheEdgesOfTheRequestedLevel) {
  Graph graph;
  const auto a = graph.add_vertex(0.0), b = graph.add_vertex(1.0);
  graph.fix(a);
  graph.add_edge(kDifference, 4.0, a, b);
  graph.set_level(graph.add_edge(kDifference, 16.0, a, b), 1);
  Options options;
  EXPECT_DOUBLE_EQ(covariance(graph, {b}, options).of(b)(0, 0), 1.0 / 4);
  options.level = 1;
  EXPECT_DOUBLE_EQ(covariance(graph, {b}, options).of(b)(0, 0), 1.0 / 16);
  options.level = -1;
  EXPECT_DOUBLE_EQ(covariance(graph, {b}, options).of(b)(0, 0), 1.0 / 20);
}

TEST(Covariance, ReportsAVertexThatTheEdgesDoNotDetermine) {
  Graph graph;
  const auto pose = graph.add_vertex(SE2(0, 0, 0));
  graph.fix(pose);
  // The edge of this point measures only one coordinate.
  const auto seen = graph.add_vertex(Vector2(3, 4), 17);
  graph.add_edge([](const auto& x, const auto& p) { return (x.inverse_times(p))[1] / 4.0 - 1.0; }, pose,
                 seen);
  const auto good = graph.add_vertex(Vector2(1, 2));
  graph.add_edge(PointObservation2(Vector2(1, 2)), pose, good);
  const Covariance result = covariance(graph, {good});
  EXPECT_EQ(result.status(), Covariance::Status::kSingular);
  EXPECT_EQ(result.failed_vertex(), VertexRef(seen));
  EXPECT_THAT(result.message(), HasSubstr("vertex 17"));
  EXPECT_THROW((void)result.of(good), Error);
  EXPECT_THROW((void)result.joint(), Error);
  graph.fix(seen);
  EXPECT_TRUE(covariance(graph, {good}).ok());
}

TEST(Covariance, ReportsAVertexThatNoEdgeTouches) {
  Graph graph;
  const auto a = graph.add_vertex(0.0), lonely = graph.add_vertex(1.0, 8);
  graph.add_edge(kDifference, a, graph.add_vertex(1.0));
  const Covariance result = covariance(graph, {a, lonely});
  EXPECT_EQ(result.status(), Covariance::Status::kSingular);
  EXPECT_EQ(result.failed_vertex(), VertexRef(lonely));
  EXPECT_TRUE(covariance(graph, {a}).ok());
}

TEST(Covariance, OfAGraphWithoutFixedVerticesIsRefusedUnderThePoliciesDampAndError) {
  for (const GaugePolicy gauge : {GaugePolicy::kDamp, GaugePolicy::kError}) {
    Graph graph;
    const auto poses = add_noisy_grid(graph, 3);
    Options options;
    options.gauge = gauge;
    const Covariance result = covariance(graph, {poses[3]}, options);
    EXPECT_EQ(result.status(), Covariance::Status::kSingular);
    EXPECT_TRUE(result.failed_vertex().has_value());
  }
}

TEST(Covariance, IsRefusedIfAnErrorIsNotFinite) {
  Graph graph;
  const auto a = graph.add_vertex(0.0, 5);
  graph.add_edge([](const auto& x) { return x * std::numeric_limits<double>::quiet_NaN(); }, a);
  const Covariance result = covariance(graph, {a});
  EXPECT_EQ(result.status(), Covariance::Status::kNotFinite);
  EXPECT_THAT(result.message(), HasSubstr("vertex 5"));
}

TEST(Covariance, CanBeStopped) {
  Graph graph;
  const auto poses = add_noisy_grid(graph, 3);
  std::atomic<bool> stop = true;
  Options options;
  options.stop = &stop;
  const Covariance result = marginal_covariances(graph, poses, options);
  EXPECT_EQ(result.status(), Covariance::Status::kStopped);
  EXPECT_FALSE(result.failed_vertex().has_value());
  EXPECT_THROW((void)result.of(poses[1]), Error);
  stop = false;
  EXPECT_TRUE(marginal_covariances(graph, poses, options).ok());
}

TEST(Covariance, RefusesBlocksThatWereNotRequested) {
  Graph graph;
  const auto a = graph.add_vertex(0.0), b = graph.add_vertex(1.0), gone = graph.add_vertex(1.0);
  graph.add_edge(kDifference, a, b);
  graph.remove(gone);
  EXPECT_THROW((void)covariance(graph, {gone}), InvalidArgument);
  EXPECT_THROW((void)covariance(graph, {a}).of(b), InvalidArgument);
  const std::vector<VertexRef> both{a, b};
  EXPECT_THROW((void)marginal_covariances(graph, both).of(a, b), InvalidArgument);
  EXPECT_EQ(marginal_covariances(graph, both).of(b)(0, 0), 1);
  EXPECT_EQ(covariance(graph, {}).joint().size(), 0);
}

TEST(Covariance, AcceptsAVectorOfTypedHandles) {
  Graph graph;
  const std::vector<VertexHandle<SE2>> poses = add_noisy_circle(graph, 6);
  EXPECT_EQ(covariance(graph, poses).joint(), covariance(graph, graph.all_vertices()).joint());
  EXPECT_EQ(marginal_covariances(graph, poses).of(poses[4]),
            marginal_covariances(graph, graph.all_vertices()).of(poses[4]));
}

TEST(Covariance, AcceptsAVertexTwice) {
  Graph graph;
  const auto a = graph.add_vertex(0.0), b = graph.add_vertex(1.0);
  graph.fix(a);
  graph.add_edge(kDifference, 4.0, a, b);
  EXPECT_TRUE(covariance(graph, {b, b}).joint().isApproxToConstant(0.25));
}

TEST(Covariance, HasTheSameBitsForAnyNumberOfThreads) {
  Graph graph;
  add_noisy_grid(graph, 5);
  const std::vector<VertexRef> all = graph.all_vertices();
  Options options;
  options.threads = 1;
  const Covariance one = marginal_covariances(graph, all, options);
  options.threads = 4;
  const Covariance four = marginal_covariances(graph, all, options);
  for (const VertexRef& vertex : all) ASSERT_EQ(one.of(vertex), four.of(vertex));
}

TEST(Covariance, DoesNotChangeEstimatesOrPlans) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 12);
  Optimizer optimizer(graph);
  ASSERT_TRUE(optimizer.run().converged());
  const SE2 before = graph.estimate(poses[5]);
  const Eigen::MatrixXd marginal = optimizer.covariance(poses[5], poses[5]);
  EXPECT_EQ(marginal, covariance(graph, {poses[5]}).of(poses[5]));
  EXPECT_EQ(graph.estimate(poses[5]).vector(), before.vector());
  EXPECT_TRUE(optimizer.run().plan_reused);
}

}  // namespace
}  // namespace boxplus
