// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/protocol/diagnosis_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "boxplus/boxplus.h"

namespace boxplus::viewer {
namespace {

using Json = nlohmann::json;

/// Poses 0, 1 and 2 in a row, and pose 10 without an edge.
struct FourPoses {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;

  FourPoses() {
    for (const Id id : {0, 1, 2, 10})
      poses.push_back(graph.add_vertex(SE2(static_cast<double>(id), 0, 0), id));
    graph.fix(poses[0]);
    graph.add_edge(Between(SE2(1, 0, 0)), poses[0], poses[1]);
    graph.add_edge(Between(SE2(1, 0, 0)), poses[1], poses[2]);
  }
};

Json diagnosed(const Graph& graph) {
  return Json::parse(diagnosis_json(graph, make_structure(graph), diagnose(graph), 7));
}

Json found(const Json& diagnosis, const std::string& kind) {
  for (const Json& finding : diagnosis["findings"]) {
    if (finding["kind"] == kind) return finding;
  }
  return nullptr;
}

TEST(DiagnosisJson, NamesTheOnlyVertexOfAFindingAndMarksIt) {
  const Json diagnosis = diagnosed(FourPoses().graph);
  EXPECT_EQ(diagnosis["structure"], 7);
  EXPECT_EQ(diagnosis["count"], diagnosis["findings"].size());
  const Json finding = found(diagnosis, "isolated-vertex");
  ASSERT_FALSE(finding.is_null()) << diagnosis;
  EXPECT_EQ(finding["severity"], "warning");
  EXPECT_EQ(finding["element"], (Json{{"key", "id"}, {"number", "10"}}));
  EXPECT_EQ(finding["vertices"], (Json{{"count", 1}, {"marked", {3}}}));
  EXPECT_EQ(finding["edges"]["count"], 0);
}

TEST(DiagnosisJson, MarksEdges) {
  FourPoses world;
  world.graph.add_edge(Between(SE2(1, 0, 0)), Information(0.0), world.poses[1], world.poses[2]);
  const Json finding = found(diagnosed(world.graph), "zero-information");
  ASSERT_FALSE(finding.is_null());
  EXPECT_EQ(finding["element"], (Json{{"key", "edge"}, {"number", "2"}}));
  EXPECT_EQ(finding["vertices"]["count"], 0);
  EXPECT_EQ(finding["edges"], (Json{{"count", 1}, {"marked", 1}, {"lines", {2}}}));
}

TEST(DiagnosisJson, NamesNoElementIfThereAreSeveral) {
  FourPoses world;
  const auto a = world.graph.add_vertex(SE2(), 20), b = world.graph.add_vertex(SE2(), 21);
  world.graph.add_edge(Between(SE2()), a, b);
  const Json finding = found(diagnosed(world.graph), "free-component");
  ASSERT_FALSE(finding.is_null());
  EXPECT_TRUE(finding["element"].is_null());
  EXPECT_EQ(finding["vertices"], (Json{{"count", 2}, {"marked", {4, 5}}}));
}

/// An edge between poses 1 and 2 with three vertices has two lines.
TEST(DiagnosisJson, MarksAllLinesOfAnEdgeAndTheVertexOfAPrior) {
  FourPoses world;
  Diagnosis diagnosis;
  diagnosis.findings.resize(2);
  const auto triple =
      world.graph.add_edge([](const SE2& a, const SE2& b, const SE2& c) { return a.x() + b.x() + c.x(); },
                           world.poses[0], world.poses[1], world.poses[3]);
  const auto prior = world.graph.add_edge([](const SE2& x) { return x.x(); }, world.poses[2]);
  diagnosis.findings[0].edges = {triple};
  diagnosis.findings[1].edges = {prior};
  const Structure structure = make_structure(world.graph);
  const Json json = Json::parse(diagnosis_json(world.graph, structure, diagnosis, 1));
  const Json edges = json["findings"][0]["edges"];
  EXPECT_EQ(edges["marked"], 1);
  ASSERT_EQ(edges["lines"].size(), 2U);
  for (const Json& line : edges["lines"]) EXPECT_EQ(structure.lines[2 * line.get<std::size_t>()], 0U);
  EXPECT_EQ(json["findings"][1]["edges"]["count"], 0);
  EXPECT_EQ(json["findings"][1]["vertices"], (Json{{"count", 1}, {"marked", {2}}}));
}

TEST(DiagnosisJson, CountsWhatIsNotMarkedBecauseThereIsTooMuch) {
  Graph graph;
  Diagnosis diagnosis;
  diagnosis.findings.resize(1);
  constexpr std::size_t kCount = kMostMarked + 5;
  auto before = graph.add_vertex(SE2());
  for (std::size_t k = 0; k < kCount; ++k) {
    const auto vertex = graph.add_vertex(SE2());
    diagnosis.findings[0].vertices.push_back(vertex);
    diagnosis.findings[0].edges.push_back(graph.add_edge(Between(SE2()), before, vertex));
    before = vertex;
  }
  const Json finding = Json::parse(diagnosis_json(graph, make_structure(graph), diagnosis, 1))["findings"][0];
  EXPECT_EQ(finding["vertices"]["count"], kCount);
  EXPECT_EQ(finding["vertices"]["marked"].size(), kMostMarked);
  EXPECT_EQ(finding["edges"]["count"], kCount);
  EXPECT_EQ(finding["edges"]["marked"], kMostMarked);
  EXPECT_EQ(finding["edges"]["lines"].size(), kMostMarked);
}

}  // namespace
}  // namespace boxplus::viewer
