// SPDX-License-Identifier: BSD-3-Clause
// The types that a reader writes from listings 4 to 7 of the g2o document.
#pragma once

#include <istream>
#include <ostream>

#include "g2o/core/base_binary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/manual/se2.h"

namespace manual {

using g2o::BaseBinaryEdge;
using g2o::BaseVertex;

class VertexSE2 : public BaseVertex<3, SE2> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexSE2() {}
  virtual void setToOriginImpl() { _estimate = SE2(); }
  virtual void oplusImpl(double* update) {
    SE2 step(update[0], update[1], update[2]);
    _estimate = _estimate * step;
  }
  virtual bool read(std::istream& is) {
    Vector3d v;
    is >> v[0] >> v[1] >> v[2];
    _estimate.fromVector(v);
    return !is.fail();
  }
  virtual bool write(std::ostream& os) const {
    const Vector3d v = _estimate.toVector();
    os << v[0] << " " << v[1] << " " << v[2];
    return os.good();
  }
};

class VertexPointXY : public BaseVertex<2, Eigen::Vector2d> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexPointXY() { _estimate.setZero(); }
  virtual void setToOriginImpl() { _estimate.setZero(); }
  virtual void oplusImpl(double* update) {
    _estimate[0] += update[0];
    _estimate[1] += update[1];
  }
  virtual bool read(std::istream& is) {
    is >> _estimate[0] >> _estimate[1];
    return !is.fail();
  }
  virtual bool write(std::ostream& os) const {
    os << _estimate[0] << " " << _estimate[1];
    return os.good();
  }
};

class EdgeSE2 : public BaseBinaryEdge<3, SE2, VertexSE2, VertexSE2> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE2() {}
  void computeError() {
    const VertexSE2* v1 = static_cast<const VertexSE2*>(_vertices[0]);
    const VertexSE2* v2 = static_cast<const VertexSE2*>(_vertices[1]);
    SE2 delta = _measurement.inverse() * (v1->estimate().inverse() * v2->estimate());
    _error = delta.toVector();
  }
  virtual bool read(std::istream& is) {
    Vector3d z;
    is >> z[0] >> z[1] >> z[2];
    _measurement.fromVector(z);
    return readInformationMatrix(is);
  }
  virtual bool write(std::ostream& os) const {
    const Vector3d z = _measurement.toVector();
    os << z[0] << " " << z[1] << " " << z[2] << " ";
    return writeInformationMatrix(os);
  }
};

class EdgeSE2PointXY : public BaseBinaryEdge<2, Eigen::Vector2d, VertexSE2, VertexPointXY> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE2PointXY() {}
  void computeError() {
    const VertexSE2* v1 = static_cast<const VertexSE2*>(_vertices[0]);
    const VertexPointXY* l2 = static_cast<const VertexPointXY*>(_vertices[1]);
    Vector2d prediction = v1->estimate().inverse() * l2->estimate();
    _error = prediction - _measurement;
  }
  virtual bool read(std::istream& is) {
    is >> _measurement[0] >> _measurement[1];
    return readInformationMatrix(is);
  }
  virtual bool write(std::ostream& os) const {
    os << _measurement[0] << " " << _measurement[1] << " ";
    return writeInformationMatrix(os);
  }
};

}  // namespace manual
