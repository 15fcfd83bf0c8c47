// SPDX-License-Identifier: BSD-3-Clause
#include "covariance/linearization_inputs.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "boxplus/robust/huber.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

/// A circle of poses, of which one sees a landmark.
struct Seen {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses = add_noisy_circle(graph, 6);
  VertexHandle<Vector2> landmark = graph.add_vertex(Vector2(2, 3));
  EdgeHandle<PointObservation2> edge =
      graph.add_edge(PointObservation2(Vector2(1, 1)), 4.0, poses[2], landmark);
  Plan plan = make_plan(graph, {});
  LinearizationInputs inputs;

  bool take() { return inputs.take(graph, plan, {}); }
  bool equal() { return inputs.equal(graph, plan, {}); }
};

TEST(LinearizationInputs, AreEqualUntilSomethingChanges) {
  Seen seen;
  EXPECT_FALSE(seen.equal());
  ASSERT_TRUE(seen.take());
  EXPECT_TRUE(seen.equal());
  EXPECT_FALSE(seen.inputs.equal(seen.graph, seen.plan, {.numeric_jacobians = true}));
  EXPECT_FALSE(seen.inputs.equal(seen.graph, seen.plan, {.triggs_correction = true}));
  const SE2 before = seen.graph.estimate(seen.poses[3]);
  seen.graph.set_estimate(seen.poses[3], SE2(before.x(), before.y() + 1e-15, before.theta()));
  EXPECT_FALSE(seen.equal());
  seen.graph.set_estimate(seen.poses[3], before);
  EXPECT_TRUE(seen.equal());
}

TEST(LinearizationInputs, DifferAfterEachChangeOfAnEdge) {
  const std::vector<std::pair<std::string, std::function<void(Seen&)>>> changes{
      {"landmark", [](Seen& s) { s.graph.set_estimate(s.landmark, Vector2(2, 4)); }},
      {"measurement", [](Seen& s) { s.graph.set_measurement(s.edge, PointObservation2(Vector2(1, 2))); }},
      {"scalar", [](Seen& s) { s.graph.set_information(s.edge, 5.0); }},
      {"diagonal",
       [](Seen& s) {
         s.graph.set_information(s.edge, Information::diagonal(std::vector{4.0, 5.0}));
       }},
      {"full",
       [](Seen& s) { s.graph.set_information(s.edge, (Eigen::Matrix2d() << 4, 1, 1, 4).finished()); }},
      {"kernel", [](Seen& s) { s.graph.set_kernel(s.edge, Huber(1)); }},
      {"enabled", [](Seen& s) { s.graph.set_enabled(s.edge, false); }},
  };
  for (const auto& [name, change] : changes) {
    SCOPED_TRACE(name);
    Seen seen;
    ASSERT_TRUE(seen.take());
    change(seen);
    EXPECT_FALSE(seen.equal());
  }
}

TEST(LinearizationInputs, OfPosesInSpaceCanBeCompared) {
  Graph graph;
  const auto poses = add_noisy_grid(graph, 2);
  const Plan plan = make_plan(graph, {});
  LinearizationInputs inputs;
  ASSERT_TRUE(inputs.take(graph, plan, {}));
  EXPECT_TRUE(inputs.equal(graph, plan, {}));
  graph.set_estimate(poses[1], SE3());
  EXPECT_FALSE(inputs.equal(graph, plan, {}));
}

TEST(LinearizationInputs, AreNotComparedIfAKernelOrAnErrorFunctionMayReferToOtherData) {
  Seen with_kernel;
  with_kernel.graph.set_kernel(with_kernel.edge, Huber(1));
  EXPECT_FALSE(with_kernel.take());
  EXPECT_FALSE(with_kernel.equal());
  Seen other;
  other.graph.add_edge([](const auto& x) { return x; }, other.landmark);
  other.plan = make_plan(other.graph, {});
  EXPECT_FALSE(other.take());
  EXPECT_FALSE(other.equal());
}

}  // namespace
}  // namespace boxplus
