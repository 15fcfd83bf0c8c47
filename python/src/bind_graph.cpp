// SPDX-License-Identifier: BSD-3-Clause
// Graph: vertices, copies and state.
#include <pybind11/stl.h>

#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "bind.h"
#include "convert.h"
#include "vertex_kinds.h"

namespace boxplus::python {
namespace {

std::optional<Id> read_id(py::handle id) {
  if (id.is_none()) return std::nullopt;
  return read_integer(id, "id");
}

/// VertexRef and EdgeRef.
template <class Ref>
void bind_ref(py::module_& module, const char* name, const char* doc) {
  py::class_<Ref>(module, name, doc)
      .def_readonly("pool", &Ref::pool)
      .def_readonly("slot", &Ref::slot)
      .def_readonly("generation", &Ref::generation)
      .def(
          "__eq__", [](const Ref& a, const Ref& b) { return a == b; }, py::is_operator())
      .def(
          "__lt__", [](const Ref& a, const Ref& b) { return a < b; }, py::is_operator())
      .def("__hash__",
           [](const Ref& ref) { return py::hash(py::make_tuple(ref.pool, ref.slot, ref.generation)); })
      .def("__repr__", [name](const Ref& ref) {
        return std::string(name) + "(pool=" + std::to_string(ref.pool) +
               ", slot=" + std::to_string(ref.slot) + ")";
      });
}

void bind_estimates(GraphClass& type) {
  type.def(
          "add_vertex",
          [](GraphObject& self, py::handle estimate, py::handle id) {
            return kind_of_estimate(estimate).add(self.write(), estimate, read_id(id), false);
          },
          py::arg("estimate"), py::arg("id") = py::none(),
          "Adds a vertex: an SE2, an SE3, or a point (an array of 2 or 3 numbers). If no id is given, the "
          "vertex "
          "gets the next free id. Returns its VertexRef.")
      .def(
          "add_parameter",
          [](GraphObject& self, py::handle value, py::handle id) {
            return kind_of_estimate(value).add(self.write(), value, read_id(id), true);
          },
          py::arg("value"), py::arg("id") = py::none(),
          "Adds a shared constant, such as a sensor offset: a fixed vertex that has an id of its own kind.")
      .def(
          "vertex", [](const GraphObject& self, py::handle id) { return vertex_of(self.read(), id, "id"); },
          py::arg("id"), "The vertex with that id.")
      .def(
          "find_vertex", [](const GraphObject& self, Id id) { return self.read().find_vertex(id); },
          py::arg("id"), "The vertex with that id, or None.")
      .def(
          "find_parameter", [](const GraphObject& self, Id id) { return self.read().find_parameter(id); },
          py::arg("id"), "The parameter with that id, or None.")
      .def(
          "estimate",
          [](const GraphObject& self, py::handle vertex) {
            const VertexRef ref = vertex_of(self.read(), vertex, "vertex");
            return kind_of_vertex(self.read(), ref).estimate(self.read(), ref);
          },
          py::arg("vertex"), "A copy of the estimate.")
      .def(
          "set_estimate",
          [](GraphObject& self, py::handle vertex, py::handle estimate) {
            const VertexRef ref = vertex_of(self.read(), vertex, "vertex");
            kind_of_vertex(self.read(), ref).set_estimate(self.write(), ref, estimate);
          },
          py::arg("vertex"), py::arg("estimate"));
}

/// Defines a method of Graph with a vertex as its only argument.
template <class Result>
void def_vertex(GraphClass& type, const char* name, Result (Graph::*method)(VertexRef) const) {
  type.def(
      name,
      [method](const GraphObject& self, py::handle vertex) {
        return (self.read().*method)(vertex_of(self.read(), vertex, "vertex"));
      },
      py::arg("vertex"));
}
void def_vertex(GraphClass& type, const char* name, void (Graph::*method)(VertexRef)) {
  type.def(
      name,
      [method](GraphObject& self, py::handle vertex) {
        (self.write().*method)(vertex_of(self.read(), vertex, "vertex"));
      },
      py::arg("vertex"));
}
void def_flag(GraphClass& type, const char* name, const char* flag, void (Graph::*method)(VertexRef, bool)) {
  type.def(
      name,
      [method](GraphObject& self, py::handle vertex, bool on) {
        (self.write().*method)(vertex_of(self.read(), vertex, "vertex"), on);
      },
      py::arg("vertex"), py::arg(flag));
}

void bind_vertices(GraphClass& type) {
  def_vertex(type, "id", &Graph::id);
  def_vertex(type, "tangent_dim", &Graph::tangent_dim);
  def_vertex(type, "is_fixed", &Graph::is_fixed);
  def_vertex(type, "is_eliminated", &Graph::is_eliminated);
  def_vertex(type, "fix", &Graph::fix);
  def_vertex(type, "unfix", &Graph::unfix);
  def_flag(type, "set_fixed", "fixed", &Graph::set_fixed);
  def_flag(type, "set_eliminated", "eliminated", &Graph::set_eliminated);
  type.def(
          "change_id",
          [](GraphObject& self, py::handle vertex, py::handle new_id) {
            self.write().change_id(vertex_of(self.read(), vertex, "vertex"), read_integer(new_id, "new_id"));
          },
          py::arg("vertex"), py::arg("new_id"))
      .def(
          "fix_directions",
          [](GraphObject& self, py::handle vertex, py::handle directions) {
            self.write().fix_directions(vertex_of(self.read(), vertex, "vertex"),
                                        read_ints(directions, "directions"));
          },
          py::arg("vertex"), py::arg("directions"), "Fixes directions of the tangent space, numbered from 0.")
      .def(
          "fixed_directions",
          [](const GraphObject& self, py::handle vertex) {
            const auto directions = self.read().fixed_directions(vertex_of(self.read(), vertex, "vertex"));
            return std::vector<int>(directions.begin(), directions.end());
          },
          py::arg("vertex"))
      .def(
          "set_bounds",
          [](GraphObject& self, py::handle vertex, int entry, double lower, double upper) {
            self.write().set_bounds(vertex_of(self.read(), vertex, "vertex"), entry, lower, upper);
          },
          py::arg("vertex"), py::arg("entry"), py::arg("lower") = -std::numeric_limits<double>::infinity(),
          py::arg("upper") = std::numeric_limits<double>::infinity(),
          "Keeps an entry of an estimate within lower <= entry <= upper. Entries are numbered from 0 as in "
          "the "
          "tangent, so in a tuple (SE3, Vector3), the vector has the entries 6 to 8. Entries of rotations "
          "and "
          "poses have no bounds.")
      .def(
          "bounds",
          [](const GraphObject& self, py::handle vertex) {
            std::vector<std::tuple<int, double, double>> result;
            for (const detail::Bound& bound : self.read().bounds(vertex_of(self.read(), vertex, "vertex")))
              result.emplace_back(bound.entry, bound.lower, bound.upper);
            return result;
          },
          py::arg("vertex"), "The bounds of a vertex: (entry, lower, upper), in ascending order of entries.")
      .def("vertex_count", [](const GraphObject& self) { return self.read().vertex_count(); })
      .def("parameter_count", [](const GraphObject& self) { return self.read().parameter_count(); })
      .def("edge_count", [](const GraphObject& self) { return self.read().edge_count(); })
      .def(
          "all_vertices", [](const GraphObject& self) { return self.read().all_vertices(); },
          "All vertices except parameters, in the order of their ids.")
      .def("all_parameters", [](const GraphObject& self) { return self.read().all_parameters(); })
      .def("all_edges", [](const GraphObject& self) { return self.read().all_edges(); });
}

void bind_state(GraphClass& type) {
  type.def(
          "push", [](GraphObject& self) { self.write().push(); }, "Pushes all estimates on a stack.")
      .def(
          "pop", [](GraphObject& self) { self.write().pop(); },
          "Restores the estimates of the matching push().")
      .def("discard_top", [](GraphObject& self) { self.write().discard_top(); })
      .def("stack_size", [](const GraphObject& self) { return self.read().stack_size(); })
      .def("clear", [](GraphObject& self) { self.write().clear(); })
      .def(
          "__copy__", [](const GraphObject& self) { return std::make_shared<GraphObject>(self); },
          "A deep copy. VertexRefs and EdgeRefs also name the elements of the copy.")
      .def("__deepcopy__",
           [](const GraphObject& self, const py::dict&) { return std::make_shared<GraphObject>(self); })
      .def("__repr__", [](const GraphObject& self) {
        return "Graph(" + std::to_string(self.read().vertex_count()) + " vertices, " +
               std::to_string(self.read().edge_count()) + " edges)";
      });
}

}  // namespace

GraphClass bind_graph(py::module_& module) {
  bind_ref<VertexRef>(module, "VertexRef", "A vertex of a graph. It is valid until the vertex is removed.");
  bind_ref<EdgeRef>(module, "EdgeRef", "An edge of a graph. It is valid until the edge is removed.");
  GraphClass type(module, "Graph",
                  "Vertices (estimates) and edges (measurements). Every method that takes a vertex takes its "
                  "VertexRef or its id.",
                  collected<GraphObject>());
  type.def(py::init<>());
  bind_estimates(type);
  bind_vertices(type);
  bind_state(type);
  return type;
}

}  // namespace boxplus::python
