// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>

#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/robust/huber.h"
#include "linearize/dense_reference.h"

namespace boxplus {
namespace {

constexpr auto kSighting = [](const auto& pose, const auto& point) { return pose.inverse_times(point); };
constexpr auto kBetween = [](const auto& a, const auto& b) { return a.inverse_times(b).vector(); };

struct World {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  std::vector<VertexHandle<Vector2>> points;
};

World make_world(int count) {
  World w;
  for (int k = 0; k < count; ++k) {
    w.poses.push_back(w.graph.add_vertex(SE2(k, 0.1 * k * k, 0.2 * k)));
    w.points.push_back(w.graph.add_vertex(Vector2(k + 1, 3 - k)));
  }
  for (std::size_t k = 0; k < w.poses.size(); ++k) {
    const std::size_t next = (k + 1) % w.poses.size();
    w.graph.add_edge(kBetween, w.poses[k], w.poses[next]);
    w.graph.set_kernel(w.graph.add_edge(kSighting, 2.0, w.poses[k], w.points[k]), Huber(0.5));
    w.graph.add_edge(kSighting, w.poses[next], w.points[k]);
  }
  return w;
}

TEST(FixedDirections, HaveZeroHessianEntriesOffTheDiagonal) {
  for (const bool eliminate : {false, true}) {
    World w = make_world(4);
    for (const auto& point : w.points) w.graph.set_eliminated(point, eliminate);
    w.graph.fix(w.poses[0]);
    const Plan free = make_plan(w.graph, {});
    Linearizer all(w.graph, free);
    all.linearize({});
    w.graph.fix_directions(w.poses[2], {2, 0});
    w.graph.fix_directions(w.points[1], {1});
    const Plan plan = make_plan(w.graph, {});
    ASSERT_EQ(plan.block_vertex, free.block_vertex);
    EXPECT_EQ(plan.fixed_scalars.size(), 3u);
    EXPECT_EQ(plan.free_scalars(), free.scalars() - 3);
    Linearizer linearizer(w.graph, plan);
    linearizer.linearize({});
    Eigen::MatrixXd expected = dense_matrix(free.structure, all.values());
    Eigen::VectorXd gradient =
        Eigen::Map<const Eigen::VectorXd>(all.gradient().data(), static_cast<Eigen::Index>(free.scalars()));
    for (const std::uint32_t scalar : plan.fixed_scalars) {
      const double diagonal = expected(scalar, scalar);
      EXPECT_GT(diagonal, 0);
      expected.row(scalar).setZero();
      expected.col(scalar).setZero();
      expected(scalar, scalar) = diagonal;
      gradient[scalar] = 0;
    }
    EXPECT_EQ(dense_matrix(plan.structure, linearizer.values()), expected);
    EXPECT_EQ(Eigen::Map<const Eigen::VectorXd>(linearizer.gradient().data(), gradient.size()), gradient);
  }
}

TEST(FixedDirections, GiveTheSameHessianForAnyNumberOfThreads) {
  World w = make_world(1500);
  for (const auto& pose : w.poses) w.graph.fix_directions(pose, {1});
  const Plan one = make_plan(w.graph, {.threads = 1});
  Linearizer reference(w.graph, one);
  reference.linearize({});
  for (const int threads : {2, 3}) {
    const Plan plan = make_plan(w.graph, {.threads = threads});
    ASSERT_EQ(plan.chunks.size(), static_cast<std::size_t>(threads));
    EXPECT_EQ(plan.fixed_scalars, one.fixed_scalars);
    Linearizer linearizer(w.graph, plan);
    linearizer.linearize({});
    EXPECT_EQ(0, std::memcmp(linearizer.values().data(), reference.values().data(),
                             reference.values().size_bytes()));
    EXPECT_EQ(0, std::memcmp(linearizer.gradient().data(), reference.gradient().data(),
                             reference.gradient().size_bytes()));
  }
}

TEST(FixedDirections, HaveAPositiveDiagonalEvenIfNoEdgeMeasuresThem) {
  Graph graph;
  const auto x = graph.add_vertex(Vector2(1, 2));
  graph.add_edge([](const auto& v) { return 3.0 * v[0]; }, x);
  graph.fix_directions(x, {1});
  const Plan plan = make_plan(graph, {});
  Linearizer linearizer(graph, plan);
  linearizer.linearize({});
  EXPECT_EQ(dense_matrix(plan.structure, linearizer.values()),
            Eigen::Vector2d(9, 1).asDiagonal().toDenseMatrix());
}

TEST(FixedDirections, FixTheVertexIfAllOfItsDirectionsAreFixed) {
  World w = make_world(3);
  w.graph.fix_directions(w.poses[0], {0, 1, 2});
  const Plan plan = make_plan(w.graph, {});
  EXPECT_EQ(plan.structure.blocks(), 5u);
  EXPECT_TRUE(plan.held.empty());
  EXPECT_TRUE(plan.fixed_scalars.empty());
}

TEST(LargeEdges, AreLinearizedLikeTheDenseReference) {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  std::vector<VertexHandle<Vector2>> points;
  for (int k = 0; k < 14; ++k) {
    poses.push_back(graph.add_vertex(SE2(k, 0.3 * k, 0.1 * k)));
    points.push_back(graph.add_vertex(Vector2(2 * k, 7 - k)));
  }
  const auto stack = [](const auto& a, const auto& b) {
    using S = std::remove_cvref_t<decltype(a[0].x())>;
    std::vector<S> e;
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); j += 3) {
        const auto local = a[i].inverse_times(b[(i + j) % b.size()]);
        e.push_back(local[0]);
        e.push_back(local[0] * local[1] + a[(i + 1) % a.size()].x());
      }
    }
    return e;
  };
  const auto edge = graph.add_edge(stack, 0.5, poses, points);
  const int rows = static_cast<int>(graph.error(edge).size());
  ASSERT_GT(rows, 64);
  graph.add_edge(kBetween, poses[3], poses[1]);
  expect_equals_reference(graph, make_plan(graph, {}));
  std::vector<double> diagonal;
  for (int k = 0; k < rows; ++k) diagonal.push_back(0.5 + 0.1 * k);
  graph.set_information(edge, Information::diagonal(diagonal));
  graph.set_kernel(edge, Huber(1));
  graph.fix(poses[5]);
  graph.set_eliminated(points[2], true);
  expect_equals_reference(graph, make_plan(graph, {}));
  expect_equals_reference(graph, make_plan(graph, {}), {.triggs_correction = true});
}

}  // namespace
}  // namespace boxplus
