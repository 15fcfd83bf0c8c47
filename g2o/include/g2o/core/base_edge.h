// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_BASE_EDGE_H
#define G2O_BASE_EDGE_H

#if __cplusplus < 201703L
#pragma GCC system_header  // Otherwise, compilers warn about C++17 in this header.
#endif

#include <algorithm>
#include <istream>
#include <ostream>

#include "g2o/core/io_helper.h"
#include "g2o/core/optimizable_graph.h"
#include "g2o/core/robust_kernel.h"

namespace g2o {
namespace internal {

/// The number of rows of an edge's error, or Eigen::Dynamic.
template <int D>
struct BaseEdgeTraits {
  static constexpr int Dimension = D;
};

/// Computes the Jacobian ∂e(v ⊞ δ)/∂δ at δ = 0, stored by columns, by central differences (g2o document, eq.
/// 34).
G2O_CORE_API void numericJacobian(OptimizableGraph::Edge& edge, OptimizableGraph::Vertex& vertex,
                                  double* jacobian);

/// Enlarges the Jacobian workspace of the edge's graph if it is too small for the edge.
G2O_CORE_API void roomForJacobians(OptimizableGraph::Edge& edge);

/// The largest number of columns of J that normalProducts() supports.
constexpr int kMostProductColumns = 16;
constexpr bool hasNormalProducts(int rows, int cols) {
  return (rows == 2 || rows == 3 || rows == 6) && cols <= kMostProductColumns;
}

/// Copies the upper triangle of Ω row by row. Returns false if Ω is not symmetric up to rounding, because it
/// is then unclear which of the two triangles is correct.
template <int D, class Omega>
bool upperTriangle(const Omega& omega, double* triangle) {
  const double rounding = 1e-12 * std::abs(omega.trace());
  for (int r = 0; r < D; ++r) {
    for (int s = r; s < D; ++s) {
      if (!(std::abs(omega(r, s) - omega(s, r)) <= rounding)) return false;
      *triangle++ = 0.5 * (omega(r, s) + omega(s, r));
    }
  }
  return true;
}

/// Computes products = JᵀΩJ and gradient = JᵀΩe from the columns of J and the rows of the upper triangle of
/// Ω. Uses the fastest available instruction set. Returns the column stride (leading dimension) of
/// `products`. `products` must have kMostProductColumns² elements.
G2O_CORE_API int normalProducts(int rows, int cols, const double* const* jacobian, const double* omega,
                                const double* error, double* products, double* gradient);

}  // namespace internal

/// An edge with a measurement of type E and an error with D rows. If D is Eigen::Dynamic, the number of rows
/// is chosen at run time.
template <int D, typename E>
class BaseEdge : public OptimizableGraph::Edge {
 public:
  static constexpr int Dimension = internal::BaseEdgeTraits<D>::Dimension;
  using Measurement = E;
  using ErrorVector = Eigen::Matrix<double, D, 1, Eigen::ColMajor>;
  using InformationType = Eigen::Matrix<double, D, D, Eigen::ColMajor>;

  BaseEdge() {
    _dimension = D;
    if constexpr (D > 0) {
      _error.setZero();
      _information.setIdentity();
    }
  }
  BaseEdge(const BaseEdge&) = delete;
  BaseEdge& operator=(const BaseEdge&) = delete;

  double chi2() const override { return _error.dot(information() * _error); }
  const double* errorData() const override { return _error.data(); }
  double* errorData() override { return _error.data(); }
  const ErrorVector& error() const { return _error; }
  ErrorVector& error() { return _error; }

  const InformationType& information() const { return _information; }
  InformationType& information() { return _information; }
  void setInformation(const InformationType& information) { _information = information; }
  template <typename Derived>
  void setInformation(const Eigen::MatrixBase<Derived>& information) {
    _information = information;
  }
  const double* informationData() const override { return _information.data(); }
  double* informationData() override { return _information.data(); }

  const Measurement& measurement() const { return _measurement; }
  virtual void setMeasurement(const Measurement& m) { _measurement = m; }

  virtual int rank() const { return _dimension; }

  /// Available only if D is Eigen::Dynamic.
  void setDimension(int dimension) {
    static_assert(D == Eigen::Dynamic, "setDimension() is for edges whose number of rows is Eigen::Dynamic");
    _dimension = dimension;
    _information.setIdentity(dimension, dimension);
    _error.setZero(dimension);
    internal::roomForJacobians(*this);
  }

  void initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) override {}

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW

 protected:
  Measurement _measurement;
  InformationType _information;
  ErrorVector _error;

  /// Returns ρ′Ω, or zero if ρ′ is negative, because a negative ρ′ would make the Hessian indefinite.
  InformationType robustInformation(const Vector3& rho) const { return std::max(0.0, rho[1]) * _information; }

  /// readInformationMatrix() and writeInformationMatrix() read and write the upper triangle of Ω, row by row.
  bool readInformationMatrix(std::istream& is) {
    for (int i = 0; i < information().rows(); ++i) {
      for (int j = i; j < information().cols(); ++j) {
        is >> information()(i, j);
        information()(j, i) = information()(i, j);
      }
    }
    return !is.fail();
  }
  bool writeInformationMatrix(std::ostream& os) const {
    for (int i = 0; i < information().rows(); ++i) {
      for (int j = i; j < information().cols(); ++j) os << information()(i, j) << " ";
    }
    return os.good();
  }
  bool readParamIds(std::istream& is) {
    for (size_t i = 0; i < numParameters(); ++i) {
      int id = 0;
      if (!(is >> id)) return false;
      setParameterId(static_cast<int>(i), id);
    }
    return true;
  }
  bool writeParamIds(std::ostream& os) const {
    for (int id : _parameterIds) os << id << " ";
    return os.good();
  }
};

}  // namespace g2o

#endif  // G2O_BASE_EDGE_H
