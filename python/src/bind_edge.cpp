// SPDX-License-Identifier: BSD-3-Clause
// The Python classes of edges: one for each row of edge_families().
#include <utility>

#include "bind.h"
#include "edge_kinds.h"

namespace boxplus::python {

void bind_edge(py::module_& module) {
  py::class_<EdgeValue> base(module, "Edge", "A measurement. Graph.add_edge() adds it to a graph.",
                             collected<EdgeValue>());
  base.def(py::init<py::object>(), py::arg("measurement"))
      .def_readwrite("measurement", &EdgeValue::measurement)
      .def("__repr__", [](const py::object& self) {
        return py::str("{}({!r})").format(py::type::of(self).attr("__name__"), self.attr("measurement"));
      });
  py::class_<CameraEdgeValue, EdgeValue> with_camera(module, "_CameraEdge", collected<CameraEdgeValue>());
  with_camera
      .def(py::init([](py::object measurement, py::object camera) {
             return CameraEdgeValue{{std::move(measurement)}, std::move(camera)};
           }),
           py::arg("measurement"), py::arg("camera"))
      .def_readwrite("camera", &CameraEdgeValue::camera)
      .def("__repr__", [](const py::object& self) {
        return py::str("{}({!r}, {!r})")
            .format(py::type::of(self).attr("__name__"), self.attr("measurement"), self.attr("camera"));
      });
  for (const EdgeFamily& family : edge_families()) {
    const py::object parent = family.has_camera ? py::object(with_camera) : py::object(base);
    py::dict members;
    members["__doc__"] = family.doc;
    members["__module__"] = "boxplus";
    members["__slots__"] = py::tuple();
    module.attr(family.name) = py::type::of(base)(family.name, py::make_tuple(parent), members);
  }
  py::class_<ConstraintValue>(
      module, "Constraint",
      "Constraint(edge): an edge whose error must be zero exactly. `edge` is what add_edge() or add_edges() "
      "takes: an edge, a class of edges or an error function of Python.",
      collected<ConstraintValue>())
      .def(py::init([](py::object edge) { return ConstraintValue{std::move(edge)}; }), py::arg("edge"))
      .def_readonly("edge", &ConstraintValue::edge)
      .def("__repr__",
           [](const ConstraintValue& self) { return py::str("Constraint({!r})").format(self.edge); });
}

}  // namespace boxplus::python
