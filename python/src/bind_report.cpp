// SPDX-License-Identifier: BSD-3-Clause
// Report: the same members as in C++. The package adds _repr_html_().
#include <pybind11/stl.h>

#include "bind.h"
#include "boxplus/optimize/report.h"
#include "enumerators.h"
#include "members.h"

namespace boxplus::python {
namespace {

using detail::GaugeFreedom;
using Timings = Report::Timings;
using StartReport = Report::StartReport;
using GaugeReport = Report::GaugeReport;
using RejectionReport = Report::RejectionReport;
using ActiveBound = Report::ActiveBound;
using ConstraintResult = Report::ConstraintResult;
using EdgeJacobians = Report::EdgeJacobians;

constexpr std::tuple kRecord{Member{"iteration", &IterationRecord::iteration},
                             Member{"chi2", &IterationRecord::chi2},
                             Member{"chi2_decrease", &IterationRecord::chi2_decrease},
                             Member{"predicted_decrease", &IterationRecord::predicted_decrease},
                             Member{"step_max", &IterationRecord::step_max},
                             Member{"gradient_max", &IterationRecord::gradient_max},
                             Member{"lambda_", &IterationRecord::lambda},
                             Member{"radius", &IterationRecord::radius},
                             Member{"tries", &IterationRecord::tries},
                             Member{"linear_iterations", &IterationRecord::linear_iterations},
                             Member{"time_s", &IterationRecord::time_s}};
constexpr std::tuple kStart{Member{"requested", &StartReport::requested},
                            Member{"used", &StartReport::used},
                            Member{"chi2_current", &StartReport::chi2_current},
                            Member{"first_step_kept", &StartReport::first_step_kept},
                            Member{"chi2_guess", &StartReport::chi2_guess},
                            Member{"ran_both", &StartReport::ran_both},
                            Member{"chi2_other_final", &StartReport::chi2_other_final},
                            Member{"other_iterations", &StartReport::other_iterations},
                            Member{"note", &StartReport::note}};
constexpr std::tuple kFreedom{
    Member{"vertex", &GaugeFreedom::vertex},         Member{"id", &GaugeFreedom::id},
    Member{"directions", &GaugeFreedom::directions}, Member{"translation", &GaugeFreedom::translation},
    Member{"rotation", &GaugeFreedom::rotation},     Member{"scale", &GaugeFreedom::scale}};
constexpr std::tuple kGauge{Member{"held", &GaugeReport::held}, Member{"free", &GaugeReport::free},
                            Member{"held_directions", &GaugeReport::held_directions}};
constexpr std::tuple kRejection{Member{"is_known", &RejectionReport::is_known},
                                Member{"edges", &RejectionReport::edges},
                                Member{"redescending", &RejectionReport::redescending},
                                Member{"by_redescending", &RejectionReport::by_redescending},
                                Member{"cut_off", &RejectionReport::cut_off}};
constexpr std::tuple kActiveBound{
    Member{"vertex", &ActiveBound::vertex}, Member{"id", &ActiveBound::id},
    Member{"entry", &ActiveBound::entry},   Member{"is_upper", &ActiveBound::is_upper},
    Member{"limit", &ActiveBound::limit},   Member{"multiplier", &ActiveBound::multiplier}};
constexpr std::tuple kConstraint{Member{"edge", &ConstraintResult::edge},
                                 Member{"multipliers", &ConstraintResult::multipliers}};
constexpr std::tuple kJacobians{Member{"edge_type", &EdgeJacobians::edge_type},
                                Member{"source", &EdgeJacobians::source}};
constexpr std::tuple kTimings{
    Member{"plan_s", &Timings::plan_s},           Member{"start_s", &Timings::start_s},
    Member{"linearize_s", &Timings::linearize_s}, Member{"factorize_s", &Timings::factorize_s},
    Member{"solve_s", &Timings::solve_s},         Member{"evaluate_s", &Timings::evaluate_s},
    Member{"total_s", &Timings::total_s}};
constexpr std::tuple kLinear{Member{"factor_nonzeros", &LinearStatistics::factor_nonzeros},
                             Member{"factor_flops", &LinearStatistics::factor_flops},
                             Member{"supernodes", &LinearStatistics::supernodes},
                             Member{"largest_front", &LinearStatistics::largest_front},
                             Member{"factor_seconds", &LinearStatistics::factor_seconds},
                             Member{"pcg_seconds", &LinearStatistics::pcg_seconds},
                             Member{"refused_factor_bytes", &LinearStatistics::refused_factor_bytes},
                             Member{"ordering", &LinearStatistics::ordering},
                             Member{"precision", &LinearStatistics::precision},
                             Member{"workers", &LinearStatistics::workers},
                             Member{"fell_back_to_double", &LinearStatistics::fell_back_to_double}};
constexpr std::tuple kReport{Member{"status", &Report::status},
                             Member{"reason", &Report::reason},
                             Member{"message", &Report::message},
                             Member{"chi2_initial", &Report::chi2_initial},
                             Member{"chi2_final", &Report::chi2_final},
                             Member{"iterations", &Report::iterations},
                             Member{"start", &Report::start},
                             Member{"gauge", &Report::gauge},
                             Member{"rejection", &Report::rejection},
                             Member{"records", &Report::records},
                             Member{"active_bounds", &Report::active_bounds},
                             Member{"constraints", &Report::constraints},
                             Member{"constraint_violation", &Report::constraint_violation},
                             Member{"constraint_rounds", &Report::constraint_rounds},
                             Member{"findings", &Report::findings},
                             Member{"algorithm", &Report::algorithm},
                             Member{"linear_solver", &Report::linear_solver},
                             Member{"vertices", &Report::vertices},
                             Member{"eliminated", &Report::eliminated},
                             Member{"edges", &Report::edges},
                             Member{"disabled_edges", &Report::disabled_edges},
                             Member{"robust_edges", &Report::robust_edges},
                             Member{"scalars", &Report::scalars},
                             Member{"rows", &Report::rows},
                             Member{"degrees_of_freedom", &Report::degrees_of_freedom},
                             Member{"jacobians", &Report::jacobians},
                             Member{"linear", &Report::linear},
                             Member{"regularized_steps", &Report::regularized_steps},
                             Member{"displaced_directions", &Report::displaced_directions},
                             Member{"precise_steps", &Report::precise_steps},
                             Member{"threads", &Report::threads},
                             Member{"workers", &Report::workers},
                             Member{"plan_reused", &Report::plan_reused},
                             Member{"time", &Report::time}};

}  // namespace

void bind_report(py::module_& module) {
  bind_enum<detail::JacobianSource>(module);
  bind_struct<IterationRecord>(module, "IterationRecord", kRecord);
  bind_struct<GaugeFreedom>(module, "GaugeFreedom", kFreedom);
  bind_struct<LinearStatistics>(module, "LinearStatistics", kLinear);
  py::class_<Report> report(module, "Report", py::dynamic_attr(),
                            "The report of a run. repr() is the table that the command prints.");
  bind_enum<Report::Status>(report);
  bind_enum<Report::Reason>(report);
  bind_struct<StartReport>(report, "StartReport", kStart);
  bind_struct<GaugeReport>(report, "GaugeReport", kGauge);
  bind_struct<RejectionReport>(report, "RejectionReport", kRejection);
  bind_struct<ActiveBound>(report, "ActiveBound", kActiveBound);
  bind_struct<ConstraintResult>(report, "ConstraintResult", kConstraint);
  bind_struct<EdgeJacobians>(report, "EdgeJacobians", kJacobians);
  bind_struct<Timings>(report, "Timings", kTimings);
  bind_members(report, kReport);
  report.def("converged", &Report::converged)
      .def("chi2_per_degree", &Report::chi2_per_degree)
      .def("chi2_start", &Report::chi2_start)
      .def("chi2_remark", &Report::chi2_remark)
      .def("start_remark", &Report::start_remark)
      .def("__repr__", [](const Report& self) { return to_string(self); });
  report.attr("kRejectedWeight") = Report::kRejectedWeight;
  module.def(
      "to_string", [](Report::Status status) { return to_string(status); }, py::arg("value"),
      "The text of a status or a reason in reports.");
  module.def(
      "to_string", [](Report::Reason reason) { return to_string(reason); }, py::arg("value"));
}

}  // namespace boxplus::python
