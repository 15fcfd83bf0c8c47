// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "boxplus/boxplus.h"
#include "boxplus/testing/simulate.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

constexpr const char* kTwoPoses = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0.5\n";

/// What the reader says about bad text.
std::string complaint(const std::string& text) {
  try {
    parse_graph(text, "g");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(GraphReader, ReadsPosesLandmarksAndTheirEdges) {
  const GraphFile file = parse_graph(
      "# a comment\n\n   \nVERTEX_SE2 0 0 0 0\r\nFIX 0\nVERTEX_SE2 3 1 0 0.5\nVERTEX_XY 7 2 3\n"
      "EDGE_SE2 0 3 1 0 0.5 1 0 0 2 0 3\nEDGE_SE2_XY 0 7 2 3 1 0 1",
      "g");
  EXPECT_EQ(file.graph.vertex_count(), 3u);
  EXPECT_THAT(file.edges, SizeIs(2));
  EXPECT_TRUE(file.graph.is_fixed(file.graph.vertex<SE2>(0)));
  EXPECT_EQ(file.graph.estimate(file.graph.vertex<Vector2>(7)), Vector2(2, 3));
  EXPECT_EQ(file.graph.information(file.edges[0])(1, 1), 2);
  EXPECT_EQ(file.graph.chi2(), 0);
  EXPECT_THAT(file.notes, IsEmpty());
}

TEST(GraphReader, AcceptsEdgesBeforeTheirVertices) {
  EXPECT_EQ(parse_graph(std::string("EDGE_SE2 0 1 1 0 0.5 1 0 0 1 0 1\n") + kTwoPoses, "g").edges.size(), 1u);
}

TEST(GraphReader, ReadsTorosOrderOfInformation) {
  const GraphFile file =
      parse_graph("VERTEX2 0 0 0 0\nVERTEX2 1 1 0 0\nEDGE2 0 1 1 0 0 10 1 20 30 2 3\n", "g");
  const InformationView omega = file.graph.information(file.edges[0]);
  EXPECT_EQ(omega(0, 0), 10);
  EXPECT_EQ(omega(0, 1), 1);
  EXPECT_EQ(omega(1, 1), 20);
  EXPECT_EQ(omega(2, 2), 30);
  EXPECT_EQ(omega(0, 2), 2);
  EXPECT_EQ(omega(1, 2), 3);
}

TEST(GraphReader, ReadsTorosRollPitchAndYaw) {
  const GraphFile file = parse_graph(
      "VERTEX3 0 0 0 0 0 0 0\nVERTEX3 1 1 2 3 0.3 -0.4 1.2\nEDGE3 0 1 1 2 3 0.3 -0.4 1.2 "
      "1 0 0 5 0 0 2 0 0 0 0 3 0 0 0 100 0 7 200 0 300\n",
      "g");
  const Eigen::Matrix3d expected =
      (Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  const SE3& pose = file.graph.estimate(file.graph.vertex<SE3>(1));
  EXPECT_LT((pose.rotation() - expected).norm(), 1e-15);
  EXPECT_EQ(pose.translation(), Vector3(1, 2, 3));
  EXPECT_LT(file.graph.chi2(), 1e-28);
  const InformationView omega = file.graph.information(file.edges[0]);
  EXPECT_EQ(omega(1, 1), 2);
  EXPECT_EQ(omega(0, 3), 2 * 5) << "an angle is twice its part of a quaternion";
  EXPECT_EQ(omega(3, 3), 4 * 100);
  EXPECT_EQ(omega(3, 5), 4 * 7);
}

TEST(GraphReader, NamesTheUnknownTagOfTheLineThatAMissingVertexIsIn) {
  EXPECT_EQ(
      complaint("VERTEX_XY 7 2 3\nVERTEX_CAM 4 0 0 0 1 500\nEDGE_SE2_XY 4 7 2 3 1 0 1\n"),
      "g:3:13: expected the id of a vertex, but there is no vertex 4; line 2 has that id after the unknown "
      "tag 'VERTEX_CAM'");
  EXPECT_THAT(complaint("VERTEX_SE2 0 0 0 0\nVERTEX_XY 1 3 0\nPARAMS_CAMERA 5 1 0 0\n"
                        "EDGE_SE2_POINTXY_OFFSET 0 1 5 2 0 1 0 1\n"),
              HasSubstr("there is no parameter 5; line 3 has that id after the unknown tag 'PARAMS_CAMERA'"));
  EXPECT_THAT(complaint("VERTEX_CAM 4 0 0 0 1 500\nVERTEX_XY 7 2 3\nFIX 4\n"), HasSubstr("'VERTEX_CAM'"));
}

TEST(GraphReader, BlamesNoUnknownTagForAVertexThatNoLineHas) {
  EXPECT_THAT(
      complaint("VERTEX_XY 7 2 3\nVERTEX_CAM 5 0\nEDGE_CAM 4 7 1\nVERTEX_CAM\nEDGE_SE2_XY 4 7 2 3 1 0 1\n"),
      testing::EndsWith("there is no vertex 4"));
}

TEST(GraphReader, ReadsTheSameForAnyNumberOfThreads) {
  Simulation simulation = simulate(World::kCity, {.poses = 3000});
  const GraphFile made{.graph = std::move(simulation.graph), .edges = std::move(simulation.edges)};
  const std::string text = format_graph(made);
  ASSERT_GT(text.size(), 3 * 131072u) << "several blocks";
  for (int threads : {1, 2, 5}) {
    ReadOptions options;
    options.threads = threads;
    EXPECT_EQ(format_graph(parse_graph(text, "g", options)), text);
  }
}

TEST(GraphReader, TakesAByteOrderMarkForNothing) {
  EXPECT_EQ(parse_graph(std::string("\xEF\xBB\xBF") + kTwoPoses, "g").graph.vertex_count(), 2u);
}

TEST(GraphReader, ReadsWordsUnderOtherNames) {
  ReadOptions options;
  options.renames = {{"POSE", "VERTEX_SE2"}, {"VERTEX_SE2", "VERTEX_XY"}};
  const GraphFile file = parse_graph("POSE 0 0 0 0\nVERTEX_SE2 1 2 3\n", "g", options);
  EXPECT_EQ(file.graph.estimate(file.graph.vertex<Vector2>(1)), Vector2(2, 3));
  EXPECT_EQ(format_graph(file), "VERTEX_SE2 0 0 0 0\nVERTEX_XY 1 2 3\n");
}

TEST(GraphReader, AppliesSensorOffsets) {
  const GraphFile file = parse_graph(
      "PARAMS_SE2OFFSET 5 1 0 0\nVERTEX_SE2 0 0 0 0\nVERTEX_XY 1 3 0\nEDGE_SE2_POINTXY_OFFSET 0 1 5 2 0 1 0 "
      "1\n",
      "g");
  EXPECT_EQ(file.graph.parameter_count(), 1u);
  EXPECT_EQ(file.graph.chi2(), 0);
}

TEST(GraphReader, ReadsOneOffsetAtBothEndsOfAnEdge) {
  const GraphFile file = parse_graph(
      std::string(kTwoPoses) + "PARAMS_SE2OFFSET 5 1 0 0\nEDGE_SE2_OFFSET 0 1 5 5 1 0 0.5 1 0 0 1 0 1\n",
      "g");
  EXPECT_THAT(file.graph.vertices(file.edges[0]), SizeIs(3));
}

TEST(GraphReader, ReadsEdgesOverAnyNumberOfPoints) {
  const GraphFile file = parse_graph(
      "VERTEX_SE2 0 0 0 0\nVERTEX_XY 1 3 0\nVERTEX_XY 2 0 4\n"
      "EDGE_SE2_LOTSOFXY 0 1 2 || 2 3 0 0 5 1 0 0 0 1 0 0 1 0 1\n",
      "g");
  EXPECT_NEAR(file.graph.chi2(), 1, 1e-15);
}

TEST(GraphReader, CreatesTheVerticesThatAnEdgeWithAnUnassignedOneNames) {
  const GraphFile file = parse_graph(
      "EDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 -1 0 1 0 0 1 0 0 1 0 1\n",
      "edges");
  EXPECT_TRUE(file.graph.find_vertex(0));
  EXPECT_EQ(file.graph.vertex_count(), 3u);
  const std::string written = format_graph(file);
  EXPECT_EQ(format_graph(parse_graph(written, "written")), written);
}

TEST(GraphReader, CreatesTheVerticesOfAFileWithEdgesOnlyAndSaysSo) {
  const GraphFile file = parse_graph("EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2_XY 1 9 1 0 1 0 1\n", "g");
  EXPECT_TRUE(file.vertices_created);
  EXPECT_EQ(file.graph.vertex_count(), 3u);
  ASSERT_THAT(file.notes, SizeIs(1));
  EXPECT_THAT(file.notes[0].text, HasSubstr("3 vertices were created"));
}

TEST(GraphReader, KeepsAndNotesUnknownLines) {
  const GraphFile file = parse_graph(std::string(kTwoPoses) + "ROBOTLASER1 x y\nROBOTLASER1 z\n", "g");
  EXPECT_THAT(file.kept, SizeIs(2));
  ASSERT_THAT(file.notes, SizeIs(1));
  EXPECT_THAT(file.notes[0].text, HasSubstr("2 lines with the unknown word 'ROBOTLASER1'"));
}

TEST(GraphReader, LeavesOutEdgesWithUnassignedVertices) {
  const GraphFile file = parse_graph(std::string(kTwoPoses) + "EDGE_SE2 0 -1 1 0 0 1 0 0 1 0 1\n", "g");
  EXPECT_THAT(file.edges, IsEmpty());
  EXPECT_THAT(file.kept, SizeIs(1));
}

TEST(GraphReader, MakesNoVerticesForSkippedLinesOfAFileWithEdgesOnly) {
  const GraphFile file = parse_graph(
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 1 7 1 0 0 1 0 0 1 0 x\nEDGE_SE2 9 9 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 1 8 1 0 0 1 2 0 1 0 1\n",
      "g", {.lenient = true});
  EXPECT_EQ(file.skipped, 3);
  EXPECT_EQ(file.graph.vertex_count(), 2u);
}

TEST(GraphReader, RefusesAnIndefiniteInformationOfAnUnassignedEdge) {
  EXPECT_THAT(complaint(std::string(kTwoPoses) + "EDGE_SE2 0 -1 1 0 0 1 2 0 1 0 1\n"),
              StartsWith("g:3:21: information: expected a positive semi-definite matrix"));
}

TEST(GraphReader, RefusesBadVertices) {
  EXPECT_EQ(complaint("VERTEX_SE2 0 1 2"), "g:1:17: expected the heading θ, got the end of the line");
  EXPECT_EQ(complaint("\nVERTEX_SE2 0 1 nan 2"), "g:2:16: expected y (a finite number), got 'nan'");
  EXPECT_EQ(complaint("VERTEX_SE2 -2 1 2 3"), "g:1:12: expected an id ≥ 0, got -2");
  EXPECT_THAT(complaint(std::string(kTwoPoses) + "VERTEX_XY 1 0 0"), HasSubstr("g:3:11: expected a new id"));
  EXPECT_THAT(complaint("VERTEX_SE2 0 1 2 3 4"), HasSubstr("g:1:20: expected the end of the line, got '4'"));
}

TEST(GraphReader, RefusesBadEdges) {
  const std::string poses = std::string(kTwoPoses) + "VERTEX_XY 2 0 0\n";
  EXPECT_THAT(complaint(poses + "EDGE_SE2 0 9 1 0 0 1 0 0 1 0 1"),
              HasSubstr("g:4:12: expected the id of a vertex, but there is no vertex 9"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2 0 2 1 0 0 1 0 0 1 0 1"),
              HasSubstr("expected the id of a vertex of type SE2, but vertex 2 is a Vector2"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2 0 0 1 0 0 1 0 0 1 0 1"), HasSubstr("appears twice"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2 0 1 1 0 0 1 0 0 1 0"),
              HasSubstr("expected an entry of the information matrix, got the end"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2 0 1 1 0 0 1 2 0 1 0 1"),
              HasSubstr("g:4:20: information: expected a positive semi-definite"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2_POINTXY_OFFSET 0 2 4 1 1 1 0 1"),
              HasSubstr("there is no parameter 4"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2_LOTSOFXY 0 2 || 999999999999 1 1 1 0 1"),
              HasSubstr("number of points"));
  EXPECT_THAT(complaint(poses + "EDGE_SE2_LOTSOFXY 0 2 || 2 1 1 1 1 1 0 0 0 1 0 0 1 0 1"),
              StartsWith("g:4:"));
  EXPECT_THAT(complaint(poses + "FIX 17"), HasSubstr("there is no vertex 17"));
  EXPECT_THAT(complaint(poses + "FIX"), HasSubstr("got the end of the line"));
}

TEST(GraphReader, NormalisesQuaternionsThatAreNearlyUnitAndRefusesOthers) {
  const GraphFile file = parse_graph("VERTEX_SE3:QUAT 0 1 2 3 0 0 0 1.0005", "g");
  EXPECT_EQ(file.graph.estimate(file.graph.vertex<SE3>(0)).quaternion().w, 1);
  ASSERT_THAT(file.notes, SizeIs(1));
  EXPECT_EQ(file.notes[0].line, 1);
  EXPECT_EQ(file.notes[0].text, "a quaternion of length 1.0005 was normalised");
  EXPECT_THAT(complaint("VERTEX_SE3:QUAT 0 1 2 3 0 0 0 0"),
              HasSubstr("g:1:25: expected a quaternion of length 1"));
  EXPECT_THAT(complaint("VERTEX_SE3:QUAT 0 1 2 3 0 0 1 1"), HasSubstr("got one of length 1.414"));
}

TEST(GraphReader, SkipsAndCountsBadLinesWhereAskedTo) {
  ReadOptions lenient;
  lenient.lenient = true;
  const GraphFile file =
      parse_graph(std::string(kTwoPoses) + "VERTEX_SE2 2 x 0 0\nEDGE_SE2 0 1 1\nFIX 0\n", "g", lenient);
  EXPECT_EQ(file.skipped, 2);
  EXPECT_EQ(file.graph.vertex_count(), 2u);
  ASSERT_THAT(file.notes, SizeIs(2));
  EXPECT_TRUE(file.notes[0].skipped);
  EXPECT_EQ(file.notes[0].line, 3);
  EXPECT_EQ(file.notes[0].column, 14);
  EXPECT_EQ(file.notes[0].text, "expected x (a finite number), got 'x'");
}

TEST(GraphReader, SaysWhichFileCannotBeOpened) {
  try {
    read_graph("/nowhere/graph.g2o");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/graph.g2o: cannot be opened: No such file or directory");
  }
  EXPECT_THROW(read_graph("/"), FileError);
}

}  // namespace
}  // namespace boxplus
