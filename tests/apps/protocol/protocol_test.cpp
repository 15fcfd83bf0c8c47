// SPDX-License-Identifier: BSD-3-Clause
#include "protocol/protocol.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"

namespace boxplus::app {
namespace {

using testing::HasSubstr;

class ProtocolTest : public testing::Test {
 protected:
  /// The answers to a text of commands.
  std::string answer(std::string_view text) {
    CommandStream stream("input");
    Protocol protocol(
        graph, "input", [&] { ++solved; }, limits);
    std::string answers;
    while (const auto command = stream.next(text)) protocol.execute(*command, answers);
    stream.finish();
    return answers;
  }

  /// The message of the error that a text causes.
  std::string error(std::string_view text) {
    try {
      answer(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  Graph graph;
  ProtocolLimits limits;
  int solved = 0;
};

TEST_F(ProtocolTest, AQueryAnswersWithTheEstimatesByAscendingIdOrInTheOrderOfTheQuestion) {
  EXPECT_EQ(answer("ADD VERTEX_XYT 7 1 2.5 -0.5; ADD VERTEX_XYT 3 0 0 0.25; QUERY_STATE;"),
            "BEGIN\nVERTEX_XYT 3 0 0 0.25\nVERTEX_XYT 7 1 2.5 -0.5\nEND\n");
  EXPECT_EQ(answer("QUERY_STATE 7 3;"), "BEGIN\nVERTEX_XYT 7 1 2.5 -0.5\nVERTEX_XYT 3 0 0 0.25\nEND\n");
}

TEST_F(ProtocolTest, TheFirstEdgePlacesAVertexWithoutAnEstimateInBothDirections) {
  const std::string text = answer(
      "ADD VERTEX_XYT 1 1 0 1.5707963267948966; ADD VERTEX_XYT 2;"
      "ADD EDGE_XYT 1 2 2 0 0.5 1 0 0 1 0 1;"  // without the id of the edge
      "ADD EDGE_XYT 9 0 1 1 0 0 1 0 0 1 0 1;"  // with it; vertex 0 is new
      "ADD EDGE_XYT 1 2 50 0 0 1 0 0 1 0 1;"   // vertex 2 has its place
      "QUERY_STATE;");
  const auto pose = [&](Id id) { return graph.estimate(graph.vertex<SE2>(id)).vector(); };
  EXPECT_TRUE(pose(2).isApprox(Vector3(1, 2, kPi / 2 + 0.5), 1e-12)) << text;
  EXPECT_TRUE(pose(0).isApprox(Vector3(1, -1, kPi / 2), 1e-12)) << text;
  EXPECT_EQ(graph.edge_count(), 3u);
}

TEST_F(ProtocolTest, AGivenEstimateStays) {
  answer("ADD VERTEX_XYT 0 0 0 0; ADD VERTEX_XYT 1 5 5 1; ADD EDGE_XYT 0 1 1 0 0 1 0 0 1 0 1;");
  EXPECT_EQ(graph.estimate(graph.vertex<SE2>(1)).vector(), Vector3(5, 5, 1));
}

TEST_F(ProtocolTest, AnglesInSpaceAreReadAndAnswered) {
  const std::string text = answer("ADD VERTEX_XYZRPY 0 1 2 3 0.25 -0.5 2; QUERY_STATE 0;");
  Id id = 0;
  double x = 0, y = 0, z = 0, roll = 0, pitch = 0, yaw = 0;
  ASSERT_EQ(std::sscanf(text.c_str(), "BEGIN\nVERTEX_XYZRPY %ld %lf %lf %lf %lf %lf %lf\nEND\n", &id, &x, &y,
                        &z, &roll, &pitch, &yaw),
            7)
      << text;
  EXPECT_EQ(Vector3(x, y, z), Vector3(1, 2, 3));
  EXPECT_TRUE(Vector3(roll, pitch, yaw).isApprox(Vector3(0.25, -0.5, 2), 1e-12)) << text;
}

TEST_F(ProtocolTest, AtAVerticalPitchTheAnswerIsTheSameRotation) {
  answer("ADD VERTEX_XYZRPY 0 0 0 0 0.5 1.5707963267948966 0.25;");
  const std::string text = answer("QUERY_STATE 0;"), begin = "BEGIN\nVERTEX_XYZRPY 0 ";
  ASSERT_EQ(text.substr(0, begin.size()), begin);
  answer("ADD VERTEX_XYZRPY 1 " + text.substr(begin.size(), text.find("\nEND") - begin.size()) + ";");
  const auto rotation = [&](Id id) { return graph.estimate(graph.vertex<SE3>(id)).rotation(); };
  EXPECT_TRUE(rotation(1).isApprox(rotation(0), 1e-7)) << text;
}

TEST_F(ProtocolTest, AnEdgeInSpaceIsTheEdgeOfAFileWithTheSameFields) {
  const char* const fields = " 0 1 1 0 0.5 0.1 -0.2 3 9 0 0 0 0 1 9 0 0 0 0 9 0 0 0 4 0 0 4 0 4";
  answer(std::string("ADD EDGE_XYZRPY") + fields + ";");
  const GraphFile file =
      parse_graph(std::string("VERTEX3 0 0 0 0 0 0 0\nVERTEX3 1 0 0 0 0 0 0\nEDGE3") + fields, "file");
  EXPECT_EQ(graph.information(graph.all_edges()[0]).matrix(),
            file.graph.information(file.graph.all_edges()[0]).matrix());
  EXPECT_NEAR(graph.chi2(), 0, 1e-20);  // the edge placed vertex 1
}

TEST_F(ProtocolTest, FixAndSolveCallTheProgram) {
  answer("ADD VERTEX_XYT 0; ADD VERTEX_XYT 1; FIX 1 0; SOLVE_STATE; SOLVE_STATE;");
  EXPECT_TRUE(graph.is_fixed(*graph.find_vertex(0)));
  EXPECT_EQ(solved, 2);
}

TEST_F(ProtocolTest, ErrorsNameLineAndColumn) {
  answer("ADD VERTEX_XYT 0 0 0 0; ADD VERTEX_XYZRPY 9;");
  const std::pair<const char*, const char*> cases[] = {
      {"\n MOVE 1;", "input:2:2: expected ADD, FIX, QUERY_STATE or SOLVE_STATE, got 'MOVE'"},
      {"ADD VERTEX_XY 1;",
       "input:1:5: expected VERTEX_XYT, VERTEX_XYZRPY, EDGE_XYT or EDGE_XYZRPY, got 'VERTEX_XY'"},
      {"ADD;", "input:1:4: expected a type"},
      {"ADD VERTEX_XYT 0;", "input:1:16: expected a new id, but vertex 0 is already there"},
      {"ADD VERTEX_XYT -1;", "input:1:16: expected the id of a vertex from 0 to 2147483647, got -1"},
      {"ADD VERTEX_XYT 2147483648;", "input:1:16: expected the id of a vertex from 0 to 2147483647"},
      {"ADD VERTEX_XYT 1\n0 nan 0;", "input:2:3: expected"},
      {"ADD VERTEX_XYT 1 0 0;", "input:1:21: expected"},
      {"ADD VERTEX_XYT 1 0 0 0 0;", "input:1:24: expected the end of the line, got '0'"},
      {"ADD EDGE_XYT 0 0 1 0 0 1 0 0 1 0 1;", "input:1:16: expected two vertices, got 0 twice"},
      {"ADD EDGE_XYT 0 9 1 0 0 1 0 0 1 0 1;",
       "input:1:16: expected a pose in the plane, but vertex 9 is another one"},
      {"ADD EDGE_XYT 0 5 1 0 0 1 0 0 -1 0 1;",
       "input:1:24: information: expected a positive semi-definite matrix, got the diagonal entry -1"},
      {"ADD EDGE_XYT 0 5 1 0 0 1 0;", "expected"},
      {"FIX;", "input:1:4: expected the id of a vertex"},
      {"FIX 0 77;", "input:1:7: expected the id of a vertex, but there is no vertex 77"},
      {"QUERY_STATE 77;", "input:1:13: expected the id of a vertex, but there is no vertex 77"},
      {"SOLVE_STATE 1;", "input:1:13: expected the end of the line, got '1'"},
      {"SOLVE_STATE", "input:1:12: expected a ; after the command, got the end of the input"},
  };
  for (const auto& [text, message] : cases) EXPECT_THAT(error(text), HasSubstr(message)) << text;
  EXPECT_EQ(graph.vertex_count(), 2u) << "a refused command has changed the graph";
  EXPECT_EQ(graph.edge_count(), 0u);
  EXPECT_FALSE(graph.is_fixed(*graph.find_vertex(0)));
}

TEST_F(ProtocolTest, TheGraphHasALargestSize) {
  limits = {.max_id = 100, .max_vertices = 3, .max_edges = 1};
  EXPECT_THAT(error("ADD VERTEX_XYT 0; ADD VERTEX_XYT 1; ADD VERTEX_XYT 2; ADD VERTEX_XYT 3;"),
              HasSubstr("input:1:70: expected at most 3 vertices"));
  graph.clear();
  EXPECT_THAT(error("ADD EDGE_XYT 0 1 1 0 0 1 0 0 1 0 1; ADD EDGE_XYT 1 0 1 0 0 1 0 0 1 0 1;"),
              HasSubstr("expected at most 3 vertices and 1 edges"));
}

}  // namespace
}  // namespace boxplus::app
