// SPDX-License-Identifier: BSD-3-Clause
// Macros for edges with automatic differentiation. The edge class implements its error as a function
// template, and a macro implements computeError() and linearizeOplus():
//
//     class EdgeCurve : public g2o::BaseUnaryEdge<1, Eigen::Vector2d, VertexCurve> {
//      public:
//       template <typename T>
//       bool operator()(const T* parameters, T* error) const { …; return true; }
//       G2O_MAKE_AUTO_AD_FUNCTIONS
//     };
//
// For each vertex, the function template receives the estimate as an array. The array must have as many
// values as the vertex has dimensions, and oplusImpl() of the vertex must add the increment to these values.
#pragma once
#ifndef G2O_AUTO_DIFFERENTIATION_H
#define G2O_AUTO_DIFFERENTIATION_H

#if __cplusplus < 201703L
#pragma GCC system_header  // Otherwise, compilers warn about C++17 in this header.
#endif

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include "g2o/autodiff/autodiff.h"
#include "g2o/stuff/logger.h"

namespace g2o {
namespace internal {

/// The types that depend on the dimensions of a BaseFixedSizedEdge and its vertices.
template <typename Edge, std::size_t... K>
struct AutoDifferentiationLayout {
  static_assert(Edge::Dimension > 0, "the number of rows of the error must be known at compile time");
  static_assert(((Edge::template VertexXnType<K>::Dimension > 0) && ...),
                "the dimensions of the vertices must be known at compile time");
  using AutoDiff = ceres::internal::AutoDiff<Edge::Dimension, Edge::template VertexXnType<K>::Dimension...>;
  using Estimates = std::tuple<std::array<double, Edge::template VertexXnType<K>::Dimension>...>;
};
template <typename Edge, std::size_t... K>
AutoDifferentiationLayout<Edge, K...> autoDifferentiationLayout(std::index_sequence<K...>);

}  // namespace internal

/// Passes the function template a pointer to the estimate of each vertex: estimate().data(), or the address
/// of a scalar estimate.
template <typename EdgeType>
class EstimateAccessor {
 public:
  template <int K>
  const double* data(const EdgeType* edge) {
    const auto& estimate = edge->template vertexXn<K>()->estimate();
    if constexpr (std::is_same<std::decay_t<decltype(estimate)>, double>::value) {
      return &estimate;
    } else {
      return estimate.data();
    }
  }
};

/// Passes the function template a pointer to a copy of the estimate of each vertex. The copy comes from
/// getEstimateData() if this function returns one value per dimension of the vertex, otherwise from
/// getMinimalEstimateData().
template <typename EdgeType>
class EstimateAccessorGet {
 public:
  template <int K>
  const double* data(const EdgeType* edge) {
    using VertexType = typename EdgeType::template VertexXnType<K>;
    constexpr int kDimension = VertexType::Dimension;
    const VertexType* v = edge->template vertexXn<K>();
    auto& copy = std::get<K>(_estimates);
    bool ok = false;
    if (v->estimateDimension() == kDimension) {
      ok = v->getEstimateData(copy.data());
    } else if (v->minimalEstimateDimension() == kDimension) {
      ok = v->getMinimalEstimateData(copy.data());
    }
    if (!ok) {
      G2O_ERROR("vertex {}: expected {} values from getEstimateData()", v->id(), kDimension);
      copy.fill(0);
    }
    return copy.data();
  }

 private:
  typename decltype(internal::autoDifferentiationLayout<EdgeType>(
      std::make_index_sequence<EdgeType::_nr_of_vertices>()))::Estimates _estimates;
};

/// Implements the macros below.
template <typename Edge, typename EstimateAccess = EstimateAccessor<Edge>>
class AutoDifferentiation {
 public:
  /// Computes edge.error() by calling edge(x₀, x₁, …, error).
  static void computeError(Edge* that) {
    EstimateAccess access;
    const Arguments x = arguments(access, that, Indices());
    static_cast<void>(call(*that, x, that->errorData(), Indices()));
  }

  /// Computes the Jacobians of all non-fixed vertices. The Jacobians are zero if the function template
  /// returns false.
  static void linearize(Edge* that) {
    if (that->allVerticesFixed()) return;
    EstimateAccess access;
    const Arguments x = arguments(access, that, Indices());
    std::array<double*, kVertices> jacobians = jacobianData(that, Indices());
    std::array<double, static_cast<std::size_t>(Edge::Dimension)> error;
    if (!AutoDiff::Differentiate(*that, x.data(), error.data(), jacobians.data())) setZero(that, Indices());
  }

 private:
  static constexpr std::size_t kVertices = Edge::_nr_of_vertices;
  using Indices = std::make_index_sequence<kVertices>;
  using Arguments = std::array<const double*, kVertices>;
  using AutoDiff = typename decltype(internal::autoDifferentiationLayout<Edge>(Indices()))::AutoDiff;

  template <std::size_t... K>
  static Arguments arguments(EstimateAccess& access, const Edge* that, std::index_sequence<K...>) {
    return {{access.template data<static_cast<int>(K)>(that)...}};
  }
  template <std::size_t... K>
  static bool call(const Edge& edge, const Arguments& x, double* error, std::index_sequence<K...>) {
    return edge(x[K]..., error);
  }
  template <std::size_t... K>
  static std::array<double*, kVertices> jacobianData(Edge* that, std::index_sequence<K...>) {
    return {{(that->template usedVertexXn<static_cast<int>(K)>()->fixed()
                  ? nullptr
                  : that->template jacobianOplusXn<static_cast<int>(K)>().data())...}};
  }
  template <std::size_t... K>
  static void setZero(Edge* that, std::index_sequence<K...>) {
    (that->template jacobianOplusXn<static_cast<int>(K)>().setZero(), ...);
  }
};

}  // namespace g2o

#define G2O_MAKE_AUTO_AD_COMPUTEERROR_WITH_(Access)                              \
  void computeError() override {                                                 \
    using G2OEdge_ = std::remove_cv_t<std::remove_reference_t<decltype(*this)>>; \
    g2o::AutoDifferentiation<G2OEdge_, Access<G2OEdge_>>::computeError(this);    \
  }
#define G2O_MAKE_AUTO_AD_LINEARIZEOPLUS_WITH_(Access)                            \
  void linearizeOplus() override {                                               \
    using G2OEdge_ = std::remove_cv_t<std::remove_reference_t<decltype(*this)>>; \
    g2o::AutoDifferentiation<G2OEdge_, Access<G2OEdge_>>::linearize(this);       \
  }

/// Use these macros in an edge class. They implement computeError(), linearizeOplus(), or both by calling
/// operator() with estimate().data() of each vertex.
#define G2O_MAKE_AUTO_AD_COMPUTEERROR G2O_MAKE_AUTO_AD_COMPUTEERROR_WITH_(g2o::EstimateAccessor)
#define G2O_MAKE_AUTO_AD_LINEARIZEOPLUS G2O_MAKE_AUTO_AD_LINEARIZEOPLUS_WITH_(g2o::EstimateAccessor)
#define G2O_MAKE_AUTO_AD_FUNCTIONS \
  G2O_MAKE_AUTO_AD_COMPUTEERROR    \
  G2O_MAKE_AUTO_AD_LINEARIZEOPLUS

/// The same macros for vertices whose estimate has no function data(). They use getEstimateData() or
/// getMinimalEstimateData().
#define G2O_MAKE_AUTO_AD_COMPUTEERROR_BY_GET G2O_MAKE_AUTO_AD_COMPUTEERROR_WITH_(g2o::EstimateAccessorGet)
#define G2O_MAKE_AUTO_AD_LINEARIZEOPLUS_BY_GET G2O_MAKE_AUTO_AD_LINEARIZEOPLUS_WITH_(g2o::EstimateAccessorGet)
#define G2O_MAKE_AUTO_AD_FUNCTIONS_BY_GET \
  G2O_MAKE_AUTO_AD_COMPUTEERROR_BY_GET    \
  G2O_MAKE_AUTO_AD_LINEARIZEOPLUS_BY_GET

#endif  // G2O_AUTO_DIFFERENTIATION_H
