// SPDX-License-Identifier: BSD-3-Clause
// 2-D SLAM with custom types: simulates a robot, builds a graph from its measurements, and optimizes the
// graph. The exit code is 1 if the result is far from the truth.
//
//     tutorial_slam2d [-poses 300] [-landmarks 100] [-seed 1] [-o FOLDER]
//
// With -o, the graph is written to FOLDER/tutorial_before.g2o and FOLDER/tutorial_after.g2o.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "edge_se2.h"
#include "edge_se2_point_xy.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/stuff/command_args.h"
#include "g2o/stuff/logger.h"
#include "simulator.h"

// [use]
G2O_USE_TYPE_GROUP(tutorial_slam2d);
// [/use]

using namespace g2o;
using namespace g2o::tutorial;

constexpr int kSensor = 0;             // the id of the parameter with the sensor's pose on the robot
constexpr int kFirstLandmark = 10000;  // the ids of poses are smaller

// [graph]
/// Adds an edge for each measurement, and the vertices of these edges. The initial poses come from the
/// odometry alone. The initial position of a landmark comes from its first observation.
void add_graph(const Simulation& world, const SE2& sensor_offset, SparseOptimizer& optimizer) {
  auto* offset = new ParameterSE2Offset;
  offset->setId(kSensor);
  offset->setOffset(sensor_offset);
  optimizer.addParameter(offset);

  auto* first = new VertexSE2;
  first->setId(0);
  optimizer.addVertex(first);
  for (const Simulation::Motion& motion : world.odometry) {
    auto* from = static_cast<VertexSE2*>(optimizer.vertex(motion.from));
    auto* to = new VertexSE2;
    to->setId(motion.to);
    to->setEstimate(from->estimate() * motion.measured);
    optimizer.addVertex(to);

    auto* edge = new EdgeSE2;
    edge->setVertex(0, from);
    edge->setVertex(1, to);
    edge->setMeasurement(motion.measured);
    edge->setInformation(world.odometry_information);
    optimizer.addEdge(edge);
  }
  for (const Simulation::Observation& seen : world.observations) {
    const auto* robot = static_cast<const VertexSE2*>(optimizer.vertex(seen.pose));
    const int id = kFirstLandmark + seen.landmark;
    if (optimizer.vertex(id) == nullptr) {
      auto* landmark = new VertexPointXY;
      landmark->setId(id);
      landmark->setEstimate(robot->estimate() * sensor_offset * seen.measured);
      landmark->setMarginalized(true);
      optimizer.addVertex(landmark);
    }
    auto* edge = new EdgeSE2PointXY;
    edge->setVertex(0, optimizer.vertex(seen.pose));
    edge->setVertex(1, optimizer.vertex(id));
    edge->setParameterId(0, kSensor);
    edge->setMeasurement(seen.measured);
    edge->setInformation(world.landmark_information);
    optimizer.addEdge(edge);
  }
}
// [/graph]

/// The root mean square distances (meters) of the poses and of the landmarks from their true positions.
struct Distance {
  double poses = 0, landmarks = 0;
};

Distance distance_from_truth(const Simulation& world, const SparseOptimizer& optimizer) {
  Distance sum;
  int seen = 0;
  for (size_t i = 0; i < world.poses.size(); ++i) {
    const auto* v = static_cast<const VertexSE2*>(optimizer.vertex(static_cast<int>(i)));
    sum.poses += (v->estimate().translation() - world.poses[i].translation()).squaredNorm();
  }
  for (size_t l = 0; l < world.landmarks.size(); ++l) {
    const auto* v = static_cast<const VertexPointXY*>(optimizer.vertex(kFirstLandmark + static_cast<int>(l)));
    if (v == nullptr) continue;  // never seen
    sum.landmarks += (v->estimate() - world.landmarks[l]).squaredNorm();
    ++seen;
  }
  return {std::sqrt(sum.poses / static_cast<double>(world.poses.size())),
          std::sqrt(sum.landmarks / std::max(seen, 1))};
}

/// Returns n − m for n rows of errors and m free unknowns. If the measurements have only Gaussian noise with
/// the information Ω, the minimum of chi2 has mean n − m and variance 2 (n − m).
double degrees_of_freedom(const SparseOptimizer& optimizer) {
  double freedom = 0;
  for (const auto* e : optimizer.activeEdges()) freedom += e->dimension();
  for (const auto* v : optimizer.indexMapping()) freedom -= v->dimension();
  return freedom;
}

void print(const char* when, SparseOptimizer& optimizer, const Distance& distance) {
  optimizer.computeActiveErrors();
  std::printf("%s chi2 = %.1f; RMS errors: poses %.3f m, landmarks %.3f m\n", when, optimizer.chi2(),
              distance.poses, distance.landmarks);
}

bool save(const SparseOptimizer& optimizer, const std::string& folder, const char* name) {
  return folder.empty() || optimizer.save((folder + "/" + name).c_str());
}

int main(int argc, char** argv) {
  logging::setSink([](logging::Level, const std::string& text) { std::cerr << text << '\n'; });
  SimulationOptions options;
  std::string folder;
  int seed = 1;
  CommandArgs args;
  args.param("poses", options.poses, options.poses, "the number of poses");
  args.param("landmarks", options.landmarks, options.landmarks, "the number of landmarks");
  args.param("seed", seed, seed, "the seed of the random world");
  args.param("o", folder, "", "write the graph to this folder, before and after the optimization");
  args.parseArgs(argc, argv);
  options.seed = static_cast<unsigned>(seed);

  const Simulation world = simulate(options);
  // [optimize]
  using Blocks = BlockSolver_3_2;
  SparseOptimizer optimizer;
  optimizer.setAlgorithm(new OptimizationAlgorithmGaussNewton(
      std::make_unique<Blocks>(std::make_unique<LinearSolverEigen<Blocks::PoseMatrixType>>())));
  add_graph(world, options.sensor_offset, optimizer);
  optimizer.vertex(0)->setFixed(true);  // fixes the gauge: the first pose is the frame of the world
  optimizer.initializeOptimization();
  // [/optimize]
  const Distance before = distance_from_truth(world, optimizer);
  std::printf("%zu poses and landmarks, %zu measurements\n", optimizer.vertices().size(),
              optimizer.edges().size());
  print("before:", optimizer, before);
  if (!save(optimizer, folder, "tutorial_before.g2o")) return 1;

  const int iterations = optimizer.optimize(10);

  const Distance after = distance_from_truth(world, optimizer);
  print("after: ", optimizer, after);
  if (!save(optimizer, folder, "tutorial_after.g2o")) return 1;
  const double freedom = degrees_of_freedom(optimizer), deviation = std::sqrt(2 * freedom);
  std::printf("expected from noise alone: chi2 = %.0f ± %.0f\n", freedom, deviation);
  const bool is_plausible = std::abs(optimizer.chi2() - freedom) < 5 * deviation;
  const bool is_near = after.poses < 0.25 && after.landmarks < 0.25;
  return iterations > 0 && is_near && is_plausible ? 0 : 1;
}
