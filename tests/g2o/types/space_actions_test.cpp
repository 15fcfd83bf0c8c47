// SPDX-License-Identifier: BSD-3-Clause
// Tests how planes, cameras, similarities and pairs of points are drawn.
#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <typeinfo>

#include "g2o/core/factory.h"
#include "g2o/types/drawn.h"
#include "g2o/types/icp/types_icp.h"
#include "g2o/types/sba/types_six_dof_expmap.h"
#include "g2o/types/sim3/types_seven_dof_expmap.h"
#include "g2o/types/slam3d_addons/types_slam3d_addons.h"

G2O_USE_TYPE_GROUP(slam3d)
G2O_USE_TYPE_GROUP(slam3d_addons)
G2O_USE_TYPE_GROUP(sba)
G2O_USE_TYPE_GROUP(expmap)
G2O_USE_TYPE_GROUP(sim3)
G2O_USE_TYPE_GROUP(icp)

namespace {

using drawn_graph::action;
using drawn_graph::count;
using drawn_graph::drawn;
using drawn_graph::gnuplot;
using drawn_graph::read;
using drawn_graph::Record;
using ::testing::HasSubstr;

const std::string kOmega1 = " 1\n", kOmega2 = " 1 0 1\n", kOmega3 = " 1 0 0 1 0 1\n",
                  kOmega4 = " 1 0 0 0 1 0 0 1 0 1\n",
                  kOmega6 = " 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n",
                  kOmega7 = " 1 0 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n";

/// A floor, a wall at x = 4, and two poses of a robot. The first pose observes the wall.
const std::string kPlanes =
    "VERTEX_SE3:QUAT 0 1 1 1 0 0 0 1\nVERTEX_SE3:QUAT 1 2 1 1 0 0 0 1\n"
    "VERTEX_SE3:QUAT 9 0 0 0.5 0 0 0 1\n"
    "VERTEX_PLANE 10 0 0 1 0 0.2 0.7 0.2\nVERTEX_PLANE 11 -1 0 0 4 0.7 0.2 0.2\n"
    "EDGE_PLANE 10 11 -1 0 -1 4" +
    kOmega4 + "EDGE_SE3_PLANE_CALIB 0 11 9 -1 0 0 3 0 0 0" + kOmega3 + "EDGE_SE3_CALIB 0 1 9 1 0 0 0 0 0 1" +
    kOmega6;

/// A vertical line at (4, 3), and a sensor that observes it.
const std::string kLines =
    "PARAMS_SE3OFFSET 0 0 0 0.5 0 0 0 1\nVERTEX_SE3:QUAT 0 1 3 1 0 0 0 1\nVERTEX_LINE3D 10 3 -4 0 0 0 1\n"
    "EDGE_SE3_LINE3D 0 10 0 0 -3 0 0 0 1" +
    kOmega4;

/// Cameras of two types (VERTEX_CAM and VERTEX_SE3:EXPMAP) at (0, 0, 0) and at (1, 0, 0), which look along
/// the z axis, and a point in front of them.
const std::string kCameras =
    "PARAMS_CAMERAPARAMETERS 0 100 50 50 0.1\n"
    "VERTEX_CAM 0 0 0 0 0 0 0 1 100 100 50 50 0.1\nVERTEX_CAM 1 1 0 0 0 0 0 1 100 100 50 50 0.1\n"
    "VERTEX_SE3:EXPMAP 2 0 0 0 0 0 0 1\nVERTEX_SE3:EXPMAP 3 1 0 0 0 0 0 1\n"
    "VERTEX_XYZ 10 0.5 0 2\n"
    "EDGE_CAM 0 1 1 0 0 0 0 0 1" +
    kOmega6 + "EDGE_SCALE 0 1 1" + kOmega1 + "EDGE_PROJECT_P2MC 10 0 75 50" + kOmega2 +
    "EDGE_PROJECT_P2SC 10 1 25 50 20" + kOmega3 + "EDGE_SE3:EXPMAP 2 3 1 0 0 0 0 0 1" + kOmega6 +
    "EDGE_PROJECT_XYZ2UV:EXPMAP 10 2 0 75 50" + kOmega2 + "EDGE_PROJECT_XYZ2UVU:EXPMAP 10 3 0 25 50 20" +
    kOmega3 + "EDGE_SE3_PROJECT_XYZ:EXPMAP 10 2 75 50" + kOmega2 +
    "EDGE_STEREO_SE3_PROJECT_XYZ:EXPMAP 10 3 25 50 20" + kOmega3 +
    "EDGE_SE3_PROJECT_XYZONLYPOSE:EXPMAP 2 75 50 1 0 1 0.5 0.25 2 100 100 50 50\n";

const std::string kSimilarities =
    "VERTEX_SIM3:EXPMAP 0 0 0 0 0 0 0 0 100 100 50 50\nVERTEX_SIM3:EXPMAP 1 0 0 0 1 0 0 0 100 100 50 50\n"
    "VERTEX_TRACKXYZ 10 0.5 0 2\n"
    "EDGE_SIM3:EXPMAP 0 1 0 0 0 1 0 0 0" +
    kOmega7 + "EDGE_PROJECT_SIM3_XYZ:EXPMAP 10 0 75 50" + kOmega2 +
    "EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP 10 1 75 50" + kOmega2;

const std::string kScans =
    "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 1 0 0 0 0 0 1\n"
    "EDGE_V_V_GICP 0 1 2 0 0 0 0 1 1 0.5 0 0 0 1\n";

TEST(SpaceActions, EveryVertexAndEveryEdgeOfTheTestGraphsIsDrawn) {
  for (const std::string& text : {kPlanes, kLines, kCameras, kSimilarities, kScans}) {
    const auto graph = read(text);
    g2o::DrawAction::Parameters draw;
    for (auto* e : graph->edges()) {
      Record record;
      draw.drawing = &record;
      EXPECT_NE((*action("draw"))(e, &draw), nullptr) << g2o::Factory::instance()->tag(e);
      EXPECT_NE(record.out.str(), "") << g2o::Factory::instance()->tag(e);
    }
    for (const auto& [id, v] : graph->vertices()) {
      Record record;
      draw.drawing = &record;
      EXPECT_NE((*action("draw"))(v, &draw), nullptr) << g2o::Factory::instance()->tag(v);
      EXPECT_NE(record.out.str(), "") << g2o::Factory::instance()->tag(v);
    }
  }
}

TEST(SpaceActions, PlanesAreDrawnAsSquaresOfThreeMetersAroundTheirPointNearestToTheOrigin) {
  const std::string shapes = drawn(*read(kPlanes));
  EXPECT_THAT(shapes, HasSubstr("ring1 (-1.5 -1.5 0) (1.5 -1.5 0) (1.5 1.5 0) (-1.5 1.5 0)"));
  EXPECT_THAT(shapes, HasSubstr("line1 (0 0 0) (0 0 0.75)\n"));  // the normal of the floor
  EXPECT_THAT(shapes, HasSubstr("line1 (4 0 0) (3.25 0 0)\n"));  // the normal of the wall
  EXPECT_THAT(shapes, HasSubstr("line1 (0 0 0) (4 0 0)\n"));     // the edge between the planes
}

TEST(SpaceActions, AMeasuredPlaneIsDrawnHalfAMeterWideInFrontOfItsSensor) {
  const auto graph = read(kPlanes);
  EXPECT_THAT(drawn(*graph), HasSubstr("line1 (1 1 1.5) (4 1 1.5)\n"));
  EXPECT_THAT(drawn(*graph), HasSubstr("(4 1.25 1.25)"));
  Record record;
  g2o::DrawAction::Parameters parameters;
  parameters.drawing = &record;
  const std::string edge = typeid(g2o::EdgeSE3PlaneSensorCalib).name();
  parameters.makeProperty<g2o::FloatProperty>(edge + "::PLANE_WIDTH", 2.F);
  parameters.makeProperty<g2o::FloatProperty>(edge + "::PLANE_HEIGHT", 1.F);
  g2o::applyAction(graph.get(), action("draw"), &parameters, edge);
  EXPECT_THAT(record.out.str(), HasSubstr("(4 2 1)"));
}

TEST(SpaceActions, ALineIsDrawnAroundItsPointNearestToTheOriginOrToTheSensor) {
  const auto graph = read(kLines);
  const std::string shapes = drawn(*graph);
  EXPECT_THAT(shapes, HasSubstr("line5 (4 3 -7.5) (4 3 7.5)\n"));
  EXPECT_THAT(shapes, HasSubstr("line1 (1 3 1.5) (4 3 1.5)\nline1 (4 3 -0.5) (4 3 3.5)\n"));
  EXPECT_THAT(gnuplot(*graph), HasSubstr("4 3 0 0 0 1\n"));
  Record record;
  g2o::DrawAction::Parameters parameters;
  parameters.drawing = &record;
  const std::string line = typeid(g2o::VertexLine3D).name();
  parameters.makeProperty<g2o::FloatProperty>(line + "::LINE_LENGTH", 2.F);
  g2o::applyAction(graph.get(), action("draw"), &parameters, line);
  EXPECT_THAT(record.out.str(), HasSubstr("line5 (4 3 -1) (4 3 1)\n"));
}

TEST(SpaceActions, CalibrationEdgesAreDrawnAsTheMotionOfTheRobot) {
  EXPECT_THAT(drawn(*read(kPlanes)), HasSubstr("line1 (1 1 1) (2 1 1)\n"));
}

TEST(SpaceActions, CamerasAreDrawnAsPyramidsInFrontOfTheirCenters) {
  const auto graph = read(kCameras);
  const std::string shapes = drawn(*graph);
  EXPECT_EQ(count(shapes, "ring"), 4);
  EXPECT_EQ(count(shapes, "line1 (1 0 0) (1.025 0.025 0.05)\n"), 2);
  Record record;
  g2o::DrawAction::Parameters parameters;
  parameters.drawing = &record;
  const std::string camera = typeid(g2o::VertexSE3Expmap).name();
  parameters.makeProperty<g2o::FloatProperty>(camera + "::CAMERA_Z", 0.5F);
  parameters.makeProperty<g2o::FloatProperty>(camera + "::CAMERA_SIDE", 0.25F);
  g2o::applyAction(graph.get(), action("draw"), &parameters, camera);
  EXPECT_THAT(record.out.str(), HasSubstr("line1 (1 0 0) (1.125 0.125 0.5)\n"));
}

TEST(SpaceActions, ProjectionsAreDrawnAsLinesBetweenCamerasAndPoints) {
  const std::string shapes = drawn(*read(kCameras));
  EXPECT_EQ(count(shapes, "line1 (0.5 0 2) (0 0 0)\n"), 3);
  EXPECT_EQ(count(shapes, "line1 (0.5 0 2) (1 0 0)\n"), 3);
  EXPECT_EQ(count(shapes, "line1 (0 0 0) (1 0 0)\n"), 3);
  EXPECT_EQ(count(shapes, "line1 (0 0 0) (0.5 0.25 2)\n"), 1);  // to the point that an edge stores
  EXPECT_EQ(count(shapes, "point"), 1);
}

TEST(SpaceActions, SimilaritiesAreDrawnAsCamerasWithTheInversePose) {
  const std::string shapes = drawn(*read(kSimilarities));
  EXPECT_EQ(count(shapes, "ring"), 2);
  EXPECT_THAT(shapes, HasSubstr("line1 (0 0 0) (1 0 0)\n"));
  EXPECT_THAT(shapes, HasSubstr("line1 (0.5 0 2) (1 0 0)\n"));
}

TEST(SpaceActions, APairOfPointsIsDrawnAsALineBetweenThem) {
  EXPECT_THAT(drawn(*read(kScans)), HasSubstr("line1 (2 0 0) (2 0.5 0)\n"));
}

TEST(SpaceActions, StereoCamerasAreDrawnAlthoughTheyHaveNoFileTag) {
  g2o::SparseOptimizer graph;
  auto* camera = new g2o::VertexSCam;
  camera->setId(0);
  ASSERT_TRUE(graph.addVertex(camera));
  EXPECT_EQ(count(drawn(graph), "ring"), 1);
}

TEST(SpaceActions, ACameraIsDrawnIfItsPoseHasACacheForIt) {
  const auto graph = read(
      "PARAMS_CAMERACALIB 0 0 0 1 0 0 0 1 100 100 50 50\nVERTEX_SE3:QUAT 0 1 0 0 0 0 0 1\n"
      "VERTEX_TRACKXYZ 1 1 0 3\nEDGE_PROJECT_DEPTH 0 1 0 50 50 2" +
      kOmega3 + "EDGE_PROJECT_DISPARITY 0 1 0 50 50 0.5" + kOmega3);
  auto* v = static_cast<g2o::VertexSE3*>(graph->vertex(0));
  v->cacheContainer()->createCache(g2o::Cache::CacheKey("CACHE_CAMERA", {graph->parameter(0)}));
  const std::string shapes = drawn(*graph);
  EXPECT_THAT(shapes, HasSubstr("line1 (1 0 1) (1.025 0.025 1.05)\n"));
  EXPECT_EQ(count(shapes, "line1 (1 0 0) (1 0 3)\n"), 2);  // the edges
}

TEST(SpaceActions, AnEdgeToManyPointsIsDrawnAsOneLinePerPoint) {
  const auto graph = read(
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_TRACKXYZ 1 1 0 0\nVERTEX_TRACKXYZ 2 0 1 0\n"
      "EDGE_SE3_LOTSOF_XYZ 0 1 2 || 2 1 0 0 0 1 0 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n");
  EXPECT_THAT(drawn(*graph), HasSubstr("line1 (0 0 0) (1 0 0)\nline1 (0 0 0) (0 1 0)\n"));
}

TEST(SpaceActions, VerticesAreWrittenForGnuplot) {
  EXPECT_THAT(gnuplot(*read(kPlanes)), HasSubstr("-1 0 0 4\n"));
  EXPECT_THAT(gnuplot(*read(kCameras)),
              HasSubstr("0 0 0 0 0 0\n1 0 0 0 0 0\n0 0 0 0 0 0\n1 0 0 0 0 0\n0.5 0 2\n"));
  EXPECT_THAT(gnuplot(*read(kSimilarities)), HasSubstr("1 0 0 0 0 0 1\n0.5 0 2\n"));
}

}  // namespace
