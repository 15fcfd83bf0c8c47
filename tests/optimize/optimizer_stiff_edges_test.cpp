// SPDX-License-Identifier: BSD-3-Clause
// Graphs with an Ω that is very large in one direction.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/slam2d.h"
#include "optimize/table_entries.h"

namespace boxplus {
namespace {

using Real = long double;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

struct Measurement {
  int from, to;
  SE2 pose;
  std::vector<double> weights;
};

/// Poses in the plane, of which the first is fixed, and measured relative poses.
struct PoseGraph {
  std::vector<SE2> poses;
  std::vector<Measurement> measurements;
};

/// A graph of three to six poses. Each edge has a direction with a weight from 1e8 to 1e18; its other weights
/// are 1.
PoseGraph random_graph(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<> uniform(-1, 1);
  const auto pose = [&](double place, double angle) {
    return SE2(place * uniform(random), place * uniform(random), angle * uniform(random));
  };
  PoseGraph graph;
  const int count = 3 + static_cast<int>(random() % 4);
  std::vector<SE2> truth;
  for (int i = 0; i < count; ++i) {
    truth.push_back(pose(5, 3));
    graph.poses.push_back(i == 0 ? truth[0] : truth.back() * pose(0.3, 0.3));
  }
  const auto measure = [&](int from, int to) {
    const auto at = [&](int i) { return truth[static_cast<std::size_t>(i)]; };
    std::vector<double> weights(3, 1);
    weights[random() % 3] = std::pow(10.0, 13 + 5 * uniform(random));
    graph.measurements.push_back({from, to, at(from).inverse() * at(to) * pose(0.5, 0.3), weights});
  };
  for (int i = 1; i < count; ++i) measure(i - 1, i);
  measure(0, count - 1);
  if (random() % 2 == 0) measure(count - 1, 1);
  return graph;
}

/// A dense Gauss-Newton method in long double. It factorizes √Ω J instead of H, so that it needs only half as
/// many digits.
class Reference {
 public:
  Reference(const PoseGraph& problem, const std::vector<SE2>& poses) : problem_(problem) {
    for (const SE2& pose : poses) {
      for (const double value : {pose.x(), pose.y(), pose.theta()}) x_.push_back(value);
    }
  }

  Real chi2() {
    linearize();
    return error_.squaredNorm();
  }

  /// The least chi2 in this many iterations.
  Real least_chi2(int iterations) {
    Real least = chi2();
    for (int i = 0; i < iterations; ++i) {
      const RealVector step = jacobian_.colPivHouseholderQr().solve(-error_);
      for (Eigen::Index k = 0; k < step.size(); ++k) x_[static_cast<std::size_t>(k + 3)] += step[k];
      least = std::min(least, chi2());
    }
    return least;
  }

 private:
  /// Computes √Ω e and √Ω J. The columns of the first pose, which is fixed, are left out.
  void linearize() {
    const auto rows = static_cast<Eigen::Index>(3 * problem_.measurements.size());
    error_.resize(rows);
    RealMatrix all = RealMatrix::Zero(rows, static_cast<Eigen::Index>(x_.size()));
    for (std::size_t k = 0; k < problem_.measurements.size(); ++k)
      linearize_edge(problem_.measurements[k], static_cast<Eigen::Index>(3 * k), all);
    jacobian_ = all.rightCols(all.cols() - 3);
  }

  void linearize_edge(const Measurement& edge, Eigen::Index row, RealMatrix& all) {
    const Real* from = &x_[static_cast<std::size_t>(3 * edge.from)];
    const Real* to = &x_[static_cast<std::size_t>(3 * edge.to)];
    const Real dx = to[0] - from[0], dy = to[1] - from[1];
    const Real angle = from[2], c = std::cos(angle), s = std::sin(angle);
    const Real cz = std::cos(Real{edge.pose.theta()}), sz = std::sin(Real{edge.pose.theta()});
    Eigen::Matrix<Real, 2, 2> back, turned, measured;
    back << c, s, -s, c;
    turned << -s, c, -c, -s;  // the derivative of `back`
    measured << cz, sz, -sz, cz;
    const Eigen::Matrix<Real, 2, 1> d(dx, dy), z(edge.pose.x(), edge.pose.y());
    const Real turn = to[2] - angle - edge.pose.theta();
    Eigen::Matrix<Real, 3, 1> e;
    e << measured * (back * d - z), std::atan2(std::sin(turn), std::cos(turn));
    Eigen::Matrix<Real, 3, 3> by_from = Eigen::Matrix<Real, 3, 3>::Zero(), by_to = by_from;
    by_to.topLeftCorner<2, 2>() = measured * back;
    by_to(2, 2) = 1;
    by_from = -by_to;
    by_from.topRightCorner<2, 1>() = measured * (turned * d);
    for (int i = 0; i < 3; ++i) {
      const Real root = std::sqrt(Real{edge.weights[static_cast<std::size_t>(i)]});
      error_[row + i] = root * e[i];
      all.block<1, 3>(row + i, 3 * edge.from) = root * by_from.row(i);
      all.block<1, 3>(row + i, 3 * edge.to) = root * by_to.row(i);
    }
  }

  const PoseGraph& problem_;
  std::vector<Real> x_;
  RealMatrix jacobian_;
  RealVector error_;
};

class StiffGraph : public ::testing::TestWithParam<AlgorithmKind> {};

TEST_P(StiffGraph, EndsAtTheOptimumOrSaysThatItDidNot) {
  int converged = 0;
  for (unsigned seed = 0; seed < 600; ++seed) {
    const PoseGraph problem = random_graph(seed);
    Graph graph;
    std::vector<VertexHandle<SE2>> poses;
    for (const SE2& pose : problem.poses) poses.push_back(graph.add_vertex(pose));
    graph.fix(poses[0]);
    for (const Measurement& edge : problem.measurements) {
      graph.add_edge(Between(edge.pose), Information::diagonal(edge.weights),
                     poses[static_cast<std::size_t>(edge.from)], poses[static_cast<std::size_t>(edge.to)]);
    }
    const Report report = optimize(graph, {.algorithm = GetParam()});
    std::vector<SE2> ends;
    for (const auto& pose : poses) ends.push_back(graph.estimate(pose));
    Reference reference(problem, ends);
    const auto chi2 = static_cast<double>(reference.chi2());
    ASSERT_NEAR(chi2, report.chi2_final, 1e-5 * (1 + chi2)) << "seed " << seed << report;
    if (!report.converged()) {
      EXPECT_THAT(report.reason,
                  ::testing::AnyOf(Report::Reason::kWeightSpan, Report::Reason::kMaxIterations))
          << "seed " << seed << report;
      continue;
    }
    ++converged;
    EXPECT_GE(static_cast<double>(reference.least_chi2(30)), (1 - 1e-5) * chi2 - 1e-9)
        << "seed " << seed << report;
  }
  EXPECT_GE(converged, 570);
}

TEST_P(StiffGraph, IsOptimizedAsIfTheWeightWereModerate) {
  for (const char* weight : {"1e8", "1e12", "1e14", "1e16", "1e18"}) {
    GraphFile file = parse_graph(std::string("VERTEX_SE2 0 2.4 1.5 0.9\n"
                                             "VERTEX_SE2 1 4.8 1.4 -0.6\n"
                                             "VERTEX_SE2 2 0.2 0.8 -1.7\n"
                                             "FIX 0\n"
                                             "EDGE_SE2 0 1 -0.8 -0.6 -0.7 ") +
                                     weight +
                                     " 0 0 1 0 1\n"
                                     "EDGE_SE2 1 2 1.4 -0.5 -0.8 1 0 0 1 0 1\n"
                                     "EDGE_SE2 0 2 1.8 -1.1 -0 1 0 0 1 0 1\n",
                                 "stiff.g2o");
    const Report report = optimize(file.graph, {.algorithm = GetParam()});
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_NEAR(report.chi2_final, 1.41981896, 2e-7) << weight << report;
  }
}

TEST_P(StiffGraph, IsOptimizedIfAnEdgeToAFixedVertexMeasuresOnlyTheStiffDirection) {
  for (const char* weight : {"1e8", "1e16", "1e18"}) {
    GraphFile file = parse_graph(std::string("VERTEX_SE2 0 0 0 0\n"
                                             "VERTEX_SE2 1 1 0.3 0.2\n"
                                             "VERTEX_SE2 2 2 0.2 -0.1\n"
                                             "FIX 0\n"
                                             "EDGE_SE2 0 1 1 0.1 0 0 0 0 ") +
                                     weight +
                                     " 0 0\n"
                                     "EDGE_SE2 1 2 1 0.1 0 1 0 0 1 0 1\n"
                                     "EDGE_SE2 0 2 2.1 0.1 0.3 1 0 0 1 0 1\n",
                                 "stiff.g2o");
    Options options;
    options.algorithm = GetParam();
    const Report report = optimize(file.graph, options);
    EXPECT_TRUE(report.converged()) << weight << report;
    EXPECT_NEAR(report.chi2_final, 0.0398635333, 1e-9) << weight;
  }
}

TEST_P(StiffGraph, IsNotConvergedIfItsOmegaIsRounded) {
  const auto optimized = [](double weight) {
    Graph graph;
    const auto a = graph.add_vertex(SE2(2.4, 1.5, 0.9)), b = graph.add_vertex(SE2(4.8, 1.4, -0.6)),
               c = graph.add_vertex(SE2(0.2, 0.8, -1.7));
    graph.fix(a);
    const Eigen::Vector3d direction(0.6, 0.8, 0);
    const Eigen::Matrix3d omega = Eigen::Matrix3d::Identity() + weight * direction * direction.transpose();
    graph.add_edge(Between(SE2(-0.8, -0.6, -0.7)), Information(omega), a, b);
    graph.add_edge(Between(SE2(1.4, -0.5, -0.8)), b, c);
    graph.add_edge(Between(SE2(1.8, -1.1, 0)), a, c);
    return optimize(graph, {.algorithm = GetParam()});
  };
  for (const double weight : {1e8, 1e12}) {
    EXPECT_TRUE(optimized(weight).converged());
    EXPECT_NEAR(optimized(weight).chi2_final, 1.516802, 1e-5);
  }
  for (const double weight : {1e15, 1e16}) {
    const Report report = optimized(weight);
    EXPECT_EQ(report.reason, Report::Reason::kWeightSpan) << report;
    EXPECT_THAT(report.message, ::testing::HasSubstr("the edge Between<SE2> between vertices 0 1"));
  }
}

INSTANTIATE_TEST_SUITE_P(Algorithms, StiffGraph, ::testing::ValuesIn(every_algorithm()),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace boxplus
