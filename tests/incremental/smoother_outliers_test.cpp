// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "boxplus/incremental/smoother.h"
#include "boxplus/outliers/outliers.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/types/slam2d.h"
#include "guess/placement.h"
#include "incremental/drive.h"
#include "testing/random_numbers.h"

namespace boxplus {
namespace {

/// Gives the vertices of a simulated world to a smoother one by one. Returns the closures that are set aside
/// in the end.
std::vector<EdgeRef> replay(Graph& graph, Smoother& smoother) {
  std::map<Id, std::vector<EdgeRef>> steps;
  for (const EdgeRef& edge : graph.all_edges()) {
    Id last = 0;
    for (const VertexRef& vertex : graph.vertices(edge)) last = std::max(last, graph.id(vertex));
    steps[last].push_back(edge);
    graph.set_level(edge, 1);
  }
  Placement placement(graph);
  for (const VertexRef& vertex : graph.all_vertices()) {
    if (!graph.is_fixed(vertex)) placement.expect(vertex);
  }
  for (const auto& [id, edges] : steps) {
    for (const EdgeRef& edge : edges) {
      graph.set_level(edge, 0);
      placement.place_by(edge);
    }
    (void)smoother.update();
  }
  EXPECT_TRUE(smoother.finish().converged());
  return smoother.set_aside();
}

TEST(Smoother, SetsFalseClosuresAsideAsTheSearchOfTheWholeGraphDoes) {
  for (const World world : {World::kManhattan, World::kSphere}) {
    Simulation simulation = simulate(world, {.poses = 400, .seed = 2, .outliers = 0.3});
    Graph whole = simulation.graph;
    const OutlierReport expected = find_outliers(whole);
    Smoother smoother(simulation.graph, {.sets_outliers_aside = true});
    std::vector<EdgeRef> aside = replay(simulation.graph, smoother), others;
    for (const EdgeVerdict& verdict : expected.verdicts) {
      if (verdict.weight == 0) others.push_back(verdict.edge);
    }
    std::sort(aside.begin(), aside.end());
    std::sort(others.begin(), others.end());
    EXPECT_EQ(aside, others) << to_string(world);
    double chi2 = 0;
    for (const EdgeRef& edge : simulation.graph.all_edges()) {
      if (!std::binary_search(aside.begin(), aside.end(), edge)) chi2 += simulation.graph.chi2(edge);
    }
    EXPECT_NEAR(chi2, expected.report.chi2_final, 1e-4 * chi2);
  }
}

TEST(Smoother, TakesAClosureBackIfLaterOnesSpeakForIt) {
  // The noise is five times what Ω says, so that the first closures seem false.
  RandomNumbers random(1);
  const auto noise = [&] { return 0.05 * random.normal(); };
  Graph graph;
  Smoother smoother(graph, {.sets_outliers_aside = true});
  std::vector<VertexHandle<SE2>> poses;
  constexpr int kLap = 40;
  std::size_t aside = 0, back = 0;
  const auto add = [&](const SE2& motion, std::size_t from) {
    const SE2 measured = motion * SE2(noise(), noise(), 0.1 * noise());
    if (from == poses.size()) poses.push_back(graph.add_vertex(graph.estimate(poses.back()) * measured));
    const auto first = from + 1 == poses.size() ? poses[poses.size() - 2] : poses[from];
    graph.add_edge(Between(measured), 1e4, first, poses.back());
  };
  poses.push_back(graph.add_vertex(SE2()));
  for (int k = 1; k < 3 * kLap; ++k) {
    add(SE2(1, 0, 2 * kPi / kLap), poses.size());
    if (k >= kLap) add(SE2(), poses.size() - 1 - kLap);
    const SmootherReport report = smoother.update();
    aside += report.set_aside.size();
    back += report.taken_back.size();
  }
  back += smoother.finish().taken_back.size();
  EXPECT_GT(aside, 0u);
  EXPECT_GT(back, 0u);
  EXPECT_TRUE(smoother.set_aside().empty());
}

TEST(Smoother, JudgesAClosureInTheNextUpdateIfTheStopFlagIsRaised) {
  Graph graph;
  std::atomic<bool> stop = false;
  Smoother smoother(graph, {.stop = &stop, .sets_outliers_aside = true});
  std::vector<VertexHandle<SE2>> poses{graph.add_vertex(SE2())};
  const auto drive = [&](int count) {
    for (int k = 0; k < count; ++k) {
      poses.push_back(graph.add_vertex(graph.estimate(poses.back()) * SE2(1, 0, 0)));
      graph.add_edge(Between(SE2(1, 0, 0)), 100.0, poses[poses.size() - 2], poses.back());
    }
  };
  drive(20);
  EXPECT_TRUE(smoother.update().converged());
  drive(3);
  const auto wrong = graph.add_edge(Between(SE2(0, 9, 1)), 100.0, poses[2], poses.back());
  stop = true;
  EXPECT_EQ(smoother.update().reason, SmootherReport::Reason::kStopFlag);
  stop = false;
  const SmootherReport report = smoother.update();
  EXPECT_TRUE(report.converged());
  EXPECT_EQ(report.set_aside, std::vector<EdgeRef>{wrong});
  EXPECT_NEAR(graph.estimate(poses.back()).translation()[0], 23, 1e-6);
}

TEST(Smoother, ForgetsAClosureThatWasRemovedWhileItWasAside) {
  Drive drive(3);
  Smoother smoother(drive.graph, {.sets_outliers_aside = true});
  for (int k = 0; k < 30; ++k) drive.step();
  (void)smoother.update();
  const auto wrong = drive.graph.add_edge(Between(SE2(50, 9, 1)), 1e4, drive.poses()[2], drive.poses()[25]);
  (void)smoother.update();
  EXPECT_EQ(smoother.set_aside(), std::vector<EdgeRef>{wrong});
  drive.graph.push();
  drive.graph.pop();
  drive.graph.remove(wrong);
  EXPECT_NO_THROW((void)smoother.update());
  EXPECT_TRUE(smoother.set_aside().empty());
}

TEST(Smoother, TakesAClosureThatIsTheOnlyEdgeOfAVertex) {
  Drive drive(4);
  Smoother smoother(drive.graph, {.sets_outliers_aside = true});
  for (int k = 0; k < 20; ++k) drive.step();
  (void)smoother.update();
  const auto lone = drive.graph.add_vertex(SE2());
  for (const std::size_t k : {3u, 4u}) {
    const SE2 seen = drive.graph.estimate(drive.poses()[k]).inverse() * SE2(2, 2, 0);
    drive.graph.add_edge(Between(seen), 100.0, drive.poses()[k], lone);
  }
  EXPECT_TRUE(smoother.update().converged());
  EXPECT_NEAR(drive.graph.estimate(lone).translation()[0], 2, 0.1);
}

}  // namespace
}  // namespace boxplus
