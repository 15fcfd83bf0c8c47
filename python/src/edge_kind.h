// SPDX-License-Identifier: BSD-3-Clause
// Makes the rows of the table of edge types.
#pragma once

#include <memory>
#include <tuple>
#include <type_traits>
#include <typeinfo>
#include <utility>

#include "edge_kinds.h"
#include "values.h"

namespace boxplus::python {

template <class E>
using Measurement = decltype(E::measurement);
/// The type of the camera that is part of an edge.
template <class E>
using CameraOf = decltype(E::camera);
template <class E>
inline constexpr bool kHasCamera = requires(const E& edge) {
  edge.camera;
};

/// The edge with this measurement. Quaternions of measurements are normalized, as in files.
template <class E>
E edge_with(const Measurement<E>& z, py::handle camera) {
  if constexpr (kHasCamera<E>) {
    return E(z, Value<CameraOf<E>>::from_python(camera, "camera"));
  } else if constexpr (std::is_same_v<Measurement<E>, SE3>) {
    return E(SE3(z.translation(), z.quaternion()));
  } else {
    return E(z);
  }
}

/// The edge with another measurement, and with the same camera if it has one.
template <class E>
E with_measurement(const E& edge, py::handle measurement) {
  py::object camera = py::none();
  if constexpr (kHasCamera<E>) camera = Value<CameraOf<E>>::to_python(edge.camera);
  return edge_with<E>(Value<Measurement<E>>::from_python(measurement, "measurement"), camera);
}

/// Adds edges E with vertices V to a graph or to a pool.
template <class E, class... V>
struct EdgeAdder {
  using Pool = detail::TypedEdgePool<E, V...>;

  template <std::size_t... I>
  static EdgeRef to_graph(const EdgePlace& place, E edge, const Information& information,
                          std::index_sequence<I...>) {
    return place.graph->add_edge(std::move(edge), information, VertexHandle<V>{place.vertices[I]}...);
  }
  static EdgeRef to(const EdgePlace& place, E edge, const Information& information) {
    if (place.pool == nullptr)
      return to_graph(place, std::move(edge), information, std::index_sequence_for<V...>());
    constexpr int kRows = detail::kRows<detail::Result<E, V...>>;
    auto& pool = static_cast<Pool&>(*place.pool);
    return {0, pool.add(std::move(edge), information, kRows, place.slots, {}), 0};
  }
  template <std::size_t... I>
  static std::unique_ptr<detail::EdgePool> pool_of(const Graph& graph, const VertexRef* vertices,
                                                   std::index_sequence<I...>) {
    const auto pools = graph.vertex_pools();
    return std::make_unique<Pool>(
        std::vector<std::uint32_t>{vertices[I].pool...},
        std::tuple(static_cast<const detail::TypedVertexPool<V>*>(pools[vertices[I].pool].get())...));
  }
};

/// The row of the table for edges E of a family, with vertices V.
template <class E, class... V>
EdgeKind edge_kind(std::string_view family) {
  using Adder = EdgeAdder<E, V...>;
  using Z = Value<Measurement<E>>;
  EdgeKind kind{
      .family = family,
      .vertices = joined({Value<V>::kName...}, ", "),
      .pools = {typeid(detail::TypedVertexPool<V>)...},
      .pool = typeid(detail::TypedEdgePool<E, V...>),
      .layout = Z::kLayout,
      .size = Z::kSize,
      .rows = detail::kRows<detail::Result<E, V...>>,
      .add = [](const EdgePlace& place, py::handle measurement, py::handle camera,
                const Information& information) -> EdgeRef {
        return Adder::to(place, edge_with<E>(Z::from_python(measurement, "measurement"), camera),
                         information);
      },
      .add_row = [](const EdgePlace& place, const double* row, RowName name, py::handle camera,
                    const Information& information) -> EdgeRef {
        return Adder::to(place, edge_with<E>(Z::from_row(row, name), camera), information);
      },
      .measurement = [](const detail::EdgePool& pool, std::uint32_t slot) -> py::object {
        return Z::to_python(static_cast<const detail::TypedEdgePool<E, V...>&>(pool).value(slot).measurement);
      },
      .set_measurement =
          [](Graph& graph, EdgeRef edge, py::handle measurement) {
            const EdgeHandle<E> handle{edge};
            graph.set_measurement(handle, with_measurement(graph.measurement(handle), measurement));
          },
      .set_measurement_in_pool =
          [](detail::EdgePool& pool, std::uint32_t slot, py::handle measurement) {
            auto& typed = static_cast<detail::TypedEdgePool<E, V...>&>(pool);
            typed.exchange(slot, with_measurement(typed.value(slot), measurement));
          },
      .empty_pool =
          [](const Graph& graph, const VertexRef* vertices) {
            return Adder::pool_of(graph, vertices, std::index_sequence_for<V...>());
          },
  };
  if constexpr (kHasCamera<E>) {
    kind.is_camera = &Value<CameraOf<E>>::is;
    kind.camera_name = Value<CameraOf<E>>::kName;
  }
  return kind;
}

}  // namespace boxplus::python
