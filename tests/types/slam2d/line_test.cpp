// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam2d/line.h"

#include <gmock/gmock.h>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/check_manifold.h"
#include "boxplus/types/slam2d.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

const SE2 kPose(1, 2, kPi / 2);
const Line2 kLine{kPi / 2, 5};  // y = 5

TEST(Line2, IsAManifoldWhoseAngleIsWrapped) {
  const ManifoldCheck check = check_manifold<Line2>({kLine, Line2{3, -1}, Line2{-3, 2}});
  EXPECT_TRUE(check.ok) << check.message;
  const double step[2] = {1, 0};
  EXPECT_NEAR(Manifold<Line2>::oplus(Line2{3, 0, {7, 8}}, step).angle, 4 - 2 * kPi, 1e-15);
  EXPECT_EQ(Manifold<Line2>::oplus(Line2{3, 0, {7, 8}}, step).ends[1], 8);
}

TEST(LineObservation2, MeasuresInTheFrameOfThePose) {
  const Vector2 e = LineObservation2(Vector2(0.5, 1)).error(kPose, kLine);
  EXPECT_NEAR(e[0], -0.5, 1e-14);  // the normal points along x of the pose
  EXPECT_NEAR(e[1], 2, 1e-14);
}

TEST(LineDifference2, HasAnAngleBetweenMinusPiAndPi) {
  const Vector2 e = LineDifference2(Vector2(1, 1)).error(Line2{3, 2}, Line2{-3, 4});
  EXPECT_NEAR(e[0], -7 + 2 * kPi, 1e-14);
  EXPECT_NEAR(e[1], 1, 1e-14);
}

TEST(PointToLine2, IsTheSignedDistance) {
  EXPECT_NEAR(PointToLine2(0.5).error(kLine, Vector2(9, 6)), 0.5, 1e-14);
}

TEST(LineEdges2, HaveCorrectJacobians) {
  expect_correct_jacobians(LineObservation2(Vector2(1, 2)), kPose, kLine);
  expect_correct_jacobians(LineDifference2(Vector2(1, 2)), kLine, Line2{1, 2});
  expect_correct_jacobians(PointToLine2(1), kLine, Vector2(3, 4));
}

/// Two walls and the poses that see them.
TEST(LineEdges2, FindTheWallsOfARoom) {
  Graph graph;
  const auto first = graph.add_vertex(SE2()), second = graph.add_vertex(SE2(0.7, 0.2, 0.3));
  graph.fix(first);
  const auto x_wall = graph.add_vertex(Line2{0.2, 3}), y_wall = graph.add_vertex(Line2{1.3, 5});
  graph.add_edge(Between(SE2(1, 0, 0.1)), first, second);
  for (const auto& [pose, at] : {std::pair{first, SE2()}, std::pair{second, SE2(1, 0, 0.1)}}) {
    for (const auto& [wall, truth] : {std::pair{x_wall, Line2{0, 4}}, std::pair{y_wall, kLine}}) {
      const Vector2 seen = LineObservation2(Vector2(0, 0)).error(at, truth);
      graph.add_edge(LineObservation2(seen), pose, wall);
    }
  }
  EXPECT_TRUE(optimize(graph).converged());
  EXPECT_NEAR(graph.estimate(x_wall).angle, 0, 1e-9);
  EXPECT_NEAR(graph.estimate(x_wall).distance, 4, 1e-9);
  EXPECT_NEAR(graph.estimate(y_wall).distance, 5, 1e-9);
  EXPECT_NEAR(graph.estimate(second).x(), 1, 1e-9);
}

}  // namespace
}  // namespace boxplus
