// SPDX-License-Identifier: BSD-3-Clause
// Findings about the information matrices. (A graph accepts no Ω that is asymmetric, indefinite or not
// finite.)
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/evidence.h"
#include "diagnose/finding_table.h"
#include "diagnose/sentences.h"

namespace boxplus {
namespace {

/// The rows of the errors of a pool; 0 if they differ.
int common_rows(const detail::EdgePool& pool, const PoolEvidence& edges) {
  const int rows = pool.shape(edges.edges.front()).rows;
  if (pool.uniform_shape()) return rows;
  const bool all = std::all_of(edges.edges.begin(), edges.edges.end(),
                               [&](std::uint32_t edge) { return pool.shape(edge).rows == rows; });
  return all ? rows : 0;
}

/// An entry of the diagonal of Ω that is far from the median of its type.
struct OddScale {
  int row = 0;
  double ratio = 1;
  EdgeRef edge;
};

/// Finds the edges whose Ω has, in a row, another scale than that of most edges of their type: more than
/// kMost times as large or as small as the median, and separated from all others by a factor of more than
/// kGap. Scales that differ by mere uncertainty have no such gap.
class ScaleFinder {
 public:
  static constexpr double kMost = 1e5, kGap = 30;
  static constexpr std::size_t kFewest = 5;

  ScaleFinder(const Evidence& evidence, const PoolEvidence& edges)
      : evidence_(evidence), edges_(edges), pool_(*evidence.graph.edge_pools()[edges.pool]) {}

  /// The edges, each once, and the entry with the largest ratio.
  std::vector<EdgeRef> find(OddScale& oddest) {
    const int rows = edges_.edges.size() < kFewest ? 0 : common_rows(pool_, edges_);
    std::vector<EdgeRef> result;
    for (int row = 0; row < rows; ++row) find_in_row(row, rows, result, oddest);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

 private:
  /// Reads the entries of a row. Returns false if they differ so little that none is odd.
  bool read(int row, int rows) {
    entries_.clear();
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const std::uint32_t edge : edges_.edges) {
      const double entry = pool_.information(edge, rows)(row, row);
      entries_.push_back(entry);
      if (entry <= 0) continue;
      least = std::min(least, entry);
      most = std::max(most, entry);
    }
    return most > kMost * least;
  }

  /// The median of the positive entries, and the scales that are usual.
  struct Usual {
    double median, least, most;
  };
  Usual usual() {
    sorted_ = entries_;
    std::erase_if(sorted_, [](double entry) { return entry <= 0; });
    std::sort(sorted_.begin(), sorted_.end());
    const std::size_t middle = sorted_.size() / 2;
    Usual result{sorted_[middle], sorted_.front(), sorted_.back()};
    for (std::size_t k = middle; k + 1 < sorted_.size(); ++k) {
      if (sorted_[k + 1] <= kGap * sorted_[k] || sorted_[k + 1] <= kMost * result.median) continue;
      result.most = sorted_[k];
      break;
    }
    for (std::size_t k = middle; k > 0; --k) {
      if (sorted_[k] <= kGap * sorted_[k - 1] || result.median <= kMost * sorted_[k - 1]) continue;
      result.least = sorted_[k];
      break;
    }
    return result;
  }

  void find_in_row(int row, int rows, std::vector<EdgeRef>& result, OddScale& oddest) {
    if (!read(row, rows)) return;
    const Usual range = usual();
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      if (entries_[k] <= 0 || (entries_[k] >= range.least && entries_[k] <= range.most)) continue;
      const EdgeRef edge = evidence_.edge_ref(edges_.pool, edges_.edges[k]);
      const double ratio = entries_[k] / range.median;
      result.push_back(edge);
      if (std::abs(std::log(ratio)) > std::abs(std::log(oddest.ratio))) oddest = {row, ratio, edge};
    }
  }

  const Evidence& evidence_;
  const PoolEvidence& edges_;
  const detail::EdgePool& pool_;
  std::vector<double> entries_, sorted_;
};

bool is_zero(const detail::InformationView& omega) {
  for (int i = 0; i < omega.rows; ++i) {
    if (omega(i, i) != 0) return false;
  }
  return true;
}

}  // namespace

void find_zero_information(const Evidence& evidence, Findings& out) {
  Finding finding;
  for (const PoolEvidence& edges : evidence.pools) {
    const detail::EdgePool& pool = *evidence.graph.edge_pools()[edges.pool];
    for (const std::uint32_t edge : edges.edges) {
      if (is_zero(pool.information(edge))) finding.edges.push_back(evidence.edge_ref(edges.pool, edge));
    }
  }
  if (finding.edges.empty()) return;
  finding.severity = Finding::Severity::kWarning;
  finding.text = fmt::format(
      "the Ω of {} is zero, so {} nothing: set Ω to the inverse covariance of the error, or remove {}",
      edges_text(evidence.graph, finding.edges),
      by_count(finding.edges.size(), "it measures", "they measure"),
      by_count(finding.edges.size(), "the edge", "these edges"));
  out.push_back(std::move(finding));
}

void find_mixed_units(const Evidence& evidence, Findings& out) {
  for (const PoolEvidence& edges : evidence.pools) {
    OddScale oddest;
    Finding finding;
    finding.edges = ScaleFinder(evidence, edges).find(oddest);
    if (finding.edges.empty()) continue;
    finding.severity = Finding::Severity::kWarning;
    const std::string size = oddest.ratio > 1 ? fmt::format("{:.2g} times as large as", oddest.ratio)
                                              : fmt::format("{:.2g} times smaller than", 1 / oddest.ratio);
    const std::string where = finding.edges.size() == 1
                                  ? fmt::format("row {}", oddest.row + 1)
                                  : fmt::format("row {} of {}", oddest.row + 1,
                                                edges_text(evidence.graph, std::span(&oddest.edge, 1)));
    finding.text =
        fmt::format("Ω of {} is {} usual for {} ({}): check the units (mm or m, degrees or radians)",
                    edges_text(evidence.graph, finding.edges), size,
                    evidence.graph.edge_pools()[edges.pool]->type_name(), where);
    out.push_back(std::move(finding));
  }
}

}  // namespace boxplus
