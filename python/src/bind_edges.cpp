// SPDX-License-Identifier: BSD-3-Clause
// Graph: edges.
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bind.h"
#include "boxplus/robust/default_width.h"
#include "boxplus/robust/make_robust_kernel.h"
#include "constraint_pool.h"
#include "edge_kinds.h"
#include "function_edges.h"

namespace boxplus::python {
namespace {

EdgeRef add_edge(GraphObject& self, py::handle argument, const py::args& vertices, py::handle information) {
  Graph& graph = self.write();
  const std::vector<VertexRef> refs = vertices_of(graph, vertices, "vertices");
  const bool is_constraint = py::isinstance<ConstraintValue>(argument);
  const py::object edge = is_constraint ? argument.cast<const ConstraintValue&>().edge
                                        : py::reinterpret_borrow<py::object>(argument);
  if (is_function(edge)) {
    FunctionEdges edges(graph, edge, refs, py::none(), is_constraint);
    const Informations informations(information, edges.rows(), "information");
    informations.require_count(1);
    return edges.add(0, informations[0], refs);
  }
  const std::string family = family_of(edge);
  if (py::isinstance<py::type>(edge)) throw_type_error("edge", "a " + family + " with its measurement", edge);
  const py::object camera = camera_of(edge);
  const EdgeKind& kind = kind_for(family, graph, refs, camera);
  const Informations informations(information, kind.rows, "information");
  informations.require_count(1);
  const py::object measurement = edge.cast<const EdgeValue&>().measurement;
  const auto add = [&](const EdgePlace& place) {
    return kind.add(place, measurement, camera, informations[0]);
  };
  return is_constraint ? add_constraint(graph, kind, refs, informations[0], add) : add({&graph, refs.data()});
}

/// One edge, or a sequence of edges.
std::vector<EdgeRef> edges_of(py::handle edges) {
  if (py::isinstance<EdgeRef>(edges)) return {edges.cast<EdgeRef>()};
  if (!py::isinstance<py::sequence>(edges)) throw_type_error("edges", "an EdgeRef or a list of them", edges);
  std::vector<EdgeRef> refs;
  for (const py::handle edge : edges) refs.push_back(edge_of(edge, "edges"));
  return refs;
}

void set_kernel(GraphObject& self, py::handle edges, const py::object& kernel, std::optional<double> width) {
  Graph& graph = self.write_kernels();
  const std::vector<EdgeRef> refs = edges_of(edges);
  std::shared_ptr<const RobustKernel> shared;
  const bool is_name = py::isinstance<py::str>(kernel);
  if (is_name && width) {
    shared = make_robust_kernel(kernel.cast<std::string>(), *width);
  } else if (width) {
    throw_type_error("width", "no width unless the kernel is a name", py::float_(*width));
  } else if (!is_name && !kernel.is_none()) {
    if (!py::isinstance<RobustKernel>(kernel))
      throw_type_error("kernel", "a name, a RobustKernel or None", kernel);
    shared = kernel.cast<std::shared_ptr<RobustKernel>>()->clone();
  }
  int rows = 0;
  for (const EdgeRef& edge : refs) {
    if (is_name && !width && graph.information(edge).rows != rows) {
      rows = graph.information(edge).rows;
      shared = make_default_kernel(kernel.cast<std::string>(), rows);
    }
    graph.set_kernel(edge, shared);
  }
}

/// Defines a method of Graph with an edge as its only argument.
template <class Function>
void def_edge(GraphClass& type, const char* name, Function function, const char* doc = "") {
  type.def(
      name,
      [function](const GraphObject& self, const EdgeRef& edge) {
        const Graph& graph = self.read();
        const GraphObject::Reading reading(self);
        const FreshEdge fresh(graph, edge);
        return function(graph, edge);
      },
      py::arg("edge"), doc);
}

void bind_measurements(GraphClass& type) {
  type.def("add_edge", &add_edge, py::arg("edge"), py::kw_only(), py::arg("information") = 1.0,
           "add_edge(Between(z), a, b, information=100): adds an edge. The information Ω is a number or a "
           "symmetric "
           "matrix, the inverse of the covariance of the error. Returns its EdgeRef. The edge may also be a "
           "function "
           "of the estimates that returns the error: a number or an array. Constraint(edge) must be zero "
           "exactly.");
  def_edge(type, "measurement", [](const Graph& graph, EdgeRef edge) {
    if (const ConstraintPool* constraints = constraint_pool_of(graph, edge))
      return constraints->measurement(edge.slot);
    return kind_of_edge(graph, edge).measurement(*graph.edge_pools()[edge.pool], edge.slot);
  });
  type.def(
      "set_measurement",
      [](GraphObject& self, const EdgeRef& edge, py::handle measurement) {
        Graph& graph = self.write();
        if (const ConstraintPool* constraints = constraint_pool_of(graph, edge))
          return const_cast<ConstraintPool*>(constraints)->set_measurement(edge.slot, measurement);
        kind_of_edge(graph, edge).set_measurement(graph, edge, measurement);
      },
      py::arg("edge"), py::arg("measurement"));
  def_edge(type, "information",
           [](const Graph& graph, EdgeRef edge) { return to_array(graph.information(edge).matrix()); });
  type.def(
      "set_information",
      [](GraphObject& self, const EdgeRef& edge, py::handle information) {
        const Informations informations(information, self.read().information(edge).rows, "information");
        informations.require_count(1);
        self.write().set_information(edge, informations[0]);
      },
      py::arg("edge"), py::arg("information"));
  def_edge(
      type, "edge_type",
      [](const Graph& graph, EdgeRef edge) {
        static_cast<void>(graph.level(edge));  // throws if there is no such edge
        return std::string(graph.edge_pools()[edge.pool]->type_name());
      },
      "The name of the type: \"Between<SE2>\".");
  def_edge(type, "vertices", [](const Graph& graph, EdgeRef edge) { return graph.vertices(edge); });
  type.def(
      "edges",
      [](const GraphObject& self, py::handle vertex) {
        return self.read().edges(vertex_of(self.read(), vertex, "vertex"));
      },
      py::arg("vertex"), "The edges that use a vertex.");
}

void bind_weights(GraphClass& type) {
  type.def(
      "set_kernel", &set_kernel, py::arg("edges"), py::arg("kernel"), py::arg("width") = py::none(),
      "Sets the robust kernel of an edge or of a list of edges: a RobustKernel, the name of one, or None. If "
      "no width is given, a named kernel has the default width for the rows of each edge.");
  def_edge(type, "kernel", [](const Graph& graph, EdgeRef edge) -> std::shared_ptr<RobustKernel> {
    const RobustKernel* kernel = graph.kernel(edge);
    return kernel == nullptr ? nullptr : std::shared_ptr<RobustKernel>(kernel->clone());
  });
  type.def(
      "set_enabled",
      [](GraphObject& self, const EdgeRef& edge, bool enabled) { self.write().set_enabled(edge, enabled); },
      py::arg("edge"), py::arg("enabled"));
  type.def(
      "set_level",
      [](GraphObject& self, const EdgeRef& edge, int level) { self.write().set_level(edge, level); },
      py::arg("edge"), py::arg("level"));
  def_edge(type, "is_enabled", [](const Graph& graph, EdgeRef edge) { return graph.is_enabled(edge); });
  def_edge(type, "level", [](const Graph& graph, EdgeRef edge) { return graph.level(edge); });
  def_edge(type, "weight", [](const Graph& graph, EdgeRef edge) { return graph.weight(edge); });
  def_edge(type, "error", [](const Graph& graph, EdgeRef edge) { return to_array(graph.error(edge)); });
  def_edge(
      type, "jacobian",
      [](const Graph& graph, EdgeRef edge) {
        std::vector<Numbers> blocks;
        for (const Eigen::MatrixXd& block : graph.jacobian(edge)) blocks.push_back(to_array(block));
        return blocks;
      },
      "One block per vertex.");
  def_edge(
      type, "chi2", [](const Graph& graph, EdgeRef edge) { return graph.chi2(edge); },
      "eᵀΩe of an edge, without its kernel.");
  type.def(
      "chi2",
      [](const GraphObject& self) {
        const Graph& graph = self.read();
        const GraphObject::Reading reading(self);
        forget_results(graph);
        return graph.chi2();
      },
      "Σ ρ(eᵀΩe) over all enabled edges.");
}

}  // namespace

void bind_edges(GraphClass& type) {
  bind_measurements(type);
  bind_weights(type);
  type.def(
      "contains",
      [](const GraphObject& self, py::handle element) {
        if (py::isinstance<EdgeRef>(element)) return self.read().contains(element.cast<EdgeRef>());
        if (py::isinstance<VertexRef>(element)) return self.read().contains(element.cast<VertexRef>());
        return self.read().find_vertex(read_integer(element, "element")).has_value();
      },
      py::arg("element"),
      "True if an EdgeRef, a VertexRef or the id of a vertex names an element of this graph.");
  type.def(
      "remove",
      [](GraphObject& self, py::handle element) {
        if (py::isinstance<EdgeRef>(element)) return self.write().remove(element.cast<EdgeRef>());
        self.write().remove(vertex_of(self.read(), element, "element"));
      },
      py::arg("element"), "Removes an edge, or a vertex and every edge that uses it.");
}

}  // namespace boxplus::python
