// SPDX-License-Identifier: BSD-3-Clause
#include "edge_kinds.h"

#include <algorithm>
#include <typeinfo>
#include <utility>

#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "values.h"

namespace boxplus::python {
namespace {

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
EdgeRef add(Graph& graph, E edge, const Information& information, const VertexRef* vertices,
            std::index_sequence<I...>) {
  return graph.add_edge(std::move(edge), information, VertexHandle<V>{vertices[I]}...);
}

template <class E, class... V>
EdgeKind kind(std::string_view family, std::string_view vertices) {
  using Z = Value<Measurement<E>>;
  return {
      .family = family,
      .vertices = vertices,
      .pools = {typeid(detail::TypedVertexPool<V>)...},
      .pool = typeid(detail::TypedEdgePool<E, V...>),
      .layout = Z::kLayout,
      .size = Z::kSize,
      .rows = detail::kRows<detail::Result<E, V...>>,
      .add = [](Graph& graph, py::handle measurement, const Information& information,
                const VertexRef* refs) -> EdgeRef {
        return add<V...>(graph, edge_with<E>(Z::from_python(measurement, "measurement")), information, refs,
                         std::index_sequence_for<V...>());
      },
      .add_row = [](Graph& graph, const double* row, RowName name, const Information& information,
                    const VertexRef* refs) -> EdgeRef {
        return add<V...>(graph, edge_with<E>(Z::from_row(row, name)), information, refs,
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

}  // namespace

std::span<const EdgeFamily> edge_families() {
  static constexpr EdgeFamily kFamilies[] = {
      {"Between", "Measures a pose or a point relative to another one of the same type. Vertices: a, b."},
      {"Prior", "Measures a pose or a point in the world."},
      {"PositionPrior", "Measures the position of a pose in the world, for example by GPS."},
      {"PointObservation2", "Measures a point in the frame of a pose in the plane. Vertices: pose, point."},
      {"PointObservation3", "Measures a point in the frame of a pose in space. Vertices: pose, point."},
      {"OffsetPointObservation2",
       "Measures a point in the frame of a sensor. Vertices: pose, point, sensor."},
      {"OffsetPointObservation3",
       "Measures a point in the frame of a sensor. Vertices: pose, point, sensor."},
      {"BearingObservation2", "Measures the angle to a point (radians). Vertices: pose, point."},
      {"BearingObservation3", "Measures the direction of a point. Vertices: pose, point."},
      {"Range", "Measures the distance between a pose and a point (meters). Vertices: pose, point."},
  };
  return kFamilies;
}

std::span<const EdgeKind> edge_kinds() {
  static const EdgeKind kinds[] = {
      kind<Between<SE2>, SE2, SE2>("Between", "SE2, SE2"),
      kind<Between<SE3>, SE3, SE3>("Between", "SE3, SE3"),
      kind<Between<Vector2>, Vector2, Vector2>("Between", "Vector2, Vector2"),
      kind<Between<Vector3>, Vector3, Vector3>("Between", "Vector3, Vector3"),
      kind<Prior<SE2>, SE2>("Prior", "SE2"),
      kind<Prior<SE3>, SE3>("Prior", "SE3"),
      kind<Prior<Vector2>, Vector2>("Prior", "Vector2"),
      kind<Prior<Vector3>, Vector3>("Prior", "Vector3"),
      kind<PositionPrior<Vector2>, SE2>("PositionPrior", "SE2"),
      kind<PositionPrior<Vector3>, SE3>("PositionPrior", "SE3"),
      kind<PointObservation2, SE2, Vector2>("PointObservation2", "SE2, Vector2"),
      kind<PointObservation3, SE3, Vector3>("PointObservation3", "SE3, Vector3"),
      kind<OffsetPointObservation2, SE2, Vector2, SE2>("OffsetPointObservation2", "SE2, Vector2, SE2"),
      kind<OffsetPointObservation3, SE3, Vector3, SE3>("OffsetPointObservation3", "SE3, Vector3, SE3"),
      kind<BearingObservation2, SE2, Vector2>("BearingObservation2", "SE2, Vector2"),
      kind<BearingObservation3, SE3, Vector3>("BearingObservation3", "SE3, Vector3"),
      kind<Range, SE2, Vector2>("Range", "SE2, Vector2"),
      kind<Range, SE3, Vector3>("Range", "SE3, Vector3"),
  };
  return kinds;
}

std::string family_of(py::handle edge) {
  const bool is_class = py::isinstance<py::type>(edge);
  const py::handle type = is_class ? edge : py::handle(py::type::handle_of(edge));
  const py::module_ package = py::module_::import("boxplus");
  std::string names;
  for (const EdgeFamily& family : edge_families()) {
    if (type.is(package.attr(family.name))) return family.name;
    names += (names.empty() ? "" : ", ") + std::string(family.name);
  }
  throw_type_error("edge", "one of " + names, edge);
}

const EdgeKind& kind_for(const std::string& family, const Graph& graph, std::span<const VertexRef> vertices) {
  std::string expected, came;
  std::vector<std::type_index> pools;
  for (const VertexRef& vertex : vertices) {
    if (!graph.contains(vertex)) static_cast<void>(graph.id(vertex));  // throws
    const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
    pools.emplace_back(typeid(pool));
    came += (came.empty() ? "" : ", ") + std::string(pool.type_name());
  }
  for (const EdgeKind& kind : edge_kinds()) {
    if (kind.family != family) continue;
    if (kind.pools == pools) return kind;
    expected += (expected.empty() ? "(" : " or (") + std::string(kind.vertices) + ")";
  }
  throw py::type_error(family + ": expected vertices of the types " + expected + ", got (" + came + ")");
}

const EdgeKind& kind_of_edge(const Graph& graph, EdgeRef edge) {
  if (!graph.contains(edge)) static_cast<void>(graph.level(edge));  // throws
  const detail::EdgePool& pool = *graph.edge_pools()[edge.pool];
  for (const EdgeKind& kind : edge_kinds()) {
    if (kind.pool == typeid(pool)) return kind;
  }
  throw py::type_error("edge: expected a type that Python knows, got a " + std::string(pool.type_name()) +
                       ", which has no Python class");
}

}  // namespace boxplus::python
