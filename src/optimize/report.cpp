// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/optimize/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <ostream>

namespace boxplus {
namespace {

using Text = fmt::memory_buffer;

template <class... A>
void add(Text& text, fmt::format_string<A...> format, A&&... arguments) {
  fmt::format_to(std::back_inserter(text), format, std::forward<A>(arguments)...);
}

/// Removes the sign of a NaN, because it would be printed.
double without_sign_of_nan(double value) {
  return std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value;
}

/// A number of bytes in a readable form, with about two digits: 950 MB, 61 GB, 1.2 TB.
std::string bytes_text(std::uint64_t bytes) {
  constexpr std::array kUnits{"kB", "MB", "GB", "TB"};
  double value = static_cast<double>(bytes) / 1e3;
  std::size_t unit = 0;
  for (; value >= 999.5 && unit + 1 < kUnits.size(); ++unit) value /= 1e3;
  return fmt::format("{:.{}f} {}", value, value < 9.95 ? 1 : 0, kUnits[unit]);
}

/// Seconds to about two digits, without an exponent: 0.31, 2.5, 254.
std::string two_digits(double seconds) {
  return fmt::format("{:.{}f}", seconds, seconds < 0.995 ? 2 : seconds < 9.95 ? 1 : 0);
}

std::string solver_text(const Report& report) {
  std::string text(report.linear_solver);
  const LinearStatistics& linear = report.linear;
  if (linear.precision == Precision::kMixed) text += " (in float, refined in double)";
  if (linear.fell_back_to_double) text += " (fell back to double)";
  if (linear.refused_factor_bytes == 0) return text;
  return text +
         fmt::format(
             " (because each factorization would take {} and {} s; a rough solution by pcg takes {} s)",
             bytes_text(linear.refused_factor_bytes), two_digits(linear.factor_seconds),
             two_digits(linear.pcg_seconds));
}

/// The numbers of rows that are printed from the beginning and from the end of a long table.
constexpr std::size_t kHeadRows = 12, kTailRows = 4;

void add_records(Text& text, const Report& report) {
  if (report.records.empty()) return;
  const bool has_lambda = report.records.front().lambda > 0;
  add(text, "\n  iter           chi2     decrease   |gradient|       |step|  {:>11}  tries   time [s]\n",
      has_lambda ? "lambda" : "radius");
  add(text, "  {:4}  {:13.7g}\n", 0, without_sign_of_nan(report.chi2_start()));
  const std::size_t count = report.records.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (count > kHeadRows + kTailRows && k == kHeadRows) {
      add(text, "  …    ({} more)\n", count - kHeadRows - kTailRows);
      k = count - kTailRows;
    }
    const IterationRecord& r = report.records[k];
    const double bound = has_lambda ? r.lambda : r.radius;
    const std::string bound_text = std::isinf(bound) ? "∞" : fmt::format("{:.3e}", bound);
    add(text, "  {:4}  {:13.7g}  {:11.4g}  {:11.3e}  {:11.3e}  {:>11}  {:5}  {:9.4f}\n", r.iteration,
        without_sign_of_nan(r.chi2), without_sign_of_nan(r.chi2_decrease), r.gradient_max, r.step_max,
        bound_text, r.tries, r.time_s);
  }
}

void add_ids(Text& text, std::string_view what, const std::vector<Id>& ids) {
  constexpr std::size_t kShown = 8;
  add(text, "{} ", what);
  for (std::size_t k = 0; k < std::min(ids.size(), kShown); ++k)
    add(text, "{}{}", k == 0 ? "" : ", ", ids[k]);
  if (ids.size() > kShown) add(text, ", … ({} in all)", ids.size());
}

void add_start(Text& text, const Report::StartReport& start) {
  add(text, "  {:<16}{}", "start", to_string(start.used));
  if (start.requested != start.used) add(text, " (requested: {})", to_string(start.requested));
  add(text, "; chi2 {:.7g} as given", without_sign_of_nan(start.chi2_current));
  if (!std::isnan(start.first_step_kept))
    add(text, ", the first step from there reached {:.0f} % of its predicted decrease",
        100 * start.first_step_kept);
  if (!(start.chi2_guess < 0))
    add(text, ", {:.7g} after the initial guess", without_sign_of_nan(start.chi2_guess));
  if (start.ran_both)
    add(text, "; both were run, the other ended at {:.7g}", without_sign_of_nan(start.chi2_other_final));
  if (start.other_iterations > 0)
    add(text, "; {} iteration{} from the start that was not used", start.other_iterations,
        start.other_iterations == 1 ? "" : "s");
  if (!start.note.empty()) add(text, " ({})", start.note);
  add(text, "\n");
}

/// "analytic: Between<SE2>, …; exact: …; numeric: …"
void add_jacobians(Text& text, const std::vector<Report::EdgeJacobians>& jacobians) {
  if (jacobians.empty()) return;
  add(text, "  {:<16}", "Jacobians");
  std::string_view separator;
  for (const detail::JacobianSource source :
       {detail::JacobianSource::kAnalytic, detail::JacobianSource::kAutomatic,
        detail::JacobianSource::kNumeric}) {
    std::vector<std::string_view> types;
    for (const Report::EdgeJacobians& edge : jacobians) {
      if (edge.source == source) types.push_back(edge.edge_type);
    }
    if (types.empty()) continue;
    add(text, "{}{}: {}", separator, to_string(source), fmt::join(types, ", "));
    separator = "; ";
  }
  add(text, "\n");
}

/// "chi2 per degree of freedom is 1.43 (18 degrees)"
void add_fit(Text& text, const Report& report) {
  if (report.rows == 0) return;
  const std::int64_t degrees = report.degrees_of_freedom;
  add(text, "  {:<16}", "fit");
  if (degrees > 0) {
    add(text, "chi2 per degree of freedom is {:.4g} ({} degree{})\n",
        without_sign_of_nan(report.chi2_per_degree()), degrees, degrees == 1 ? "" : "s");
  } else if (degrees == 0) {
    add(text, "no degrees of freedom: as many rows as unknowns\n");
  } else {
    add(text, "no degrees of freedom: {} fewer rows than unknowns\n", -degrees);
  }
}

void add_gauge(Text& text, const Report::GaugeReport& gauge) {
  if (!gauge.held.empty()) {
    add(text, "  {:<16}", "gauge");
    add_ids(text, gauge.held.size() == 1 ? "held vertex" : "held vertices", gauge.held);
    add(text, ": nothing else fixes {} component\n", gauge.held.size() == 1 ? "its" : "their");
  }
  constexpr std::size_t kShown = 4;
  for (std::size_t k = 0; k < std::min(gauge.free.size(), kShown); ++k)
    add(text, "  {:<16}{} free in the component of vertex {}\n", "gauge", to_string(gauge.free[k]),
        gauge.free[k].id);
  if (gauge.free.size() > kShown) add(text, "  {:<16}… ({} components in all)\n", "gauge", gauge.free.size());
  if (gauge.held_directions > 0)
    add(text, "  {:<16}held {} direction{} that nothing measures\n", "gauge", gauge.held_directions,
        gauge.held_directions == 1 ? "" : "s");
}

void add_kernels(Text& text, const Report& report) {
  if (!report.rejection.is_known) return;
  add(text, "  {:<16}rejected {} of {} edges (weight below {:g}); {} edge{} a kernel\n", "kernels",
      report.rejection.edges, report.edges, Report::kRejectedWeight, report.robust_edges,
      report.robust_edges == 1 ? " has" : "s have");
}

/// "vertex 3, entry 0 at its upper limit 2.5 (multiplier 0.73)"
void add_bounds(Text& text, const std::vector<Report::ActiveBound>& bounds) {
  constexpr std::size_t kShown = 5;
  for (std::size_t k = 0; k < std::min(bounds.size(), kShown); ++k) {
    const Report::ActiveBound& bound = bounds[k];
    add(text, "  {:<16}vertex {}, entry {}, is at its {} limit {:.9g} (multiplier {:.4g})\n", "bound",
        bound.id, bound.entry, bound.is_upper ? "upper" : "lower", bound.limit, bound.multiplier);
  }
  if (bounds.size() > kShown) add(text, "  {:<16}… ({} active bounds in all)\n", "bound", bounds.size());
}

void add_constraints(Text& text, const Report& report) {
  if (report.constraint_rounds == 0) return;
  add(text, "  {:<16}{}, with errors of at most {:.2g}, after {} round{}\n", "constraints",
      report.constraints.size(), report.constraint_violation, report.constraint_rounds,
      report.constraint_rounds == 1 ? "" : "s");
}

void add_findings(Text& text, const Report& report) {
  constexpr std::size_t kShown = 5;
  for (std::size_t k = 0; k < std::min(report.findings.size(), kShown); ++k) {
    const detail::Finding& finding = report.findings[k];
    add(text, "  {:<16}{} [{}]\n", to_string(finding.severity), finding.text, to_string(finding.kind));
  }
  if (report.findings.size() > kShown)
    add(text, "  {:<16}({} more; `diagnose()` and `boxplus info --diagnose` list them)\n", "…",
        report.findings.size() - kShown);
}

void add_notes(Text& text, const Report& report) {
  add_findings(text, report);
  add_bounds(text, report.active_bounds);
  add_constraints(text, report);
  add_kernels(text, report);
  add_gauge(text, report.gauge);
  add_jacobians(text, report.jacobians);
  for (const std::string_view remark : {report.start_remark(), report.chi2_remark()}) {
    if (!remark.empty()) add(text, "  {:<16}{}\n", "note", remark);
  }
  if (report.disabled_edges > 0) add(text, "  {:<16}{} disabled edge(s)\n", "note", report.disabled_edges);
  if (report.displaced_directions > 0) {
    add(text, "  {:<16}displaced {} direction{} in which chi2 was stationary, but not at a minimum\n", "note",
        report.displaced_directions, report.displaced_directions == 1 ? "" : "s");
  }
  if (report.regularized_steps > 0) {
    add(text, "  {:<16}H was not positive definite in {} step(s) and was damped\n", "note",
        report.regularized_steps);
  }
  if (report.precise_steps > 0) {
    add(text,
        "  {:<16}the weights (Ω, or Jacobians) differ so much that {} step(s) were computed with 32 digits\n",
        "note", report.precise_steps);
  }
}

}  // namespace

double Report::chi2_per_degree() const {
  return degrees_of_freedom > 0 ? chi2_final / static_cast<double>(degrees_of_freedom)
                                : std::numeric_limits<double>::quiet_NaN();
}

std::string_view Report::chi2_remark() const {
  // With fewer degrees, ratios beyond these limits are not rare even if every Ω is right.
  constexpr std::int64_t kFewestDegrees = 10;
  constexpr double kMost = 4, kLeast = 0.25;
  constexpr double kExact = 1e-12;  // chi2 per row below which the errors are those of rounding
  if (!converged() || degrees_of_freedom < kFewestDegrees) return {};
  const double ratio = chi2_per_degree();
  if (ratio > kMost)
    return "chi2 per degree of freedom is above 4: Ω is too large, there are outliers, or this is a local "
           "minimum";
  if (ratio < kLeast && chi2_final > kExact * static_cast<double>(rows) && robust_edges == 0)
    return "chi2 per degree of freedom is below 1/4: Ω is too small for errors as small as these";
  return {};
}

std::string_view Report::start_remark() const {
  constexpr double kTolerance = 1e-6;  // so that the same minimum does not count as higher
  if (start.used == Start::kCurrent || !(chi2_final > (1 + kTolerance) * start.chi2_current)) return {};
  return "chi2 ended above that of the given estimates: the start 'current' is better";
}

std::string to_string(const Report& report) {
  Text text;
  add(text, "{}: chi2 {:.9g} → {:.9g} in {} iteration{}, {:.4f} s\n", to_string(report.status),
      without_sign_of_nan(report.chi2_initial), without_sign_of_nan(report.chi2_final), report.iterations,
      report.iterations == 1 ? "" : "s", report.time.total_s);
  add(text, "  {:<16}{}\n", "because", report.message);
  add(text, "  {:<16}{} vertices ({} unknowns), {} edges ({} rows)\n", "problem", report.vertices,
      report.scalars, report.edges, report.rows);
  add_fit(text, report);
  if (report.eliminated > 0) add(text, "  {:<16}{} vertices\n", "eliminated", report.eliminated);
  add(text, "  {:<16}{}, {}, {} of {} thread{}\n", "method", report.algorithm, solver_text(report),
      report.workers, report.threads, report.threads == 1 ? "" : "s");
  add_start(text, report.start);
  add_notes(text, report);
  const Report::Timings& t = report.time;
  add(text,
      "  {:<16}plan {:.4f}, start {:.4f}, linearize {:.4f}, factorize {:.4f}, solve {:.4f}, evaluate "
      "{:.4f}\n",
      "time [s]", t.plan_s, t.start_s, t.linearize_s, t.factorize_s, t.solve_s, t.evaluate_s);
  add_records(text, report);
  return fmt::to_string(text);
}

std::ostream& operator<<(std::ostream& out, const Report& report) {
  return out << to_string(report);
}

std::string_view to_string(Report::Status status) {
  switch (status) {
    case Report::Status::kConverged:
      return "converged";
    case Report::Status::kNotConverged:
      return "not converged";
    default:
      return "failed";
  }
}

std::string_view to_string(Report::Reason reason) {
  switch (reason) {
    case Report::Reason::kCostTolerance:
      return "chi2 no longer falls noticeably";
    case Report::Reason::kStepTolerance:
      return "the step is negligible";
    case Report::Reason::kGradientTolerance:
      return "the gradient vanishes";
    case Report::Reason::kNoFurtherDecrease:
      return "no step lowers chi2 by more than rounding";
    case Report::Reason::kNothingToOptimize:
      return "there is nothing to optimize: no active edge touches a vertex that may move";
    case Report::Reason::kMaxIterations:
      return "the iteration limit is reached";
    case Report::Reason::kTimeLimit:
      return "the time limit is reached";
    case Report::Reason::kStopFlag:
      return "the run was interrupted";
    case Report::Reason::kCallback:
      return "the callback asked to stop";
    case Report::Reason::kNoStepFound:
      return "no step that lowers chi2 was found";
    case Report::Reason::kRaisedChi2:
      return "chi2 is above its start; dogleg and Levenberg-Marquardt take only steps that lower it";
    case Report::Reason::kNotPositiveDefinite:
      return "the linear system cannot be solved";
    case Report::Reason::kRejectedEdges:
      return "robust kernels reject edges that the result needs";
    case Report::Reason::kWeightSpan:
      return "the weights span more digits than double precision has";
    case Report::Reason::kConstraints:
      return "constraints do not hold";
    case Report::Reason::kNotFinite:
      return "the problem is not finite";
    default:
      return "a component can move without changing any error (Options::gauge = error)";
  }
}

}  // namespace boxplus
