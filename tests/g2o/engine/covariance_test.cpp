// SPDX-License-Identifier: BSD-3-Clause
// On public graphs, covariance() of the engine (boxplus without the g2o API) and computeMarginals() of the
// g2o API return the same covariances.
#include "boxplus/covariance/covariance.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"

G2O_USE_TYPE_GROUP(slam2d);
G2O_USE_TYPE_GROUP(slam3d);

namespace {

using Linear = g2o::LinearSolverEigen<g2o::BlockSolverX::PoseMatrixType>;

/// The matrix that converts a step of the engine's vertex to a step of the g2o vertex. A step moves a
/// VertexSE2 of g2o along the axes of the world, but an SE2 of the engine along the axes of the body.
Eigen::MatrixXd tangent_change(const boxplus::Graph& graph, boxplus::VertexRef vertex) {
  Eigen::MatrixXd change = Eigen::MatrixXd::Identity(graph.tangent_dim(vertex), graph.tangent_dim(vertex));
  if (change.rows() == 3) {
    change.topLeftCorner(2, 2) = graph.estimate(graph.typed<boxplus::SE2>(vertex)).rotation();
  }
  return change;
}

class EngineCovariance : public testing::TestWithParam<const char*> {};

/// The engine and g2o start at the optimum. Therefore, the single iteration of g2o linearizes at the same
/// estimates as the engine.
TEST_P(EngineCovariance, AgreesWithComputeMarginals) {
  const char* folder = std::getenv("BOXPLUS_DATA");
  const std::string path = std::string(folder ? folder : ".") + "/" + GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "SKIPPED: no " << path;
  boxplus::GraphFile file = boxplus::read_graph(path);
  boxplus::Graph& graph = file.graph;
  graph.fix(graph.all_vertices().front());
  ASSERT_TRUE(boxplus::optimize(graph).converged());

  g2o::SparseOptimizer optimizer;
  std::istringstream text(boxplus::format_graph(file));
  ASSERT_TRUE(optimizer.load(text));
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(
      std::make_unique<g2o::BlockSolverX>(std::make_unique<Linear>())));
  ASSERT_TRUE(optimizer.initializeOptimization());
  ASSERT_EQ(optimizer.optimize(1), 1);

  const std::vector<boxplus::VertexRef> all = graph.all_vertices();
  std::vector<boxplus::VertexRef> asked;
  std::vector<std::pair<int, int>> pairs;
  const auto index = [&](boxplus::VertexRef v) {
    return optimizer.vertex(static_cast<int>(graph.id(v)))->hessianIndex();
  };
  for (std::size_t k = 1; k <= 5; ++k) asked.push_back(all[k * (all.size() - 1) / 5]);
  for (const boxplus::VertexRef& a : asked) {
    for (const boxplus::VertexRef& b : asked) {
      if (index(a) <= index(b)) pairs.emplace_back(index(a), index(b));
    }
  }
  g2o::SparseBlockMatrix<g2o::MatrixX> marginals;
  ASSERT_TRUE(optimizer.computeMarginals(marginals, pairs));
  const boxplus::Covariance covariance = boxplus::covariance(graph, asked);
  ASSERT_TRUE(covariance.ok()) << covariance.message();
  const double scale = covariance.joint().cwiseAbs().maxCoeff();
  for (const boxplus::VertexRef& a : asked) {
    for (const boxplus::VertexRef& b : asked) {
      if (index(a) > index(b)) continue;
      const g2o::MatrixX& expected = *marginals.block(index(a), index(b));
      const Eigen::MatrixXd actual =
          tangent_change(graph, a) * covariance.of(a, b) * tangent_change(graph, b).transpose();
      EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), 1e-6 * scale)
          << graph.id(a) << " and " << graph.id(b);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Public, EngineCovariance,
                         testing::Values("posegraph2d/intel_1728.g2o", "posegraph2d/M3500.g2o",
                                         "posegraph3d/sphere2500.g2o", "posegraph3d/parking-garage.g2o"),
                         [](const auto& test) {
                           std::string name = std::filesystem::path(test.param).stem().string();
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

}  // namespace
