// SPDX-License-Identifier: BSD-3-Clause
// find_outliers(): false loop closures.
#include <pybind11/stl.h>

#include <string>

#include "bind.h"
#include "boxplus/outliers/outliers.h"
#include "enumerators.h"
#include "members.h"
#include "options_object.h"
#include "search.h"
#include "shown_progress.h"
#include "viewers_of_run.h"

namespace boxplus::python {
namespace {

constexpr std::tuple kVerdict{Member{"edge", &EdgeVerdict::edge},
                              Member{"from_", &EdgeVerdict::from},
                              Member{"to", &EdgeVerdict::to},
                              Member{"verdict", &EdgeVerdict::verdict},
                              Member{"weight", &EdgeVerdict::weight},
                              Member{"chi2", &EdgeVerdict::chi2},
                              Member{"supported", &EdgeVerdict::supported}};
constexpr std::tuple kOutlierReport{
    Member{"suspects", &OutlierReport::suspects}, Member{"report", &OutlierReport::report},
    Member{"verdicts", &OutlierReport::verdicts}, Member{"noise_scale", &OutlierReport::noise_scale},
    Member{"time_s", &OutlierReport::time_s},     Member{"note", &OutlierReport::note}};

OutlierReport find(GraphObject& graph, py::handle options, py::handle suspects, py::handle false_alarm,
                   py::handle evidence, py::handle window, const py::kwargs& changes) {
  const OptionsObject object = options_with(options, changes);
  OutlierOptions native{.options = object.for_graph(graph.read()),
                        .suspects = read_enumerator<Suspects>(suspects, "suspects"),
                        .false_alarm = read_number(false_alarm, "false_alarm"),
                        .evidence = read_number(evidence, "evidence"),
                        .window = read_int(window, "window")};
  GraphObject::Run run(graph);
  const ViewersOfRun viewers(graph);
  const ShownProgress progress("finding outliers");
  return Search(run, object).run(native.options, [&] {
    OutlierReport found = find_outliers(run.graph(), native);
    viewers.show(found);
    return found;
  });
}

/// An array of a member of each verdict.
template <class M>
py::array_t<M> column(const OutlierReport& report, M EdgeVerdict::*member) {
  py::array_t<M> array(static_cast<py::ssize_t>(report.verdicts.size()));
  M* out = array.mutable_data();
  for (const EdgeVerdict& verdict : report.verdicts) *out++ = verdict.*member;
  return array;
}

py::dict arrays(const OutlierReport& self) {
  py::list verdicts;
  for (const EdgeVerdict& verdict : self.verdicts) verdicts.append(std::string(to_string(verdict.verdict)));
  py::dict result;
  result["from"] = column(self, &EdgeVerdict::from);
  result["to"] = column(self, &EdgeVerdict::to);
  result["verdict"] = py::module_::import("numpy").attr("array")(verdicts, py::arg("dtype") = "U9");
  result["weight"] = column(self, &EdgeVerdict::weight);
  result["chi2"] = column(self, &EdgeVerdict::chi2);
  result["supported"] = column(self, &EdgeVerdict::supported);
  return result;
}

std::string text(const OutlierReport& self) {
  std::string text;
  for (const Enumerator<Verdict>& verdict : Enumerators<Verdict>::kAll)
    text += text_of(verdict.name) + "=" + std::to_string(self.count(verdict.value)) + ", ";
  return "OutlierReport(" + text + "noise_scale=" + std::string(py::repr(py::float_(self.noise_scale))) +
         ", note=" + std::string(py::repr(py::str(self.note))) + ")";
}

Verdict read_verdict(py::handle verdict) {
  return read_enumerator<Verdict>(verdict, "verdict");
}

}  // namespace

void bind_outliers(py::module_& module) {
  bind_enum<Suspects>(module);
  bind_enum<Verdict>(module);
  bind_struct<EdgeVerdict>(module, "EdgeVerdict", kVerdict);
  py::class_<OutlierReport> type(module, "OutlierReport",
                                 "The verdicts, one for each closure, and the report of the final run.");
  bind_members(type, kOutlierReport);
  type.def(
          "count",
          [](const OutlierReport& self, py::handle verdict) { return self.count(read_verdict(verdict)); },
          py::arg("verdict"), "The number of closures with a verdict, such as \"outlier\".")
      .def(
          "edges",
          [](const OutlierReport& self, py::handle verdict) { return self.edges(read_verdict(verdict)); },
          py::arg("verdict"), "The closures with a verdict, such as \"outlier\".")
      .def("arrays", &arrays,
           "The verdicts as a dict of arrays with one entry per closure: the ids \"from\" and \"to\", "
           "\"verdict\" (the text \"inlier\", \"outlier\" or \"undecided\"), \"weight\", \"chi2\" and "
           "\"supported\".")
      .def("__repr__", &text);

  const OutlierOptions defaults;
  module.def(
      "find_outliers", &find, py::arg("graph").none(false), py::arg("options") = py::none(), py::kw_only(),
      py::arg("suspects") = text_of(Enumerators<Suspects>::kAll[0].name),
      py::arg("false_alarm") = defaults.false_alarm, py::arg("evidence") = defaults.evidence,
      py::arg("window") = defaults.window,
      "find_outliers(graph, suspects=\"all\"): optimizes a graph without its false edges. The suspects are "
      "\"loop-closures\" or \"all\". boxplus/outliers/outliers.h explains the method, false_alarm, evidence "
      "and window; the other "
      "options are those of optimize(). Other threads of Python run meanwhile. Ctrl-C "
      "(KeyboardInterrupt) stops the search.");
  module.def(
      "to_string", [](Verdict verdict) { return std::string(to_string(verdict)); }, py::arg("value"));
}

}  // namespace boxplus::python
