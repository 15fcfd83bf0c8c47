// SPDX-License-Identifier: BSD-3-Clause
// Client edges that weight their terms of H and b themselves, or that are between vertices of other classes
// than they declare.
#include "g2o/core/base_fixed_sized_edge.h"

#include <gtest/gtest.h>

#include <memory>
#include <tuple>
#include <utility>

#include "g2o/core/base_unary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/edge_checks.h"
#include "g2o/solvers/eigen/linear_solver_eigen.h"

namespace {

template <int D>
class Numbers : public g2o::BaseVertex<D, g2o::VectorN<D>> {
 public:
  void setToOriginImpl() override { this->_estimate.setZero(); }
  void oplusImpl(const double* step) override { this->_estimate += Eigen::Map<const g2o::VectorN<D>>(step); }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

/// An edge whose information matrix is scaled by a weight when the edge adds its terms to H and b.
class WeightedEdge : public g2o::BaseFixedSizedEdge<2, g2o::Vector2, Numbers<2>, Numbers<1>, Numbers<3>> {
 public:
  void computeError() override {
    const g2o::Vector2& x = vertexXn<0>()->estimate();
    const double scale = vertexXn<1>()->estimate()[0];
    const g2o::Vector3& y = vertexXn<2>()->estimate();
    _error = scale * x + g2o::Vector2(y[0] * y[1], y[2]) - _measurement;
  }
  void constructQuadraticForm() override {
    constructQuadraticFormNs(weight * _information, weight * (_information * -_error),
                             std::make_index_sequence<_nr_of_vertices>());
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }

  double weight = 1;
};

class ClientWeights : public testing::Test {
 protected:
  void SetUp() override {
    a.setEstimate({1, -2});
    b.setEstimate(g2o::VectorN<1>(1.5));
    c.setEstimate({0.3, -0.7, 2});
    edge.setVertex(0, &a);
    edge.setVertex(1, &b);
    edge.setVertex(2, &c);
    edge.setMeasurement({0.1, 0.2});
    g2o::Matrix2 omega;
    omega << 3, 1, 1, 2;
    edge.setInformation(omega);
  }
  Numbers<2> a;
  Numbers<1> b;
  Numbers<3> c;
  WeightedEdge edge;
};

TEST_F(ClientWeights, TheTermsOfAllVerticesCanBeAddedByOneCall) {
  for (const bool transposed : {false, true}) {
    for (size_t fixed = 0; fixed <= 3; ++fixed) edge_checks::expect_quadratic_form(edge, transposed, fixed);
  }
}

TEST_F(ClientWeights, ScaleTheTerms) {
  g2o::MatrixX H[2], Hs(2, 2);
  g2o::VectorX rhs[2];
  for (const int i : {0, 1}) {
    edge.weight = i == 0 ? 1 : 0.25;
    g2o::JacobianWorkspace workspace;
    workspace.updateSize(&edge);
    ASSERT_TRUE(workspace.allocate());
    Hs.setZero();
    a.mapHessianMemory(Hs.data());
    a.clearQuadraticForm();
    edge.computeError();
    edge.linearizeOplus(workspace);
    edge.constructQuadraticForm();
    H[i] = Hs;
    rhs[i] = Eigen::Map<const g2o::VectorX>(a.bData(), 2);
  }
  EXPECT_GT(H[0].norm(), 1);
  EXPECT_LT((H[1] - 0.25 * H[0]).norm(), 1e-12);
  EXPECT_LT((rhs[1] - 0.25 * rhs[0]).norm(), 1e-12);
}

/// Another class with the base of Numbers<3>.
class Place : public g2o::BaseVertex<3, g2o::Vector3> {
 public:
  void setToOriginImpl() override { _estimate.setZero(); }
  void oplusImpl(const double* step) override { _estimate += Eigen::Map<const g2o::Vector3>(step); }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

/// A class with as many dimensions as Numbers<3> and another type of estimate.
class Column : public g2o::BaseVertex<3, g2o::VectorX> {
 public:
  void setToOriginImpl() override { _estimate.setZero(3); }
  void oplusImpl(const double* step) override { _estimate += Eigen::Map<const g2o::Vector3>(step); }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

class NumbersPrior : public g2o::BaseUnaryEdge<3, g2o::Vector3, Numbers<3>> {
 public:
  void computeError() override { _error = usedVertexXn<0>()->estimate() - _measurement; }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

/// An optimizer that owns vertex 0.
template <class VertexType>
struct OneVertex {
  OneVertex() {
    vertex->setId(0);
    vertex->setToOrigin();
    optimizer.addVertex(vertex);
  }
  g2o::SparseOptimizer optimizer;
  VertexType* vertex = new VertexType;
};

TEST(OtherVertexClass, WithTheBaseOfTheDeclaredOneIsOptimized) {
  OneVertex<Place> graph;
  using Linear = g2o::LinearSolverEigen<g2o::BlockSolverX::PoseMatrixType>;
  graph.optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(
      std::make_unique<g2o::BlockSolverX>(std::make_unique<Linear>())));
  auto* prior = new NumbersPrior;
  prior->setVertex(0, graph.vertex);
  prior->setMeasurement({1, 2, 3});
  prior->setInformation(g2o::Matrix3::Identity());
  ASSERT_TRUE(graph.optimizer.addEdge(prior));
  ASSERT_TRUE(graph.optimizer.initializeOptimization());
  EXPECT_EQ(graph.optimizer.optimize(5), 5);
  EXPECT_LT((graph.vertex->estimate() - g2o::Vector3(1, 2, 3)).norm(), 1e-9);
}

template <class VertexType>
bool accepts_numbers_prior() {
  OneVertex<VertexType> graph;
  auto prior = std::make_unique<NumbersPrior>();
  prior->setVertex(0, graph.vertex);
  if (!graph.optimizer.addEdge(prior.get())) return false;
  std::ignore = prior.release();  // the optimizer owns it
  return true;
}

TEST(OtherVertexClass, WithAnotherDimensionOrEstimateIsRefused) {
  EXPECT_TRUE(accepts_numbers_prior<Numbers<3>>());
  EXPECT_FALSE(accepts_numbers_prior<Numbers<2>>());
  EXPECT_FALSE(accepts_numbers_prior<Column>());
}

}  // namespace
