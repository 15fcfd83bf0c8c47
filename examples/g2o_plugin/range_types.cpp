// SPDX-License-Identifier: BSD-3-Clause
// A plug-in for the tool `g2o` with two types: a vertex for a beacon at an unknown position, and an edge for
// the measured distance between a pose and a beacon. In files, vertices and edges have these lines:
//
//     VERTEX_BEACON id x y        EDGE_RANGE pose beacon meters information
#include <cmath>
#include <istream>
#include <ostream>

#include "g2o/core/base_binary_edge.h"
#include "g2o/core/base_vertex.h"
#include "g2o/core/factory.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace example {

class VertexBeacon : public g2o::BaseVertex<2, Eigen::Vector2d> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  void setToOriginImpl() override { _estimate.setZero(); }
  void oplusImpl(const double* update) override { _estimate += Eigen::Vector2d(update); }
  bool read(std::istream& is) override { return static_cast<bool>(is >> _estimate[0] >> _estimate[1]); }
  bool write(std::ostream& os) const override {
    os << _estimate[0] << " " << _estimate[1];
    return os.good();
  }
};

// [edge]
class EdgeRange : public g2o::BaseBinaryEdge<1, double, g2o::VertexSE2, VertexBeacon> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  void computeError() override {
    const auto* pose = static_cast<const g2o::VertexSE2*>(_vertices[0]);
    const auto* beacon = static_cast<const VertexBeacon*>(_vertices[1]);
    _error[0] = (beacon->estimate() - pose->estimate().translation()).norm() - _measurement;
  }
  bool read(std::istream& is) override { return is >> _measurement && readInformationMatrix(is); }
  bool write(std::ostream& os) const override {
    os << _measurement << " ";
    return writeInformationMatrix(os);
  }
};
// [/edge]

// [register]
G2O_REGISTER_TYPE_GROUP(range)
G2O_REGISTER_TYPE(VERTEX_BEACON, VertexBeacon)
G2O_REGISTER_TYPE(EDGE_RANGE, EdgeRange)
// [/register]

}  // namespace example
