// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/scans.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "viewer/protocol/messages.h"

namespace boxplus::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Three beams to the left, 1 m, 2 m and 20 m long. The last one has hit nothing.
constexpr const char* kRaw = "RAWLASER1 0 1.5707963267948966 0 0 20 0 0 3 1 2 20 0 5 robot 5\n";
/// One beam ahead, of a laser 1 m in front of the robot.
constexpr const char* kLaser = "ROBOTLASER1 0 0 0 0 20 0 0 1 3 0 1 0 0 0 0 0 0 0 0 0 0 5 robot 5\n";

GraphFile parse(const std::string& text) {
  return parse_graph(text, "log");
}

TEST(Scans, HaveTheirPointsInTheFramesOfTheirPoses) {
  const GraphFile file =
      parse(std::string("VERTEX_XY 3 0 0\nVERTEX_SE2 7 5 5 1\nVERTEX_TAG door 1 0 0 0 0 0 5 h 5\n") + kLaser +
            "VERTEX_SE2 9 6 5 1\n" + kRaw);
  const Structure structure = make_structure(file.graph);
  const Scans scans = ScansOfFile(file, "log").of(file.graph, structure);
  EXPECT_THAT(scans.vertices, ElementsAre(0, 1)) << "poses come before points";
  EXPECT_THAT(scans.counts, ElementsAre(1, 2));
  using testing::FloatNear;
  EXPECT_THAT(scans.points, ElementsAre(4, 0, 0, FloatNear(0, 1e-6F), 1, 0, FloatNear(0, 1e-6F), 2, 0));
}

TEST(Scans, OfPointsAndOfRemovedPosesAreNotDrawn) {
  GraphFile file = parse(std::string("VERTEX_XY 3 0 0\n") + kRaw + "VERTEX_SE2 7 5 5 1\n" + kRaw +
                         "VERTEX_SE2 8 5 5 1\n" + kLaser);
  const ScansOfFile of_file(file, "log");
  file.graph.remove(*file.graph.find_vertex(7));
  const Scans scans = of_file.of(file.graph, make_structure(file.graph));
  EXPECT_THAT(scans.vertices, ElementsAre(0));
  EXPECT_THAT(scans.points, ElementsAre(4, 0, 0));
}

TEST(Scans, ThatAreMalformedAreNoted) {
  const GraphFile file = parse(std::string("VERTEX_SE2 7 5 5 1\nRAWLASER1 0 x\n") + kRaw);
  const ScansOfFile of_file(file, "log");
  EXPECT_THAT(of_file.notes(), ElementsAre(HasSubstr("log:2:13: expected the angle of the first beam")));
  EXPECT_FALSE(of_file.of(file.graph, make_structure(file.graph)).empty());
}

TEST(Scans, WithVeryManyPointsAreThinnedEvenly) {
  std::string line = "RAWLASER1 0 0 0 0 20 0 0 1000";
  for (int k = 0; k < 1000; ++k) line += " " + std::to_string(1 + k / 100);
  line += " 0 5 robot 5\n";
  std::string text = "VERTEX_SE2 0 0 0 0\n";
  for (int k = 0; k < 1500; ++k) text += line;
  const GraphFile file = parse(text);
  const ScansOfFile of_file(file, "log");
  EXPECT_THAT(of_file.notes(), ElementsAre("750000 of 1500000 points of laser scans are drawn"));
  const Scans scans = of_file.of(file.graph, make_structure(file.graph));
  EXPECT_EQ(scans.points.size(), 3 * 750000);
  EXPECT_EQ(scans.counts.front(), 500);
  EXPECT_EQ(scans.counts.back(), 500);
}

TEST(Scans, AreArraysOfTheMessageOfTheStructure) {
  const GraphFile file = parse(std::string("VERTEX_SE2 7 5 5 1\n") + kRaw);
  const Structure structure = make_structure(file.graph);
  const auto arrays = [&](const Scans& scans) {
    const Message message = structure_message(structure, 1, 2, scans);
    const std::size_t begin = message->find('{');
    return nlohmann::json::parse(message->substr(begin, message->rfind('}') - begin + 1))["arrays"];
  };
  const nlohmann::json with = arrays(ScansOfFile(file, "log").of(file.graph, structure)),
                       without = arrays({});
  EXPECT_EQ(with["scan_vertices"]["count"], 1);
  EXPECT_EQ(with["scan_counts"]["count"], 1);
  EXPECT_EQ(with["scan_points"]["count"], 6);
  EXPECT_FALSE(without.contains("scan_points"));
}

}  // namespace
}  // namespace boxplus::viewer
