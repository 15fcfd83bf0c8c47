// SPDX-License-Identifier: BSD-3-Clause
// Covariances of vertices.
#include <pybind11/stl.h>

#include <memory>
#include <vector>

#include "bind.h"
#include "convert.h"
#include "covariance_object.h"
#include "enumerators.h"
#include "options_object.h"

namespace boxplus::python {
namespace {

using Function = Covariance (*)(const Graph&, std::span<const VertexRef>, const Options&);

void bind_function(py::module_& module, const char* name, Function function, const char* doc) {
  module.def(
      name,
      [function](GraphObject& graph, py::handle vertices, py::handle options, const py::kwargs& changes) {
        const std::vector<VertexRef> refs = vertices_of(graph.read(), vertices, "vertices");
        const OptionsObject object = options_with(options, changes);
        const Options native = object.for_graph(graph.read());
        Covariance result = [&] {
          GraphObject::Run run(graph);
          const py::gil_scoped_release release;
          return function(run.graph(), refs, native);
        }();
        return CovarianceObject{std::move(result), py::cast(graph, py::return_value_policy::reference)};
      },
      py::arg("graph").none(false), py::arg("vertices"), py::arg("options") = py::none(), doc);
}

}  // namespace

void bind_covariance(py::module_& module) {
  py::class_<CovarianceObject> type(
      module, "Covariance", "Blocks of H⁻¹: the covariances of δ in x ⊞ δ, in the order of the tangent.",
      collected<CovarianceObject>());
  bind_enum<Covariance::Status>(type);
  type.def("status", [](const CovarianceObject& self) { return self.covariance.status(); })
      .def("ok", [](const CovarianceObject& self) { return self.covariance.ok(); })
      .def("message", [](const CovarianceObject& self) { return self.covariance.message(); })
      .def("failed_vertex", [](const CovarianceObject& self) { return self.covariance.failed_vertex(); })
      .def("held", [](const CovarianceObject& self) { return self.covariance.held(); })
      .def(
          "of",
          [](const CovarianceObject& self, py::handle a, py::handle b) {
            const VertexRef row = self.vertex(a, "a");
            return to_array(self.covariance.of(row, b.is_none() ? row : self.vertex(b, "b")));
          },
          py::arg("a"), py::arg("b") = py::none(),
          "The covariance of a vertex, or the cross-covariance of two.")
      .def(
          "joint", [](const CovarianceObject& self) { return to_array(self.covariance.joint()); },
          "The joint covariance of all vertices, in their order.");
  bind_function(module, "covariance", &covariance,
                "covariance(graph, [a, b]): the covariances of vertices at the current estimates, with all "
                "cross-covariances.");
  bind_function(
      module, "marginal_covariances", &marginal_covariances,
      "Only the covariance of each vertex with itself: cheap enough for all vertices of a large graph.");
}

}  // namespace boxplus::python
