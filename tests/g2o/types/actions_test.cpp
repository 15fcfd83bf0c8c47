// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "g2o/core/factory.h"
#include "g2o/core/hyper_graph_action.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/types/drawn.h"
#include "g2o/types/slam2d/types_slam2d.h"
#include "g2o/types/slam3d/types_slam3d.h"

G2O_USE_TYPE_GROUP(slam2d)
G2O_USE_TYPE_GROUP(slam3d)

namespace {

using drawn_graph::action;
using drawn_graph::count;
using drawn_graph::drawn;
using drawn_graph::gnuplot;
using drawn_graph::read;
using drawn_graph::Record;
using ::testing::HasSubstr;
using ::testing::Not;

/// A graph with all planar types of elements that have an action.
constexpr const char* kPlane =
    "PARAMS_SE2OFFSET 0 0.3 0 0.5\n"
    "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 2 0 1.2\nVERTEX_SE2 2 2.5 2 2.5\nVERTEX_SE2 3 0.2 0.1 0\n"
    "VERTEX_XY 10 1 1\nVERTEX_XY 11 3 1\n"
    "EDGE_SE2 0 1 2 0 1.2 1 0 0 1 0 1\n"
    "EDGE_SE2_OFFSET 1 2 0 0 2 0 1.2 1 0 0 1 0 1\n"
    "EDGE_SE2_XY 0 10 1 1 1 0 1\n"
    "EDGE_BEARING_SE2_XY 1 10 0.5 1\n"
    "EDGE_SE2_POINTXY_OFFSET 1 11 0 1 1 1 0 1\n"
    "EDGE_SE2_XY_CALIB 2 11 3 1 1 1 0 1\n"
    "EDGE_SE2_TWOPOINTSXY 0 10 11 1 1 3 1 1 0 0 0 1 0 0 1 0 1\n"
    "EDGE_POINTXY 10 11 2 0 1 0 1\n"
    "EDGE_PRIOR_SE2 2 2.4 2.2 2.5 1 0 0 1 0 1\n"
    "EDGE_PRIOR_SE2_XY 1 2.1 -0.2 1 0 1\n"
    "EDGE_PRIOR_XY 10 1.1 0.8 1 0 1\n";

/// A graph with 3-D types of elements that have an action.
constexpr const char* kSpace =
    "PARAMS_SE3OFFSET 0 0.3 0 0.2 0 0 0 1\n"
    "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 2 0 0.5 0 0 0.6 0.8\n"
    "VERTEX_SE3:QUAT 2 2.5 2 1 0 0.28 0.96 0\n"
    "VERTEX_TRACKXYZ 10 1 1 2\nVERTEX_TRACKXYZ 11 3 1 0\n"
    "EDGE_SE3:QUAT 0 1 2 0 0.5 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n"
    "EDGE_SE3_OFFSET 1 2 0 0 2 0 0.5 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n"
    "EDGE_SE3_TRACKXYZ 0 10 0 1 1 2 1 0 0 1 0 1\n"
    "EDGE_POINTXYZ 10 11 2 0 -2 1 0 0 1 0 1\n"
    "EDGE_SE3_PRIOR 2 0 2.4 2.2 1 0 0 0 1 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n"
    "EDGE_SE3_XYZ_PRIOR 1 0 2.1 -0.2 0.5 1 0 0 1 0 1\n"
    "EDGE_POINTXYZ_PRIOR 11 3 1.4 0 1 0 0 1 0 1\n";

TEST(Actions, EveryElementOfAPlanarGraphIsDrawnAndWrittenForGnuplot) {
  const auto graph = read(kPlane);
  ASSERT_EQ(graph->vertices().size() + graph->edges().size(), 17U);
  g2o::DrawAction::Parameters draw;
  Record record;
  draw.drawing = &record;
  g2o::WriteGnuplotAction::Parameters write;
  write.os = &record.out;
  for (auto* e : graph->edges()) {
    EXPECT_NE((*action("draw"))(e, &draw), nullptr) << g2o::Factory::instance()->tag(e);
    EXPECT_NE((*action("writeGnuplot"))(e, &write), nullptr) << g2o::Factory::instance()->tag(e);
  }
  const std::string shapes = drawn(*graph);
  EXPECT_EQ(count(shapes, "pose"), 4);
  EXPECT_EQ(count(shapes, "point"), 2);
  EXPECT_THAT(shapes, HasSubstr("pose0.2x0.05 (2 0 0)"));
  EXPECT_THAT(shapes, HasSubstr("(2.5 2 0) (2.4 2.2 0)"));  // from the pose to the measurement of its prior
  // There is no line to vertex 3, because it is the offset of a sensor and has no position in the world.
  EXPECT_THAT(shapes, Not(HasSubstr("(2.5 2 0) (0.2 0.1 0)")));
  const std::string text = gnuplot(*graph);
  EXPECT_THAT(text, HasSubstr("0 0 0\n2 0 1.2\n\n"));
  EXPECT_THAT(text, HasSubstr("2.5 2\n2.4 2.2\n\n"));
  EXPECT_THAT(text, HasSubstr("0 0\n1 1\n\n0 0\n3 1\n\n"));  // one pose observes two points
  EXPECT_EQ(count(text, "\n\n"), 12);
}

TEST(Actions, EveryElementOfA3dGraphIsDrawnAndWrittenForGnuplot) {
  const auto graph = read(kSpace);
  ASSERT_EQ(graph->vertices().size() + graph->edges().size(), 12U);
  const std::string shapes = drawn(*graph);
  EXPECT_EQ(count(shapes, "pose"), 3);
  EXPECT_EQ(count(shapes, "point"), 2);
  EXPECT_THAT(shapes, HasSubstr("(0 0 0) (2 0 0.5)"));
  EXPECT_THAT(shapes, HasSubstr("(3 1 0) (3 1.4 0)"));
  const std::string text = gnuplot(*graph);
  EXPECT_EQ(count(text, "\n\n"), 7);
  EXPECT_THAT(text, HasSubstr("0 0 0\n1 1 2\n\n"));
}

TEST(Actions, SensorsAreDrawnIfTheirPosesHaveCachesForThem) {
  const auto graph = read(kPlane);
  g2o::CacheSE2Offset* cache = nullptr;
  auto* v = static_cast<g2o::VertexSE2*>(graph->vertex(0));
  v->cacheContainer()->createCache(g2o::Cache::CacheKey("CACHE_SE2_OFFSET", {graph->parameter(0)}));
  ASSERT_EQ(v->cacheContainer()->size(), 1U);
  cache = dynamic_cast<g2o::CacheSE2Offset*>(v->cacheContainer()->begin()->second);
  ASSERT_NE(cache, nullptr);
  EXPECT_EQ(count(drawn(*graph), "ring"), 2);
}

TEST(Actions, NothingIsDrawnWithoutADrawingOrWithoutParameters) {
  const auto graph = read(kPlane);
  g2o::DrawAction::Parameters parameters;
  EXPECT_EQ((*action("draw"))(graph->vertex(0), &parameters), nullptr);
  EXPECT_EQ((*action("draw"))(graph->vertex(0), nullptr), nullptr);
  EXPECT_EQ((*action("writeGnuplot"))(graph->vertex(0), &parameters), nullptr);
  EXPECT_EQ(action("no such action"), nullptr);
  g2o::applyAction(graph.get(), action("no such action"));
  EXPECT_FALSE(g2o::HyperGraphActionLibrary::instance()->registerAction(nullptr));
  EXPECT_FALSE(g2o::HyperGraphActionLibrary::instance()->unregisterAction(nullptr));
}

TEST(Actions, PropertiesHideAndScaleTheElementsOfAType) {
  const auto graph = read(kPlane);
  const std::string pose = typeid(g2o::VertexSE2).name(), point = typeid(g2o::VertexPointXY).name();
  Record record;
  g2o::DrawAction::Parameters parameters;
  parameters.drawing = &record;
  parameters.makeProperty<g2o::FloatProperty>(pose + "::TRIANGLE_X", 0.5F);
  parameters.makeProperty<g2o::BoolProperty>(point + "::SHOW", false);
  g2o::applyAction(graph.get(), action("draw"), &parameters);
  EXPECT_EQ(count(record.out.str(), "pose0.5x0.05"), 4);
  EXPECT_EQ(count(record.out.str(), "point"), 0);
  EXPECT_TRUE(parameters.updatePropertyFromString(point + "::SHOW", "1"));
  g2o::applyAction(graph.get(), action("draw"), &parameters, point);
  EXPECT_EQ(count(record.out.str(), "point"), 2);
}

TEST(Actions, AnEdgeWithoutItsSecondPoseIsDrawnToThePredictedPose) {
  const auto graph = read(kPlane);
  auto* e = new g2o::EdgeSE2;
  e->setVertex(0, graph->vertex(0));
  e->setVertex(1, graph->vertex(1));
  e->setMeasurement(g2o::SE2(0, 7, 0));
  ASSERT_TRUE(graph->addEdge(e));
  graph->setEdgeVertex(e, 1, nullptr);
  EXPECT_THAT(drawn(*graph), HasSubstr("(0 7 0)"));
  EXPECT_EQ(count(gnuplot(*graph), "\n\n"), 12);
}

TEST(Actions, AnEdgeWithoutItsLandmarkIsDrawnToThePredictedLandmark) {
  const auto plane = read(kPlane), space = read(kSpace);
  auto* in_plane = new g2o::EdgeSE2PointXY;
  in_plane->setVertex(0, plane->vertex(1));
  in_plane->setVertex(1, plane->vertex(10));
  in_plane->setMeasurement(g2o::Vector2(5, 0));
  ASSERT_TRUE(plane->addEdge(in_plane));
  plane->setEdgeVertex(in_plane, 1, nullptr);
  static_cast<g2o::VertexSE2*>(plane->vertex(1))->setEstimate(g2o::SE2(2, 0, 0));
  EXPECT_THAT(drawn(*plane), HasSubstr("point4 (7 0 0)"));

  auto* in_space = new g2o::EdgeSE3PointXYZ;
  in_space->setVertex(0, space->vertex(0));
  in_space->setVertex(1, space->vertex(11));
  in_space->setParameterId(0, 0);
  in_space->setMeasurement(g2o::Vector3(5, 0, 1));
  ASSERT_TRUE(space->addEdge(in_space));
  space->setEdgeVertex(in_space, 1, nullptr);
  EXPECT_THAT(drawn(*space), HasSubstr("line1 (0 0 0) (5.3 0 1.2)"));  // the sensor is at (0.3, 0, 0.2)
}

/// User data of an element, and the action that draws it.
struct Label : g2o::HyperGraph::Data {
  explicit Label(std::string text) : words(std::move(text)) {}
  bool read(std::istream& is) override { return static_cast<bool>(is >> words); }
  bool write(std::ostream& os) const override { return static_cast<bool>(os << words); }
  std::string words;
};
struct DrawLabel : g2o::DrawAction {
  DrawLabel() : g2o::DrawAction(typeid(Label).name()) {}
  g2o::HyperGraphElementAction* operator()(g2o::HyperGraph::HyperGraphElement* element,
                                           g2o::HyperGraphElementAction::Parameters* parameters) override {
    if (!refreshPropertyPtrs(parameters) || !_show->value()) return nullptr;
    _previousParams->drawing->text(g2o::Vector3::Zero(), static_cast<Label*>(element)->words, g2o::Color(),
                                   1);
    return this;
  }
};

TEST(Actions, UserDataIsDrawnWithItsVertexOrEdge) {
  const g2o::RegisterActionProxy<DrawLabel> registered;
  const auto graph = read(kPlane);
  graph->vertex(0)->addUserData(new Label("start"));
  graph->vertex(0)->addUserData(new Label("door"));
  (*graph->edges().begin())->addUserData(new Label("measured"));
  const std::string shapes = drawn(*graph);
  EXPECT_EQ(count(shapes, "text "), 3);
  EXPECT_THAT(shapes, HasSubstr("text door\ntext start\n"));
  EXPECT_THAT(shapes, HasSubstr("text measured\n"));
}

TEST(Actions, ActionsOfLibraryTypesAreAvailableAsClasses) {
  const auto graph = read(kPlane);
  std::ostringstream expected, out;
  g2o::WriteGnuplotAction::Parameters parameters;
  parameters.os = &expected;
  ASSERT_NE((*action("writeGnuplot"))(graph->vertex(1), &parameters), nullptr);
  parameters.os = &out;
  g2o::VertexSE2WriteGnuplotAction write;
  EXPECT_EQ(write(graph->vertex(1), &parameters), &write);
  EXPECT_FALSE(out.str().empty());
  EXPECT_EQ(out.str(), expected.str());
  EXPECT_EQ(write(graph->vertex(10), &parameters), nullptr);  // a point
  EXPECT_EQ(write.name(), "writeGnuplot");
  EXPECT_EQ(write.typeName(), typeid(g2o::VertexSE2).name());

  Record record;
  g2o::DrawAction::Parameters draw;
  draw.drawing = &record;
  g2o::EdgeSE2DrawAction edges;
  for (auto* e : graph->edges()) edges(e, &draw);
  EXPECT_EQ(count(record.out.str(), "line"), 1);  // there is one EDGE_SE2
}

/// An action of a user for a type of the library.
struct CountPoses : g2o::HyperGraphElementAction {
  struct Parameters : g2o::HyperGraphElementAction::Parameters {
    int poses = 0;
  };
  CountPoses() : g2o::HyperGraphElementAction(typeid(g2o::VertexSE2).name()) { _name = "count"; }
  g2o::HyperGraphElementAction* operator()(g2o::HyperGraph::HyperGraphElement*,
                                           g2o::HyperGraphElementAction::Parameters* parameters) override {
    ++static_cast<Parameters*>(parameters)->poses;
    return this;
  }
};

TEST(Actions, UserActionsAreAppliedOnlyWhileTheyAreRegistered) {
  const auto graph = read(kPlane);
  CountPoses::Parameters parameters;
  {
    const g2o::RegisterActionProxy<CountPoses> registered;
    g2o::applyAction(graph.get(), action("count"), &parameters);
    EXPECT_EQ(parameters.poses, 4);
  }
  g2o::applyAction(graph.get(), action("count"), &parameters);
  EXPECT_EQ(parameters.poses, 4);
}

}  // namespace
