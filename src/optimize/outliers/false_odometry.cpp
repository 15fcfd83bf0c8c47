// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/outliers/false_odometry.h"

#include <algorithm>
#include <numeric>

namespace boxplus::outliers {

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

std::optional<Contradiction> most_contradicted_link(const PoseGraph& poses, const CycleTests& cycles,
                                                    std::span<const detail::EdgeVerdict> verdicts) {
  constexpr std::uint32_t kLargestFalseGroup = 10;
  std::vector<std::int64_t> across(poses.poses.size() + 1, 0);  // rejected closures minus accepted ones
  for (std::size_t k = 0; k < verdicts.size(); ++k) {
    const PoseEdge& closure = poses.closures[k];
    const bool is_rejected = verdicts[k].weight == 0;
    if (is_rejected && (!verdicts[k].supported || cycles.group_size[k] <= kLargestFalseGroup)) continue;
    across[closure.from + 1] += is_rejected ? 1 : -1;
    across[closure.to + 1] -= is_rejected ? 1 : -1;
  }
  std::partial_sum(across.begin(), across.end(), across.begin());
  Contradiction most;
  for (const PoseEdge& link : poses.links) {
    const std::int64_t closures = across[link.to];
    if (closures > static_cast<std::int64_t>(most.closures))
      most = {link.to, static_cast<std::size_t>(closures)};
  }
  return most.closures > kLargestFalseGroup ? std::optional(most) : std::nullopt;
}

}  // namespace boxplus::outliers
