// SPDX-License-Identifier: BSD-3-Clause
#include "outliers/false_odometry.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "boxplus/robust/default_width.h"

namespace boxplus::outliers {
namespace {

/// False closures may agree with each other in groups of this size. By chance, two groups may agree.
constexpr std::uint32_t kLargestFalseGroup = 10;

bool is_rejected_in_group(const CycleTests& cycles, std::size_t closure, const EdgeVerdict& verdict,
                          std::uint32_t larger_than) {
  return verdict.weight == 0 && verdict.supported && cycles.group_size[closure] > larger_than;
}

}  // namespace

std::vector<std::uint8_t> contradicting_links(const PoseGraph& poses, const Evidence& evidence, double scale,
                                              double needed) {
  constexpr double kTolerance = 16;  // of the noise
  std::vector<std::uint8_t> result(poses.links.size(), 0);
  std::vector<std::uint32_t> order(poses.links.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t k) { return poses.links[k].to; });
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const auto link = [&](std::size_t k) -> const PoseEdge& { return poses.links[order[k]]; };
    bool contradict = false;
    for (end = begin; end < order.size() && link(end).to == link(begin).to; ++end) {
      for (std::size_t other = begin; other < end; ++other) {
        const Spread spread = link(end).spread + link(other).spread;
        const auto deviation = Deviation::between(link(end).motion, link(other).motion, spread);
        contradict = contradict || evidence.log_odds(deviation, kTolerance * scale) < -needed;
      }
    }
    for (std::size_t k = begin; contradict && k < end; ++k) result[order[k]] = 1;
  }
  return result;
}

std::optional<Contradiction> most_contradicted_link(const Graph& graph, const PoseGraph& poses,
                                                    const CycleTests& cycles,
                                                    std::span<const EdgeVerdict> verdicts) {
  std::vector<std::int64_t> across(poses.poses.size() + 1, 0);  // rejected closures minus accepted ones
  for (std::size_t k = 0; k < verdicts.size(); ++k) {
    const PoseEdge& closure = poses.closures[k];
    const bool is_rejected = is_rejected_in_group(cycles, k, verdicts[k], kLargestFalseGroup);
    if (!is_rejected && verdicts[k].weight == 0) continue;
    across[closure.from + 1] += is_rejected ? 1 : -1;
    across[closure.to + 1] -= is_rejected ? 1 : -1;
  }
  std::partial_sum(across.begin(), across.end(), across.begin());
  std::pair<std::int64_t, double> most{kLargestFalseGroup, 0};
  std::optional<Contradiction> result;
  for (const PoseEdge& link : poses.links) {
    const std::pair candidate(across[link.to], graph.chi2(link.edge));
    if (candidate.first <= kLargestFalseGroup || candidate <= most) continue;
    most = candidate;
    result = {link.to, static_cast<std::size_t>(candidate.first)};
  }
  return result;
}

std::size_t rejected_in_large_groups(const CycleTests& cycles, std::span<const EdgeVerdict> verdicts) {
  constexpr std::uint32_t kByChance = 2;
  std::size_t count = 0;
  for (std::size_t k = 0; k < verdicts.size(); ++k)
    count += cycles.supporters[k] > kByChance &&
             is_rejected_in_group(cycles, k, verdicts[k], 2 * kLargestFalseGroup);
  return count > std::max<std::size_t>(kLargestFalseGroup, verdicts.size() / 100) ? count : 0;
}

std::vector<std::uint32_t> bent_links(const Graph& graph, const PoseGraph& poses, double noise_scale) {
  constexpr double kFarAbove = 20;
  constexpr std::size_t kMost = 3;
  if (poses.links.empty()) return {};
  std::vector<double> ratios;
  for (const PoseEdge& link : poses.links)
    ratios.push_back(graph.chi2(link.edge) / chi2_quantile(link.rows, 0.5));
  std::vector<double> sorted = ratios;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::ranges::nth_element(sorted, middle);
  const double most = kFarAbove * std::max(noise_scale, *middle);
  std::vector<std::size_t> bent;
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    if (ratios[k] > most) bent.push_back(k);
  }
  std::ranges::stable_sort(bent, std::greater(), [&](std::size_t k) { return ratios[k]; });
  std::vector<std::uint32_t> result;
  for (std::size_t k = 0; k < std::min(kMost, bent.size()); ++k) result.push_back(poses.links[bent[k]].to);
  return result;
}

}  // namespace boxplus::outliers
