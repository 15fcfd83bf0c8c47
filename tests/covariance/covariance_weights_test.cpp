// SPDX-License-Identifier: BSD-3-Clause
// Covariances of graphs whose weights span many digits.
#include <gmock/gmock.h>

#include <cmath>

#include "boxplus/covariance/covariance.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {
namespace {

using ::testing::HasSubstr;

/// A straight chain of poses with a prior on the first one. The variances are those of x, y and the heading.
struct Chain {
  Chain(int count, const Vector3& of_prior, const Vector3& of_step) : prior(of_prior), step(of_step) {
    for (int k = 0; k < count; ++k) poses.push_back(graph.add_vertex(SE2(k, 0, 0)));
    const auto inverse = [](const Vector3& v) {
      return Information::diagonal(std::vector{1 / v[0], 1 / v[1], 1 / v[2]});
    };
    graph.add_edge(Prior(SE2()), inverse(prior), poses[0]);
    for (std::size_t k = 1; k < poses.size(); ++k)
      graph.add_edge(Between(SE2(1, 0, 0)), inverse(step), poses[k - 1], poses[k]);
  }

  /// The covariance of the last pose.
  Eigen::Matrix3d truth() const {
    const auto n = static_cast<double>(poses.size() - 1);
    Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
    result(0, 0) = prior[0] + n * step[0];
    result(1, 1) = prior[1] + n * step[1] + prior[2] * n * n + step[2] * (n - 1) * n * (2 * n - 1) / 6;
    result(2, 2) = prior[2] + n * step[2];
    result(1, 2) = result(2, 1) = prior[2] * n + step[2] * n * (n - 1) / 2;
    return result;
  }

  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  Vector3 prior, step;
};

double relative_error(const Eigen::MatrixXd& found, const Eigen::Matrix3d& truth) {
  return (found - truth).cwiseAbs().maxCoeff() / truth.cwiseAbs().maxCoeff();
}

TEST(CovarianceOfWideWeights, IsRightIfAWeakPriorHoldsALongChain) {
  for (const int count : {2, 10, 50, 100, 300, 1000}) {
    const Chain chain(count, Vector3(1e8, 1e8, 9.87), Vector3(1e-4, 1e-4, 1e-6));
    const Covariance covariance = boxplus::covariance(chain.graph, {chain.poses.front(), chain.poses.back()});
    ASSERT_TRUE(covariance.ok()) << count << ": " << covariance.message();
    EXPECT_LT(relative_error(covariance.of(chain.poses.back()), chain.truth()), 1e-9) << count;
  }
}

TEST(CovarianceOfWideWeights, IsRightForSpansOfUpToTwentyDigits) {
  for (const double weak : {1e4, 1e6, 1e8, 1e12, 1e14}) {
    const Chain chain(100, Vector3(weak, weak, weak), Vector3(1e-4, 1e-4, 1e-6));
    const Covariance covariance = boxplus::covariance(chain.graph, {chain.poses.back()});
    ASSERT_TRUE(covariance.ok()) << weak << ": " << covariance.message();
    EXPECT_LT(relative_error(covariance.of(chain.poses.back()), chain.truth()), 1e-7) << weak;
  }
}

TEST(CovarianceOfWideWeights, IsTheSameInAnOptimizer) {
  Chain chain(100, Vector3(1e8, 1e8, 9.87), Vector3(1e-4, 1e-4, 1e-6));
  Optimizer optimizer(chain.graph);
  std::ignore = optimizer.run();
  const std::vector<VertexRef> all = chain.graph.all_vertices();
  const Covariance covariance = optimizer.marginal_covariances(all);
  ASSERT_TRUE(covariance.ok()) << covariance.message();
  EXPECT_LT(relative_error(covariance.of(chain.poses.back()), chain.truth()), 1e-9);
}

TEST(CovarianceOfWideWeights, NoticesALightWeightThatHInDoubleDoesNotShow) {
  Chain chain(100, Vector3(1e14, 1e14, 1e14), Vector3(1e-4, 1e-4, 1e-6));
  Optimizer optimizer(chain.graph);
  ASSERT_TRUE(optimizer.covariance(std::vector<VertexRef>{chain.poses.back()}).ok());
  chain.prior *= 10;
  chain.graph.set_information(chain.graph.all_edges().front(),
                              Information::diagonal(std::vector{1e-15, 1e-15, 1e-15}));
  const Covariance covariance = optimizer.covariance(std::vector<VertexRef>{chain.poses.back()});
  ASSERT_TRUE(covariance.ok()) << covariance.message();
  EXPECT_LT(relative_error(covariance.of(chain.poses.back()), chain.truth()), 1e-7);
}

TEST(CovarianceOfWideWeights, NamesTheWeightsBeyond) {
  const Chain chain(100, Vector3::Constant(1e40), Vector3(1e-4, 1e-4, 1e-6));
  const Covariance covariance = boxplus::covariance(chain.graph, {chain.poses.back()});
  ASSERT_FALSE(covariance.ok());
  EXPECT_THAT(covariance.message(),
              HasSubstr("the weights span 46.0 digits, from 1e-40 (Prior<SE2>, vertex 0)"));
  EXPECT_THAT(covariance.message(), HasSubstr("to 1e+06 (Between<SE2>, vertices 0 1)"));
}

TEST(CovarianceOfWideWeights, StillNamesAVertexThatNothingDetermines) {
  Chain chain(10, Vector3(1e8, 1e8, 9.87), Vector3(1e-4, 1e-4, 1e-6));
  const auto point = chain.graph.add_vertex(Vector2(3, 1));
  chain.graph.add_edge(BearingObservation2(0.3), chain.poses[0], point);
  const Covariance covariance = boxplus::covariance(chain.graph, {point});
  ASSERT_FALSE(covariance.ok());
  EXPECT_THAT(covariance.message(), HasSubstr("is not determined"));
}

}  // namespace
}  // namespace boxplus
