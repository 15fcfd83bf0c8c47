// SPDX-License-Identifier: BSD-3-Clause
// The Python classes of edges: one for each row of edge_families().
#include "bind.h"
#include "edge_kinds.h"

namespace boxplus::python {

void bind_edge(py::module_& module) {
  py::class_<EdgeValue> base(module, "Edge", "A measurement. Graph.add_edge() adds it to a graph.");
  base.def(py::init<py::object>(), py::arg("measurement"))
      .def_readwrite("measurement", &EdgeValue::measurement)
      .def("__repr__", [](const py::object& self) {
        return py::str("{}({!r})").format(py::type::of(self).attr("__name__"), self.attr("measurement"));
      });
  for (const EdgeFamily& family : edge_families()) {
    py::dict members;
    members["__doc__"] = family.doc;
    members["__module__"] = "boxplus";
    members["__slots__"] = py::tuple();
    module.attr(family.name) = py::type::of(base)(family.name, py::make_tuple(base), members);
  }
}

}  // namespace boxplus::python
