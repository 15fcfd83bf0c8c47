// SPDX-License-Identifier: BSD-3-Clause
// Estimates the direction of gravity from noisy measurements of an accelerometer at rest. The direction is a
// unit vector. It has three coordinates, but only two degrees of freedom.
#include <cmath>
#include <cstdio>
#include <istream>
#include <memory>
#include <ostream>

#include "g2o/core/base_unary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_gauss_newton.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/solvers/dense/linear_solver_dense.h"

// [vertex]
/// A unit vector. A step (a, b) rotates the vector by a and b radians about two axes that are orthogonal to
/// the vector.
class VertexDirection : public g2o::BaseVertex<2, Eigen::Vector3d> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  void setToOriginImpl() override { _estimate = Eigen::Vector3d::UnitZ(); }

  void oplusImpl(const double* update) override {
    const Eigen::Vector3d step = axes() * Eigen::Vector2d(update);
    const double angle = step.norm();
    if (angle > 0) _estimate = Eigen::AngleAxisd(angle, step / angle) * _estimate;
    _estimate.normalize();  // otherwise rounding errors add up
  }

  /// Returns two unit vectors that are orthogonal to the estimate and to each other.
  Eigen::Matrix<double, 3, 2> axes() const {
    Eigen::Matrix<double, 3, 2> result;
    result.col(0) = _estimate.unitOrthogonal();
    result.col(1) = _estimate.cross(result.col(0));
    return result;
  }

  bool read(std::istream& is) override { return is >> _estimate[0] >> _estimate[1] >> _estimate[2] && true; }
  bool write(std::ostream& os) const override { return os << _estimate.transpose() && true; }
};
// [/vertex]

// [edge]
class EdgeAcceleration : public g2o::BaseUnaryEdge<3, Eigen::Vector3d, VertexDirection> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  static constexpr double kGravity = 9.81;

  void computeError() override {
    _error = kGravity * static_cast<const VertexDirection*>(_vertices[0])->estimate() - _measurement;
  }

  /// The derivative of u ⊞ δ at δ = 0: a small rotation of u about an axis a moves u in the direction a × u.
  void linearizeOplus() override {
    const auto* v = static_cast<const VertexDirection*>(_vertices[0]);
    const Eigen::Matrix<double, 3, 2> axes = v->axes();
    for (int i = 0; i < 2; ++i) _jacobianOplusXi.col(i) = kGravity * axes.col(i).cross(v->estimate());
  }

  bool read(std::istream& is) override {
    return is >> _measurement[0] >> _measurement[1] >> _measurement[2] && readInformationMatrix(is);
  }
  bool write(std::ostream& os) const override {
    os << _measurement.transpose() << " ";
    return writeInformationMatrix(os);
  }
};
// [/edge]

// [check]
/// Returns the largest difference between the Jacobian that an edge computes and the numeric Jacobian that
/// its base class computes.
template <class OwnEdge>
double jacobian_error(OwnEdge& edge) {
  g2o::JacobianWorkspace workspace;
  workspace.updateSize(&edge);
  workspace.allocate();
  auto& base = static_cast<g2o::OptimizableGraph::Edge&>(edge);
  edge.computeError();
  base.linearizeOplus(workspace);  // maps the Jacobians to the workspace and computes them
  const Eigen::MatrixXd own = edge.template jacobianOplusXn<0>();
  edge.OwnEdge::BaseFixedSizedEdge::linearizeOplus();
  return (edge.template jacobianOplusXn<0>() - own).cwiseAbs().maxCoeff();
}
// [/check]

int main() {
  using Blocks = g2o::BlockSolverX;
  g2o::SparseOptimizer optimizer;
  optimizer.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(
      std::make_unique<Blocks>(std::make_unique<g2o::LinearSolverDense<Blocks::PoseMatrixType>>())));
  auto* up = new VertexDirection;
  up->setId(0);
  up->setToOrigin();
  optimizer.addVertex(up);
  const Eigen::Vector3d measured[] = {
      {5.62, 0.11, 8.02}, {5.75, -0.06, 7.99}, {5.58, 0.02, 8.10}, {5.66, 0.05, 7.95}};
  EdgeAcceleration* edge = nullptr;
  for (const Eigen::Vector3d& z : measured) {
    edge = new EdgeAcceleration;
    edge->setVertex(0, up);
    edge->setMeasurement(z);
    edge->setInformation(Eigen::Matrix3d::Identity() * 100);
    optimizer.addEdge(edge);
  }
  optimizer.initializeOptimization();
  const int iterations = optimizer.optimize(5);
  const Eigen::Vector3d& u = up->estimate();
  const double difference = jacobian_error(*edge);
  std::printf("up is (%.4f, %.4f, %.4f), with length %.12f and dimension %d\n", u[0], u[1], u[2], u.norm(),
              up->dimension());
  std::printf("Jacobian agrees with numeric differences: %s\n", difference < 1e-7 ? "yes" : "no");
  return iterations > 0 && difference < 1e-7 && std::abs(u.norm() - 1) < 1e-12 ? 0 : 1;
}
