// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/stiff_edge.h"

#include <gtest/gtest.h>

#include <vector>

#include "boxplus/manifold/rn.h"
#include "boxplus/types/prior.h"
#include "boxplus/types/slam2d.h"
#include "linearize/dense_reference.h"
#include "linearize/double_double_system.h"

namespace boxplus {
namespace {

struct Poses {
  Graph graph;
  VertexHandle<SE2> a = graph.add_vertex(SE2(0, 0, 0.3)), b = graph.add_vertex(SE2(2, 1, 0.7));
  EdgeHandle<Between<SE2>> edge = graph.add_edge(Between(SE2(1, 0, 0)), a, b);

  std::optional<StiffEdge> stiff() const {
    return find_stiff_edge(graph, make_plan(graph, {}), {}, kStiffRatio);
  }
  bool information_is_stiff() const { return boxplus::information_is_stiff(graph, make_plan(graph, {})); }
};

/// 1 + (weight − 1) u uᵀ for the direction u = (0.6, 0.8, 0).
Information in_one_direction(double weight) {
  const Eigen::Vector3d u(0.6, 0.8, 0);
  return Information(Eigen::Matrix3d(Eigen::Matrix3d::Identity() + (weight - 1) * u * u.transpose()));
}

TEST(FindStiffEdge, FindsTheEdgeThatIsHeavyInOneDirection) {
  Poses poses;
  poses.graph.fix(poses.a);
  EXPECT_FALSE(poses.stiff());
  for (const Information& omega :
       {Information::diagonal(std::vector{1.0, 1e13, 1.0}), in_one_direction(1e13)}) {
    poses.graph.set_information(poses.edge, omega);
    ASSERT_TRUE(poses.stiff());
    EXPECT_EQ(poses.stiff()->edge, EdgeRef(poses.edge));
    EXPECT_EQ(poses.stiff()->vertex, VertexRef(poses.b));
    EXPECT_TRUE(poses.information_is_stiff());
  }
  poses.graph.set_information(poses.edge, in_one_direction(1e7));
  EXPECT_FALSE(poses.stiff());
  EXPECT_FALSE(poses.information_is_stiff());
}

TEST(FindStiffEdge, FindsAHeavyEdgeBesideLightOnes) {
  Poses poses;
  poses.graph.add_edge(Prior(SE2(0, 0, 0)), poses.a);
  poses.graph.set_information(poses.edge, 1e13);
  ASSERT_TRUE(poses.stiff());
  EXPECT_EQ(poses.stiff()->edge, EdgeRef(poses.edge));
  EXPECT_EQ(poses.stiff()->vertex, VertexRef(poses.a));
  EXPECT_TRUE(poses.information_is_stiff());
}

TEST(FindRoundedEdge, FindsAnOmegaWhoseRoundingHidesItsLightDirections) {
  Poses poses;
  poses.graph.fix(poses.a);
  const auto rounded = [&] { return find_rounded_edge(poses.graph, make_plan(poses.graph, {}), {}); };
  for (const Information& omega :
       {in_one_direction(1e11), Information::diagonal(std::vector{1e18, 1.0, 1.0}), Information(1e18)}) {
    poses.graph.set_information(poses.edge, omega);
    EXPECT_FALSE(rounded());
  }
  poses.graph.set_information(poses.edge, in_one_direction(1e15));
  ASSERT_TRUE(rounded());
  EXPECT_EQ(rounded()->edge, EdgeRef(poses.edge));
}

TEST(FindStiffEdge, IgnoresEdgesThatOnlyFixAVertex) {
  Poses poses;
  poses.graph.add_edge(Prior(SE2(0, 0, 0)), 1e18, poses.a);
  EXPECT_FALSE(poses.stiff());
  EXPECT_FALSE(poses.information_is_stiff());
}

TEST(DoubleDoubleSystem, EqualsADenseSystem) {
  Poses poses;
  poses.graph.add_edge(Prior(SE2(0.1, 0, 0)), in_one_direction(5), poses.a);
  poses.graph.add_edge(Between(SE2(0.3, 0, 0)), in_one_direction(3), poses.b, poses.a);
  const int fixed[] = {1};
  poses.graph.fix_directions(poses.b, fixed);
  const Plan plan = make_plan(poses.graph, {});
  DoubleDoubleSystem system;
  linearize_in_double_double(poses.graph, plan, {}, {}, system);
  Linearizer linearizer(poses.graph, plan);
  linearizer.linearize({});
  for (std::size_t i = 0; i < system.values.size(); ++i)
    EXPECT_NEAR(static_cast<double>(system.values[i]), linearizer.values()[i], 1e-12);
  for (std::size_t i = 0; i < system.gradient.size(); ++i)
    EXPECT_NEAR(static_cast<double>(system.gradient[i]), linearizer.gradient()[i], 1e-12);
}

TEST(DoubleDoubleSystem, KeepsTheRowsOfWeightOne) {
  Poses poses;
  poses.graph.fix(poses.a);
  poses.graph.set_information(poses.edge, Information::diagonal(std::vector{1e18, 1.0, 1.0}));
  const Plan plan = make_plan(poses.graph, {});
  DoubleDoubleSystem system;
  linearize_in_double_double(poses.graph, plan, {}, {}, system);
  const DenseEdge edge(*poses.graph.edge_pools()[0], 0);
  const Eigen::RowVector3d heavy = edge.jacobian.block<1, 3>(0, 3);
  const Eigen::MatrixXd light = edge.jacobian.block<2, 3>(1, 3);
  const Eigen::MatrixXd expected = light.transpose() * light;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const DoubleDouble rest = system.values[static_cast<std::size_t>(3 * j + i)] -
                                DoubleDouble::product(heavy[i], heavy[j]) * 1e18;
      EXPECT_NEAR(static_cast<double>(rest), expected(i, j), 1e-12);
    }
  }
}

}  // namespace
}  // namespace boxplus
