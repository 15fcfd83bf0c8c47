// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eval.h>

#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

#include "graph_object.h"
#include "vertex_kind.h"
#include "vertex_kinds.h"

namespace boxplus::python {
namespace {

/// Points, which are the most frequent, are first.
template <int... I>
std::vector<VertexKind> vector_kinds(std::integer_sequence<int, I...>) {
  return {vertex_kind<Vector2>(), vertex_kind<Vector3>(), vertex_kind<Vector<double, 1>>(),
          vertex_kind<Vector<double, I + 4>>()...};
}

void append(const std::vector<VertexKind>& kinds, std::vector<VertexKind>& all) {
  all.insert(all.end(), kinds.begin(), kinds.end());
}

}  // namespace

std::span<const VertexKind> vertex_kinds() {
  static const auto kinds = [] {
    std::vector<VertexKind> all{vertex_kind<SE2>(),    vertex_kind<SE3>(),  vertex_kind<SO2>(),
                                vertex_kind<SO3>(),    vertex_kind<S2>(),   vertex_kind<Sim3>(),
                                vertex_kind<Plane3>(), vertex_kind<Line3>()};
    append(camera_vertex_kinds(), all);
    append(product_vertex_kinds(), all);
    append(vector_kinds(std::make_integer_sequence<int, int{kMostNumbersOfVector} - 3>()),
           all);  // any list is a vector
    return all;
  }();
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
  const bool is_class = py::isinstance<py::type>(type), is_tuple = py::isinstance<py::tuple>(type);
  const py::dict names = py::module_::import("boxplus").attr("__dict__");
  for (const VertexKind& kind : vertex_kinds()) {
    if (!(kind.is_tuple ? is_tuple : is_class)) continue;
    const std::string text(kind.name);  // "SE3", "(SE3, BalCamera)"
    if (kind.is_tuple ? type.equal(py::eval(text, names)) : type.is(names[text.c_str()])) return kind;
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
