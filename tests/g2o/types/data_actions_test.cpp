// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "g2o/core/factory.h"
#include "g2o/types/data/types_data.h"
#include "g2o/types/drawn.h"

G2O_USE_TYPE_GROUP(slam2d);
G2O_USE_TYPE_GROUP(slam3d);
G2O_USE_TYPE_GROUP(data);

namespace {

using drawn_graph::count;
using drawn_graph::drawn;
using testing::HasSubstr;

/// A laser 1 m in front of the robot, which looks along x and has hit points 1 m, 2 m and 3 m ahead of it.
constexpr const char* kLaser = "ROBOTLASER1 0 0 0 0 10 0 0 4 1 2 3 10 0 1 0 0 0 0 0 0 0 0 0 0 5 h 5\n";

TEST(DataActions, DrawTheEndPointsOfBeamsAtThePose) {
  const auto graph = drawn_graph::read(std::string("VERTEX_SE2 0 10 20 0\n") + kLaser);
  const std::string shapes = drawn(*graph);
  EXPECT_EQ(count(shapes, "point1 "), 3);
  EXPECT_THAT(shapes, HasSubstr("point1 (12 20 0)\npoint1 (13 20 0)\npoint1 (14 20 0)\n"));
}

TEST(DataActions, DrawDataOfPosesInSpace) {
  const auto graph = drawn_graph::read(std::string("VERTEX_SE3:QUAT 0 10 20 30 0 0 0 1\n") + kLaser);
  EXPECT_THAT(drawn(*graph), HasSubstr("point1 (12 20 30)\n"));
}

TEST(DataActions, DrawFewerBeamsIfTheUserWantsFewer) {
  const auto graph = drawn_graph::read(std::string("VERTEX_SE2 0 0 0 0\n") + kLaser);
  drawn_graph::Record record;
  g2o::DrawAction::Parameters parameters;
  parameters.drawing = &record;
  const std::string type = typeid(g2o::RobotLaser).name();
  parameters.makeProperty<g2o::IntProperty>(type + "::BEAMS_DOWNSAMPLING", 2);
  parameters.makeProperty<g2o::FloatProperty>(type + "::POINT_SIZE", 3);
  parameters.makeProperty<g2o::FloatProperty>(type + "::MAX_RANGE", 2.5F);
  g2o::applyAction(graph.get(), drawn_graph::action("draw"), &parameters);
  EXPECT_THAT(record.out.str(), HasSubstr("point3 (2 0 0)\n"));
  EXPECT_EQ(count(record.out.str(), "point3 "), 1) << "of the ranges 1 and 3, one is small enough";
}

TEST(DataActions, DrawNamesAndEllipses) {
  const auto graph = drawn_graph::read(
      "VERTEX_SE2 0 10 20 0\nVERTEX_TAG kitchen 1 0 0 0 0 0 5 h 5\nVERTEX_ELLIPSE 4 0 0 1 0 0 1 3 4\n");
  const std::string shapes = drawn(*graph);
  EXPECT_THAT(shapes, HasSubstr("text kitchen\n"));
  EXPECT_EQ(count(shapes, "ring1 "), 1);
  EXPECT_THAT(shapes, HasSubstr("line1 (10 20 0) (12 20 0)\n")) << "one standard deviation is 2 m";
  EXPECT_THAT(shapes, HasSubstr("line1 (10 20 0) (13 24 0)\n")) << "the matching vertex";
}

TEST(DataActions, DrawNothingForDataWithoutAPose) {
  const auto graph = drawn_graph::read(std::string("VERTEX_XY 0 1 2\n") + kLaser);
  EXPECT_EQ(count(drawn(*graph), "point1 "), 0);
}

TEST(DataActions, HavePublicClasses) {
  const auto graph = drawn_graph::read("VERTEX_SE2 0 0 0 0\nVERTEX_TAG kitchen 1 0 0 0 0 0 5 h 5\n");
  drawn_graph::Record record;
  g2o::DrawAction::Parameters parameters;
  parameters.drawing = &record;
  g2o::VertexTagDrawAction tag;
  g2o::RobotLaserDrawAction laser;
  EXPECT_EQ(laser(graph->vertex(0)->userData(), &parameters), nullptr);
  EXPECT_EQ(tag(graph->vertex(0)->userData(), &parameters), &tag);
  EXPECT_EQ(record.out.str(), "text kitchen\n");
}

}  // namespace
