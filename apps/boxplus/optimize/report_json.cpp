// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/report_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "boxplus/diagnose/diagnose.h"
#include "boxplus/linear/instruction_set.h"
#include "optimize/outlier_search.h"

namespace boxplus::app {
namespace {

using Json = nlohmann::ordered_json;

/// Returns null for negative values, which mean "absent".
Json unless_negative(double value) {
  return value < 0 ? Json(nullptr) : Json(value);
}

/// Returns null for NaN, which means "absent".
Json unless_nan(double value) {
  return std::isnan(value) ? Json(nullptr) : Json(value);
}

/// Returns null for zero, which means "absent".
Json unless_zero(std::uint64_t value) {
  return value == 0 ? Json(nullptr) : Json(value);
}

/// Returns null for an empty text, which means "absent".
Json unless_empty(std::string_view text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json start_json(const Report::StartReport& start) {
  return {{"requested", to_string(start.requested)},
          {"used", to_string(start.used)},
          {"chi2_current", start.chi2_current},
          {"first_step_kept", unless_nan(start.first_step_kept)},
          {"chi2_guess", unless_negative(start.chi2_guess)},
          {"ran_both", start.ran_both},
          {"chi2_other_final", unless_negative(start.chi2_other_final)},
          {"other_iterations", start.other_iterations},
          {"note", start.note}};
}

Json gauge_json(const Report::GaugeReport& gauge) {
  Json free = Json::array();
  for (const detail::GaugeFreedom& freedom : gauge.free) {
    free.push_back({{"vertex", freedom.id},
                    {"directions", freedom.directions},
                    {"translation", freedom.translation},
                    {"rotation", freedom.rotation},
                    {"scale", freedom.scale}});
  }
  return {{"held", gauge.held}, {"free", free}, {"held_directions", gauge.held_directions}};
}

Json kernel_json(const KernelFacts& kernel) {
  if (kernel.name.empty()) return nullptr;
  if (kernel.width) return {{"name", kernel.name}, {"width", *kernel.width}, {"edges", kernel.edges}};
  Json widths = Json::object();
  for (const auto& [rows, width] : kernel.widths) widths[std::to_string(rows)] = width;
  return {{"name", kernel.name}, {"width_by_rows", widths}, {"edges", kernel.edges}};
}

Json certificate_json(const std::optional<Certificate>& certificate) {
  if (!certificate) return nullptr;
  const bool has_better = certificate->verdict == Certificate::Verdict::kLocalMinimum;
  return {{"verdict", to_string(certificate->verdict)},
          {"relation", to_string(certificate->relation)},
          {"chi2", certificate->chi2},
          {"better_chi2", has_better ? Json(certificate->better_chi2) : Json(nullptr)},
          {"chordal_cost", certificate->chordal_cost},
          {"bound", certificate->bound},
          {"relative_gap", certificate->relative_gap()},
          {"chi2_bound", certificate->chi2_bound()},
          {"chi2_from_chordal", certificate->chi2_from_chordal},
          {"steps", certificate->steps},
          {"escapes", certificate->escapes},
          {"note", unless_empty(certificate->note)},
          {"time_s", certificate->time_s}};
}

Json rejection_json(const Report& report) {
  const Report::RejectionReport& rejection = report.rejection;
  if (!rejection.is_known) return nullptr;
  return {{"robust_edges", report.robust_edges},
          {"rejected", rejection.edges},
          {"redescending", rejection.redescending},
          {"rejected_by_redescending", rejection.by_redescending},
          {"cut_off", rejection.cut_off}};
}

Json bounds_json(const std::vector<Report::ActiveBound>& bounds) {
  Json result = Json::array();
  for (const Report::ActiveBound& bound : bounds) {
    result.push_back({{"vertex", bound.id},
                      {"entry", bound.entry},
                      {"limit", bound.is_upper ? "upper" : "lower"},
                      {"value", bound.limit},
                      {"multiplier", bound.multiplier}});
  }
  return result;
}

Json jacobians_json(const std::vector<Report::EdgeJacobians>& jacobians) {
  Json result = Json::array();
  for (const Report::EdgeJacobians& edge : jacobians) {
    result.push_back({{"edge_type", edge.edge_type}, {"source", to_string(edge.source)}});
  }
  return result;
}

Json time_json(const Report::Timings& time, const RunFacts& facts) {
  return {{"load", facts.load_s},
          {"plan", time.plan_s},
          {"start", time.start_s},
          {"optimize", time.total_s},
          {"linearize", time.linearize_s},
          {"factorize", time.factorize_s},
          {"solve", time.solve_s},
          {"evaluate", time.evaluate_s},
          {"total", facts.total_s},
          {"outliers", facts.outliers ? Json(facts.outliers->time_s) : Json(nullptr)}};
}

Json findings_json(const std::vector<Finding>& findings) {
  Json result = Json::array();
  for (const Finding& finding : findings) {
    result.push_back({{"kind", to_string(finding.kind)},
                      {"severity", to_string(finding.severity)},
                      {"text", finding.text},
                      {"vertices", finding.ids}});
  }
  return result;
}

Json records_json(const std::vector<IterationRecord>& records) {
  Json result = Json::array();
  for (const IterationRecord& record : records) {
    result.push_back({{"iteration", record.iteration},
                      {"chi2", record.chi2},
                      {"predicted_decrease", record.predicted_decrease},
                      {"step_max", record.step_max},
                      {"gradient_max", record.gradient_max},
                      {"lambda", record.lambda},
                      {"radius", record.radius},
                      {"tries", record.tries},
                      {"linear_iterations", record.linear_iterations},
                      {"time_s", record.time_s}});
  }
  return result;
}

Json priors_json(const std::optional<PositionPriors>& priors) {
  if (!priors) return nullptr;
  return {{"positions", priors->positions},
          {"directions", priors->directions},
          {"unknown_images", priors->others},
          {"far_positions", priors->far},
          {"scale", priors->scale}};
}

/// Returns the report with the chi2 of the result: --certify may have found a better minimum, or two.
Report report_of_result(const Report& run, const RunFacts& facts) {
  Report report = run;
  for (const std::optional<Certificate>& certificate : {facts.certificate, facts.of_better}) {
    if (certificate && certificate->verdict == Certificate::Verdict::kLocalMinimum)
      report.chi2_final = certificate->better_chi2;
  }
  return report;
}

}  // namespace

std::string report_json(const Report& run, const RunFacts& facts) {
  const Report report = report_of_result(run, facts);
  const Json json = {{"input", facts.input},
                     {"status", to_string(report.status)},
                     {"reason", to_string(report.reason)},
                     {"message", report.message},
                     {"chi2_initial", report.chi2_initial},
                     {"chi2_final", report.chi2_final},
                     {"chi2_final_of_run", run.chi2_final},
                     {"iterations", report.iterations},
                     {"start", start_json(report.start)},
                     {"gauge", gauge_json(report.gauge)},
                     {"kernel", kernel_json(facts.kernel)},
                     {"position_priors", priors_json(facts.priors)},
                     {"rejection", rejection_json(report)},
                     {"active_bounds", bounds_json(report.active_bounds)},
                     {"findings", findings_json(report.findings)},
                     {"outliers", facts.outliers ? outliers_json(*facts.outliers) : Json(nullptr)},
                     {"certificate", certificate_json(facts.certificate)},
                     {"certificate_of_better", certificate_json(facts.of_better)},
                     {"algorithm", report.algorithm},
                     {"linear_solver", report.linear_solver},
                     {"precision", to_string(report.linear.precision)},
                     {"fell_back_to_double", report.linear.fell_back_to_double},
                     {"refused_factor_bytes", unless_zero(report.linear.refused_factor_bytes)},
                     {"predicted_factor_s", report.linear.factor_seconds},
                     {"predicted_pcg_s", report.linear.pcg_seconds},
                     {"instructions", instruction_set()},
                     {"threads", report.threads},
                     {"workers", report.workers},
                     {"vertices", report.vertices},
                     {"edges", report.edges},
                     {"skipped_lines", facts.skipped_lines},
                     {"indefinite_edges", facts.indefinite_edges},
                     {"scalars", report.scalars},
                     {"rows", report.rows},
                     {"degrees_of_freedom", report.degrees_of_freedom},
                     {"chi2_per_degree", unless_nan(report.chi2_per_degree())},
                     {"chi2_remark", unless_empty(report.chi2_remark())},
                     {"start_remark", unless_empty(report.start_remark())},
                     {"jacobians", jacobians_json(report.jacobians)},
                     {"regularized_steps", report.regularized_steps},
                     {"displaced_directions", report.displaced_directions},
                     {"precise_steps", report.precise_steps},
                     {"time_s", time_json(report.time, facts)},
                     {"records", records_json(report.records)}};
  // Messages may contain text from the file, so bytes that are not valid UTF-8 are replaced.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace boxplus::app
