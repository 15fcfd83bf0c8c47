// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/data.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "boxplus/base/error.h"
#include "boxplus/optimize/optimizer.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using Place = GraphFile::KeptLine::Place;

/// Data after each element, with blanks that no writer would write.
constexpr const char* kText =
    "VERTEX_SE2 0 0 0 0\n"
    "ROBOTLASER1 0 -1 2  1 10 0 0  2 1.50 2 0 0 0 0 0 0 0 0 0 0 0 0 1.0 robot 2\n"
    "# the door\n"
    "VERTEX_TAG door 1 0 0   0 0 0 1 robot 2\n"
    "FIX 0\n"
    "# fixed\n"
    "VERTEX_SE2 1 1 0.125 0\n"
    "VERTEX_ELLIPSE 1 0 0 1 0 1 0\n"
    "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"
    "VERTEX_TAG loop 0 0 0 0 0 0 0 robot 0\n";

TEST(Data, BelongsToTheElementBeforeIt) {
  const std::vector<AttachedData> all = read_data(parse_graph(kText, "g"), "g");
  ASSERT_THAT(all, SizeIs(4));
  EXPECT_THAT(std::get<RobotLaser>(all[0].data).ranges, ElementsAre(1.5, 2));
  EXPECT_EQ(std::get<VertexTag>(all[1].data).name, "door");
  EXPECT_EQ(std::get<VertexEllipse>(all[2].data).covariance(1, 1), 1);
  EXPECT_EQ(std::get<VertexTag>(all[3].data).name, "loop");
  const std::vector<std::pair<Place, std::int64_t>> expected{
      {Place::kAfterVertex, 0}, {Place::kAfterVertex, 0}, {Place::kAfterVertex, 1}, {Place::kAfterEdge, 0}};
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_EQ(std::pair(all[k].place, all[k].after), expected[k]);
}

TEST(Data, IsWrittenBackByteForByteAlsoAfterAnOptimization) {
  GraphFile file = parse_graph(kText, "g");
  EXPECT_EQ(format_graph(file), kText);
  EXPECT_TRUE(optimize(file.graph).converged());
  std::string expected = kText;
  const std::string old = "VERTEX_SE2 1 1 0.125 0\n";
  expected.replace(expected.find(old), old.size(), "VERTEX_SE2 1 1 0 0\n");
  EXPECT_EQ(format_graph(file), expected);
}

TEST(Data, IsNoUnknownTag) {
  EXPECT_THAT(parse_graph(kText, "g").notes, IsEmpty());
  EXPECT_THAT(data_tags(), ElementsAre("ROBOTLASER1", "RAWLASER1", "VERTEX_TAG", "VERTEX_ELLIPSE"));
  EXPECT_EQ(data_tag_of("\t VERTEX_TAG x"), "VERTEX_TAG");
  EXPECT_EQ(data_tag_of("VERTEX_TAGS x"), "");
  EXPECT_EQ(data_tag_of("# VERTEX_TAG x"), "");
  EXPECT_EQ(data_tag_of(""), "");
}

TEST(Data, ThatIsMalformedIsKeptAndReportedWhenItIsRead) {
  const std::string text = "# one\nVERTEX_SE2 0 0 0 0\n\n  VERTEX_TAG door 1 0 wall\n";
  const GraphFile file = parse_graph(text, "g");
  EXPECT_EQ(format_graph(file), "# one\nVERTEX_SE2 0 0 0 0\n  VERTEX_TAG door 1 0 wall\n");
  try {
    read_data(file, "map.g2o");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "map.g2o:4:23: expected the position of a name (a finite number), got 'wall'");
  }
}

TEST(Data, IsSkippedWithTheElementThatItBelongsTo) {
  const std::string tag = "VERTEX_TAG door 1 0 0 0 0 0 1 robot 2\n";
  const GraphFile file = parse_graph("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 x 0 0\n" + tag +
                                         "# kept\nEDGE_SE2 0\n" + tag + "VERTEX_SE2 2 1 0 0\n" + tag,
                                     "g", {.lenient = true});
  EXPECT_EQ(file.skipped, 4);
  EXPECT_EQ(format_graph(file), "VERTEX_SE2 0 0 0 0\n# kept\nVERTEX_SE2 2 1 0 0\n" + tag);
}

TEST(Data, ThatAProgramMadeIsReadBack) {
  RobotLaser scan;
  scan.ranges = {1, 0.1, 1.0 / 3};
  GraphFile file = parse_graph("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\n", "g");
  file.kept.push_back({Place::kAfterVertex, 0, format_data(scan)});
  const GraphFile again = parse_graph(format_graph(file), "again");
  const std::vector<AttachedData> all = read_data(again, "again");
  ASSERT_THAT(all, SizeIs(1));
  EXPECT_EQ(all[0].after, 0);
  EXPECT_EQ(std::get<RobotLaser>(all[0].data).ranges, scan.ranges);
}

/// The distance from (x, y) in a direction to the next wall, if there is a wall at each x and each y that is
/// a multiple of 6 m.
double distance_to_wall(double x, double y, double direction) {
  constexpr double kRoom = 6;
  const auto along = [](double at, double speed) {
    if (speed == 0) return HUGE_VAL;
    const double next = kRoom * (speed > 0 ? std::floor(at / kRoom) + 1 : std::ceil(at / kRoom) - 1);
    return (next - at) / speed;
  };
  return std::min(along(x, std::cos(direction)), along(y, std::sin(direction)));
}

RobotLaser simulated_scan(const SE2& T_world_robot) {
  RobotLaser scan;
  scan.first_beam = -1.5;
  scan.field_of_view = 3;
  scan.angular_step = 3.0 / 180;
  scan.max_range = 80;
  const SE2 T_world_laser = T_world_robot * SE2(0.25, 0.03, 0.02);
  scan.laser_pose = {T_world_laser.x(), T_world_laser.y(), T_world_laser.theta()};
  scan.robot_pose = {T_world_robot.x(), T_world_robot.y(), T_world_robot.theta()};
  for (int k = 0; k <= 180; ++k) {
    const double direction = T_world_laser.theta() + scan.first_beam + k * scan.angular_step;
    scan.ranges.push_back(distance_to_wall(T_world_laser.x(), T_world_laser.y(), direction));
  }
  return scan;
}

double distance_from_wall(double x) {
  return std::abs(std::remainder(x, 6.0));
}

TEST(Data, OfALargeLogGivesTheMapAndIsKeptByTheOptimization) {
  const char* folder = std::getenv("BOXPLUS_DATA");
  const std::string path = std::string(folder ? folder : ".") + "/posegraph2d/intel_1728.g2o";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "SKIPPED: no " << path;
  GraphFile file = read_graph(path);
  std::vector<std::string> scans;
  for (const VertexRef& vertex : file.graph.all_vertices()) {
    const SE2 pose = file.graph.estimate(VertexHandle<SE2>{vertex});
    scans.push_back(format_data(simulated_scan(pose)));
    file.kept.push_back({Place::kAfterVertex, file.graph.id(vertex), scans.back()});
  }
  GraphFile log = parse_graph(format_graph(file), "log");
  const std::vector<AttachedData> all = read_data(log, "log");
  ASSERT_EQ(all.size(), scans.size());
  double worst = 0;
  for (const AttachedData& attached : all) {
    const SE2 pose = log.graph.estimate(log.graph.vertex<SE2>(attached.after));
    for (const Vector<double, 2>& point : std::get<RobotLaser>(attached.data).end_points_of_robot()) {
      const Vector<double, 2> hit = pose * point;
      worst = std::max(worst, std::min(distance_from_wall(hit[0]), distance_from_wall(hit[1])));
    }
  }
  EXPECT_LT(worst, 1e-9);
  EXPECT_TRUE(optimize(log.graph).converged());
  std::istringstream lines(format_graph(log));
  std::size_t found = 0;
  for (std::string line, last; std::getline(lines, line); last = line) {
    if (data_tag_of(line).empty()) continue;
    ASSERT_LT(found, scans.size());
    EXPECT_EQ(line, scans[found++]);
    EXPECT_TRUE(last.starts_with("VERTEX_SE2 "));
  }
  EXPECT_EQ(found, scans.size());
}

}  // namespace
}  // namespace boxplus
