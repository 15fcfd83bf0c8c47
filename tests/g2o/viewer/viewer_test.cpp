// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/viewer/viewer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "boxplus/base/error.h"
#include "g2o/core/factory.h"
#include "g2o/core/hyper_graph_action.h"
#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/types/drawn.h"
#include "g2o/types/slam2d/types_slam2d.h"
#include "viewer/optimizer_subject.h"
#include "viewer/recorded_drawing.h"

G2O_USE_TYPE_GROUP(slam2d)
G2O_USE_OPTIMIZATION_LIBRARY(eigen)

namespace g2o {
namespace {

using boxplus::EdgeRole;
using boxplus::Settings;
using boxplus::viewer::Shape;
using boxplus::viewer::Structure;
using internal::OptimizerSubject;
using internal::RecordedDrawing;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kGraph =
    "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 2 0 1.2\nVERTEX_SE2 2 2.5 2 2.5\nVERTEX_XY 10 1 1\n"
    "FIX 0\n"
    "EDGE_SE2 0 1 2 0 1 1 0 0 1 0 1\n"
    "EDGE_SE2 1 2 2 0 1 1 0 0 1 0 1\n"
    "EDGE_SE2 0 2 2 2 2 1 0 0 1 0 1\n"
    "EDGE_SE2_XY 0 10 1 1.5 1 0 1\n";

class Log final : public boxplus::viewer::Listener {
 public:
  bool note(const boxplus::IterationRecord& record) override {
    records.push_back(record);
    return true;
  }
  void log(const char* /*level*/, std::string text) override { lines += text + "\n"; }
  const std::atomic<bool>& stop_flag() const override { return stop; }

  std::vector<boxplus::IterationRecord> records;
  std::string lines;
  std::atomic<bool> stop = false;
};

TEST(RecordedDrawing, HasTheShapesOfEachTypeAndTheRolesOfEdges) {
  const auto graph = drawn_graph::read(kGraph);
  const Structure structure = RecordedDrawing(*graph).structure();
  ASSERT_EQ(structure.vertices.size(), 2U);
  EXPECT_EQ(structure.vertices[0].name, "VERTEX_SE2");
  EXPECT_EQ(structure.vertices[0].shape, Shape::kPose);
  EXPECT_EQ(structure.vertices[0].slots.size(), 3U);
  EXPECT_EQ(structure.vertices[1].shape, Shape::kPoint);
  EXPECT_EQ(structure.oriented, 3U);
  EXPECT_EQ(structure.dimension, 2);
  EXPECT_THAT(structure.fixed, ElementsAre(1, 0, 0, 0));
  ASSERT_EQ(structure.line_groups.size(), 3U);
  EXPECT_EQ(structure.line_groups[0].role, EdgeRole::kOdometry);
  EXPECT_EQ(structure.line_groups[1].role, EdgeRole::kLoopClosure);
  EXPECT_EQ(structure.line_groups[2].role, EdgeRole::kObservation);
  EXPECT_THAT(structure.lines, ElementsAre(0, 1, 1, 2, 0, 2, 0, 3));
}

TEST(RecordedDrawing, HasPositionsAndOrientationsInTheOrderOfTheStructure) {
  const auto graph = drawn_graph::read(kGraph);
  const boxplus::viewer::Positions positions = RecordedDrawing(*graph).positions({1, 0, 0});
  ASSERT_EQ(positions.points.size(), 12U);
  EXPECT_FLOAT_EQ(positions.points[3], 1);   // x of vertex 1
  EXPECT_FLOAT_EQ(positions.points[10], 1);  // y of the landmark
  ASSERT_EQ(positions.orientations.size(), 12U);
  EXPECT_FLOAT_EQ(positions.orientations[6], std::sin(0.6F));
}

/// A type of a client, with an action of its own.
class Beacon : public BaseVertex<1, double> {
 public:
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
  void setToOriginImpl() override { _estimate = 0; }
  void oplusImpl(const double* update) override { _estimate += update[0]; }
};

class DrawBeacon : public DrawAction {
 public:
  DrawBeacon() : DrawAction(typeid(Beacon).name()) {}
  HyperGraphElementAction* operator()(HyperGraph::HyperGraphElement* element,
                                      HyperGraphElementAction::Parameters* parameters) override {
    if (!refreshPropertyPtrs(parameters)) return nullptr;
    const double height = static_cast<Beacon*>(element)->estimate();
    const Color red{1, 0, 0, 1};
    _previousParams->drawing->point({1, 2, height}, red, 3);
    _previousParams->drawing->line({1, 2, 0}, {1, 2, height}, red, 1);
    return this;
  }
};

TEST(RecordedDrawing, ShowsTypesOfClientsWithTheirColors) {
  const RegisterActionProxy<DrawBeacon> action;
  SparseOptimizer optimizer;
  auto* beacon = new Beacon;
  beacon->setId(0);
  beacon->setEstimate(5);
  optimizer.addVertex(beacon);
  const RecordedDrawing drawing(optimizer);
  const Structure structure = drawing.structure();
  ASSERT_EQ(structure.vertices.size(), 2U);
  EXPECT_THAT(structure.vertices[0].name, HasSubstr("Beacon"));
  EXPECT_EQ(structure.vertices[0].color, "#ff0000");
  EXPECT_EQ(structure.vertices[1].shape, Shape::kCorner);
  EXPECT_EQ(structure.dimension, 3);
  ASSERT_EQ(structure.line_groups.size(), 1U);
  EXPECT_EQ(structure.line_groups[0].color, "#ff0000");
  EXPECT_FLOAT_EQ(drawing.positions({0, 0, 0}).points[2], 5);
}

/// The optimum of the graph in 10 iterations without the viewer.
double reference_chi2(const std::string& algorithm) {
  const auto graph = drawn_graph::read(kGraph);
  OptimizationAlgorithmProperty property;
  graph->setAlgorithm(OptimizationAlgorithmFactory::instance()->construct(algorithm, property));
  graph->initializeOptimization();
  graph->optimize(10);
  return graph->activeRobustChi2();
}

TEST(OptimizerSubject, OptimizesAsTheOptimizerDoes) {
  OptimizerSubject subject(drawn_graph::read(kGraph), "graph");
  Log log;
  const boxplus::viewer::Outcome outcome = subject.run({{"algorithm", "gn_var"}}, log);
  EXPECT_DOUBLE_EQ(outcome.chi2, reference_chi2("gn_var"));
  EXPECT_EQ(log.records.size(), 10U);
  EXPECT_DOUBLE_EQ(log.records.back().chi2, outcome.chi2);
  EXPECT_FALSE(subject.update_structure());
}

TEST(OptimizerSubject, RestoresWhatItKept) {
  OptimizerSubject subject(drawn_graph::read(kGraph), "graph");
  Log log;
  const double before = subject.chi2();
  subject.keep_estimates();
  subject.step({{"kernel", "Huber"}, {"kernel-width", "0.1"}}, log);
  EXPECT_LT(subject.chi2(), before);
  subject.restore();
  EXPECT_DOUBLE_EQ(subject.chi2(), before);
  EXPECT_TRUE(subject.guess("odometry", log));
  EXPECT_NE(subject.chi2(), before);
  subject.restore();
  EXPECT_DOUBLE_EQ(subject.chi2(), before);
  subject.drop_estimates();
}

TEST(OptimizerSubject, RefusesSettingsThatDoNotExist) {
  const OptimizerSubject subject(drawn_graph::read(kGraph), "graph");
  for (const Settings& settings :
       {Settings{{"algorithm", "best"}}, Settings{{"speed", "9"}}, Settings{{"iterations", "-1"}},
        Settings{{"iterations", "ten"}}, Settings{{"kernel", "Huber"}, {"kernel-width", "0"}}})
    EXPECT_THROW(subject.check(settings), boxplus::InvalidArgument);
}

TEST(OptimizerSubject, SaysWhyAnAlgorithmDoesNotSuitTheGraph) {
  const OptimizerSubject subject(drawn_graph::read(kGraph), "graph");
  EXPECT_THAT(*subject.form(), HasSubstr("needs poses with 6 and landmarks with 3 dimensions"));
  EXPECT_THAT(subject.formatted("g2o"), HasSubstr("EDGE_SE2_XY 0 10"));
}

TEST(Viewer, WatchesTheRunsOfAProgram) {
  const auto graph = drawn_graph::read(kGraph);
  OptimizationAlgorithmProperty property;
  graph->setAlgorithm(OptimizationAlgorithmFactory::instance()->construct("gn_var", property));
  graph->initializeOptimization();
  {
    Viewer viewer(*graph);
    EXPECT_THAT(viewer.url(), StartsWith("http://127.0.0.1:"));
    EXPECT_EQ(graph->optimize(10), 10);
    viewer.update();
    viewer.handOver();
    viewer.takeBack();
    EXPECT_EQ(graph->optimize(1), 1);
  }
  EXPECT_EQ(graph->forceStopFlag(), nullptr);
  EXPECT_EQ(graph->optimize(1), 1);
}

}  // namespace
}  // namespace g2o
