// SPDX-License-Identifier: BSD-3-Clause
// Clients with their own LinearSolver or their own Solver.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

#include "g2o/core/optimization_algorithm_factory.h"
#include "g2o/core/small_graph.h"
#include "g2o/core/sparse_optimizer_terminate_action.h"
#include "g2o/solvers/dense/linear_solver_dense.h"

G2O_USE_OPTIMIZATION_LIBRARY(eigen)
G2O_USE_OPTIMIZATION_LIBRARY(dense)
G2O_USE_OPTIMIZATION_LIBRARY(pcg)

namespace {

using small_graph::add_square;

/// A linear solver that copies the sparse block matrix to a dense matrix and factorizes it with Eigen.
template <typename MatrixType>
class CustomLinearSolver : public g2o::LinearSolver<MatrixType> {
 public:
  bool init() override { return true; }
  bool solve(const g2o::SparseBlockMatrix<MatrixType>& A, double* x, double* b) override {
    ++calls;
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(A.rows(), A.cols());
    for (size_t c = 0; c < A.blockCols().size(); ++c) {
      for (const auto& [r, block] : A.blockCols()[c])
        dense.block(A.rowBaseOfBlock(r), A.colBaseOfBlock(static_cast<int>(c)), block->rows(),
                    block->cols()) = *block;
    }
    dense.triangularView<Eigen::StrictlyLower>() = dense.transpose().triangularView<Eigen::StrictlyLower>();
    const Eigen::LLT<Eigen::MatrixXd> factor(dense);
    if (factor.info() != Eigen::Success) return false;
    Eigen::Map<Eigen::VectorXd>(x, A.cols()) = factor.solve(Eigen::Map<Eigen::VectorXd>(b, A.cols()));
    return true;
  }
  int calls = 0;
};

/// A solver that builds and solves the system itself. The edges write their quadratic forms to memory that
/// this solver owns.
class CustomSolver : public g2o::Solver {
 public:
  bool init(g2o::SparseOptimizer* optimizer, bool = false) override {
    setOptimizer(optimizer);
    return true;
  }
  bool buildStructure(bool = false) override {
    const auto& vertices = optimizer()->indexMapping();
    diagonal_.assign(vertices.size(), Eigen::Matrix3d::Zero());
    for (auto* v : optimizer()->activeVertices()) v->mapHessianMemory(nullptr);
    for (size_t i = 0; i < vertices.size(); ++i) {
      vertices[i]->mapHessianMemory(diagonal_[i].data());
      vertices[i]->setColInHessian(static_cast<int>(3 * i));
    }
    resizeVector(3 * vertices.size());
    H_.resize(static_cast<Eigen::Index>(vectorSize()), static_cast<Eigen::Index>(vectorSize()));
    return true;
  }
  bool updateStructure(const std::vector<g2o::HyperGraph::Vertex*>&,
                       const g2o::HyperGraph::EdgeSet&) override {
    return buildStructure();
  }
  bool buildSystem() override {
    H_.setZero();
    for (Eigen::Matrix3d& block : diagonal_) block.setZero();
    for (auto* v : optimizer()->indexMapping()) v->clearQuadraticForm();
    for (auto* e : optimizer()->activeEdges()) add(*e);
    for (auto* v : optimizer()->indexMapping()) {
      H_.block<3, 3>(v->colInHessian(), v->colInHessian()) = Eigen::Map<Eigen::Matrix3d>(v->hessianData());
      v->copyB(_b + v->colInHessian());
    }
    return true;
  }
  bool solve() override {
    const auto n = H_.rows();
    Eigen::Map<Eigen::VectorXd>(_x, n) =
        (H_ + lambda_ * Eigen::MatrixXd::Identity(n, n)).ldlt().solve(Eigen::Map<Eigen::VectorXd>(_b, n));
    return true;
  }
  bool computeMarginals(g2o::SparseBlockMatrix<g2o::MatrixX>&,
                        const std::vector<std::pair<int, int>>&) override {
    return false;
  }
  bool setLambda(double lambda, bool = false) override {
    lambda_ = lambda;
    return true;
  }
  void restoreDiagonal() override { lambda_ = 0; }
  bool schur() override { return false; }
  void setSchur(bool) override {}
  void setWriteDebug(bool) override {}
  bool writeDebug() const override { return false; }
  bool saveHessian(const std::string&) const override { return false; }

 private:
  /// Adds the off-diagonal block of an edge between two poses. The edge writes the block to memory that
  /// exists only during this call.
  void add(g2o::OptimizableGraph::Edge& e) {
    const auto* a = static_cast<g2o::OptimizableGraph::Vertex*>(e.vertex(0));
    const auto* b = static_cast<g2o::OptimizableGraph::Vertex*>(e.vertex(1));
    Eigen::Matrix3d pair = Eigen::Matrix3d::Zero();
    e.mapHessianMemory(pair.data(), 0, 1, false);
    e.linearizeOplus(optimizer()->jacobianWorkspace());
    e.constructQuadraticForm();
    e.mapHessianMemory(nullptr, 0, 1, false);
    if (a->hessianIndex() < 0 || b->hessianIndex() < 0) return;
    H_.block<3, 3>(a->colInHessian(), b->colInHessian()) += pair;
    H_.block<3, 3>(b->colInHessian(), a->colInHessian()) += pair.transpose();
  }

  std::vector<Eigen::Matrix3d> diagonal_;
  Eigen::MatrixXd H_;
  double lambda_ = 0;
};

double optimum(g2o::OptimizationAlgorithm* algorithm, bool with_landmark = false) {
  g2o::SparseOptimizer optimizer;
  add_square(optimizer);
  if (with_landmark) {
    auto* l = new g2o::VertexPointXY;
    l->setId(9);
    l->setEstimate(Eigen::Vector2d(0.5, 0.4));
    l->setMarginalized(true);
    optimizer.addVertex(l);
    for (int i = 0; i < 4; ++i) {
      auto* e = new g2o::EdgeSE2PointXY;
      e->setVertex(0, optimizer.vertex(i));
      e->setVertex(1, l);
      e->setMeasurement(Eigen::Vector2d(0.5, 0.5 + 0.01 * i));
      EXPECT_TRUE(optimizer.addEdge(e));
    }
  }
  optimizer.setAlgorithm(algorithm);
  EXPECT_TRUE(optimizer.initializeOptimization());
  EXPECT_GT(optimizer.optimize(20), 0);
  optimizer.computeActiveErrors();
  return optimizer.activeChi2();
}

TEST(CustomSolvers, ACustomLinearSolverReceivesTheHessian) {
  using Matrix = g2o::BlockSolverX::PoseMatrixType;
  const double expected = optimum(new g2o::OptimizationAlgorithmGaussNewton(small_graph::make_solver()));
  auto linear = std::make_unique<CustomLinearSolver<Matrix>>();
  EXPECT_NEAR(optimum(new g2o::OptimizationAlgorithmGaussNewton(
                  std::make_unique<g2o::BlockSolverX>(std::move(linear)))),
              expected, 1e-9 * expected);
  EXPECT_NEAR(optimum(new g2o::OptimizationAlgorithmLevenberg(
                  new g2o::BlockSolverX(new CustomLinearSolver<Matrix>()))),
              expected, 1e-9 * expected);
}

TEST(CustomSolvers, ACustomLinearSolverForFixedBlockSizesReceivesTheSchurComplement) {
  using Blocks = g2o::BlockSolver_3_2;
  const double expected =
      optimum(new g2o::OptimizationAlgorithmGaussNewton(small_graph::make_solver()), true);
  auto* linear = new CustomLinearSolver<Blocks::PoseMatrixType>();
  auto* algorithm = new g2o::OptimizationAlgorithmGaussNewton(new Blocks(linear));
  EXPECT_NEAR(optimum(algorithm, true), expected, 1e-9 * expected);
}

/// A block solver that copies the blocks of H and of its Schur complement from its base class.
class CustomBlockSolver : public g2o::BlockSolver_3_2 {
 public:
  using g2o::BlockSolver_3_2::BlockSolver_3_2;
  bool solve() override {
    poses = Eigen::MatrixXd::Zero(_sizePoses, _sizePoses);
    for (int c = 0; c < _numPoses; ++c) {
      for (const auto& [r, block] : _Hpp->blockCols()[static_cast<size_t>(c)])
        poses.block<3, 3>(3 * r, 3 * c) = *block;
    }
    landmark = *_Hll->block(0, 0);
    between = *_Hpl->block(0, 0);
    const bool solved = g2o::BlockSolver_3_2::solve();
    schur = Eigen::MatrixXd::Zero(_sizePoses, _sizePoses);
    for (int c = 0; c < _numPoses; ++c) {
      for (const auto& [r, block] : _Hschur->blockCols()[static_cast<size_t>(c)])
        schur.block<3, 3>(3 * r, 3 * c) = *block;
    }
    return solved;
  }
  Eigen::MatrixXd poses, schur;
  Eigen::Matrix2d landmark;
  Eigen::Matrix<double, 3, 2> between;
};

TEST(CustomSolvers, ADerivedBlockSolverReadsTheBlocksOfTheHessian) {
  g2o::SparseOptimizer optimizer;
  add_square(optimizer);
  auto* l = new g2o::VertexPointXY;
  l->setId(10);
  l->setMarginalized(true);
  l->setEstimate(Eigen::Vector2d(0.5, 0.5));
  ASSERT_TRUE(optimizer.addVertex(l));
  auto* e = new g2o::EdgeSE2PointXY;
  e->setVertex(0, optimizer.vertex(1));
  e->setVertex(1, l);
  e->setMeasurement(Eigen::Vector2d(0.4, 0.6));
  ASSERT_TRUE(optimizer.addEdge(e));
  auto* blocks =
      new CustomBlockSolver(std::make_unique<g2o::LinearSolverDense<g2o::BlockSolver_3_2::PoseMatrixType>>());
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(blocks));
  ASSERT_TRUE(optimizer.initializeOptimization());
  e->linearizeOplus(optimizer.jacobianWorkspace());
  const Eigen::Matrix<double, 3, 2> between = e->jacobianOplusXi().transpose() * e->jacobianOplusXj();
  ASSERT_EQ(optimizer.optimize(1), 1);
  ASSERT_EQ(blocks->poses.rows(), 9);
  for (int i = 0; i < 3; ++i) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c)
        EXPECT_EQ(blocks->poses(3 * i + r, 3 * i + c), optimizer.vertex(i + 1)->hessian(r, c));
    }
  }
  EXPECT_NE(blocks->poses(0, 3), 0);  // poses 1 and 2 share an edge
  EXPECT_EQ(blocks->landmark(0, 1), l->hessian(0, 1));
  EXPECT_LT((blocks->between - between).norm(), 1e-12);
  Eigen::MatrixXd schur = blocks->poses;  // only pose 1, the first in H, observes the landmark
  schur.topLeftCorner<3, 3>() -= blocks->between * blocks->landmark.inverse() * blocks->between.transpose();
  EXPECT_LT((Eigen::MatrixXd(schur.triangularView<Eigen::Upper>()) -
             Eigen::MatrixXd(blocks->schur.triangularView<Eigen::Upper>()))
                .norm(),
            1e-9 * schur.norm());
}

TEST(CustomSolvers, ACustomSolverWorksWithGaussNewtonAndLevenbergMarquardt) {
  const double expected = optimum(new g2o::OptimizationAlgorithmGaussNewton(small_graph::make_solver()));
  EXPECT_NEAR(optimum(new g2o::OptimizationAlgorithmGaussNewton(new CustomSolver)), expected,
              1e-9 * expected);
  EXPECT_NEAR(optimum(new g2o::OptimizationAlgorithmLevenberg(std::make_unique<CustomSolver>())), expected,
              1e-9 * expected);
}

TEST(CustomSolvers, AllAlgorithmsOfTheLibraryAreConstructedByTheirNames) {
  const double expected =
      optimum(new g2o::OptimizationAlgorithmGaussNewton(small_graph::make_solver()), true);
  g2o::OptimizationAlgorithmFactory* factory = g2o::OptimizationAlgorithmFactory::instance();
  for (const char* name : {"gn_var", "gn_fix3_2", "lm_var", "lm_fix3_2", "dl_var", "gn_dense", "gn_dense3_2",
                           "lm_dense", "lm_dense3_2", "gn_pcg", "gn_pcg3_2", "lm_pcg", "lm_pcg3_2"}) {
    SCOPED_TRACE(name);
    g2o::OptimizationAlgorithmProperty property;
    g2o::OptimizationAlgorithm* algorithm = factory->construct(name, property);
    ASSERT_NE(algorithm, nullptr);
    EXPECT_EQ(property.name, name);
    EXPECT_EQ(property.requiresMarginalize, std::string(name).find("3_2") != std::string::npos);
    EXPECT_NEAR(optimum(algorithm, true), expected, 1e-6 * expected);
  }
  const g2o::OptimizationAlgorithmFactory::CreatorList& all = factory->creatorList();
  const auto is_of_library = [](const auto& creator) { return creator->property().type != "Custom"; };
  EXPECT_EQ(std::count_if(all.begin(), all.end(), is_of_library), 25);
  g2o::OptimizationAlgorithmProperty property;
  EXPECT_EQ(factory->construct("no_such_solver", property), nullptr);
}

TEST(CustomSolvers, PropertiesOfAnAlgorithmAreSetFromText) {
  g2o::OptimizationAlgorithmLevenberg algorithm(small_graph::make_solver());
  EXPECT_TRUE(algorithm.updatePropertiesFromString("initialLambda=0.25, maxTrialsAfterFailure=3"));
  EXPECT_EQ(algorithm.userLambdaInit(), 0.25);
  EXPECT_EQ(algorithm.maxTrialsAfterFailure(), 3);
  EXPECT_FALSE(algorithm.updatePropertiesFromString("noSuchProperty=1"));
}

TEST(CustomSolvers, TheTerminateActionStopsARunWhenChi2HardlyDecreases) {
  g2o::SparseOptimizer optimizer;
  add_square(optimizer);
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(small_graph::make_solver()));
  g2o::SparseOptimizerTerminateAction terminate;
  terminate.setGainThreshold(1e-3);
  optimizer.addPostIterationAction(&terminate);
  optimizer.initializeOptimization();
  const int iterations = optimizer.optimize(100);
  EXPECT_GT(iterations, 1);
  EXPECT_LT(iterations, 10);
}

TEST(CustomSolvers, LinearSolversWorkWithoutABlockSolver) {
  const int ends[] = {2, 4};
  g2o::SparseBlockMatrixX A(ends, ends, 2, 2);
  *A.block(0, 0, true) = Eigen::Matrix2d::Identity() * 4;
  *A.block(1, 1, true) = Eigen::Matrix2d::Identity() * 3;
  *A.block(0, 1, true) << 1, 2, 0, 1;
  Eigen::Matrix4d dense;
  dense << 4, 0, 1, 2, 0, 4, 0, 1, 1, 0, 3, 0, 2, 1, 0, 3;
  Eigen::Vector4d b(1, 2, 3, 4), x;
  g2o::LinearSolverEigen<g2o::MatrixX> sparse;
  g2o::LinearSolverDense<g2o::MatrixX> dense_solver;
  for (g2o::LinearSolver<g2o::MatrixX>* solver :
       {static_cast<g2o::LinearSolver<g2o::MatrixX>*>(&sparse),
        static_cast<g2o::LinearSolver<g2o::MatrixX>*>(&dense_solver)}) {
    ASSERT_TRUE(solver->init());
    ASSERT_TRUE(solver->solve(A, x.data(), b.data()));
    EXPECT_LT((dense * x - b).norm(), 1e-12);
  }
  g2o::SparseBlockMatrixX inverse;
  ASSERT_TRUE(sparse.solvePattern(inverse, {{0, 0}, {0, 1}, {1, 0}}, A));
  const Eigen::Matrix4d expected = dense.inverse();
  EXPECT_LT((*inverse.block(0, 1) - expected.block(0, 2, 2, 2)).norm(), 1e-12);
  EXPECT_LT((*inverse.block(1, 0) - expected.block(2, 0, 2, 2)).norm(), 1e-12);
  double** blocks = nullptr;
  ASSERT_TRUE(sparse.solveBlocks(blocks, A));
  EXPECT_NEAR(blocks[1][0], expected(2, 2), 1e-12);
  g2o::LinearSolver<g2o::MatrixX>::deallocateBlocks(A, blocks);
}

}  // namespace
