// SPDX-License-Identifier: BSD-3-Clause
// A client that constrains its estimates by equations. The Lagrange multiplier of each equation is a vertex,
// and so the Hessian is indefinite.
#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "g2o/core/base_binary_edge.h"
#include "g2o/core/base_unary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_dogleg.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/optimization_algorithm_levenberg.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/cholmod/linear_solver_cholmod.h"
#include "g2o/solvers/dense/linear_solver_dense.h"
#include "g2o/solvers/pcg/linear_solver_pcg.h"
#include "g2o/stuff/logger.h"

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Matrix = g2o::BlockSolverX::PoseMatrixType;

template <int D>
class VectorVertex : public g2o::BaseVertex<D, Eigen::Matrix<double, D, 1>> {
 public:
  void setToOriginImpl() override { this->_estimate.setZero(); }
  void oplusImpl(const double* step) override {
    this->_estimate += Eigen::Map<const Eigen::Matrix<double, D, 1>>(step);
  }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream& os) const override { return os.good(); }
};
using PointVertex = VectorVertex<2>;
using MultiplierVertex = VectorVertex<1>;

class PriorEdge : public g2o::BaseUnaryEdge<2, Eigen::Vector2d, PointVertex> {
 public:
  void computeError() override { _error = vertexXn<0>()->estimate() - _measurement; }
  void linearizeOplus() override { _jacobianOplusXi.setIdentity(); }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream& os) const override { return os.good(); }
};

/// The equation aᵀp = c, whose measurement is (a, c). With the error (aᵀp − c, λ) and this information,
/// the gradient is that of the Lagrangian λ (aᵀp − c).
class EquationEdge : public g2o::BaseBinaryEdge<2, Eigen::Vector3d, PointVertex, MultiplierVertex> {
 public:
  EquationEdge() { _information << 0, 1, 1, 0; }
  void computeError() override {
    _error[0] = _measurement.head<2>().dot(vertexXn<0>()->estimate()) - _measurement[2];
    _error[1] = vertexXn<1>()->estimate()[0];
  }
  void linearizeOplus() override {
    _jacobianOplusXi << _measurement.head<2>().transpose(), 0, 0;
    _jacobianOplusXj << 0, 1;
  }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream& os) const override { return os.good(); }
};

/// The point of the line 2x − y = 5 that is nearest to (10, 10). It is (8, 11), and its multiplier is 1.
class EqualityConstraint : public testing::Test {
 protected:
  EqualityConstraint() {
    point_->setId(0);
    point_->setEstimate(Eigen::Vector2d(10, 10));
    optimizer_.addVertex(point_);
    multiplier_->setId(1);
    multiplier_->setToOrigin();
    optimizer_.addVertex(multiplier_);
    auto* prior = new PriorEdge;
    prior->setVertex(0, point_);
    prior->setMeasurement(Eigen::Vector2d(10, 10));
    prior->setInformation(Eigen::Matrix2d::Identity());
    optimizer_.addEdge(prior);
    add_equation(1, Eigen::Vector3d(2, -1, 5));
    g2o::logging::setSink([this](g2o::logging::Level level, const std::string& text) {
      if (level == g2o::logging::Level::kError) errors_.push_back(text);
    });
  }
  ~EqualityConstraint() override { g2o::logging::setSink({}); }

  void add_equation(int multiplier, const Eigen::Vector3d& equation) {
    auto* e = new EquationEdge;
    e->setVertex(0, point_);
    e->setVertex(1, optimizer_.vertex(multiplier));
    e->setMeasurement(equation);
    optimizer_.addEdge(e);
  }
  template <class Algorithm, template <class> class LinearSolver>
  int optimize(int iterations) {
    auto linear = std::make_unique<LinearSolver<Matrix>>();
    optimizer_.setAlgorithm(new Algorithm(std::make_unique<g2o::BlockSolverX>(std::move(linear))));
    EXPECT_TRUE(optimizer_.initializeOptimization());
    return optimizer_.optimize(iterations);
  }
  void expect_optimum() const {
    EXPECT_LT((point_->estimate() - Eigen::Vector2d(8, 11)).norm(), 1e-12);
    EXPECT_NEAR(multiplier_->estimate()[0], 1, 1e-12);
    EXPECT_THAT(errors_, IsEmpty());
  }

  g2o::SparseOptimizer optimizer_;
  PointVertex* point_ = new PointVertex;
  MultiplierVertex* multiplier_ = new MultiplierVertex;
  std::vector<std::string> errors_;
};

using GaussNewton = g2o::OptimizationAlgorithmGaussNewton;

TEST_F(EqualityConstraint, IsMetByGaussNewtonWithLinearSolverCholmod) {
  EXPECT_EQ((optimize<GaussNewton, g2o::LinearSolverCholmod>(3)), 3);
  expect_optimum();
}

TEST_F(EqualityConstraint, IsMetIfThePointIsMarginalized) {
  point_->setMarginalized(true);
  EXPECT_EQ((optimize<GaussNewton, g2o::LinearSolverCholmod>(3)), 3);
  expect_optimum();
}

TEST_F(EqualityConstraint, LeavesNoVarianceAcrossItsLine) {
  EXPECT_EQ((optimize<GaussNewton, g2o::LinearSolverCholmod>(1)), 1);
  g2o::SparseBlockMatrixX covariance;
  ASSERT_TRUE(optimizer_.computeMarginals(covariance, point_));
  const Eigen::Vector2d along = Eigen::Vector2d(1, 2).normalized();
  const int i = point_->hessianIndex();
  EXPECT_LT((*covariance.block(i, i) - along * along.transpose()).norm(), 1e-12);
}

TEST_F(EqualityConstraint, IsRefusedByOtherLinearSolversWithAnError) {
  const auto error = AllOf(HasSubstr("not positive definite"), HasSubstr("LinearSolverCholmod"));
  EXPECT_EQ((optimize<GaussNewton, g2o::LinearSolverEigen>(3)), 0);
  EXPECT_THAT(errors_, ElementsAre(error));
  EXPECT_EQ((optimize<GaussNewton, g2o::LinearSolverDense>(3)), 0);
  EXPECT_THAT(errors_, ElementsAre(error, error));
  EXPECT_EQ((optimize<GaussNewton, g2o::LinearSolverPCG>(3)), 0);
  EXPECT_THAT(errors_, ElementsAre(error, error, error));
  EXPECT_EQ(point_->estimate(), Eigen::Vector2d(10, 10));
}

TEST_F(EqualityConstraint, IsMetByLevenbergMarquardtAndDoglegWithLinearSolverCholmod) {
  optimize<g2o::OptimizationAlgorithmDogleg, g2o::LinearSolverCholmod>(10);
  expect_optimum();
  point_->setEstimate(Eigen::Vector2d(10, 10));
  multiplier_->setToOrigin();
  optimize<g2o::OptimizationAlgorithmLevenberg, g2o::LinearSolverCholmod>(10);
  EXPECT_LT((point_->estimate() - Eigen::Vector2d(8, 11)).norm(), 1e-6);
  EXPECT_THAT(errors_, IsEmpty());
}

TEST_F(EqualityConstraint, IsReportedOnceByAlgorithmsThatAddDampingWithOtherLinearSolvers) {
  optimize<g2o::OptimizationAlgorithmLevenberg, g2o::LinearSolverEigen>(10);
  EXPECT_THAT(errors_, ElementsAre(HasSubstr("only LinearSolverCholmod")));
  errors_.clear();
  optimize<g2o::OptimizationAlgorithmDogleg, g2o::LinearSolverEigen>(10);
  EXPECT_THAT(errors_, ElementsAre(HasSubstr("only LinearSolverCholmod")));
}

/// (x − 1)² under the equation x = 2. Its vertex is x and the multiplier, its chi2 is only (x − 1)², and it
/// adds the derivatives of the Lagrangian to H and b itself.
class LagrangianEdge : public g2o::BaseUnaryEdge<1, double, PointVertex> {
 public:
  void computeError() override { _error[0] = x()[0] - 1; }
  void linearizeOplus() override { _jacobianOplusXi << 1, 0; }
  void constructQuadraticForm() override {
    auto* v = static_cast<PointVertex*>(_vertices[0]);
    Eigen::Matrix2d H;
    H << 1, 1, 1, 0;
    v->A() += H;
    v->b() -= Eigen::Vector2d(x()[0] - 1 + x()[1], x()[0] - 2);
  }
  bool read(std::istream&) override { return true; }
  bool write(std::ostream& os) const override { return os.good(); }

 private:
  Eigen::Vector2d x() const { return static_cast<const PointVertex*>(_vertices[0])->estimate(); }
};

template <class Algorithm>
double solution_of_lagrangian() {
  g2o::SparseOptimizer optimizer;
  auto linear = std::make_unique<g2o::LinearSolverCholmod<Matrix>>();
  optimizer.setAlgorithm(new Algorithm(std::make_unique<g2o::BlockSolverX>(std::move(linear))));
  auto* v = new PointVertex;
  v->setId(0);
  v->setEstimate(Eigen::Vector2d(10, 0));
  optimizer.addVertex(v);
  auto* e = new LagrangianEdge;
  e->setVertex(0, v);
  e->setInformation(Eigen::Matrix<double, 1, 1>::Identity());
  optimizer.addEdge(e);
  EXPECT_TRUE(optimizer.initializeOptimization());
  optimizer.optimize(50);
  return v->estimate()[0];
}

TEST(Lagrangian, OfAnEdgeThatAddsToHItselfIsSolvedByEveryAlgorithm) {
  EXPECT_NEAR(solution_of_lagrangian<GaussNewton>(), 2, 1e-9);
  EXPECT_NEAR(solution_of_lagrangian<g2o::OptimizationAlgorithmDogleg>(), 2, 1e-9);
  EXPECT_NEAR(solution_of_lagrangian<g2o::OptimizationAlgorithmLevenberg>(), 2, 1e-6);
}

TEST_F(EqualityConstraint, ThatIsGivenTwiceIsSingular) {
  auto* second = new MultiplierVertex;
  second->setId(2);
  second->setToOrigin();
  optimizer_.addVertex(second);
  add_equation(2, Eigen::Vector3d(4, -2, 10));
  EXPECT_EQ((optimize<GaussNewton, g2o::LinearSolverCholmod>(3)), 0);
  EXPECT_THAT(errors_, ElementsAre(HasSubstr("and it is singular")));
  EXPECT_EQ(point_->estimate(), Eigen::Vector2d(10, 10));
}

}  // namespace
