// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/diagnosis_json.h"

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
  EXPECT_EQ(finding["marked"], Json::array({3}));
}

TEST(DiagnosisJson, MarksTheVerticesOfEdges) {
  FourPoses world;
  world.graph.add_edge(Between(SE2(1, 0, 0)), Information(0.0), world.poses[1], world.poses[2]);
  const Json finding = found(diagnosed(world.graph), "zero-information");
  ASSERT_FALSE(finding.is_null());
  EXPECT_EQ(finding["element"], (Json{{"key", "edge"}, {"number", "2"}}));
  EXPECT_EQ(finding["marked"], Json::array({1, 2}));
}

TEST(DiagnosisJson, NamesNoElementIfThereAreSeveral) {
  FourPoses world;
  const auto a = world.graph.add_vertex(SE2(), 20), b = world.graph.add_vertex(SE2(), 21);
  world.graph.add_edge(Between(SE2()), a, b);
  const Json finding = found(diagnosed(world.graph), "free-component");
  ASSERT_FALSE(finding.is_null());
  EXPECT_TRUE(finding["element"].is_null());
  EXPECT_EQ(finding["marked"], Json::array({4, 5}));
}

}  // namespace
}  // namespace boxplus::viewer
