// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_BASE_BINARY_EDGE_H
#define G2O_BASE_BINARY_EDGE_H

#include "g2o/core/base_fixed_sized_edge.h"

namespace g2o {

/// An edge between two vertices.
template <int D, typename E, typename VertexXi, typename VertexXj>
class BaseBinaryEdge : public BaseFixedSizedEdge<D, E, VertexXi, VertexXj> {
 public:
  using Base = BaseFixedSizedEdge<D, E, VertexXi, VertexXj>;
  using VertexXiType = VertexXi;
  using VertexXjType = VertexXj;
  static constexpr int Di = VertexXiType::Dimension;
  static constexpr int Dj = VertexXjType::Dimension;
  static constexpr int Dimension = Base::Dimension;
  using Measurement = typename Base::Measurement;
  using ErrorVector = typename Base::ErrorVector;
  using InformationType = typename Base::InformationType;
  using JacobianXiOplusType = typename Base::template JacobianType<D, VertexXi::Dimension>;
  using JacobianXjOplusType = typename Base::template JacobianType<D, VertexXj::Dimension>;
  using HessianBlockType = typename Base::template HessianBlockType<Di, Dj>;
  using HessianBlockTransposedType = typename Base::template HessianBlockType<Dj, Di>;

  BaseBinaryEdge()
      : _hessianRowMajor(Base::_hessianRowMajor[0]),
        _hessian(std::get<0>(this->_hessianTuple)),
        _hessianTransposed(std::get<0>(this->_hessianTupleTransposed)),
        _jacobianOplusXi(std::get<0>(_jacobianOplus)),
        _jacobianOplusXj(std::get<1>(_jacobianOplus)) {}

  const JacobianXiOplusType& jacobianOplusXi() const { return _jacobianOplusXi; }
  const JacobianXjOplusType& jacobianOplusXj() const { return _jacobianOplusXj; }

 protected:
  using Base::_error;
  using Base::_information;
  using Base::_jacobianOplus;
  using Base::_measurement;
  using Base::_vertices;

  /// The off-diagonal Hessian block of the two vertices is mapped to _hessianTransposed if _hessianRowMajor
  /// is true, otherwise to _hessian.
  bool& _hessianRowMajor;
  HessianBlockType& _hessian;
  HessianBlockTransposedType& _hessianTransposed;
  JacobianXiOplusType& _jacobianOplusXi;
  JacobianXjOplusType& _jacobianOplusXj;
};

}  // namespace g2o

#endif  // G2O_BASE_BINARY_EDGE_H
