// SPDX-License-Identifier: BSD-3-Clause
#include "vertex_kinds.h"

#include <string>
#include <typeinfo>

#include "boxplus/autodiff/dual.h"
#include "boxplus/autodiff/dual_eigen.h"
#include "boxplus/graph/differentiate.h"
#include "boxplus/types/vertex_pools.h"
#include "graph_object.h"
#include "values.h"

namespace boxplus::python {
namespace {

template <class T>
void step_derivative(const double* row, double* out) {
  constexpr int kDim = Manifold<T>::kDim;
  using Dual = detail::Dual<double, kDim>;
  const auto moved = detail::lift<Dual>(Value<T>::from_row(row, {}), 0, 0);
  for (int i = 0; i < Value<T>::kSize; ++i) {
    for (int k = 0; k < kDim; ++k) *out++ = moved.data()[i].derivative[static_cast<std::size_t>(k)];
  }
}

template <class T>
VertexKind kind() {
  using V = Value<T>;
  static_assert(V::kSize <= int{kMostNumbers});
  return {
      .name = V::kName,
      .layout = V::kLayout,
      .size = V::kSize,
      .dim = Manifold<T>::kDim,
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
      .set_row = [](Graph& graph, VertexRef vertex,
                    const double* row) { graph.set_estimate(VertexHandle<T>{vertex}, V::from_row(row, {})); },
      .read =
          [](const detail::VertexPool& pool, std::uint32_t slot, double* row) {
            const T& x = static_cast<const detail::TypedVertexPool<T>&>(pool).value(slot);
            if constexpr (std::is_same_v<T, SE3>) {  // quaternions from files have rounded digits
              V::to_row(SE3(x.translation(), x.quaternion()), row);
            } else {
              V::to_row(x, row);
            }
          },
      .step = [](const double* row, const double* delta,
                 double* out) { V::to_row(Manifold<T>::oplus(V::from_row(row, {}), delta), out); },
      .step_derivative = &step_derivative<T>,
      .object_of_row = [](const double* row) { return V::to_python(V::from_row(row, {})); },
  };
}

}  // namespace

std::span<const VertexKind> vertex_kinds() {
  static const VertexKind kinds[] = {kind<SE2>(),
                                     kind<SE3>(),
                                     kind<Vector2>(),
                                     kind<Vector3>(),
                                     kind<Vector<double, 1>>(),
                                     kind<Vector<double, 4>>(),
                                     kind<Vector<double, 5>>(),
                                     kind<Vector<double, 6>>(),
                                     kind<Vector<double, 7>>(),
                                     kind<Vector<double, 8>>(),
                                     kind<Vector<double, 9>>(),
                                     kind<Vector<double, 10>>(),
                                     kind<Vector<double, 11>>(),
                                     kind<Vector<double, 12>>()};
  return kinds;
}

std::string vertex_kind_names() {
  std::string names;
  for (const VertexKind& kind : vertex_kinds()) names += (names.empty() ? "" : ", ") + std::string(kind.name);
  return names;
}

const VertexKind& kind_of_estimate(py::handle estimate) {
  for (const VertexKind& kind : vertex_kinds()) {
    if (kind.is(estimate)) return kind;
  }
  throw_type_error("estimate", "one of " + vertex_kind_names() + " (vectors are arrays of 1 to 12 numbers)",
                   estimate);
}

const VertexKind& kind_of_class(py::handle type, std::string_view name) {
  const py::module_ package = py::module_::import("boxplus");
  for (const VertexKind& kind : vertex_kinds()) {
    if (type.is(package.attr(std::string(kind.name).c_str()))) return kind;
  }
  throw_type_error(name, "one of the classes " + vertex_kind_names(), type);
}

const VertexKind& kind_of_vertex(const Graph& graph, VertexRef vertex) {
  if (!graph.contains(vertex)) static_cast<void>(graph.id(vertex));  // throws
  const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  for (const VertexKind& kind : vertex_kinds()) {
    if (kind.pool == typeid(pool)) return kind;
  }
  throw py::type_error("vertex " + std::to_string(graph.id(vertex)) + ": expected one of the types " +
                       vertex_kind_names() + ", got a " + std::string(pool.type_name()) +
                       ", which has no Python class");
}

std::uint32_t pool_index_of_kind(const Graph& graph, const VertexKind& kind) {
  const auto pools = graph.vertex_pools();
  std::uint32_t index = 0;
  for (; index < pools.size(); ++index) {
    const detail::VertexPool& pool = *pools[index];
    if (kind.pool == typeid(pool)) break;
  }
  return index;
}

const detail::VertexPool* pool_of_kind(const Graph& graph, const VertexKind& kind) {
  const std::uint32_t index = pool_index_of_kind(graph, kind);
  return index < graph.vertex_pools().size() ? graph.vertex_pools()[index].get() : nullptr;
}

VertexRef vertex_of(const Graph& graph, py::handle vertex, std::string_view name) {
  if (py::isinstance<VertexRef>(vertex)) return vertex.cast<VertexRef>();
  if (!is_integer(vertex)) throw_type_error(name, "a VertexRef or the id of a vertex", vertex);
  const Id id = read_integer(vertex, name);
  const std::optional<VertexRef> found = graph.find_vertex(id);
  if (!found)
    throw InvalidArgument(std::string(name) + ": there is no vertex with the id " + std::to_string(id));
  return *found;
}

std::vector<VertexRef> vertices_of(const Graph& graph, py::handle vertices, std::string_view name) {
  if (!py::isinstance<py::sequence>(vertices) && !py::isinstance<py::array>(vertices))
    throw_type_error(name, "a list of VertexRefs or ids", vertices);
  std::vector<VertexRef> refs;
  for (const py::handle vertex : vertices)
    refs.push_back(vertex_of(graph, vertex, RowName{name, refs.size()}.text()));
  return refs;
}

EdgeRef edge_of(py::handle edge, std::string_view name) {
  if (!py::isinstance<EdgeRef>(edge)) throw_type_error(name, "an EdgeRef", edge);
  return edge.cast<EdgeRef>();
}

}  // namespace boxplus::python
