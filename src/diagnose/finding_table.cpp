// SPDX-License-Identifier: BSD-3-Clause
#include "diagnose/finding_table.h"

namespace boxplus {
namespace {

using Kind = Finding::Kind;

constexpr FindingEntry kFindings[] = {
    {Kind::kNonFiniteEstimate, "non-finite-estimate", find_non_finite_estimates},
    {Kind::kNonFiniteError, "non-finite-error", find_non_finite_errors},
    {Kind::kNonFiniteJacobian, "non-finite-jacobian", find_non_finite_jacobians},
    {Kind::kImplausibleEstimate, "implausible-estimate", find_implausible_estimates},
    {Kind::kNothingMoves, "nothing-moves", find_nothing_moves},
    {Kind::kWrongJacobian, "wrong-jacobian", find_wrong_jacobians},
    {Kind::kIsolatedVertex, "isolated-vertex", find_isolated_vertices},
    {Kind::kFreeComponent, "free-component", find_free_components},
    {Kind::kZeroJacobian, "zero-jacobian", find_zero_jacobians},
    {Kind::kUndeterminedDirection, "undetermined-direction", find_undetermined_directions},
    {Kind::kSeenOnce, "seen-once", find_points_seen_once},
    {Kind::kBehindCameras, "behind-cameras", find_points_behind_cameras},
    {Kind::kFarPoint, "far-point", find_far_points},
    {Kind::kZeroInformation, "zero-information", find_zero_information},
    {Kind::kMixedUnits, "mixed-units", find_mixed_units},
    {Kind::kDuplicateEdge, "duplicate-edge", find_duplicate_edges},
    {Kind::kOutlier, "outlier", find_outliers},
    {Kind::kDominantVertex, "dominant-vertex", find_dominant_vertex},
    {Kind::kFixedEdge, "fixed-edge", find_fixed_edges},
    {Kind::kNotAtMinimum, "not-at-minimum", find_not_at_minimum},
    {Kind::kChi2Ratio, "chi2-ratio", find_chi2_ratio},
};

}  // namespace

std::span<const FindingEntry> finding_table() {
  return kFindings;
}

std::string_view detail::to_string(Finding::Kind kind) {
  for (const FindingEntry& entry : kFindings) {
    if (entry.kind == kind) return entry.name;
  }
  return "unknown";
}

}  // namespace boxplus
