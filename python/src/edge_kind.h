// SPDX-License-Identifier: BSD-3-Clause
// Makes the rows of the table of edge types.
#pragma once

#include <typeinfo>
#include <utility>

#include "edge_kinds.h"
#include "values.h"

namespace boxplus::python {

template <class E>
using Measurement = decltype(E::measurement);

/// The edge with this measurement. Quaternions of measurements are normalized, as in files.
template <class E>
E edge_with(const Measurement<E>& z) {
  if constexpr (std::is_same_v<Measurement<E>, SE3>) {
    return E(SE3(z.translation(), z.quaternion()));
  } else {
    return E(z);
  }
}

template <class... V, class E, std::size_t... I>
EdgeRef add_edge_at(Graph& graph, E edge, const Information& information, const VertexRef* vertices,
                    std::index_sequence<I...>) {
  return graph.add_edge(std::move(edge), information, VertexHandle<V>{vertices[I]}...);
}

/// The row of the table for edges E of a family, with vertices V.
template <class E, class... V>
EdgeKind edge_kind(std::string_view family) {
  using Z = Value<Measurement<E>>;
  return {
      .family = family,
      .vertices = joined({Value<V>::kName...}, ", "),
      .pools = {typeid(detail::TypedVertexPool<V>)...},
      .pool = typeid(detail::TypedEdgePool<E, V...>),
      .layout = Z::kLayout,
      .size = Z::kSize,
      .rows = detail::kRows<detail::Result<E, V...>>,
      .add = [](Graph& graph, py::handle measurement, const Information& information,
                const VertexRef* refs) -> EdgeRef {
        return add_edge_at<V...>(graph, edge_with<E>(Z::from_python(measurement, "measurement")), information,
                                 refs, std::index_sequence_for<V...>());
      },
      .add_row = [](Graph& graph, const double* row, RowName name, const Information& information,
                    const VertexRef* refs) -> EdgeRef {
        return add_edge_at<V...>(graph, edge_with<E>(Z::from_row(row, name)), information, refs,
                                 std::index_sequence_for<V...>());
      },
      .measurement = [](const Graph& graph, EdgeRef edge) -> py::object {
        return Z::to_python(graph.measurement(EdgeHandle<E>{edge}).measurement);
      },
      .set_measurement =
          [](Graph& graph, EdgeRef edge, py::handle measurement) {
            graph.set_measurement(EdgeHandle<E>{edge},
                                  edge_with<E>(Z::from_python(measurement, "measurement")));
          },
  };
}

}  // namespace boxplus::python
