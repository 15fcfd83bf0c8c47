// SPDX-License-Identifier: BSD-3-Clause
#include "outliers/cycle_test.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.h"

namespace boxplus::outliers {
namespace {

std::int64_t distance(std::uint32_t a, std::uint32_t b) {
  return std::abs(static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b));
}

class PairFinder {
 public:
  PairFinder(const PoseGraph& poses, const OdometryChain& chain, int window)
      : closures_(poses.closures), chain_(chain), window_(window), by_from_(closures_.size()) {
    std::iota(by_from_.begin(), by_from_.end(), 0u);
    std::sort(by_from_.begin(), by_from_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tie(closures_[a].from, closures_[a].to, a) <
             std::tie(closures_[b].from, closures_[b].to, b);
    });
  }

  /// The pairs of each closure with its nearest neighbors among the later ones.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> find() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    std::vector<std::pair<std::int64_t, std::uint32_t>> near;
    for (std::size_t k = 0; k < by_from_.size(); ++k) {
      list_near(k, near);
      for (const auto& [distance, other] : near) pairs.emplace_back(by_from_[k], other);
    }
    return pairs;
  }

 private:
  /// A copy of a measurement confirms nothing.
  static bool are_copies(const PoseEdge& a, const PoseEdge& b) {
    return a.from == b.from && a.to == b.to && a.motion.translation == b.motion.translation &&
           a.motion.rotation == b.motion.rotation;
  }

  void list_near(std::size_t k, std::vector<std::pair<std::int64_t, std::uint32_t>>& near) const {
    constexpr std::size_t kNearest = 10;
    const PoseEdge& a = closures_[by_from_[k]];
    near.clear();
    for (std::size_t m = k + 1; m < by_from_.size(); ++m) {
      const PoseEdge& b = closures_[by_from_[m]];
      const std::int64_t from = distance(a.from, b.from), to = distance(a.to, b.to);
      if (from > window_) break;
      if (to > window_ || chain_.part(a.from) != chain_.part(b.from) ||
          chain_.part(a.to) != chain_.part(b.to) || are_copies(a, b))
        continue;
      near.emplace_back(from + to, by_from_[m]);
    }
    if (near.size() <= kNearest) return;
    std::nth_element(near.begin(), near.begin() + kNearest, near.end());
    near.resize(kNearest);
  }

  const std::vector<PoseEdge>& closures_;
  const OdometryChain& chain_;
  std::int64_t window_;
  std::vector<std::uint32_t> by_from_;
};

/// The deviation of closure a from the motion along the chain, closure b, and the chain: a.from → b.from →
/// b.to → a.to. All levers are relative to a.from.
Deviation cycle_deviation(const PoseEdge& a, const PoseEdge& b, const OdometryChain& chain) {
  const Motion first = chain.pose(a.from).inverse_times(chain.pose(b.from));
  const Motion last = chain.pose(b.to).inverse_times(chain.pose(a.to));
  const Motion around = first * b.motion * last;
  // The place of a.from, seen from the part of the chain to which a.to belongs.
  const Vector3 origin = (chain.pose(a.to) * a.motion.inverse()).translation;
  Spread spread = a.spread + b.spread;
  spread.translation += a.spread.rotation * a.motion.translation.squaredNorm() +
                        b.spread.rotation * (first * b.motion).translation.squaredNorm();
  spread = spread + chain.between(a.from, b.from).spread_at(chain.pose(a.from).translation) +
           chain.between(a.to, b.to).spread_at(origin);
  return Deviation::between(around, a.motion, spread);
}

}  // namespace

CycleTests test_cycles(const PoseGraph& poses, const OdometryChain& chain, const Evidence& evidence,
                       double needed, int window) {
  const auto pairs = PairFinder(poses, chain, window).find();
  std::vector<Deviation> deviations;
  deviations.reserve(pairs.size());
  for (const auto& [a, b] : pairs) {
    deviations.push_back(cycle_deviation(poses.closures[a], poses.closures[b], chain));
  }
  CycleTests result;
  result.support.assign(poses.closures.size(), -std::numeric_limits<double>::infinity());
  result.supporters.assign(poses.closures.size(), 0);
  result.noise_scale = evidence.noise_scale(deviations);
  DisjointSets sets(poses.closures.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double odds = evidence.log_odds(deviations[k], result.noise_scale);
    for (const std::uint32_t closure : {pairs[k].first, pairs[k].second}) {
      result.support[closure] = std::max(result.support[closure], odds);
      result.supporters[closure] += odds >= needed;
    }
    if (odds >= needed) sets.join(pairs[k].first, pairs[k].second);
  }
  std::vector<std::uint32_t> size(poses.closures.size(), 0);
  for (std::uint32_t k = 0; k < poses.closures.size(); ++k) {
    result.group.push_back(sets.find(k));
    ++size[result.group[k]];
  }
  for (const std::uint32_t group : result.group) result.group_size.push_back(size[group]);
  return result;
}

}  // namespace boxplus::outliers
