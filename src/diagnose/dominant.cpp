// SPDX-License-Identifier: BSD-3-Clause
// The finding about a vertex whose edges have most of chi2.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnose/evidence.h"
#include "diagnose/finding_table.h"
#include "diagnose/sentences.h"

namespace boxplus {
namespace {

/// Sums over the finite edges of a vertex, without kernels.
struct Share {
  double chi2 = 0, worst = 0;  ///< of all edges, and of the worst one
  std::uint64_t edges = 0, rows = 0;
};

/// The sums of each vertex, by pool and slot, and of the whole graph.
struct Shares {
  explicit Shares(const Evidence& evidence) {
    for (const auto& pool : evidence.graph.vertex_pools()) of.emplace_back(pool->slots());
    for (const PoolEvidence& edges : evidence.pools) {
      const detail::EdgePool& pool = *evidence.graph.edge_pools()[edges.pool];
      for (std::size_t k = 0; k < edges.edges.size(); ++k) {
        const std::uint32_t edge = edges.edges[k];
        if (!std::isfinite(edges.chi2[k])) continue;
        const auto rows = static_cast<std::uint64_t>(pool.shape(edge).rows);
        add(edges.chi2[k], rows, all);
        const auto slots = pool.vertex_slots(edge);
        for (int place = 0; place < pool.arity(edge); ++place)
          add(edges.chi2[k], rows, of[pool.vertex_pool(edge, place)][slots[place]]);
      }
    }
  }

  static void add(double chi2, std::uint64_t rows, Share& to) {
    to.chi2 += chi2;
    to.worst = std::max(to.worst, chi2);
    to.rows += rows;
    ++to.edges;
  }

  std::vector<std::vector<Share>> of;
  Share all;
};

/// Whether the edges have most of chi2 even without the worst of them, which may be an outlier, and much more
/// chi2 per row than the other edges.
bool dominates(const Share& share, const Share& all) {
  constexpr double kMost = 0.5, kExcess = 10;
  if (!(share.chi2 - share.worst > kMost * all.chi2) || share.rows >= all.rows) return false;
  const double others = std::max(0.0, all.chi2 - share.chi2) / static_cast<double>(all.rows - share.rows);
  return share.chi2 / static_cast<double>(share.rows) > kExcess * others;
}

}  // namespace

/// If noise explains chi2, it is no matter how chi2 is distributed.
void find_dominant_vertex(const Evidence& evidence, Findings& out) {
  constexpr double kLargeChi2 = 4;  // per row
  const Shares shares(evidence);
  if (!(shares.all.chi2 > kLargeChi2 * static_cast<double>(shares.all.rows))) return;
  std::optional<VertexRef> found;
  Share least;
  for (std::uint32_t pool = 0; pool < shares.of.size(); ++pool) {
    for (std::uint32_t slot = 0; slot < shares.of[pool].size(); ++slot) {
      const Share& share = shares.of[pool][slot];
      if (!dominates(share, shares.all) || (found && share.rows >= least.rows)) continue;
      found = evidence.vertex_ref(pool, slot);
      least = share;
    }
  }
  if (!found) return;
  Finding finding;
  finding.severity = evidence.at_minimum() ? Finding::Severity::kWarning : Finding::Severity::kNote;
  finding.vertices = {*found};
  finding.text = fmt::format(
      "the {} edges of {} ({} % of all) have {:.0f} % of chi2 (without kernels): check its estimate and "
      "its measurements",
      least.edges, vertices_text(evidence.graph, finding.vertices),
      std::max(1.0,
               std::round(100.0 * static_cast<double>(least.edges) / static_cast<double>(shares.all.edges))),
      std::floor(100 * least.chi2 / shares.all.chi2));
  out.push_back(std::move(finding));
}

}  // namespace boxplus
