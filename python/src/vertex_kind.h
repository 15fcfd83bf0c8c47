// SPDX-License-Identifier: BSD-3-Clause
// Makes the rows of the table of vertex types.
#pragma once

#include <array>
#include <optional>
#include <typeinfo>
#include <utility>

#include "boxplus/autodiff/dual.h"
#include "boxplus/autodiff/dual_eigen.h"
#include "boxplus/graph/differentiate.h"
#include "boxplus/types/vertex_pools.h"
#include "landmark_values.h"
#include "values.h"
#include "vertex_kinds.h"

namespace boxplus::python {

/// x ⊞ 0. Quaternions from files have rounded digits; planes and lines may have any scale.
template <class T>
const T& normalized(const T& x) {
  return x;
}
inline SE3 normalized(const SE3& x) {
  return {x.translation(), x.quaternion()};
}
template <class Camera>
Product<SE3, Camera> normalized(const Product<SE3, Camera>& x) {
  return Product<SE3, Camera>(normalized(x.template get<0>()), x.template get<1>());
}
inline Plane3 normalized(const Plane3& x) {
  return x.unit();
}
inline Line3 normalized(const Line3& x) {
  const double zeros[4] = {};
  return Manifold<Line3>::oplus(x, zeros);
}

/// The value of a row. What rows do not contain is taken from the old value.
template <class T>
T with_row(const T& /*old*/, const double* row) {
  return Value<T>::from_row(row, {});
}
inline Plane3 with_row(const Plane3& old, const double* row) {
  return {Value<Plane3>::from_row(row, {}).coefficients, old.color};
}

template <class T>
inline constexpr bool kIsProduct = false;
template <class... Parts>
inline constexpr bool kIsProduct<Product<Parts...>> = true;

template <class T>
void step_derivative(const double* row, double* out) {
  constexpr int kDim = Manifold<T>::kDim;
  using Dual = detail::Dual<double, kDim>;
  std::array<Dual, std::size_t{Value<T>::kSize}> moved;
  Value<T>::to_row(detail::lift(Value<T>::from_row(row, {}), detail::Seed<Dual>{}), moved.data());
  for (const Dual& number : moved) {
    for (int k = 0; k < kDim; ++k) *out++ = number.derivative[k];
  }
}

/// The row of the table for a type.
template <class T>
VertexKind vertex_kind() {
  using V = Value<T>;
  static_assert(V::kSize <= int{kMostNumbers});
  return {
      .name = V::kName,
      .layout = V::kLayout,
      .size = V::kSize,
      .dim = Manifold<T>::kDim,
      .is_tuple = kIsProduct<T>,
      .pool = typeid(detail::TypedVertexPool<T>),
      .is = &V::is,
      .add = [](Graph& graph, py::handle estimate, std::optional<Id> id, bool is_parameter) -> VertexRef {
        T value = V::from_python(estimate, "estimate");
        if (is_parameter) return graph.add_parameter(std::move(value), id);
        return graph.add_vertex(std::move(value), id);
      },
      .check_row = [](const double* row, RowName name) { static_cast<void>(V::from_row(row, name)); },
      .add_row = [](Graph& graph, const double* row, std::optional<Id> id) -> VertexRef {
        return graph.add_vertex(V::from_row(row, {}), id);
      },
      .estimate = [](const Graph& graph, VertexRef vertex) -> py::object {
        return V::to_python(graph.estimate(VertexHandle<T>{vertex}));
      },
      .set_estimate =
          [](Graph& graph, VertexRef vertex, py::handle estimate) {
            graph.set_estimate(VertexHandle<T>{vertex}, V::from_python(estimate, "estimate"));
          },
      .get_row = [](const Graph& graph, VertexRef vertex,
                    double* row) { V::to_row(graph.estimate(VertexHandle<T>{vertex}), row); },
      .set_row =
          [](Graph& graph, VertexRef vertex, const double* row) {
            const VertexHandle<T> handle{vertex};
            graph.set_estimate(handle, with_row(graph.estimate(handle), row));
          },
      .read =
          [](const detail::VertexPool& pool, std::uint32_t slot, double* row) {
            const T& x = static_cast<const detail::TypedVertexPool<T>&>(pool).value(slot);
            V::to_row(normalized(x), row);
          },
      .step = [](const double* row, const double* delta,
                 double* out) { V::to_row(Manifold<T>::oplus(V::from_row(row, {}), delta), out); },
      .step_derivative = &step_derivative<T>,
      .object_of_row = [](const double* row) { return V::to_python(V::from_row(row, {})); },
  };
}

}  // namespace boxplus::python
