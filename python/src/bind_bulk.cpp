// SPDX-License-Identifier: BSD-3-Clause
// Graph: many vertices or edges at a time, as arrays. All arguments are checked
// before the graph changes; if a function throws, the graph is as before.
#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "bind.h"
#include "constraint_pool.h"
#include "edge_kinds.h"
#include "function_edges.h"
#include "vertex_kinds.h"

namespace boxplus::python {
namespace {

/// Removes the edges that a function has added, unless it comes to its end.
class AddedEdges {
 public:
  AddedEdges(Graph& graph, std::size_t count) : graph_(&graph) { edges_.reserve(count); }
  ~AddedEdges() {
    for (auto edge = edges_.rbegin(); edge != edges_.rend(); ++edge) graph_->remove(*edge);
  }
  AddedEdges(const AddedEdges&) = delete;
  AddedEdges& operator=(const AddedEdges&) = delete;
  void push_back(const EdgeRef& edge) { edges_.push_back(edge); }
  /// Reserves memory for a total of `count` added edges; there must be one.
  void reserve(std::size_t count) {
    const EdgeRef& first = edges_.front();
    graph_->reserve_edges(first, graph_->edge_pools()[first.pool]->alive_count() - 1 + count);
  }
  std::vector<EdgeRef> keep() { return std::exchange(edges_, {}); }

 private:
  Graph* graph_;
  std::vector<EdgeRef> edges_;
};

void require_equal(std::size_t came, std::size_t expected, const std::string& name, const std::string& like) {
  if (came == expected) return;
  throw py::value_error(name + ": expected as many rows as " + like + " (" + std::to_string(expected) +
                        "), got " + std::to_string(came));
}

/// Rows of numbers, each of which is an estimate.
class Estimates {
 public:
  Estimates(py::handle estimates, const VertexKind& kind)
      : rows_(read_rows(estimates, kind.size, "estimates", kind.layout)),
        size_(static_cast<std::size_t>(kind.size)) {
    for (std::size_t i = 0; i < count(); ++i) kind.check_row(row(i), {"estimates", i});
  }
  std::size_t count() const { return static_cast<std::size_t>(rows_.shape(0)); }
  const double* row(std::size_t i) const { return rows_.data() + i * size_; }

 private:
  Numbers rows_;
  std::size_t size_;
};

/// Throws InvalidArgument if an id is taken or appears twice.
void require_new(const Graph& graph, const std::vector<Id>& ids) {
  std::unordered_set<Id> seen;
  seen.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (graph.find_vertex(ids[i]) || !seen.insert(ids[i]).second)
      throw InvalidArgument(RowName{"ids", i}.text() + ": expected a new id, got " + std::to_string(ids[i]) +
                            ", which is taken");
  }
}

py::array_t<Id> add_vertices(GraphObject& self, py::handle type, py::handle ids, py::handle estimates) {
  Graph& graph = self.write();
  const VertexKind& kind = kind_of_class(type, "type");
  const Estimates rows(estimates, kind);
  std::vector<Id> chosen;
  if (!ids.is_none()) {
    chosen = read_ids(ids, "ids");
    require_equal(rows.count(), chosen.size(), "estimates", "ids");
    require_new(graph, chosen);
  }
  py::array_t<Id> result(static_cast<py::ssize_t>(rows.count()));
  Id* out = result.mutable_data();
  for (std::size_t i = 0; i < rows.count(); ++i) {
    const std::optional<Id> id = chosen.empty() ? std::nullopt : std::optional(chosen[i]);
    *out++ = graph.id(kind.add_row(graph, rows.row(i), id));
  }
  return result;
}

std::pair<py::array_t<Id>, Numbers> estimates(const GraphObject& self, py::handle type) {
  const Graph& graph = self.read();
  const VertexKind& kind = kind_of_class(type, "type");
  std::vector<std::pair<Id, VertexRef>> found;
  if (const detail::VertexPool* pool = pool_of_kind(graph, kind)) {
    const std::uint32_t index = pool_index_of_kind(graph, kind);
    for (std::uint32_t slot = 0; slot < pool->slots(); ++slot) {
      if (pool->alive(slot) && !pool->parameter(slot))
        found.emplace_back(pool->id(slot), VertexRef{index, slot, pool->generation(slot)});
    }
  }
  std::sort(found.begin(), found.end());
  const auto count = static_cast<py::ssize_t>(found.size());
  py::array_t<Id> ids(count);
  Numbers rows({count, static_cast<py::ssize_t>(kind.size)});
  Id* id = ids.mutable_data();
  double* row = rows.mutable_data();
  for (const auto& [name, vertex] : found) {
    *id++ = name;
    kind.get_row(graph, vertex, row);
    row += kind.size;
  }
  return {ids, rows};
}

/// The vertices of an array of ids, or of a list with VertexRefs.
std::vector<VertexRef> vertices_of_array(const Graph& graph, py::handle vertices, const std::string& name) {
  const py::array array = py::array::ensure(vertices);
  std::vector<VertexRef> refs;
  if (array && array.ndim() == 1 && array.dtype().kind() == 'O') {
    refs = vertices_of(graph, array, name);
    for (std::size_t i = 0; i < refs.size(); ++i) {
      if (!graph.contains(refs[i]))
        throw InvalidArgument(RowName{name, i}.text() + ": expected a vertex of this graph");
    }
    return refs;
  }
  const std::vector<Id> ids = read_ids(vertices, name);
  refs.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::optional<VertexRef> found = graph.find_vertex(ids[i]);
    if (!found)
      throw InvalidArgument(RowName{name, i}.text() + ": there is no vertex with the id " +
                            std::to_string(ids[i]));
    refs.push_back(*found);
  }
  return refs;
}

/// The vertices of many edges at one place: an array of vertices, or one vertex for all edges.
class Column {
 public:
  Column(const Graph& graph, py::handle vertices, const std::string& name) {
    is_shared_ = py::isinstance<VertexRef>(vertices) || is_integer(vertices);
    refs_ =
        is_shared_ ? std::vector{vertex_of(graph, vertices, name)} : vertices_of_array(graph, vertices, name);
  }
  bool fits(std::size_t count) const { return is_shared_ || refs_.size() == count; }
  std::size_t size() const { return refs_.size(); }
  const VertexRef& operator[](std::size_t i) const { return refs_[is_shared_ ? 0 : i]; }

 private:
  std::vector<VertexRef> refs_;
  bool is_shared_;
};

void set_estimates(GraphObject& self, py::handle type, py::handle ids, py::handle estimates) {
  Graph& graph = self.write();
  const VertexKind& kind = kind_of_class(type, "type");
  const Estimates rows(estimates, kind);
  const std::vector<VertexRef> vertices = vertices_of_array(graph, ids, "ids");
  require_equal(rows.count(), vertices.size(), "estimates", "ids");
  const std::uint32_t pool = pool_index_of_kind(graph, kind);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i].pool != pool)
      throw py::type_error(RowName{"ids", i}.text() + ": expected a vertex of the type " +
                           std::string(kind.name) + ", got vertex " + std::to_string(graph.id(vertices[i])) +
                           " of another type");
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) kind.set_row(graph, vertices[i], rows.row(i));
}

/// The vertices of many edges.
class Columns {
 public:
  Columns(const Graph& graph, const py::args& vertices, std::size_t edges) : refs_(vertices.size()) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const std::string name = RowName{"vertices", i}.text();
      columns_.emplace_back(graph, vertices[i], name);
      if (!columns_.back().fits(edges)) require_equal(columns_.back().size(), edges, name, "measurements");
    }
  }
  /// The vertices of an edge, until the next call.
  std::span<const VertexRef> of_edge(std::size_t edge) {
    for (std::size_t i = 0; i < refs_.size(); ++i) refs_[i] = columns_[i][edge];
    return refs_;
  }
  /// Throws TypeError if the vertices of an edge have other types than those of the first edge.
  void require_same_types(const Graph& graph, std::size_t edges) const {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      for (std::size_t edge = 1; edge < edges; ++edge) {
        if (columns_[i][edge].pool == columns_[i][0].pool) continue;
        const auto type = [&](std::size_t k) {
          return std::string(graph.vertex_pools()[columns_[i][k].pool]->type_name());
        };
        throw py::type_error(RowName{"vertices", i}.text() + ": expected vertices of one type, got " +
                             type(0) + " at [0] and " + type(edge) + " at [" + std::to_string(edge) + "]");
      }
    }
  }

 private:
  std::vector<Column> columns_;
  std::vector<VertexRef> refs_;
};

/// Adds edges with add(edge), one after the other, and returns their EdgeRefs.
template <class Add>
py::list add_all(Graph& graph, std::size_t count, const Add& add) {
  AddedEdges added(graph, count);
  for (std::size_t edge = 0; edge < count; ++edge) {
    try {
      added.push_back(add(edge));
    } catch (const InvalidArgument& error) {
      throw InvalidArgument("edge " + std::to_string(edge) + " of the arrays: " + error.what());
    }
    if (edge == 0) added.reserve(count);
  }
  py::list edges(count);
  std::size_t i = 0;
  for (const EdgeRef& edge : added.keep()) edges[i++] = py::cast(edge);
  return edges;
}

/// The number of edges: that of the measurements or, without measurements, of the longest array of vertices.
std::size_t count_edges(const Graph& graph, const py::args& vertices, py::handle measurements) {
  if (!measurements.is_none()) {
    const Numbers numbers = read_numbers(measurements, "measurements");
    if (numbers.ndim() == 0) throw_value_error("measurements", "an array with a row per edge", measurements);
    return static_cast<std::size_t>(numbers.shape(0));
  }
  std::size_t count = vertices.empty() ? 0 : 1;
  for (const py::handle column : vertices) {
    if (!py::isinstance<VertexRef>(column) && !is_integer(column))
      return vertices_of_array(graph, column, "vertices").size();
  }
  return count;
}

py::list add_function_edges(Graph& graph, const py::object& edge, const py::args& vertices,
                            const py::object& measurements, py::handle informations, bool is_constraint) {
  const std::size_t count = count_edges(graph, vertices, measurements);
  Columns columns(graph, vertices, count);
  if (count == 0) return py::list();
  columns.require_same_types(graph, count);
  FunctionEdges edges(graph, edge, columns.of_edge(0), measurements, is_constraint);
  const Informations omegas(informations, edges.rows(), "informations");
  omegas.require_count(count);
  return add_all(graph, count, [&](std::size_t k) { return edges.add(k, omegas[k], columns.of_edge(k)); });
}

py::list add_edges(GraphObject& self, py::handle argument, const py::args& vertices,
                   const py::object& measurements, py::handle informations, py::handle camera) {
  Graph& graph = self.write();
  const bool is_constraint = py::isinstance<ConstraintValue>(argument);
  const py::object type = is_constraint ? argument.cast<const ConstraintValue&>().edge
                                        : py::reinterpret_borrow<py::object>(argument);
  if (is_batched_function(type)) {
    if (!camera.is_none())
      throw_type_error("camera", "None, because an error function takes no camera", camera);
    return add_function_edges(graph, type, vertices, measurements, informations, is_constraint);
  }
  const std::string family = family_of(type);
  if (!py::isinstance<py::type>(type)) throw_type_error("type", "the class " + family, type);
  const Numbers numbers = read_numbers(measurements, "measurements");
  if (numbers.ndim() == 0) throw_value_error("measurements", "an array with a row per edge", measurements);
  const auto count = static_cast<std::size_t>(numbers.shape(0));
  Columns columns(graph, vertices, count);
  if (count == 0) return py::list();

  const EdgeKind& kind = kind_for(family, graph, columns.of_edge(0), camera);
  columns.require_same_types(graph, count);
  const Numbers rows = read_rows(numbers, kind.size, "measurements", kind.layout);
  const Informations omegas(informations, kind.rows, "informations");
  omegas.require_count(count);

  return add_all(graph, count, [&](std::size_t edge) {
    const double* row = rows.data() + edge * static_cast<std::size_t>(kind.size);
    const std::span<const VertexRef> refs = columns.of_edge(edge);
    const Information omega = omegas[edge];
    const auto add = [&](const EdgePlace& place) {
      return kind.add_row(place, row, {"measurements", edge}, camera, omega);
    };
    return is_constraint ? add_constraint(graph, kind, refs, omega, add) : add({&graph, refs.data()});
  });
}

}  // namespace

void bind_bulk(GraphClass& type) {
  type.def("add_vertices", &add_vertices, py::arg("type"), py::arg("ids"), py::arg("estimates"),
           "add_vertices(SE2, ids, array): adds a vertex per row. If ids is None, the vertices get the next "
           "free "
           "ids. Returns the ids.")
      .def("estimates", &estimates, py::arg("type"),
           "The ids of all vertices of a type, ascending, and their estimates, one per row.")
      .def("set_estimates", &set_estimates, py::arg("type"), py::arg("ids"), py::arg("estimates"))
      .def("add_edges", &add_edges, py::arg("type"), py::kw_only(), py::arg("measurements") = py::none(),
           py::arg("informations") = 1.0, py::arg("camera") = py::none(),
           "add_edges(Between, i, j, measurements=z, informations=omega): adds an edge per row of the "
           "measurements. "
           "The vertices are arrays of ids, lists of VertexRefs, or one vertex for all edges. The "
           "informations are a number or a "
           "matrix "
           "for all edges, or an array of numbers (n,) or of matrices (n, d, d). Returns the list of "
           "EdgeRefs. Instead of a class, the first argument may be an error function: an object with a "
           "method "
           "error(estimates..., measurements) that computes the errors of all edges at once (BatchedEdge). "
           "Constraint(type) makes constraints. camera: the known camera of all edges "
           "CalibratedReprojection.");
}

}  // namespace boxplus::python
