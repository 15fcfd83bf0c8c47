// SPDX-License-Identifier: BSD-3-Clause
// Both faces find the same chi2: of a file, and after five Gauss-Newton iterations from its estimates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/simulate.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"
#include "g2o/types/slam2d/types_slam2d.h"
#include "g2o/types/slam3d/types_slam3d.h"

G2O_USE_TYPE_GROUP(slam2d);
G2O_USE_TYPE_GROUP(slam3d);

namespace {

using Linear = g2o::LinearSolverEigen<g2o::BlockSolverX::PoseMatrixType>;

constexpr int kIterations = 5;

/// chi2 at the beginning and after each iteration.
std::vector<double> native_chi2(boxplus::Graph& graph) {
  boxplus::Options options;
  options.algorithm = boxplus::AlgorithmKind::kGaussNewton;
  options.max_iterations = kIterations;
  options.cost_tolerance = options.step_tolerance = options.noise_tolerance = 0;
  if (graph.vertex_count() > 0) graph.fix(graph.all_vertices().front());
  const boxplus::Report report = boxplus::optimize(graph, options);
  std::vector<double> chi2{report.chi2_initial};
  for (const boxplus::IterationRecord& record : report.records) chi2.push_back(record.chi2);
  // It ends within rounding, where the g2o API goes on.
  if (report.reason == boxplus::Reason::kNoFurtherDecrease) chi2.resize(kIterations + 1, chi2.back());
  return chi2;
}

std::vector<double> face_chi2(g2o::SparseOptimizer& optimizer) {
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(
      std::make_unique<g2o::BlockSolverX>(std::make_unique<Linear>())));
  int lowest = optimizer.vertices().begin()->first;
  for (const auto& [id, v] : optimizer.vertices()) lowest = std::min(lowest, id);
  optimizer.vertex(lowest)->setFixed(true);
  optimizer.setComputeBatchStatistics(true);
  EXPECT_TRUE(optimizer.initializeOptimization());
  optimizer.computeActiveErrors();
  std::vector<double> chi2{optimizer.activeChi2()};
  EXPECT_EQ(optimizer.optimize(kIterations), kIterations);
  for (const g2o::G2OBatchStatistics& iteration : optimizer.batchStatistics()) chi2.push_back(iteration.chi2);
  return chi2;
}

/// To 1e-9 at the beginning and the end. Between, of what the step began with: one that takes csail
/// from 1.3e6 to 771 leaves 1e-8 of the latter to rounding, whatever factorises.
void expect_same(const std::vector<double>& native, const std::vector<double>& face) {
  ASSERT_EQ(native.size(), kIterations + 1u);
  ASSERT_EQ(face.size(), kIterations + 1u);
  for (std::size_t i = 0; i < native.size(); ++i) {
    const double scale = i == 0 || i == kIterations ? native[i] : std::max(native[i - 1], native[i]);
    EXPECT_NEAR(face[i], native[i], 1e-9 * scale) << "after iteration " << i;
  }
}

TEST(NativeFace, SimulatedGraphsHaveTheSameChi2) {
  for (const boxplus::World world :
       {boxplus::World::kSphere, boxplus::World::kGrid, boxplus::World::kManhattan, boxplus::World::kCity}) {
    SCOPED_TRACE(boxplus::to_string(world));
    boxplus::SimulationOptions options;
    options.poses = 300;
    options.noise = 0.2;  // so that Gauss-Newton descends
    boxplus::Graph graph = boxplus::simulate(world, options).graph;
    boxplus::GraphFile file;
    file.graph = std::move(graph);
    std::istringstream text(boxplus::format_graph(file));
    g2o::SparseOptimizer optimizer;
    ASSERT_TRUE(optimizer.load(text));
    expect_same(native_chi2(file.graph), face_chi2(optimizer));
  }
}

class NativeFaceFile : public testing::TestWithParam<const char*> {};

TEST_P(NativeFaceFile, HasTheSameChi2) {
  const char* folder = std::getenv("BOXPLUS_DATA");
  const std::string path = std::string(folder ? folder : ".") + "/" + GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "SKIPPED: no " << path;
  g2o::SparseOptimizer optimizer;
  ASSERT_TRUE(optimizer.load(path));
  boxplus::GraphFile file = boxplus::read_graph(path);
  ASSERT_EQ(optimizer.edges().size(), file.graph.edge_count());
  expect_same(native_chi2(file.graph), face_chi2(optimizer));
}

// Files from whose estimates Gauss-Newton descends. (From those of victoriaPark it goes astray, and five
// iterations turn rounding into 3e-9 of chi2.)
INSTANTIATE_TEST_SUITE_P(Public, NativeFaceFile,
                         testing::Values("posegraph2d/intel_1728.g2o", "posegraph2d/csail.g2o",
                                         "posegraph2d/M3500.g2o", "posegraph2d/city10000.g2o",
                                         "posegraph3d/parking-garage.g2o", "posegraph3d/sphere2500.g2o",
                                         "posegraph3d/torus3D.g2o", "posegraph3d/smallGrid3D.g2o"),
                         [](const auto& test) {
                           std::string name = std::filesystem::path(test.param).stem().string();
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

TEST(NativeFace, StepsOfGaussNewtonAreExactThoseOfLevenbergRefinedFromFloatLikeOurs) {
  boxplus::GraphFile file;
  file.graph = boxplus::simulate(boxplus::World::kSphere, {.poses = 2500}).graph;
  std::istringstream text(boxplus::format_graph(file));
  g2o::SparseOptimizer optimizer;
  ASSERT_TRUE(optimizer.load(text));
  face_chi2(optimizer);
  EXPECT_EQ(optimizer.batchStatistics().front().iterationsLinearSolver, 0);
  auto made = std::make_unique<Linear>();
  Linear& linear_solver = *made;
  optimizer.setAlgorithm(
      new g2o::OptimizationAlgorithmLevenberg(std::make_unique<g2o::BlockSolverX>(std::move(made))));
  EXPECT_EQ(optimizer.optimize(1), 1);
  EXPECT_GT(optimizer.batchStatistics().front().iterationsLinearSolver, 0);
  linear_solver.setExact(true);
  EXPECT_EQ(optimizer.optimize(1), 1);
  EXPECT_EQ(optimizer.batchStatistics().front().iterationsLinearSolver, 0);
}

TEST(NativeFace, AFileComesBackAsItWas) {
  boxplus::GraphFile file;
  file.graph = boxplus::simulate(boxplus::World::kSphere, {.poses = 100}).graph;
  const std::string text = boxplus::format_graph(file);
  std::istringstream in(text);
  g2o::SparseOptimizer optimizer;
  ASSERT_TRUE(optimizer.load(in));
  std::ostringstream out;
  ASSERT_TRUE(optimizer.save(out));
  EXPECT_EQ(out.str(), text);
}

}  // namespace
