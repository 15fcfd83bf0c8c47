// SPDX-License-Identifier: BSD-3-Clause
// The base class of edges whose number of vertices is chosen at run time.
#pragma once
#ifndef G2O_BASE_VARIABLE_SIZED_EDGE_H
#define G2O_BASE_VARIABLE_SIZED_EDGE_H

#include <cassert>
#include <new>
#include <vector>

#include "g2o/core/base_edge.h"

namespace g2o {

/// An edge whose number of vertices is set by resize(). A derived class implements computeError(), read() and
/// write(). It also implements linearizeOplus() if it has analytic Jacobians.
template <int D, typename E>
class BaseVariableSizedEdge : public BaseEdge<D, E> {
 public:
  /// The Hessian block of two vertices, mapped to memory of the solver.
  struct HessianHelper {
    Eigen::Map<MatrixX> matrix;
    bool transposed;
    HessianHelper() : matrix(nullptr, 0, 0), transposed(false) {}
  };

  static constexpr int Dimension = BaseEdge<D, E>::Dimension;
  using Measurement = typename BaseEdge<D, E>::Measurement;
  using ErrorVector = typename BaseEdge<D, E>::ErrorVector;
  using InformationType = typename BaseEdge<D, E>::InformationType;
  using JacobianType = Eigen::Map<Eigen::Matrix<double, D, Eigen::Dynamic>>;
  using HessianBlockType = Eigen::Map<MatrixX>;

  void resize(size_t size) override {
    const bool same = size == _vertices.size() && size == _jacobianOplus.size();
    BaseEdge<D, E>::resize(size);
    if (same) return;
    // Creates new maps, because an assignment to an Eigen::Map would copy values.
    _hessian.clear();
    _hessian.resize(size * (size - (size > 0 ? 1 : 0)) / 2);
    _jacobianOplus.clear();
    _jacobianOplus.resize(size, JacobianType(nullptr, D > 0 ? D : 0, 0));
    internal::roomForJacobians(*this);
  }

  bool allVerticesFixed() const override {
    for (size_t i = 0; i < _vertices.size(); ++i) {
      if (!at(i)->fixed()) return false;
    }
    return true;
  }

  void linearizeOplus(JacobianWorkspace& jacobianWorkspace) override {
    if (_jacobianOplus.size() < _vertices.size())
      _jacobianOplus.resize(_vertices.size(), JacobianType(nullptr, D > 0 ? D : 0, 0));
    for (size_t i = 0; i < _vertices.size(); ++i) {
      new (&_jacobianOplus[i]) JacobianType(jacobianWorkspace.workspaceForVertex(static_cast<int>(i)),
                                            this->_dimension, at(i)->dimension());
    }
    linearizeOplus();
  }
  /// Computes the Jacobians of the vertices that are not fixed. By default, differentiates numerically.
  virtual void linearizeOplus() {
    for (size_t i = 0; i < _vertices.size(); ++i) {
      if (!at(i)->fixed()) internal::numericJacobian(*this, *at(i), _jacobianOplus[i].data());
    }
  }

  void constructQuadraticForm() override {
    if (this->robustKernel() != nullptr) {
      Vector3 rho;
      this->robustKernel()->robustify(this->chi2(), rho);
      const InformationType omega = this->robustInformation(rho);
      computeQuadraticForm(omega, omega * -_error);
    } else {
      computeQuadraticForm(_information, _information * -_error);
    }
  }

  void mapHessianMemory(double* d, int i, int j, bool rowMajor) override {
    const int index = j * (j - 1) / 2 + i;
    if (i < 0 || i >= j || index >= static_cast<int>(_hessian.size())) return;
    HessianHelper& helper = _hessian[static_cast<size_t>(index)];
    const int first = at(static_cast<size_t>(i))->dimension();
    const int second = at(static_cast<size_t>(j))->dimension();
    new (&helper.matrix) HessianBlockType(d, rowMajor ? second : first, rowMajor ? first : second);
    helper.transposed = rowMajor;
  }

 protected:
  using BaseEdge<D, E>::_measurement;
  using BaseEdge<D, E>::_information;
  using BaseEdge<D, E>::_error;
  using BaseEdge<D, E>::_vertices;
  using BaseEdge<D, E>::_dimension;

  std::vector<HessianHelper> _hessian;
  std::vector<JacobianType> _jacobianOplus;

  void computeQuadraticForm(const InformationType& omega, const ErrorVector& weightedError) {
    for (size_t i = 0; i < _vertices.size(); ++i) {
      OptimizableGraph::Vertex* from = at(i);
      if (from->fixed() || from->hessianData() == nullptr) continue;
      const JacobianType& J = _jacobianOplus[i];
      const Eigen::Matrix<double, Eigen::Dynamic, D, Eigen::ColMajor> JtOmega = J.transpose() * omega;
      const int dim = from->dimension();
      Eigen::Map<VectorX>(from->bData(), dim).noalias() += J.transpose() * weightedError;
      Eigen::Map<MatrixX>(from->hessianData(), dim, dim).noalias() += JtOmega * J;
      for (size_t j = i + 1; j < _vertices.size(); ++j) {
        if (at(j)->fixed()) continue;
        HessianHelper& helper = _hessian[j * (j - 1) / 2 + i];
        if (helper.matrix.data() == nullptr) continue;
        if (helper.transposed) {
          helper.matrix.noalias() += _jacobianOplus[j].transpose() * JtOmega.transpose();
        } else {
          helper.matrix.noalias() += JtOmega * _jacobianOplus[j];
        }
      }
    }
  }

 private:
  OptimizableGraph::Vertex* at(size_t i) { return static_cast<OptimizableGraph::Vertex*>(_vertices[i]); }
  const OptimizableGraph::Vertex* at(size_t i) const {
    return static_cast<const OptimizableGraph::Vertex*>(_vertices[i]);
  }
};

}  // namespace g2o

#endif  // G2O_BASE_VARIABLE_SIZED_EDGE_H
