// SPDX-License-Identifier: BSD-3-Clause
// Findings about numbers that are NaN or infinite.
#include <fmt/format.h>

#include "base/all_finite.h"
#include "diagnose/evidence.h"
#include "diagnose/finding_table.h"
#include "diagnose/sentences.h"

namespace boxplus {
namespace {

bool is_finite(const detail::Frame& frame) {
  return all_finite(frame.rotation) && all_finite(frame.translation);
}

}  // namespace

/// A vertex with finite edges has a finite estimate. Poses and points only: the estimates of other types are
/// hidden in their pools, but their edges are not finite, either.
void find_non_finite_estimates(const Evidence& evidence, Findings& out) {
  const Graph& graph = evidence.graph;
  std::vector<VertexRef> vertices;
  for (std::uint32_t p = 0; p < graph.vertex_pools().size(); ++p) {
    const detail::VertexPool& pool = *graph.vertex_pools()[p];
    for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
      detail::Frame frame;
      const VertexEvidence* known = evidence.find(p, slot);
      if (!pool.alive(slot) || (known != nullptr && known->edges > 0 && known->is_finite)) continue;
      if (!pool.get_frame(slot, frame)) break;  // all vertices of a pool have one type
      if (!is_finite(frame)) vertices.push_back(evidence.vertex_ref(p, slot));
    }
  }
  if (vertices.empty()) return;
  sort_by_id(graph, vertices);
  Finding finding;
  finding.severity = Finding::Severity::kError;
  finding.text =
      fmt::format("the {} of {} {} NaN or infinite: set {} before the run, for example by an initial guess",
                  by_count(vertices.size(), "estimate", "estimates"), vertices_text(graph, vertices),
                  by_count(vertices.size(), "is", "are"), by_count(vertices.size(), "it", "them"));
  finding.vertices = std::move(vertices);
  out.push_back(std::move(finding));
}

void find_non_finite_errors(const Evidence& evidence, Findings& out) {
  if (evidence.non_finite_errors.empty()) return;
  Finding finding;
  finding.severity = Finding::Severity::kError;
  finding.edges = evidence.non_finite_errors;
  finding.text = fmt::format(
      "the error of {} is NaN, infinite or too large to be squared: check the measurement and the estimates "
      "of the vertices",
      edges_text(evidence.graph, finding.edges));
  out.push_back(std::move(finding));
}

void find_non_finite_jacobians(const Evidence& evidence, Findings& out) {
  if (evidence.non_finite_jacobians.empty()) return;
  Finding finding;
  finding.severity = Finding::Severity::kError;
  finding.edges = evidence.non_finite_jacobians;
  finding.text = fmt::format(
      "a Jacobian (or the weight of the robust kernel) of {} is NaN or infinite although the error is "
      "finite: check jacobians(), or start from estimates at which the error has a derivative",
      edges_text(evidence.graph, finding.edges));
  out.push_back(std::move(finding));
}

}  // namespace boxplus
