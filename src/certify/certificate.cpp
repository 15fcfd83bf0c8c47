// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/certify/certificate.h"

#include <fmt/format.h>

#include <ostream>

namespace boxplus {
namespace {

using Relation = Certificate::Relation;

/// "relative gap 3.1e-08". Smaller gaps are below rounding errors.
std::string gap_text(double gap) {
  constexpr double kRounding = 1e-12;
  return gap < kRounding ? "relative gap below 1e-12" : fmt::format("relative gap {:.1e}", gap);
}

std::string global_text(const Certificate& certificate) {
  const std::string gap = gap_text(certificate.relative_gap());
  if (certificate.relation == Relation::kEqual) {
    return fmt::format(
        "The minimum is global: no estimates have a chi2 below {:.10g} with normalized rotations ({}).",
        certificate.bound, gap);
  }
  std::string text =
      fmt::format("The minimum is the one next to the global minimum of the chordal cost, {:.10g} ({}).",
                  certificate.chordal_cost, gap);
  if (certificate.relation == Relation::kBelow)
    text += fmt::format(" No estimates have a chi2 below {:.10g}.", certificate.bound);
  return text;
}

}  // namespace

std::string_view to_string(Certificate::Verdict verdict) {
  switch (verdict) {
    case Certificate::Verdict::kGlobalMinimum:
      return "global-minimum";
    case Certificate::Verdict::kLocalMinimum:
      return "local-minimum";
    default:
      return "undecided";
  }
}

std::string_view to_string(Relation relation) {
  switch (relation) {
    case Relation::kEqual:
      return "equal";
    case Relation::kBelow:
      return "below";
    default:
      return "similar";
  }
}

std::string to_string(const Certificate& certificate) {
  switch (certificate.verdict) {
    case Certificate::Verdict::kGlobalMinimum:
      return global_text(certificate);
    case Certificate::Verdict::kLocalMinimum:
      return fmt::format("The minimum is a local one: there is a better one with chi2 {:.10g}.",
                         certificate.better_chi2);
    default:
      return fmt::format("It is undecided whether the minimum is global: {}.", certificate.note);
  }
}

std::ostream& operator<<(std::ostream& out, const Certificate& certificate) {
  return out << to_string(certificate);
}

}  // namespace boxplus
