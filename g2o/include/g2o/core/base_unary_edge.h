// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_BASE_UNARY_EDGE_H
#define G2O_BASE_UNARY_EDGE_H

#include "g2o/core/base_fixed_sized_edge.h"

namespace g2o {

/// An edge with one vertex, for example a prior or an observation of a known landmark.
template <int D, typename E, typename VertexXi>
class BaseUnaryEdge : public BaseFixedSizedEdge<D, E, VertexXi> {
 public:
  using Base = BaseFixedSizedEdge<D, E, VertexXi>;
  using VertexXiType = VertexXi;
  static constexpr int Dimension = Base::Dimension;
  using Measurement = typename Base::Measurement;
  using ErrorVector = typename Base::ErrorVector;
  using InformationType = typename Base::InformationType;
  using JacobianXiOplusType = typename Base::template JacobianType<D, VertexXi::Dimension>;

  BaseUnaryEdge() : _jacobianOplusXi(std::get<0>(_jacobianOplus)) {}

  const JacobianXiOplusType& jacobianOplusXi() const { return _jacobianOplusXi; }

  /// Does nothing, because an edge with one vertex cannot derive an estimate from other vertices.
  void initialEstimate(const OptimizableGraph::VertexSet&, OptimizableGraph::Vertex*) override {}

 protected:
  using Base::_error;
  using Base::_information;
  using Base::_jacobianOplus;
  using Base::_measurement;
  using Base::_vertices;

  JacobianXiOplusType& _jacobianOplusXi;
};

}  // namespace g2o

#endif  // G2O_BASE_UNARY_EDGE_H
