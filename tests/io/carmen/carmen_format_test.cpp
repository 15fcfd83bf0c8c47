// SPDX-License-Identifier: BSD-3-Clause
#include "io/carmen/carmen_format.h"

#include <gmock/gmock.h>

#include <numbers>

#include "boxplus/io/data.h"
#include "boxplus/types/between.h"
#include "io/complaint.h"

namespace boxplus {
namespace {

using testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180;

/// A robot stands, drives, and stands again.
const std::string kLog =
    "# CARMEN Logfile\n"
    "PARAM robot_length 0.5 1 host 0.1\n"
    "RAWLASER1 0 -1 2 1 10 0 0 2 1.5 2 0 0.9 host 0.2\n"
    "ODOM 1 2 0 0.5 0 0 1.0 host 0.3\n"
    "FLASER 3 1 2 81.83 1.1 2 0 1 2 0 1.1 host 0.4\n"
    "ODOM 2 2 1.5 0.5 0 0 2.0 host 0.5\n"
    "ODOM 2 2 1.5 0 0 0 3.0 host 0.6\n"
    "ROBOTLASER1 0 -1 2 1 10 0 0 2 1.5 2 1 0.5 2 3 1.5 2 3 1.5 0 0 0 0 0 4 host 0.7\n"
    "SYNC x 5 host 0.8\n";

TEST(CarmenFormat, MakesPosesAndMotionsOfTheOdometry) {
  const GraphFile file = parse_graph(kLog, "g");
  EXPECT_EQ(file.format, "CARMEN");
  EXPECT_EQ(file.lines, 9);
  ASSERT_EQ(file.graph.vertex_count(), 3u) << "the same pose twice is one vertex";
  const SE2& second = file.graph.estimate(file.graph.vertex<SE2>(1));
  EXPECT_EQ(second.vector(), Vector3(2, 2, 1.5));
  EXPECT_EQ(file.graph.estimate(file.graph.vertex<SE2>(2)).vector(), Vector3(2, 3, 1.5));
  ASSERT_EQ(file.edges.size(), 2u);
  const SE2& motion = file.graph.measurement(EdgeHandle<Between<SE2>>{file.edges[0]}).measurement;
  EXPECT_EQ(motion.vector(), Vector3(1, 0, 1.5));
  EXPECT_LT(file.graph.chi2(), 1e-25);
}

TEST(CarmenFormat, KeepsScansAfterTheirPose) {
  const GraphFile file = parse_graph(kLog, "g");
  const std::vector<AttachedData> data = read_data(file, "g");
  ASSERT_EQ(data.size(), 3u);
  using Place = GraphFile::KeptLine::Place;
  EXPECT_EQ(data[0].place, Place::kBegin);
  EXPECT_EQ(std::get<RawLaser>(data[0].data).ranges, (std::vector<double>{1.5, 2}));
  EXPECT_EQ(data[1].place, Place::kAfterVertex);
  EXPECT_EQ(data[1].after, 0);
  EXPECT_EQ(data[2].after, 2);
  EXPECT_EQ(file.kept[2].text,
            "ROBOTLASER1 0 -1 2 1 10 0 0 2 1.5 2 1 0.5 2 3 1.5 2 3 1.5 0 0 0 0 0 4 host 0.7");
  EXPECT_EQ(file.kept[2].line, 8);
}

TEST(CarmenFormat, KeepsTheScansOfOtherLasersWithThePoseOfTheirLaser) {
  const GraphFile file = parse_graph(
      "ROBOTLASER2 0 -1 2 1 10 0 0 1 1.5 0 2 3 3.1 1 2 0.5 0 0 0 0 0 4 host 0.7\n"
      "RAWLASER2 0 -1 2 1 10 0 0 1 1.5 0 5 host 0.8\nROBOTLASER6 1\n",
      "g");
  EXPECT_EQ(file.format, "CARMEN");
  EXPECT_EQ(file.graph.vertex_count(), 1u);
  ASSERT_EQ(file.kept.size(), 1u);
  EXPECT_EQ(file.kept[0].text, "ROBOTLASER1 0 -1 2 1 10 0 0 1 1.5 0 2 3 3.1 1 2 0.5 0 0 0 0 0 4 host 0.7");
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_EQ(file.notes[0].text, "2 lines are not part of the graph: 1 'RAWLASER2', 1 'ROBOTLASER6'");
  EXPECT_EQ(complaint("ROBOTLASER2 0 -1 2 1 10 0 0 1 1.5 0 2 3\n").substr(0, 8), "g:1:40: ");
}

TEST(CarmenFormat, AddsTheDirectionsOfTheBeamsOfAnOldScan) {
  const GraphFile file = parse_graph(kLog, "g");
  const RobotLaser laser = std::get<RobotLaser>(*parse_data(file.kept[1], "g"));
  EXPECT_EQ(laser.ranges, (std::vector<double>{1, 2, 81.83}));
  EXPECT_NEAR(laser.first_beam, -90 * kDegree, 1e-15);
  EXPECT_NEAR(laser.angular_step, 90 * kDegree, 1e-15);
  EXPECT_EQ(laser.stamp.timestamp, 1.1);
  EXPECT_EQ(laser.stamp.host, "host");
  const auto points = laser.end_points_of_robot();
  ASSERT_EQ(points.size(), 2u) << "81.83 m is the code of a failure";
  EXPECT_NEAR(points[0][0], 0.1, 1e-15);
  EXPECT_NEAR(points[0][1], -1, 1e-15);
  EXPECT_NEAR(points[1][0], 2.1, 1e-15);
}

TEST(CarmenFormat, NotesWhatIsAssumedAndWhatIsLeftOut) {
  const GraphFile file = parse_graph(kLog, "g");
  ASSERT_EQ(file.notes.size(), 3u);
  EXPECT_EQ(file.notes[0].text, "2 lines are not part of the graph: 1 'PARAM', 1 'SYNC'");
  EXPECT_THAT(file.notes[1].text, HasSubstr("covariances: they are assumed for 2 edges of the odometry"));
  EXPECT_THAT(file.notes[2].text, HasSubstr("1 scan without the directions of the beams"));
}

TEST(CarmenFormat, IsRecognizedByItsMessages) {
  const auto format_of = [](const std::string& text) { return default_formats().recognize(text)->name; };
  EXPECT_EQ(format_of("ODOM 0 0 0 0 0 0 1 h 2\n"), "CARMEN");
  EXPECT_EQ(format_of("# CARMEN Logfile\nRAWLASER1 0\nFLASER 0\n"), "CARMEN");
  const std::string scan = "ROBOTLASER1 0 -1 2 1 10 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 h 2\n";
  EXPECT_EQ(format_of(scan), "CARMEN") << "a scan with a pose, and nothing else";
  EXPECT_EQ(format_of(scan + "VERTEX_SE2 0 0 0 0\n"), "g2o");
  EXPECT_EQ(format_of("VERTEX_SE2 0 0 0 0\n" + scan), "g2o");
  EXPECT_EQ(format_of("RAWLASER1 0\n"), "g2o");
}

TEST(CarmenFormat, IsWrittenAsG2oWithTheScans) {
  const std::string written = format_graph(parse_graph(kLog, "g"));
  EXPECT_THAT(written, HasSubstr("VERTEX_SE2 0 1 2 0\nROBOTLASER1 0 "));
  EXPECT_EQ(format_graph(parse_graph(written, "g")), written);
}

TEST(CarmenFormat, ReportsMalformedMessagesWithTheirPlace) {
  const std::string good = "ODOM 0 0 0 0 0 0 1 h 2\n";
  EXPECT_EQ(complaint(good + "ODOM 1 x 0 0 0 0 1 h 2\n"),
            "g:2:8: expected the pose of the robot (a finite number), got 'x'");
  EXPECT_EQ(complaint(good + "ODOM 1 1 0 0 0 0 1 h\n"),
            "g:2:21: expected the time of the record, got the end of the line");
  EXPECT_EQ(complaint(good + "ODOM 1 1 0 0 0 0 1 h 2 3\n"), "g:2:24: expected the end of the line, got '3'");
  EXPECT_EQ(complaint(good + "FLASER 3 1 2 h\n"), "g:2:14: expected a range (a finite number), got 'h'");
  EXPECT_EQ(complaint(good + "RLASER -1\n"), "g:2:8: expected the number of ranges (a number ≥ 0), got -1");
  EXPECT_EQ(complaint(good + "ROBOTLASER1 0 -1\n"),
            "g:2:17: expected a field of view, got the end of the line");
  EXPECT_EQ(complaint(good + "RAWLASER1 x\n"), "g:2:11: expected the type of a laser (an integer), got 'x'");
  EXPECT_THAT(complaint(good + "ODOM 1e200 1 0 0 0 0 1 h 2\n"), HasSubstr("g:2:6: expected a position"));
}

TEST(CarmenFormat, SkipsMalformedMessagesIfItIsLenient) {
  const GraphFile file =
      parse_graph(kLog + "ODOM 1 x\nODOM 3 3 1.5 0 0 0 5 host 0.9\n", "g", {.lenient = true});
  EXPECT_EQ(file.skipped, 1);
  EXPECT_EQ(file.graph.vertex_count(), 4u);
}

TEST(OdometryInformation, FallsWithTheDistanceAndTheRotation) {
  const Information at_rest = odometry_information(SE2(0, 0, 0));
  ASSERT_EQ(at_rest.kind(), Information::Kind::kDiagonal);
  EXPECT_NEAR(at_rest.values()[0], 1e4, 1e-8);
  EXPECT_NEAR(at_rest.values()[2], 4e4, 1e-8);
  const Information moving = odometry_information(SE2(0, -1, -0.1));
  EXPECT_NEAR(moving.values()[1], 1 / (0.06 * 0.06), 1e-9);
  EXPECT_NEAR(moving.values()[2], 1 / (0.03 * 0.03), 1e-9);
}

TEST(AssumedBeams, CoverTheFieldOfViewOfTheLaser) {
  struct Case {
    std::size_t count;
    double field_of_view, step;
  };
  for (const auto& [count, field_of_view, step] :
       {Case{181, 180, 1}, Case{180, 180, 1}, Case{361, 180, 0.5}, Case{101, 100, 1}, Case{401, 100, 0.25}}) {
    const AssumedBeams beams = assumed_beams(count);
    EXPECT_NEAR(beams.field_of_view, field_of_view * kDegree, 1e-15) << count;
    EXPECT_NEAR(beams.first, -field_of_view / 2 * kDegree, 1e-15) << count;
    EXPECT_NEAR(beams.step, step * kDegree, 1e-15) << count;
  }
  EXPECT_EQ(assumed_beams(0).step, 0);
}

}  // namespace
}  // namespace boxplus
