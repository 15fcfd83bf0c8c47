// SPDX-License-Identifier: BSD-3-Clause
// Actions on the elements of a graph: drawing, writing, and a custom action. The program finds an action by
// its name, and applies it to the elements of one type or of all types.
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "g2o/core/block_solver.h"
#include "g2o/core/drawing.h"
#include "g2o/core/factory.h"
#include "g2o/core/hyper_graph_action.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/types/slam2d/types_slam2d.h"

G2O_USE_TYPE_GROUP(slam2d)

using namespace g2o;

constexpr const char* kGraph = R"(VERTEX_SE2 0 0 0 0
FIX 0
VERTEX_SE2 1 2 0 0.4
VERTEX_SE2 2 3.8 0.8 1.2
VERTEX_SE2 3 4.4 2.6 2
VERTEX_SE2 4 3.4 4 2.8
VERTEX_XY 10 1 2.5
VERTEX_XY 11 2.6 2.6
EDGE_SE2 0 1 2 0 0.4 1 0 0 1 0 1
EDGE_SE2 1 2 2 0 0.8 1 0 0 1 0 1
EDGE_SE2 2 3 1.9 0 0.8 1 0 0 1 0 1
EDGE_SE2 3 4 1.7 0 0.8 1 0 0 1 0 1
EDGE_SE2_XY 0 10 1 2.5 1 0 1
EDGE_SE2_XY 1 10 0 2.7 1 0 1
EDGE_SE2_XY 1 11 1.6 2.1 1 0 1
EDGE_SE2_XY 2 11 1.2 1.8 1 0 1
EDGE_SE2_XY 4 10 1.8 2.2 1 0 1
EDGE_SE2_XY 4 11 0.3 1.6 1 0 1
EDGE_PRIOR_SE2_XY 4 3.2 4.3 1 0 1
)";

// [custom]
/// A custom action for one type of edge: adds up the distance that the robot drove.
class EdgeSE2Length : public HyperGraphElementAction {
 public:
  struct Parameters : HyperGraphElementAction::Parameters {
    double meters = 0;
  };
  EdgeSE2Length() : HyperGraphElementAction(typeid(EdgeSE2).name()) { _name = "length"; }

  HyperGraphElementAction* operator()(HyperGraph::HyperGraphElement* element,
                                      HyperGraphElementAction::Parameters* parameters) override {
    auto* result = dynamic_cast<Parameters*>(parameters);
    if (result == nullptr) return nullptr;
    result->meters += static_cast<EdgeSE2*>(element)->measurement().translation().norm();
    return this;
  }
};
G2O_REGISTER_ACTION(EdgeSE2Length)
// [/custom]

// [drawing]
/// Receives the shapes that the action "draw" draws.
class CountShapes : public Drawing {
 public:
  void polyline(const std::vector<Vector3>&, bool, const Color&, double /*width*/) override { ++lines; }
  void point(const Vector3& at, const Color&, double diameter) override {
    std::printf("a point at (%g, %g), %g pixels wide\n", at.x(), at.y(), diameter);
  }
  void pose(const Isometry3&, const Color&, double /*length*/, double /*width*/) override { ++poses; }
  void text(const Vector3&, const std::string&, const Color&, double /*height*/) override {}
  int lines = 0, poses = 0;
};
// [/drawing]

// [iteration]
/// Called by the optimizer after each iteration.
class CountIterations : public HyperGraphAction {
 public:
  HyperGraphAction* operator()(const HyperGraph*, Parameters* parameters) override {
    const auto* iteration = dynamic_cast<ParametersIteration*>(parameters);
    if (iteration != nullptr && iteration->iteration >= 0) ++count;  // −1 in initializeOptimization()
    return this;
  }
  int count = 0;
};
// [/iteration]

int main() {
  SparseOptimizer graph;
  std::istringstream file(kGraph);
  if (!graph.load(file)) return 1;

  // [length]
  HyperGraphActionLibrary* library = HyperGraphActionLibrary::instance();
  EdgeSE2Length::Parameters length;
  applyAction(&graph, library->actionByName("length"), &length);
  std::printf("driven: %.1f m\n", length.meters);
  // [/length]

  // [gnuplot]
  std::ostringstream text;
  WriteGnuplotAction::Parameters write;
  write.os = &text;
  applyAction(&graph, library->actionByName("writeGnuplot"), &write, typeid(EdgeSE2PointXY).name());
  // [/gnuplot]
  std::cout << text.str().substr(0, text.str().find("\n\n")) << '\n';

  // [draw]
  CountShapes shapes;
  DrawAction::Parameters draw;
  draw.drawing = &shapes;
  draw.makeProperty<FloatProperty>(std::string(typeid(VertexPointXY).name()) + "::POINT_SIZE", 8.F);
  applyAction(&graph, library->actionByName("draw"), &draw);
  std::printf("%d poses, %d lines\n", shapes.poses, shapes.lines);
  // [/draw]

  using Blocks = BlockSolverX;
  graph.setAlgorithm(new OptimizationAlgorithmGaussNewton(
      std::make_unique<Blocks>(std::make_unique<LinearSolverEigen<Blocks::PoseMatrixType>>())));
  // [count]
  CountIterations counter;
  graph.addPostIterationAction(&counter);
  graph.initializeOptimization();
  graph.optimize(3);
  graph.removePostIterationAction(&counter);
  // [/count]
  return counter.count == 3 && std::abs(length.meters - 7.6) < 1e-9 && shapes.poses == 5 ? 0 : 1;
}
