// SPDX-License-Identifier: BSD-3-Clause
#include "certify/chordal_problem.h"

#include <gtest/gtest.h>

#include <random>

#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"

namespace boxplus::certificate {
namespace {

ChordalProblem problem_of(const Graph& graph) {
  ChordalProblem problem;
  std::string complaint;
  EXPECT_TRUE(read_problem(graph, {}, problem, complaint)) << complaint;
  return problem;
}

class Random {
 public:
  double operator()() { return uniform_(engine_); }
  SE3 pose() {
    double delta[6];
    for (double& value : delta) value = (*this)();
    return Manifold<SE3>::oplus(SE3(), delta);
  }

 private:
  std::mt19937 engine_{5};
  std::uniform_real_distribution<> uniform_{-1, 1};
};

/// τ I for the translation, and a random Ω for the rotation.
Eigen::MatrixXd information_with_isotropic_translation(Random& random, double tau) {
  Eigen::MatrixXd omega = Eigen::MatrixXd::Identity(6, 6) * tau;
  Eigen::Matrix3d root;
  for (double& value : root.reshaped()) value = 10 * random();
  omega.bottomRightCorner<3, 3>() = root * root.transpose();
  return omega;
}

TEST(ChordalProblem, HasTheChi2OfEdgesInSpaceWithAnyInformationOfTheRotation) {
  Random random;
  for (int trial = 0; trial < 20; ++trial) {
    Graph graph;
    const auto a = graph.add_vertex(random.pose()), b = graph.add_vertex(random.pose());
    graph.add_edge(Between(random.pose()), information_with_isotropic_translation(random, 7), a, b);
    const ChordalProblem problem = problem_of(graph);
    EXPECT_EQ(problem.relation, Certificate::Relation::kEqual);
    EXPECT_NEAR(problem.cost(read_poses(graph, problem)), graph.chi2(), 1e-9 * graph.chi2());
  }
}

TEST(ChordalProblem, ReplacesTheSquaredAngleOfEdgesInThePlane) {
  for (const double angle : {0.01, 0.5, 2.0, -3.0}) {
    Graph graph;
    const auto a = graph.add_vertex(SE2(1, 2, 0.7)), b = graph.add_vertex(SE2(1, 2, 0.7) * SE2(3, 4, angle));
    graph.add_edge(Between(SE2(2, 4, 0)), Information::diagonal(std::vector{5.0, 5.0, 9.0}), a, b);
    const ChordalProblem problem = problem_of(graph);
    EXPECT_EQ(problem.relation, Certificate::Relation::kBelow);
    const double cost = problem.cost(read_poses(graph, problem));
    EXPECT_NEAR(cost, 5 + 9 * (2 - 2 * std::cos(angle)), 1e-9);
    EXPECT_LE(cost, graph.chi2());
  }
}

TEST(ChordalProblem, UsesTheHarmonicMeanOfTheInformationOfTheTranslation) {
  Graph graph;
  const auto a = graph.add_vertex(SE2()), b = graph.add_vertex(SE2(1, 0, 0));
  graph.add_edge(Between(SE2()), Information::diagonal(std::vector{1.0, 3.0, 1.0}), a, b);
  const ChordalProblem problem = problem_of(graph);
  EXPECT_EQ(problem.relation, Certificate::Relation::kSimilar);
  EXPECT_NEAR(problem.cost(read_poses(graph, problem)), 1.5, 1e-12);
}

TEST(ChordalProblem, IsOnlySimilarIfRotationAndTranslationAreCorrelated) {
  Random random;
  Graph graph;
  const auto a = graph.add_vertex(random.pose()), b = graph.add_vertex(random.pose());
  Eigen::MatrixXd omega = Eigen::MatrixXd::Identity(6, 6);
  omega(0, 4) = omega(4, 0) = 1e-3;
  graph.add_edge(Between(random.pose()), omega, a, b);
  EXPECT_EQ(problem_of(graph).relation, Certificate::Relation::kSimilar);
}

TEST(ChordalProblem, HasTheGradientOfItsCost) {
  Random random;
  Graph graph;
  const auto a = graph.add_vertex(random.pose()), b = graph.add_vertex(random.pose());
  graph.add_edge(Between(random.pose()), information_with_isotropic_translation(random, 2), a, b);
  const ChordalProblem problem = problem_of(graph);
  StackedPoses poses = read_poses(graph, problem);
  const StackedPoses gradient = problem.gradient(poses);
  constexpr double kStep = 1e-6;
  for (std::size_t pose = 0; pose < 2; ++pose) {
    for (Eigen::Index k = 0; k < poses[pose].size(); ++k) {
      double& value = poses[pose].data()[k];
      const double kept = value;
      value = kept + kStep;
      const double above = problem.cost(poses);
      value = kept - kStep;
      const double below = problem.cost(poses);
      value = kept;
      EXPECT_NEAR((above - below) / (2 * kStep), 2 * gradient[pose].data()[k], 1e-4);
    }
  }
}

TEST(ChordalProblem, WritesThePosesThatItReads) {
  Random random;
  Graph graph;
  const auto a = graph.add_vertex(random.pose()), b = graph.add_vertex(random.pose());
  graph.add_edge(Between(random.pose()), a, b);
  const ChordalProblem problem = problem_of(graph);
  const StackedPoses poses = read_poses(graph, problem);
  graph.set_estimate(b, random.pose());
  write_poses(poses, problem, graph);
  const StackedPoses again = read_poses(graph, problem);
  EXPECT_TRUE(again[1].isApprox(poses[1], 1e-12));
}

}  // namespace
}  // namespace boxplus::certificate
