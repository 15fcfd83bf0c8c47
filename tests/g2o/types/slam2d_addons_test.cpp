// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "g2o/edge_checks.h"
#include "g2o/types/slam2d_addons/types_slam2d_addons.h"

G2O_USE_TYPE_GROUP(slam2d_segment);

namespace {

using edge_checks::omega;

TEST(Slam2dAddons, AllTypesHaveExactJacobiansAndAreWrittenAsTheyWereRead) {
  edge_checks::expect_laws_of_file(
      "VERTEX_SE2 0 1 2 0.5\n"
      "VERTEX_SEGMENT2D 1 4 1 5 3\n"
      "VERTEX_LINE2D 2 0.6 2 4 5\n"
      "VERTEX_LINE2D 3 -2.9 -1 -1 -1\n"
      "VERTEX_XY 4 1 2\n"
      "VERTEX_XY 5 -1 3\n"
      "EDGE_SE2_SEGMENT2D 0 1 2 -2 4 -1" +
      omega(4) +
      "\n"
      "EDGE_SE2_SEGMENT2D_LINE 0 1 -0.8 3" +
      omega(2) +
      "\n"
      "EDGE_SE2_SEGMENT2D_POINTLINE 0 1 0 2 -2 -0.8" +
      omega(3) +
      "\n"
      "EDGE_SE2_SEGMENT2D_POINTLINE 0 1 1 4 -1 -0.8" +
      omega(3) +
      "\n"
      "EDGE_SE2_LINE2D 0 2 0.2 0.3" +
      omega(2) +
      "\n"
      "EDGE_LINE2D 2 3 2.5 -2" +
      omega(2) +
      "\n"
      "EDGE_LINE2D_POINTXY 2 4 0.1" +
      omega(1) + "\n");
}

TEST(Slam2dAddons, ErrorsFollowTheSignConventionsOfTheFileFormat) {
  // The pose sees the segment from (1, 0) to (3, 0), with the normal (0, −1), and the line y = −3.
  const std::string right_angle = "1.5707963267948966";
  const double angle_error = 1.5 - 1.5707963267948966, full_turn = 6.283185307179586;
  edge_checks::expect_errors("VERTEX_SE2 0 1 2 " + right_angle +
                                 "\n"
                                 "VERTEX_SEGMENT2D 1 1 3 1 5\n"
                                 "VERTEX_LINE2D 2 0 4 -1 -1\n"
                                 "VERTEX_LINE2D 3 3 1 -1 -1\n"
                                 "VERTEX_LINE2D 4 -3 2 -1 -1\n"
                                 "VERTEX_XY 5 6 1\n"
                                 "EDGE_SE2_SEGMENT2D 0 1 1 0.5 2 0" +
                                 omega(4) +
                                 "\n"
                                 "EDGE_SE2_SEGMENT2D_LINE 0 1 -1.5 0.25" +
                                 omega(2) +
                                 "\n"
                                 "EDGE_SE2_SEGMENT2D_POINTLINE 0 1 1 2 1 -1.5" +
                                 omega(3) +
                                 "\n"
                                 "EDGE_SE2_LINE2D 0 2 -1.5 2.5" +
                                 omega(2) +
                                 "\n"
                                 "EDGE_LINE2D 3 4 0 0.5" +
                                 omega(2) +
                                 "\n"
                                 "EDGE_LINE2D_POINTXY 2 5 0.5" +
                                 omega(1) + "\n",
                             {{"EDGE_SE2_SEGMENT2D", {0, -0.5, 1, 0}},
                              {"EDGE_SE2_SEGMENT2D_LINE", {angle_error, -0.25}},
                              {"EDGE_SE2_SEGMENT2D_POINTLINE", {1, -1, angle_error}},
                              {"EDGE_SE2_LINE2D", {angle_error, 0.5}},
                              {"EDGE_LINE2D", {full_turn - 6, 0.5}},
                              {"EDGE_LINE2D_POINTXY", {1.5}}});
}

TEST(Slam2dAddons, ALineIsMovedTogetherWithItsPoints) {
  const g2o::SE2 motion(1, -2, 0.7);
  const g2o::Line2D line(g2o::Vector2(2.8, 1.5)), moved = motion * line;
  const g2o::Vector2 along(-std::sin(line[0]), std::cos(line[0])), foot(std::cos(line[0]), std::sin(line[0]));
  const g2o::Vector2 point = motion * g2o::Vector2(1.5 * foot + 3 * along);
  EXPECT_NEAR(std::cos(moved[0]) * point.x() + std::sin(moved[0]) * point.y(), moved[1], 1e-14);
  EXPECT_NEAR(moved[0], 2.8 + 0.7 - 2 * M_PI, 1e-14);
}

TEST(Slam2dAddons, TheAngleOfALineIsWrapped) {
  g2o::VertexLine2D v;
  v.setEstimate(g2o::Line2D(g2o::Vector2(3, 1)));
  const double step[] = {0.5, -2};
  v.oplus(step);
  EXPECT_NEAR(v.theta(), 3.5 - 2 * M_PI, 1e-15);
  EXPECT_EQ(v.rho(), -1);
}

TEST(Slam2dAddons, BadFieldsAreRefused) {
  for (const char* line :
       {"VERTEX_SEGMENT2D 1 4 1 5\n", "VERTEX_LINE2D 2 0.6 2 4\n", "VERTEX_LINE2D 2 0.6 2 4 99999999999\n",
        "VERTEX_LINE2D 2 0.6 2 4 -2\n", "EDGE_SE2_SEGMENT2D_POINTLINE 0 8 2 2 -2 -0.8 1 0 0 1 0 1\n",
        "EDGE_SE2_SEGMENT2D_LINE 0 8 -0.8 3 1 0 -1\n", "EDGE_SE2_LINE2D 0 8 1 1 1 0 1\n"}) {
    SCOPED_TRACE(line);
    g2o::SparseOptimizer optimizer;
    std::istringstream in(std::string("VERTEX_SE2 0 1 2 0.5\nVERTEX_SEGMENT2D 8 0 0 1 1\n") + line);
    EXPECT_FALSE(optimizer.load(in));
    EXPECT_EQ(optimizer.vertices().size(), 2U);
    EXPECT_TRUE(optimizer.edges().empty());
  }
}

}  // namespace
