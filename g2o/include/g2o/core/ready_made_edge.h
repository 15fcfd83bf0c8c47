// SPDX-License-Identifier: BSD-3-Clause
// The class between an edge type of the library and BaseUnaryEdge, BaseBinaryEdge or BaseFixedSizedEdge.
#pragma once
#ifndef G2O_READY_MADE_EDGE_H
#define G2O_READY_MADE_EDGE_H

#if __cplusplus < 201703L
#pragma GCC system_header  // Otherwise, compilers warn about C++17 in this header.
#endif

#include <type_traits>

#include "g2o/core/base_binary_edge.h"
#include "g2o/core/base_unary_edge.h"

namespace g2o {
namespace internal {

/// The functions of the edge type `Edge`. They are defined in the library of this type. They are no members
/// of ReadyMadeEdge, because its template arguments, such as Eigen's matrices, are not exported, so that
/// compilers would not export its members.
template <class Edge>
struct G2O_API_EXPORT EdgeFunctions {
  using Vertices = OptimizableGraph::VertexSet;

  static void compute_error(Edge& e);
  static void linearize(Edge& e);
  static bool read(Edge& e, std::istream& is);
  static bool write(const Edge& e, std::ostream& os);
  static int measurement_size();
  static bool set_data(Edge& e, const double* d);
  static bool get_data(const Edge& e, double* d);
  static bool measure(Edge& e);
  static double cost_of_guess(const Edge& e, const Vertices& from, const OptimizableGraph::Vertex* to);
  static void guess(Edge& e, const Vertices& from, const OptimizableGraph::Vertex* to);
};

/// How the library computes the functions of an edge type (see ready_made_edge.h of its sources).
template <class Edge>
struct EdgeModel;

/// What an edge stores in addition to its measurement, such as the inverse.
template <class E>
struct KeptMeasurement {
  void keep(const E&) {}
};

template <int D, class E, class... V>
struct BaseOfReadyMade {
  using type = BaseFixedSizedEdge<D, E, V...>;
};
template <int D, class E, class Xi>
struct BaseOfReadyMade<D, E, Xi> {
  using type = BaseUnaryEdge<D, E, Xi>;
};
template <int D, class E, class Xi, class Xj>
struct BaseOfReadyMade<D, E, Xi, Xj> {
  using type = BaseBinaryEdge<D, E, Xi, Xj>;
};

}  // namespace internal

/// The base of the edge type `Edge` of the library: implements its virtual functions. The other parameters
/// are those of BaseFixedSizedEdge. A client derives from `Edge` or from BaseFixedSizedEdge.
template <class Edge, int D, class E, class... V>
class ReadyMadeEdge : public internal::BaseOfReadyMade<D, E, V...>::type,
                      protected internal::KeptMeasurement<E> {
  using Parent = typename internal::BaseOfReadyMade<D, E, V...>::type;
  using Functions = internal::EdgeFunctions<Edge>;
  friend Functions;

 public:
  /// The measurement is zero or the identity.
  ReadyMadeEdge() {
    auto& z = this->_measurement;
    if constexpr (std::is_same<E, double>::value) {
      z = 0;
    } else if constexpr (std::is_base_of<Eigen::EigenBase<E>, E>::value) {
      z.setZero();
    } else if constexpr (std::is_same<E, Isometry3>::value) {
      z.setIdentity();
    }
  }

  void computeError() override { Functions::compute_error(self()); }
  void linearizeOplus() override { Functions::linearize(self()); }
  using Parent::linearizeOplus;
  bool read(std::istream& is) override { return Functions::read(self(), is); }
  bool write(std::ostream& os) const override { return Functions::write(self(), os); }

  void setMeasurement(const E& m) override {
    this->_measurement = m;
    this->keep(m);
  }
  bool setMeasurementData(const double* d) override { return Functions::set_data(self(), d); }
  bool getMeasurementData(double* d) const override { return Functions::get_data(self(), d); }
  int measurementDimension() const override { return Functions::measurement_size(); }
  bool setMeasurementFromState() override { return Functions::measure(self()); }

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override {
    return Functions::cost_of_guess(self(), from, to);
  }
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override {
    Functions::guess(self(), from, to);
  }

 private:
  Edge& self() { return static_cast<Edge&>(*this); }
  const Edge& self() const { return static_cast<const Edge&>(*this); }
};

}  // namespace g2o

#endif  // G2O_READY_MADE_EDGE_H
