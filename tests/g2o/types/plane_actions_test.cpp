// SPDX-License-Identifier: BSD-3-Clause
// Tests how segments, lines and calibration edges of the plane are drawn.
#include <gmock/gmock.h>

#include <sstream>
#include <string>

#include "g2o/core/factory.h"
#include "g2o/types/drawn.h"
#include "g2o/types/sclam2d/types_sclam2d.h"
#include "g2o/types/slam2d_addons/types_slam2d_addons.h"

G2O_USE_TYPE_GROUP(slam2d_segment)
G2O_USE_TYPE_GROUP(sclam)

namespace {

using drawn_graph::count;
using drawn_graph::drawn;
using drawn_graph::gnuplot;
using drawn_graph::read;
using drawn_graph::Record;
using ::testing::HasSubstr;

/// A wall from (2, −1) to (2, 3), the lines y = 5 between x = −1 and x = 4 and y = 8, and a robot at (1, 1).
const std::string kRoom =
    "VERTEX_SE2 0 1 1 0\n"
    "VERTEX_SEGMENT2D 1 2 -1 2 3\n"
    "VERTEX_LINE2D 2 1.5707963267948966 5 4 5\n"
    "VERTEX_LINE2D 3 1.5707963267948966 8 -1 -1\n"
    "VERTEX_XY 4 -1 5.5\n"
    "VERTEX_XY 5 4 4.5\n";

TEST(PlaneActions, SegmentsAndLinesAreDrawnBetweenTheirEnds) {
  const auto graph = read(kRoom);
  const std::string shapes = drawn(*graph);
  EXPECT_THAT(shapes, HasSubstr("line1 (2 -1 0) (2 3 0)"));
  EXPECT_EQ(count(shapes, "line"), 3);
  const std::string text = gnuplot(*graph);
  EXPECT_THAT(text, HasSubstr("2 -1\n2 3\n\n"));
  EXPECT_THAT(text, HasSubstr("\n-1 5\n4 5\n\n"));
  EXPECT_EQ(count(text, "\n\n"), 3);
}

TEST(PlaneActions, ALineWithoutEndPointsIsDrawnAroundTheOrigin) {
  auto* v = new g2o::VertexLine2D;
  v->setId(0);
  v->setEstimate(g2o::Line2D(g2o::Vector2(0, 2)));
  v->p1Id = 77;  // is not in the graph
  g2o::SparseOptimizer graph;
  ASSERT_TRUE(graph.addVertex(v));
  EXPECT_THAT(drawn(graph), HasSubstr("line1 (2 -7.5 0) (2 7.5 0)"));
}

/// The shapes that one edge adds to the room.
std::string drawn_edge(const std::string& line) {
  const std::string room = drawn(*read(kRoom)), all = drawn(*read(kRoom + line));
  EXPECT_EQ(all.substr(0, room.size()), room);
  return all.substr(room.size());
}

TEST(PlaneActions, ObservationsAreDrawnFromThePoseToWhatItSees) {
  EXPECT_EQ(drawn_edge("EDGE_SE2_SEGMENT2D 0 1 1 -2 1 2 1 0 0 0 1 0 0 1 0 1\n"),
            "line1 (1 1 0) (2 -1 0)\nline1 (1 1 0) (2 3 0)\n");
  EXPECT_EQ(drawn_edge("EDGE_SE2_SEGMENT2D_LINE 0 1 0 1 1 0 1\n"), "line1 (1 1 0) (2 1 0)\n");
  EXPECT_EQ(drawn_edge("EDGE_SE2_SEGMENT2D_POINTLINE 0 1 1 1 2 0 1 0 0 1 0 1\n"), "line1 (1 1 0) (2 3 0)\n");
  EXPECT_EQ(drawn_edge("EDGE_SE2_LINE2D 0 2 1.5 4 1 0 1\n"), "line1 (1 1 0) (1 5 0)\n");
  EXPECT_EQ(drawn_edge("EDGE_LINE2D_POINTXY 2 5 0 1\n"), "line1 (4 4.5 0) (4 5 0)\n");
  EXPECT_EQ(count(drawn_edge("EDGE_LINE2D 2 3 0 3 1 0 1\n"), "line1 "), 1);
}

TEST(PlaneActions, CalibrationEdgesAreDrawnAsTheMotionOfTheRobot) {
  const std::string shapes = drawn(
      *read("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 2 1 0\nVERTEX_SE2 2 9 9 0\nVERTEX_ODOM_DIFFERENTIAL 3 1 1 1\n"
            "EDGE_SE2_CALIB 0 1 2 1 0 0 1 0 0 1 0 1\n"
            "EDGE_SE2_ODOM_DIFFERENTIAL_CALIB 1 0 3 1 1 1 1 0 0 1 0 1\n"));
  EXPECT_EQ(count(shapes, "line"), 2);
  EXPECT_THAT(shapes, HasSubstr("line1 (0 0 0) (2 1 0)"));
  EXPECT_THAT(shapes, HasSubstr("line1 (2 1 0) (0 0 0)"));
}

TEST(PlaneActions, AreAvailableAsClasses) {
  const auto graph = read(kRoom);
  Record record;
  g2o::DrawAction::Parameters draw;
  draw.drawing = &record;
  g2o::VertexSegment2DDrawAction segment;
  g2o::VertexLine2DDrawAction line;
  EXPECT_EQ(segment(graph->vertex(1), &draw), &segment);
  EXPECT_EQ(line(graph->vertex(2), &draw), &line);
  EXPECT_EQ(line(graph->vertex(1), &draw), nullptr);
  EXPECT_EQ(count(record.out.str(), "line"), 2);
  std::ostringstream out;
  g2o::WriteGnuplotAction::Parameters write;
  write.os = &out;
  g2o::VertexSegment2DWriteGnuplotAction gnuplot_segment;
  EXPECT_EQ(gnuplot_segment(graph->vertex(1), &write), &gnuplot_segment);
  EXPECT_EQ(out.str(), "2 -1\n2 3\n\n");
}

}  // namespace
