// SPDX-License-Identifier: BSD-3-Clause
// A table of the kinds of findings, with their names and the functions that look for them.
#pragma once

#include <span>
#include <vector>

#include "boxplus/diagnose/finding.h"
#include "boxplus/graph/graph.h"

namespace boxplus {

using detail::Finding;
using detail::to_string;

class Evidence;
using Findings = std::vector<Finding>;

struct FindingEntry {
  Finding::Kind kind;
  std::string_view name;  ///< "isolated-vertex"
  /// Appends the findings of this kind. Sets everything but `kind` and `ids`. The vertices are sorted by id.
  void (*find)(const Evidence&, Findings&);
};

/// One entry per Finding::Kind.
std::span<const FindingEntry> finding_table();

// finite.cpp
void find_non_finite_estimates(const Evidence& evidence, Findings& out);
void find_non_finite_errors(const Evidence& evidence, Findings& out);
void find_non_finite_jacobians(const Evidence& evidence, Findings& out);
// implausible.cpp
void find_implausible_estimates(const Evidence& evidence, Findings& out);
// structure.cpp
void find_nothing_moves(const Evidence& evidence, Findings& out);
void find_isolated_vertices(const Evidence& evidence, Findings& out);
void find_fixed_edges(const Evidence& evidence, Findings& out);
void find_duplicate_edges(const Evidence& evidence, Findings& out);
// components.cpp
void find_free_components(const Evidence& evidence, Findings& out);
// determination.cpp
void find_zero_jacobians(const Evidence& evidence, Findings& out);
void find_undetermined_directions(const Evidence& evidence, Findings& out);
void find_points_seen_once(const Evidence& evidence, Findings& out);
// points.cpp
void find_points_behind_cameras(const Evidence& evidence, Findings& out);
void find_far_points(const Evidence& evidence, Findings& out);
// information.cpp
void find_zero_information(const Evidence& evidence, Findings& out);
void find_mixed_units(const Evidence& evidence, Findings& out);
// wrong_jacobian.cpp
void find_wrong_jacobians(const Evidence& evidence, Findings& out);
// dominant.cpp
void find_dominant_vertex(const Evidence& evidence, Findings& out);
// minimum.cpp
void find_outliers(const Evidence& evidence, Findings& out);
void find_not_at_minimum(const Evidence& evidence, Findings& out);
void find_chi2_ratio(const Evidence& evidence, Findings& out);

}  // namespace boxplus
