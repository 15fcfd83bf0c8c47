// SPDX-License-Identifier: BSD-3-Clause
// optimize() works at exit, when main() has ended and thread-local objects are destroyed.
#include <gtest/gtest.h>

#include <cstdlib>

#include "optimize/small_graphs.h"
#include "sanitized.h"

namespace boxplus {
namespace {

/// Its edges include an edge over a range of points and an edge that is differentiated automatically.
void optimize_a_small_graph() {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 20);
  std::vector<VertexHandle<Vector2>> points;
  for (int k = 0; k < 3; ++k) points.push_back(graph.add_vertex(Vector2(k, 1)));
  const auto variable = graph.add_vertex(Eigen::VectorXd::Ones(3).eval());
  graph.add_edge([](const auto& x) { return (x.array() - 2.0).matrix().eval(); }, variable);
  graph.add_edge(PointsObservation2(Eigen::VectorXd::Ones(6)), 1.0, poses[0], points);
  if (!optimize(graph).converged()) std::_Exit(2);
}

struct OptimizesAtTheEnd {
  ~OptimizesAtTheEnd() { optimize_a_small_graph(); }
};

TEST(OptimizeInTheDestructorOfAGlobalObject, WorksIfMainCalledItToo) {
  if (is_emulated()) GTEST_SKIP() << "an emulated program cannot start itself again";
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        static const OptimizesAtTheEnd last;
        optimize_a_small_graph();
        std::exit(0);
      },
      ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace boxplus
