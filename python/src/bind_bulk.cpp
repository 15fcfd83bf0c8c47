// SPDX-License-Identifier: BSD-3-Clause
// Graph: many vertices or edges at a time, as arrays. If a function throws, the graph is as before.
#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "bind.h"
#include "edge_kinds.h"
#include "vertex_kinds.h"

namespace boxplus::python {
namespace {

/// Removes the elements that a function has added, unless it comes to its end.
template <class Ref>
class Added {
 public:
  explicit Added(Graph& graph, std::size_t count) : graph_(&graph) { refs_.reserve(count); }
  ~Added() {
    for (auto ref = refs_.rbegin(); ref != refs_.rend(); ++ref) graph_->remove(*ref);
  }
  Added(const Added&) = delete;
  Added& operator=(const Added&) = delete;
  void push_back(const Ref& ref) { refs_.push_back(ref); }
  const Ref& front() const { return refs_.front(); }
  std::vector<Ref> keep() { return std::exchange(refs_, {}); }

 private:
  Graph* graph_;
  std::vector<Ref> refs_;
};

void require_equal(std::size_t came, std::size_t expected, const std::string& name, const std::string& like) {
  if (came == expected) return;
  throw py::value_error(name + ": expected as many rows as " + like + " (" + std::to_string(expected) +
                        "), got " + std::to_string(came));
}

/// "measurements[3]"
std::string row_name(const char* name, std::size_t row) {
  return std::string(name) + "[" + std::to_string(row) + "]";
}

py::array_t<Id> add_vertices(GraphObject& self, py::handle type, py::handle ids, py::handle estimates) {
  Graph& graph = self.write();
  const VertexKind& kind = kind_of_class(type, "type");
  const Numbers rows = read_rows(estimates, kind.size, "estimates", kind.layout);
  const auto count = static_cast<std::size_t>(rows.shape(0));
  std::vector<Id> chosen;
  if (!ids.is_none()) {
    chosen = read_ids(ids, "ids");
    require_equal(count, chosen.size(), "estimates", "ids");
  }
  Added<VertexRef> added(graph, count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* row = rows.data() + i * static_cast<std::size_t>(kind.size);
    const std::optional<Id> id = chosen.empty() ? std::nullopt : std::optional(chosen[i]);
    added.push_back(kind.add_row(graph, row, id, "estimates"));
  }
  std::vector<Id> names;
  names.reserve(count);
  for (const VertexRef& vertex : added.keep()) names.push_back(graph.id(vertex));
  return to_array(names);
}

py::tuple estimates(const GraphObject& self, py::handle type) {
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
  return py::make_tuple(ids, rows);
}

void set_estimates(GraphObject& self, py::handle type, py::handle ids, py::handle estimates) {
  Graph& graph = self.write();
  const VertexKind& kind = kind_of_class(type, "type");
  const Numbers rows = read_rows(estimates, kind.size, "estimates", kind.layout);
  const std::vector<Id> names = read_ids(ids, "ids");
  require_equal(static_cast<std::size_t>(rows.shape(0)), names.size(), "estimates", "ids");
  std::vector<VertexRef> vertices;
  for (std::size_t i = 0; i < names.size(); ++i) {
    vertices.push_back(vertex_of(graph, py::int_(names[i]), row_name("ids", i)));
    if (&kind_of_vertex(graph, vertices.back()) != &kind)
      throw py::type_error(row_name("ids", i) + ": expected a vertex of the type " + std::string(kind.name) +
                           ", got vertex " + std::to_string(names[i]) + " of another type");
  }
  graph.push(vertices);
  try {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      kind.set_row(graph, vertices[i], rows.data() + i * static_cast<std::size_t>(kind.size), "estimates");
  } catch (...) {
    graph.pop();
    throw;
  }
  graph.discard_top();
}

/// The vertices of many edges at one place: an array of ids, or one vertex for all edges.
class Column {
 public:
  Column(const Graph& graph, py::handle vertices, const std::string& name) {
    is_shared_ = py::isinstance<VertexRef>(vertices) || is_integer(vertices);
    if (is_shared_) {
      refs_.push_back(vertex_of(graph, vertices, name));
      return;
    }
    const std::vector<Id> ids = read_ids(vertices, name);
    refs_.reserve(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const std::optional<VertexRef> found = graph.find_vertex(ids[i]);
      if (!found)
        throw InvalidArgument(row_name(name.c_str(), i) + ": there is no vertex with the id " +
                              std::to_string(ids[i]));
      refs_.push_back(*found);
    }
  }
  bool fits(std::size_t count) const { return is_shared_ || refs_.size() == count; }
  std::size_t size() const { return refs_.size(); }
  const VertexRef& operator[](std::size_t i) const { return refs_[is_shared_ ? 0 : i]; }

 private:
  std::vector<VertexRef> refs_;
  bool is_shared_;
};

py::list add_edges(GraphObject& self, py::handle type, const py::args& vertices, py::handle measurements,
                   py::handle informations) {
  Graph& graph = self.write();
  const std::string family = family_of(type);
  if (!py::isinstance<py::type>(type)) throw_type_error("type", "the class " + family, type);
  std::vector<Column> columns;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    columns.emplace_back(graph, vertices[i], row_name("vertices", i));
  const auto count = static_cast<std::size_t>(py::len(measurements));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!columns[i].fits(count))
      require_equal(columns[i].size(), count, row_name("vertices", i), "measurements");
  }
  if (count == 0) return py::list();

  std::vector<VertexRef> refs(columns.size());
  const auto gather = [&](std::size_t edge) {
    for (std::size_t i = 0; i < columns.size(); ++i) refs[i] = columns[i][edge];
  };
  gather(0);
  const EdgeKind& kind = kind_for(family, graph, refs);
  const std::vector<VertexRef> first = refs;
  const Numbers rows = read_rows(measurements, kind.size, "measurements", kind.layout);
  const Informations omegas(informations, kind.rows, "informations");
  omegas.require_count(count);

  Added<EdgeRef> added(graph, count);
  for (std::size_t edge = 0; edge < count; ++edge) {
    gather(edge);
    for (std::size_t i = 0; i < refs.size(); ++i) {
      if (refs[i].pool != first[i].pool)
        kind_for(family, graph, refs);  // throws, or there is a kind for these types
    }
    const bool same = std::equal(refs.begin(), refs.end(), first.begin(),
                                 [](const VertexRef& a, const VertexRef& b) { return a.pool == b.pool; });
    if (!same)
      throw py::type_error(row_name("vertices", edge) + ": expected vertices of the same types in all edges");
    try {
      added.push_back(kind.add_row(graph, rows.data() + edge * static_cast<std::size_t>(kind.size),
                                   omegas[edge], refs.data()));
    } catch (const InvalidArgument& error) {
      throw InvalidArgument("edge " + std::to_string(edge) + " of the arrays: " + error.what());
    }
    if (edge == 0)
      graph.reserve_edges(added.front(), count + graph.edge_pools()[added.front().pool]->alive_count());
  }
  py::list edges(count);
  std::size_t i = 0;
  for (const EdgeRef& edge : added.keep()) edges[i++] = py::cast(edge);
  return edges;
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
      .def("add_edges", &add_edges, py::arg("type"), py::kw_only(), py::arg("measurements"),
           py::arg("informations") = 1.0,
           "add_edges(Between, i, j, measurements=z, informations=omega): adds an edge per row of the "
           "measurements. "
           "The vertices are arrays of ids, or one vertex for all edges. The informations are a number or a "
           "matrix "
           "for all edges, or an array of numbers (n,) or of matrices (n, d, d). Returns the list of "
           "EdgeRefs.");
}

}  // namespace boxplus::python
