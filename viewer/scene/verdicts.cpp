// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/verdicts.h"

#include <algorithm>

namespace boxplus::viewer {
namespace {

std::uint8_t code_of(std::optional<Verdict> verdict) {
  if (!verdict) return 0;
  return *verdict == Verdict::kInlier ? 1 : *verdict == Verdict::kUndecided ? 2 : 3;
}

}  // namespace

Verdicts::Verdicts(std::span<const EdgeVerdict> verdicts) {
  verdicts_.reserve(verdicts.size());
  for (const EdgeVerdict& each : verdicts) verdicts_.emplace_back(each.edge, each.verdict);
  std::ranges::sort(verdicts_, {}, &std::pair<EdgeRef, Verdict>::first);
}

std::optional<Verdict> Verdicts::of(EdgeRef edge) const {
  const auto found = std::ranges::lower_bound(verdicts_, edge, {}, &std::pair<EdgeRef, Verdict>::first);
  if (found == verdicts_.end() || found->first != edge) return std::nullopt;
  return found->second;
}

std::vector<EdgeRef> Verdicts::edges(Verdict verdict) const {
  std::vector<EdgeRef> edges;
  for (const auto& [edge, found] : verdicts_) {
    if (found == verdict) edges.push_back(edge);
  }
  return edges;
}

std::vector<std::uint8_t> verdicts_of_lines(const Graph& graph, const Structure& structure,
                                            const Verdicts& verdicts) {
  std::vector<std::uint8_t> codes;
  if (verdicts.empty()) return codes;
  codes.reserve(structure.line_edges.size());
  for (const LineGroup& group : structure.line_groups) {
    const detail::EdgePool& pool = *graph.edge_pools()[group.pool];
    for (std::uint32_t line = group.first; line < group.first + group.count; ++line) {
      const std::uint32_t slot = structure.line_edges[line];
      codes.push_back(code_of(verdicts.of({group.pool, slot, pool.generation(slot)})));
    }
  }
  return codes;
}

}  // namespace boxplus::viewer
