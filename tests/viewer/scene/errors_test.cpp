// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "boxplus/io/graph_file.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/robust/huber.h"
#include "boxplus/testing/simulate_bundle.h"
#include "boxplus/types/between.h"

namespace boxplus::viewer {
namespace {

using testing::ElementsAre;
using testing::FloatEq;
using testing::IsEmpty;
using testing::SizeIs;

/// Two steps of 1 m, the second of which is measured as 4 m with a standard deviation of 0.5 m, and an edge
/// that closes the loop without an error.
GraphFile with_outlier() {
  return parse_graph(
      "VERTEX_SE2 0 0 0 0\n"
      "VERTEX_SE2 1 1 0 0\n"
      "VERTEX_SE2 2 2 0 0\n"
      "EDGE_SE2 0 2 2 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 1 2 4 0 0 4 0 0 4 0 4\n",
      "test");
}

TEST(Errors, OfLinesAreChi2DividedByTheRows) {
  const Graph graph = with_outlier().graph;
  const Errors errors = read_errors(graph, make_structure(graph));
  // Odometry comes before the loop closure.
  EXPECT_THAT(errors.chi2, ElementsAre(0, 4 * 3 * 3 / 3, 0));
  EXPECT_THAT(errors.weights, IsEmpty());
  EXPECT_THAT(errors.points, IsEmpty());
}

TEST(Errors, HaveWeightsIfAnEdgeHasAKernel) {
  GraphFile file = with_outlier();
  file.graph.set_kernel(file.edges[2], Huber(1));
  const Errors errors = read_errors(file.graph, make_structure(file.graph));
  EXPECT_THAT(errors.weights, ElementsAre(1, FloatEq(1.0F / 6), 1));
  EXPECT_THAT(errors.chi2, ElementsAre(0, 12, 0));  // before the kernel
  file.graph.set_kernel(file.edges[2], nullptr);
  EXPECT_THAT(read_errors(file.graph, make_structure(file.graph)).weights, IsEmpty());
}

TEST(Errors, OfDisabledEdgesHaveTheWeightZero) {
  GraphFile file = with_outlier();
  file.graph.set_enabled(file.edges[2], false);
  const Errors errors = read_errors(file.graph, make_structure(file.graph));
  EXPECT_THAT(errors.weights, ElementsAre(1, 0, 1));
  EXPECT_THAT(errors.chi2, ElementsAre(0, 12, 0));
}

TEST(Errors, HaveTheVerdictsOfTheLastRun) {
  GraphFile file = with_outlier();
  const auto verdicts_of = [](std::vector<EdgeVerdict> list) { return Verdicts(list); };
  const Verdicts verdicts =
      verdicts_of({{file.edges[2], 1, 2, Verdict::kUndecided}, {file.edges[0], 0, 2, Verdict::kOutlier}});
  const Structure structure = make_structure(file.graph);
  // Lines: 0–1, 1–2, 0–2.
  EXPECT_THAT(read_errors(file.graph, structure, verdicts).verdicts, ElementsAre(0, 2, 3));
  EXPECT_THAT(read_errors(file.graph, structure).verdicts, IsEmpty());
  EXPECT_EQ(verdicts.of(file.edges[1]), std::nullopt);
  EXPECT_EQ(verdicts.of(file.edges[0]), Verdict::kOutlier);
}

TEST(Errors, HaveNoVerdictIfAnotherEdgeHasTheSlot) {
  GraphFile file = with_outlier();
  const std::vector<EdgeVerdict> list{{file.edges[0], 0, 2, Verdict::kOutlier}};
  const auto [from, to] =
      std::pair(file.graph.vertices(file.edges[0])[0], file.graph.vertices(file.edges[0])[1]);
  file.graph.remove(file.edges[0]);
  file.graph.add_edge(Between(SE2(2, 2, 0)), file.graph.typed<SE2>(from), file.graph.typed<SE2>(to));
  EXPECT_THAT(read_errors(file.graph, make_structure(file.graph), Verdicts(list)).verdicts,
              ElementsAre(0, 0, 0));
}

TEST(Errors, OfAllLinesOfAnEdgeAreTheSame) {
  Graph graph;
  const auto a = graph.add_vertex(Vector<double, 2>(0, 0)), b = graph.add_vertex(Vector<double, 2>(1, 0)),
             c = graph.add_vertex(Vector<double, 2>(2, 3));
  graph.add_edge([](const Vector2& x, const Vector2& y) { return y[0] - x[0] - 1; }, a, b);
  graph.add_edge([](const Vector2& x, const Vector2& y, const Vector2& z) { return x[0] - 2 * y[0] + z[1]; },
                 a, b, c);
  const Structure structure = make_structure(graph);
  EXPECT_THAT(structure.lines, ElementsAre(0, 1, 0, 1, 0, 2));
  EXPECT_THAT(structure.line_edges, ElementsAre(0, 0, 0));
  EXPECT_THAT(read_errors(graph, structure).chi2, ElementsAre(0, 1, 1));
}

TEST(Errors, SkipTheSlotsOfRemovedEdges) {
  GraphFile file = with_outlier();
  file.graph.remove(file.edges[1]);
  const Structure structure = make_structure(file.graph);
  EXPECT_THAT(read_errors(file.graph, structure).chi2, ElementsAre(12, 0));
}

TEST(Errors, OfPointsAreTheMeanOfTheirObservations) {
  BundleOptions options;
  options.cameras = 4;
  options.points = 10;
  const BundleSimulation scene = simulate_bundle(BundleShape::kRing, options);
  const Structure structure = make_structure(scene.graph);
  const Errors errors = read_errors(scene.graph, structure);
  ASSERT_THAT(errors.points, SizeIs(structure.count - structure.oriented));
  ASSERT_THAT(errors.chi2, SizeIs(scene.graph.edge_count()));
  // Each observation has two rows, so the sum over points and the sum over lines agree.
  double of_points = 0, of_lines = 0;
  for (std::size_t k = 0; k < errors.points.size(); ++k)
    of_points += static_cast<double>(errors.points[k]) * errors.points[k] * structure.track_lengths[k];
  for (const float chi2 : errors.chi2) of_lines += 2.0 * chi2;
  EXPECT_GT(of_lines, 0);
  EXPECT_NEAR(of_points / of_lines, 1, 1e-5);
}

}  // namespace
}  // namespace boxplus::viewer
