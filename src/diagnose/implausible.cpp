// SPDX-License-Identifier: BSD-3-Clause
// The finding about estimates that cannot be right, as their types say.
#include <fmt/format.h>

#include "diagnose/evidence.h"
#include "diagnose/finding_table.h"
#include "diagnose/sentences.h"

namespace boxplus {

void find_implausible_estimates(const Evidence& evidence, Findings& out) {
  for (std::uint32_t p = 0; p < evidence.graph.vertex_pools().size(); ++p) {
    const detail::VertexPool& pool = *evidence.graph.vertex_pools()[p];
    Finding finding;
    std::string reason;
    Id least = 0;
    for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
      if (!pool.alive(slot)) continue;
      std::string why = pool.implausible(slot);
      if (why.empty()) continue;
      if (finding.vertices.empty() || pool.id(slot) < least) {
        reason = std::move(why);
        least = pool.id(slot);
      }
      finding.vertices.push_back(evidence.vertex_ref(p, slot));
    }
    if (finding.vertices.empty()) continue;
    sort_by_id(evidence.graph, finding.vertices);
    finding.severity = Finding::Severity::kWarning;
    const std::size_t count = finding.vertices.size();
    finding.text = fmt::format(
        "the {} of {} cannot be right: {}{}; check the order, the units and the signs of the values",
        by_count(count, "estimate", "estimates"), vertices_text(evidence.graph, finding.vertices), reason,
        count == 1 ? "" : fmt::format(" (that of {})", least));
    out.push_back(std::move(finding));
  }
}

}  // namespace boxplus
