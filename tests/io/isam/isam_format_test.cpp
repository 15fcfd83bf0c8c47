// SPDX-License-Identifier: BSD-3-Clause
#include "io/isam/isam_format.h"

#include <gmock/gmock.h>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/between.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "io/complaint.h"

namespace boxplus {
namespace {

using testing::HasSubstr;

const std::string kPlane =
    "ODOMETRY 0 1 1 0 0.5 2 1 0 3 0.5 4\n"
    "LANDMARK 0 1 2 3 5 1 6\n"
    "LANDMARK 1 12 -1 3 5 0 5\n";
const std::string kSpace =
    "ODOMETRY3 0 1 1 0 0 0.1 -0.2 0.3 2 0 0 0 0 1 2 0 0 0 0 2 0 0 0 3 0 0 3 0 3\n"
    "POINT3 1 7 1 2 3 5 0 1 5 0 5\n";

TEST(IsamFormat, ReadsMotionsWithOmegaAsTheSquareOfR) {
  const GraphFile file = parse_graph(kPlane, "g");
  EXPECT_EQ(file.format, "iSAM");
  const SE2& motion = file.graph.measurement(EdgeHandle<Between<SE2>>{file.edges.at(0)}).measurement;
  EXPECT_EQ(motion.vector(), Vector3(1, 0, 0.5));
  // R = [2 1 0; 0 3 0.5; 0 0 4]
  Eigen::Matrix3d expected;
  expected << 4, 2, 0, 2, 10, 1.5, 0, 1.5, 16.25;
  EXPECT_EQ(file.graph.information(file.edges[0]).matrix(), expected);
  Eigen::Matrix2d of_landmark;
  of_landmark << 25, 5, 5, 37;
  EXPECT_EQ(file.graph.information(file.edges[1]).matrix(), of_landmark);
}

TEST(IsamFormat, GivesLandmarksOtherIdsIfTheyHaveTheIdsOfPoses) {
  const GraphFile file = parse_graph(kPlane, "g");
  ASSERT_EQ(file.notes.size(), 2u);
  EXPECT_EQ(file.notes[0].text, "poses and landmarks have the same ids: landmark n became vertex 10 + n");
  EXPECT_TRUE(file.vertices_created);
  EXPECT_EQ(file.graph.vertex_count(), 4u);
  EXPECT_EQ(file.graph.id(file.graph.vertices(file.edges[1])[1]), 11);
  EXPECT_EQ(file.graph.id(file.graph.vertices(file.edges[2])[1]), 22);
  const GraphFile others = parse_graph("ODOMETRY 0 10 1 0 0.5 1 0 0 1 0 1\nLANDMARK 10 5 1 1 1 0 1\n", "g");
  EXPECT_EQ(others.notes.size(), 1u) << "no id occurs twice";
  EXPECT_TRUE(others.graph.find_vertex(5));
}

TEST(IsamFormat, ReadsMotionsAndPointsInSpace) {
  const GraphFile file = parse_graph(kSpace, "g");
  const SE3& motion = file.graph.measurement(EdgeHandle<Between<SE3>>{file.edges.at(0)}).measurement;
  const GraphFile toro = parse_graph(
      "VERTEX3 0 0 0 0 0 0 0\nVERTEX3 1 1 0 0 0.1 -0.2 0.3\nEDGE3 0 1 1 0 0 0.1 -0.2 0.3 "
      "1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n",
      "g");
  EXPECT_EQ(motion.vector(),
            toro.graph.measurement(EdgeHandle<Between<SE3>>{toro.edges.at(0)}).measurement.vector());
  const detail::InformationView omega = file.graph.information(file.edges[0]);
  EXPECT_EQ(omega(0, 0), 4);
  EXPECT_EQ(omega(0, 5), 2 * 2) << "R_x,x · R_x,yaw; a small angle is twice its component of the quaternion";
  EXPECT_EQ(omega(5, 5), 4 * (9 + 1));
  const auto point = EdgeHandle<OffsetPointObservation3>{file.edges.at(1)};
  EXPECT_EQ(file.graph.measurement(point).measurement, Vector3(1, 2, 3));
  EXPECT_EQ(file.graph.information(point)(2, 2), 26);
  EXPECT_EQ(file.graph.parameter_count(), 1u);
}

TEST(IsamFormat, IsSolvedFromAnInitialGuess) {
  // A square of 2 m, and a landmark in its center.
  std::string text;
  for (int i = 0; i < 4; ++i) {
    text += "ODOMETRY " + std::to_string(i) + " " + std::to_string((i + 1) % 4) +
            " 2 0 1.5707963267948966 10 0 0 10 0 10\n";
    text += "LANDMARK " + std::to_string(i) + " 0 1 1 10 0 10\n";
  }
  GraphFile file = parse_graph(text, "g");
  const Report report = optimize(file.graph, {.start = Start::kChordal});
  EXPECT_LT(report.chi2_final, 1e-20);
  const SE2 T_0_2 = file.graph.estimate(file.graph.vertex<SE2>(0))
                        .inverse_times(file.graph.estimate(file.graph.vertex<SE2>(2)));
  EXPECT_NEAR(T_0_2.x(), 2, 1e-9);
  EXPECT_NEAR(T_0_2.y(), 2, 1e-9);
}

TEST(IsamFormat, IsWrittenAsG2o) {
  for (const std::string& text : {kPlane, kSpace}) {
    const std::string written = format_graph(parse_graph(text, "g"));
    EXPECT_EQ(format_graph(parse_graph(written, "g")), written);
  }
}

TEST(IsamFormat, IsRecognizedUnlessTheFirstTagIsOneOfToro) {
  const auto format_of = [](const std::string& text) { return default_formats().recognize(text)->name; };
  EXPECT_EQ(format_of(kPlane), "iSAM");
  EXPECT_EQ(format_of("# a comment\n" + kSpace), "iSAM");
  EXPECT_EQ(format_of("EDGE2 0 1 1 0 0 1 0 0 1 0 1\n" + kPlane), "TORO");
  EXPECT_EQ(format_of("ODOM 1\n"), "CARMEN");
}

TEST(IsamFormat, ReportsMalformedLinesWithTheirPlace) {
  EXPECT_EQ(complaint(kPlane + "ODOMETRY 1 2 1 0 y 1 0 0 1 0 1\n"),
            "g:4:18: expected a coordinate of the motion (a finite number), got 'y'");
  EXPECT_EQ(complaint(kPlane + "ODOMETRY 1 2 1 0 0.5 1 0 0 1 0\n"),
            "g:4:31: expected an entry of the information matrix, got the end of the line");
  EXPECT_EQ(complaint(kPlane + "LANDMARK 1 2 1 1 1 0 1 0\n"),
            "g:4:24: expected the end of the line, got '0'");
  EXPECT_EQ(complaint(kPlane + "ODOMETRY 2 2 1 0 0 1 0 0 1 0 1\n"),
            "g:4:12: expected the id of another pose, but pose 2 appears twice");
  EXPECT_EQ(complaint(kPlane + "LANDMARK 1 -2 1 1 1 0 1\n"),
            "g:4:12: expected the id of a landmark (an integer from 0 to 1000000000000000), got -2");
  EXPECT_EQ(complaint(kPlane + "POINT3 1 7 1 2 3 1 0 0 1 0 1\n"),
            "g:4:8: expected the id of a pose in space, but a line before it has 1 in the plane");
  EXPECT_THAT(complaint(kPlane + "LANDMARK 1 2 1 1 0 0 0\n"),
              HasSubstr("g:4:18: information: expected a nonzero"));
  EXPECT_THAT(complaint(kPlane + "LANDMARK 1 2 1 1 1e-200 0 1e-200\n"), HasSubstr("one whose RᵀR is zero"));
  EXPECT_THAT(complaint(kPlane + "LANDMARK 1 2 1 1 1e200 0 1\n"), HasSubstr("g:4:18: information"));
}

TEST(IsamFormat, LeavesOutOtherLinesWithANoteAndSkipsMalformedOnes) {
  const GraphFile file = parse_graph(kPlane + "CAMERA_STEREO 1 2\nODOMETRY 1 5 x\n", "g", {.lenient = true});
  EXPECT_EQ(file.skipped, 1);
  EXPECT_EQ(file.edges.size(), 3u);
  EXPECT_FALSE(file.graph.find_vertex(5)) << "the id of a skipped line";
  EXPECT_EQ(file.notes.at(1).text, "1 line is not part of the graph: 1 'CAMERA_STEREO'");
}

}  // namespace
}  // namespace boxplus
