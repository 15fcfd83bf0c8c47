// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_BASE_VERTEX_H
#define G2O_BASE_VERTEX_H

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <stack>
#include <vector>

#include "g2o/core/creators.h"
#include "g2o/core/io_helper.h"
#include "g2o/core/optimizable_graph.h"

namespace g2o {
namespace internal {

/// Returns a reference to a NaN. It replaces the entries of a Hessian block that is not mapped to memory.
inline double& unmappedEntry() {
  thread_local double entry;
  entry = std::numeric_limits<double>::quiet_NaN();
  return entry;
}

}  // namespace internal

/// A vertex with an estimate of type T and D dimensions. If D is Eigen::Dynamic, the number of dimensions is
/// chosen at run time (see BaseDynamicVertex). A derived class implements oplusImpl(), setToOriginImpl(),
/// read() and write().
template <int D, typename T>
class BaseVertex : public OptimizableGraph::Vertex {
 public:
  using EstimateType = T;
  /// What edges use of a vertex type. Edges on this type accept every vertex that is derived from this class.
  /// If edges read members that a derived class adds, the derived class replaces this by itself.
  using UsedByEdges = BaseVertex;
  using BackupStackType = std::stack<EstimateType, std::vector<EstimateType>>;
  static constexpr int Dimension = D;
  /// The vertex's diagonal block of the Hessian, mapped to memory of the solver.
  using HessianBlockType = Eigen::Map<Eigen::Matrix<double, D, D, Eigen::ColMajor>>;
  using BVector = Eigen::Matrix<double, D, 1, Eigen::ColMajor>;

  BaseVertex() : _hessian(nullptr, std::max(D, 0), std::max(D, 0)) {
    _dimension = D;
    if (D > 0) _b = BVector::Zero(D);
  }
  BaseVertex(const BaseVertex&) = delete;
  BaseVertex& operator=(const BaseVertex&) = delete;

  const double& hessian(int i, int j) const override {
    return _hessian.data() == nullptr ? internal::unmappedEntry() : _hessian(i, j);
  }
  double& hessian(int i, int j) override {
    return _hessian.data() == nullptr ? internal::unmappedEntry() : _hessian(i, j);
  }
  double hessianDeterminant() const override {
    return _hessian.data() == nullptr ? internal::unmappedEntry() : _hessian.determinant();
  }
  double* hessianData() override { return _hessian.data(); }

  void mapHessianMemory(double* d) override {
    const int dim = d == nullptr && D == Eigen::Dynamic ? 0 : dimension();
    new (&_hessian) HessianBlockType(d, dim, dim);
  }

  int copyB(double* b_) const override {
    std::copy_n(_b.data(), dimension(), b_);
    return dimension();
  }
  const double& b(int i) const override { return _b(i); }
  double& b(int i) override { return _b(i); }
  double* bData() override { return _b.data(); }
  void clearQuadraticForm() override { _b.setZero(); }

  double solveDirect(double lambda = 0) override {
    if (_hessian.data() == nullptr) return internal::unmappedEntry();
    MatrixX damped = _hessian;
    damped.diagonal().array() += lambda;
    const double determinant = damped.determinant();
    if (std::isnan(determinant) || determinant < std::numeric_limits<double>::epsilon()) return determinant;
    const VectorX step = damped.llt().solve(_b);
    oplus(step.data());
    return determinant;
  }

  BVector& b() { return _b; }
  const BVector& b() const { return _b; }
  HessianBlockType& A() { return _hessian; }
  const HessianBlockType& A() const { return _hessian; }

  void push() override { _backup.push(_estimate); }
  void pop() override {
    if (_backup.empty()) return;
    _estimate = _backup.top();
    _backup.pop();
    updateCache();
  }
  void discardTop() override {
    if (!_backup.empty()) _backup.pop();
  }
  int stackSize() const override { return static_cast<int>(_backup.size()); }

  const EstimateType& estimate() const { return _estimate; }
  void setEstimate(const EstimateType& et) {
    _estimate = et;
    updateCache();
  }

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW

 protected:
  HessianBlockType _hessian;
  BVector _b;
  EstimateType _estimate;
  BackupStackType _backup;
};

}  // namespace g2o

#endif  // G2O_BASE_VERTEX_H
