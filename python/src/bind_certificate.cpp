// SPDX-License-Identifier: BSD-3-Clause
// certify(): is it the global minimum?
#include <pybind11/stl.h>

#include <string>

#include "bind.h"
#include "boxplus/certify/certificate.h"
#include "enumerators.h"
#include "members.h"
#include "options_object.h"
#include "search.h"
#include "shown_progress.h"
#include "viewers_of_run.h"

namespace boxplus::python {
namespace {

constexpr std::tuple kCertificate{Member{"verdict", &Certificate::verdict},
                                  Member{"relation", &Certificate::relation},
                                  Member{"chi2", &Certificate::chi2},
                                  Member{"better_chi2", &Certificate::better_chi2},
                                  Member{"chordal_cost", &Certificate::chordal_cost},
                                  Member{"bound", &Certificate::bound},
                                  Member{"chi2_from_chordal", &Certificate::chi2_from_chordal},
                                  Member{"steps", &Certificate::steps},
                                  Member{"escapes", &Certificate::escapes},
                                  Member{"time_s", &Certificate::time_s},
                                  Member{"note", &Certificate::note}};

Certificate certify_graph(GraphObject& graph, py::handle options, py::handle tolerance,
                          py::handle max_escapes, const py::kwargs& changes) {
  const OptionsObject object = options_with(options, changes);
  CertificateOptions native{.options = object.for_graph(graph.read()),
                            .tolerance = read_number(tolerance, "tolerance"),
                            .max_escapes = read_int(max_escapes, "max_escapes")};
  GraphObject::Run run(graph);
  const ViewersOfRun viewers(graph);
  const ShownProgress progress("certifying");
  return Search(run, object).run(native.options, [&] {
    Certificate certificate = certify(run.graph(), native);
    viewers.update();
    return certificate;
  });
}

}  // namespace

void bind_certificate(py::module_& module) {
  py::class_<Certificate> type(module, "Certificate",
                               "Whether a minimum is global. repr() says what is proved, and the gap.");
  bind_enum<Certificate::Verdict>(type);
  bind_enum<Certificate::Relation>(type);
  bind_members(type, kCertificate);
  type.def("relative_gap", &Certificate::relative_gap, "(chordal_cost - bound) / chordal_cost")
      .def("chi2_bound", &Certificate::chi2_bound,
           "A number that chi2 is proved not to fall below, for any estimates; 0 if there is none.")
      .def("__repr__", [](const Certificate& self) { return to_string(self); });

  const CertificateOptions defaults;
  module.def(
      "certify", &certify_graph, py::arg("graph").none(false), py::arg("options") = py::none(), py::kw_only(),
      py::arg("tolerance") = defaults.tolerance, py::arg("max_escapes") = defaults.max_escapes,
      "certify(graph): decides whether the minimum at which optimize() has ended is the global one. If a "
      "better minimum is found, the graph gets its estimates. docs/certificate.md explains what is proved, "
      "and boxplus/certify/certificate.h tolerance, max_escapes and the options that have an effect. Other "
      "threads of Python run meanwhile. Ctrl-C (KeyboardInterrupt) stops the search.");
  module.def(
      "why_not_certifiable",
      [](const GraphObject& graph, py::handle options, const py::kwargs& changes) {
        return why_not_certifiable(graph.read(), options_with(options, changes).for_graph(graph.read()));
      },
      py::arg("graph").none(false), py::arg("options") = py::none(),
      "Says why certify() refuses a graph. Empty if it does not.");
  module.def(
      "to_string", [](Certificate::Verdict verdict) { return std::string(to_string(verdict)); },
      py::arg("value"));
  module.def(
      "to_string", [](Certificate::Relation relation) { return std::string(to_string(relation)); },
      py::arg("value"));
}

}  // namespace boxplus::python
