// SPDX-License-Identifier: BSD-3-Clause
// diagnose(): what is wrong with a graph.
#include <pybind11/stl.h>

#include <string>

#include "bind.h"
#include "boxplus/diagnose/diagnose.h"
#include "enumerators.h"
#include "members.h"
#include "options_object.h"

namespace boxplus::python {
namespace {

using Direction = Finding::Direction;

constexpr std::tuple kDirection{Member{"kind", &Direction::kind}, Member{"axis", &Direction::axis},
                                Member{"vertex", &Direction::vertex}, Member{"tangent", &Direction::tangent}};
constexpr std::tuple kFinding{Member{"kind", &Finding::kind},
                              Member{"severity", &Finding::severity},
                              Member{"text", &Finding::text},
                              Member{"vertices", &Finding::vertices},
                              Member{"ids", &Finding::ids},
                              Member{"edges", &Finding::edges},
                              Member{"directions", &Finding::directions}};
constexpr std::tuple kDiagnosis{Member{"findings", &Diagnosis::findings},
                                Member{"is_complete", &Diagnosis::is_complete},
                                Member{"at_minimum", &Diagnosis::at_minimum}};

/// The lines of a diagnosis, without a line break at the end.
std::string lines(const Diagnosis& diagnosis) {
  std::string text = to_string(diagnosis);
  if (text.empty()) return "no findings";
  text.pop_back();
  return text;
}

Diagnosis diagnose_graph(GraphObject& graph, py::handle options, const py::kwargs& changes) {
  const OptionsObject object = options_with(options, changes);
  const Options native = object.for_graph(graph.read());
  GraphObject::Run run(graph);
  const py::gil_scoped_release release;
  return diagnose(run.graph(), native);
}

}  // namespace

void bind_diagnose(py::module_& module) {
  py::class_<Finding> finding(module, "Finding", "Something that is wrong with a graph, or unusual.");
  bind_enum<Finding::Kind>(finding);
  bind_enum<Finding::Severity>(finding);
  bind_struct<Direction>(finding, "Direction", kDirection);
  bind_enum<Direction::Kind>(finding.attr("Direction"));
  bind_members(finding, kFinding);
  finding.def("__repr__", [](const Finding& self) { return lines({.findings = {self}}); });

  py::class_<Diagnosis> diagnosis(module, "Diagnosis",
                                  "The findings: errors first, then warnings, then notes. repr() has a line "
                                  "for each finding.");
  bind_members(diagnosis, kDiagnosis);
  diagnosis.def("ok", &Diagnosis::ok, "Whether there are only notes.")
      .def(
          "count",
          [](const Diagnosis& self, py::handle severity) {
            return self.count(read_enumerator<Finding::Severity>(severity, "severity"));
          },
          py::arg("severity"), "The number of findings of a severity, such as \"warning\".")
      .def("__repr__", &lines);

  module.def(
      "diagnose", &diagnose_graph, py::arg("graph").none(false), py::arg("options") = py::none(),
      "diagnose(graph): says what is wrong with a graph at its current estimates, and changes nothing. "
      "docs/diagnosis.md explains the findings. Of the options, level, vertices, edges, "
      "numeric_jacobians, stop and time_limit_s have an effect.");
  module.def(
      "to_string", [](Finding::Kind kind) { return std::string(to_string(kind)); }, py::arg("value"));
  module.def(
      "to_string", [](Finding::Severity severity) { return std::string(to_string(severity)); },
      py::arg("value"));
}

}  // namespace boxplus::python
