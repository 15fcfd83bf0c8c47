// SPDX-License-Identifier: BSD-3-Clause
#include "linear/ordering/vertex_separator.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <queue>
#include <utility>

#include "base/paced_stop.h"

namespace boxplus {
namespace {

constexpr std::uint32_t kNoVertex = 0xFFFFFFFFu;
constexpr std::uint32_t kCoarsest = 100;  // the number of vertices of a graph that is not coarsened further
constexpr double kLeastShrinkage = 0.95;  // the largest useful ratio of the sizes after and before coarsening
constexpr double kLargestSide = 0.6;      // the largest share of one side in the total weight
constexpr double kImbalance = 0.5;        // the cost of unequal sides, relative to the separator's weight
constexpr std::uint32_t kTries = 3;       // the number of divisions, of which the best is used
constexpr std::uint32_t kSeeds = 5;       // the number of start vertices that are tried in the coarsest graph
constexpr int kMostPasses = 3;            // the largest number of passes of the refinement
constexpr int kPatience = 60;             // the number of moves without gain after which a pass ends

Side other(Side side) {
  return side == kLeft ? kRight : kLeft;
}

/// A pseudorandom number that is the same in every run (the finalizer of MurmurHash3, Appleby 2011).
std::uint32_t scramble(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x85ebca6bu;
  x = (x ^ (x >> 13)) * 0xc2b2ae35u;
  return x ^ (x >> 16);
}

/// Matches vertices in pairs. Returns the partner of each vertex, or the vertex itself if it has no partner.
/// Visits vertices of low degree first. Each vertex chooses the free neighbor with the heaviest edge. `salt`
/// decides between edges of equal weight.
std::vector<std::uint32_t> heavy_edge_matching(const WeightedGraph& graph, std::uint32_t salt,
                                               PacedStop& pace) {
  struct Visit {
    std::uint64_t rank;
    std::uint32_t vertex;
  };
  const std::uint32_t n = graph.vertices();
  const std::int64_t limit = 3 * graph.total() / (2 * kCoarsest) + 1;
  std::vector<Visit> visits(n);
  std::vector<std::uint32_t> luck(n), partner(n, kNoVertex);
  for (std::uint32_t v = 0; v < n; ++v) {
    luck[v] = scramble(v ^ salt);
    visits[v] = {std::uint64_t{graph.start[v + 1] - graph.start[v]} << 32 | luck[v], v};
  }
  std::sort(visits.begin(), visits.end(), [&](const Visit& a, const Visit& b) {
    pace.step();
    return a.rank < b.rank;
  });
  for (const auto& [rank, v] : visits) {
    if (partner[v] != kNoVertex) continue;
    std::uint32_t best = v;
    std::int64_t heaviest = 0;
    for (std::uint32_t k = graph.start[v]; k < graph.start[v + 1]; ++k) {
      pace.step();
      const std::uint32_t u = graph.neighbor[k];
      const std::int64_t weight = graph.edge_weight[k];
      if (partner[u] != kNoVertex || graph.weight[u] + graph.weight[v] > limit) continue;
      if (weight > heaviest || (weight == heaviest && luck[u] < luck[best])) best = u, heaviest = weight;
    }
    partner[v] = best;
    partner[best] = v;
  }
  return partner;
}

/// Merges partners. `coarse_of` receives, for each vertex of `graph`, the vertex of the result.
WeightedGraph contract(const WeightedGraph& graph, const std::vector<std::uint32_t>& partner,
                       std::vector<std::uint32_t>& coarse_of, PacedStop& pace) {
  const std::uint32_t n = graph.vertices();
  coarse_of.assign(n, kNoVertex);
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < n; ++v) {
    if (coarse_of[v] == kNoVertex) coarse_of[v] = coarse_of[partner[v]] = count++;
  }
  WeightedGraph coarse;
  coarse.weight.assign(count, 0);
  std::vector<std::uint32_t> place(count, kNoVertex);  // the index in coarse.neighbor of each neighbor
  for (std::uint32_t v = 0; v < n; ++v) {
    if (coarse.start.size() != coarse_of[v] + std::size_t{1}) continue;  // already merged with its partner
    const std::uint32_t c = coarse_of[v], first = coarse.start.back();
    const auto add = [&](std::uint32_t fine) {
      coarse.weight[c] += graph.weight[fine];
      for (std::uint32_t k = graph.start[fine]; k < graph.start[fine + 1]; ++k) {
        pace.step();
        const std::uint32_t u = coarse_of[graph.neighbor[k]];
        if (u == c) continue;
        if (place[u] == kNoVertex || place[u] < first) {
          place[u] = static_cast<std::uint32_t>(coarse.neighbor.size());
          coarse.neighbor.push_back(u);
          coarse.edge_weight.push_back(0);
        }
        coarse.edge_weight[place[u]] += graph.edge_weight[k];
      }
    };
    add(v);
    if (partner[v] != v) add(partner[v]);
    coarse.start.push_back(static_cast<std::uint32_t>(coarse.neighbor.size()));
  }
  return coarse;
}

/// Moves vertices out of the separator to decrease cost(). Also makes a limited number of moves that do not
/// decrease it, because they may allow later moves that do.
class Refiner {
 public:
  Refiner(const WeightedGraph& graph, std::vector<Side>& side, PacedStop& pace)
      : graph_(graph),
        side_(side),
        pace_(pace),
        locked_(graph.vertices(), 0),
        near_{std::vector<std::int64_t>(graph.vertices()), std::vector<std::int64_t>(graph.vertices())},
        move_of_(graph.vertices(), 0) {
    for (std::uint32_t v = 0; v < graph.vertices(); ++v) weight_[side[v]] += graph.weight[v];
    limit_ = static_cast<std::int64_t>(kLargestSide * static_cast<double>(graph.total()));
  }

  void run() {
    for (int k = 0; k < kMostPasses && pass(); ++k) {
    }
  }
  /// The cost to minimize: the weight of the separator, plus a cost for sides of different weight, plus a
  /// high cost if a side is too heavy.
  double cost() const {
    const auto left = static_cast<double>(weight_[kLeft]), right = static_cast<double>(weight_[kRight]);
    const auto separator = static_cast<double>(weight_[kSeparator]);
    const double excess = std::max(0.0, std::max(left, right) - static_cast<double>(limit_));
    return separator * (1 + kImbalance * std::abs(left - right) / (left + right + separator)) + 4 * excess;
  }

 private:
  struct Candidate {
    std::int64_t gain;
    std::uint32_t vertex;
    bool operator<(const Candidate& b) const { return gain != b.gain ? gain < b.gain : vertex > b.vertex; }
  };
  struct Change {
    std::uint32_t vertex;
    Side before;
  };

  /// The decrease of the separator's weight if v moves to the side `to`. The neighbors of v on the other side
  /// then join the separator.
  std::int64_t gain(std::uint32_t v, Side to) const { return graph_.weight[v] - near_[other(to)][v]; }
  void count_near(std::uint32_t v) {
    near_[kLeft][v] = near_[kRight][v] = 0;
    for (const std::uint32_t u : graph_.neighbors(v)) {
      pace_.step();
      if (side_[u] != kSeparator) near_[side_[u]][v] += graph_.weight[u];
    }
  }
  void propose(std::uint32_t v) {
    pace_.step();
    if (side_[v] != kSeparator || locked_[v]) return;
    for (const Side to : {kLeft, kRight}) queue_[to].push({gain(v, to), v});
  }
  /// The vertex that has the largest gain if it moves to the side `to`, or kNoVertex if no vertex can move.
  std::uint32_t best(Side to) {
    auto& queue = queue_[to];
    while (!queue.empty()) {
      const Candidate top = queue.top();
      if (side_[top.vertex] == kSeparator && !locked_[top.vertex] && gain(top.vertex, to) == top.gain)
        return top.vertex;
      queue.pop();  // outdated; a newer entry may be in the queue
    }
    return kNoVertex;
  }
  void set_side(std::uint32_t v, Side side) {
    changes_.push_back({v, side_[v]});
    weight_[side_[v]] -= graph_.weight[v];
    weight_[side] += graph_.weight[v];
    for (const std::uint32_t u : graph_.neighbors(v)) {
      pace_.step();
      if (side_[u] != kSeparator) continue;
      if (side_[v] != kSeparator) near_[side_[v]][u] -= graph_.weight[v];
      if (side != kSeparator) near_[side][u] += graph_.weight[v];
    }
    side_[v] = side;
    if (side == kSeparator) count_near(v);
  }
  /// Moves v, and proposes every vertex whose gain this changes, once.
  void move(std::uint32_t v, Side to) {
    set_side(v, to);
    locked_[v] = 1;
    ++moves_;
    changed_.clear();
    const auto note = [&](std::uint32_t u) {
      pace_.step();
      if (std::exchange(move_of_[u], moves_) != moves_) changed_.push_back(u);
    };
    for (const std::uint32_t u : graph_.neighbors(v)) {
      note(u);
      if (side_[u] != other(to)) continue;
      set_side(u, kSeparator);
      for (const std::uint32_t w : graph_.neighbors(u)) note(w);
    }
    for (const std::uint32_t u : changed_) propose(u);
  }
  /// The side to which the next vertex moves, or kSeparator if no vertex can move.
  Side choose() {
    const std::uint32_t left = best(kLeft), right = best(kRight);
    const auto fits = [&](std::uint32_t v, Side to) {
      return v != kNoVertex && weight_[to] + graph_.weight[v] <= limit_;
    };
    const Side lighter = weight_[kLeft] <= weight_[kRight] ? kLeft : kRight;
    const bool fits_left = fits(left, kLeft), fits_right = fits(right, kRight);
    if (fits_left && fits_right) {
      const std::int64_t to_left = queue_[kLeft].top().gain, to_right = queue_[kRight].top().gain;
      return to_left == to_right ? lighter : to_left > to_right ? kLeft : kRight;
    }
    if (fits_left) return kLeft;
    if (fits_right) return kRight;
    return (lighter == kLeft ? left : right) != kNoVertex ? lighter : kSeparator;
  }

  /// Makes one pass. Then undoes all moves that were made after the cost was lowest. Returns whether the cost
  /// decreased.
  bool pass() {
    std::fill(locked_.begin(), locked_.end(), 0);
    for (auto& queue : queue_) queue = {};
    for (std::uint32_t v = 0; v < graph_.vertices(); ++v) {
      if (side_[v] == kSeparator) count_near(v);
      propose(v);
    }
    changes_.clear();
    const double before = cost();
    double lowest = before;
    std::size_t kept = 0;
    for (int since = 0; since < kPatience; ++since) {
      const Side to = choose();
      if (to == kSeparator) break;
      const std::uint32_t v = queue_[to].top().vertex;
      queue_[to].pop();
      move(v, to);
      if (const double now = cost(); now < lowest) lowest = now, kept = changes_.size(), since = -1;
    }
    while (changes_.size() > kept) {
      const auto [v, side] = changes_.back();
      changes_.pop_back();
      weight_[side_[v]] -= graph_.weight[v];
      weight_[side] += graph_.weight[v];
      side_[v] = side;
    }
    return lowest < before;
  }

  const WeightedGraph& graph_;
  std::vector<Side>& side_;
  PacedStop& pace_;
  std::vector<std::uint8_t> locked_;
  /// For each vertex of the separator: the weight of its neighbors on each side.
  std::array<std::vector<std::int64_t>, 2> near_;
  std::int64_t weight_[3] = {0, 0, 0}, limit_ = 0;
  std::array<std::priority_queue<Candidate>, 2> queue_;
  std::vector<Change> changes_;
  std::vector<std::uint32_t> changed_;  // the vertices whose gain the current move changes
  std::vector<std::uint32_t> move_of_;  // the last move that changed the gain of each vertex
  std::uint32_t moves_ = 0;
};

/// Grows one side from `seed` by breadth-first search, until it has half of the weight. The vertices next to
/// this side become the separator.
std::vector<Side> grow_from(const WeightedGraph& graph, std::uint32_t seed, PacedStop& pace) {
  const std::uint32_t n = graph.vertices();
  std::vector<Side> side(n, kRight);
  std::vector<std::uint32_t> front;
  std::vector<std::uint8_t> seen(n, 0);
  const std::int64_t half = graph.total() / 2;
  std::int64_t grown = 0;
  std::uint32_t next_seed = seed;
  for (std::size_t k = 0; grown < half; ++k) {
    if (k == front.size()) {
      while (seen[next_seed]) next_seed = (next_seed + 1) % n;
      front.push_back(next_seed);
      seen[next_seed] = 1;
    }
    const std::uint32_t v = front[k];
    side[v] = kLeft;
    grown += graph.weight[v];
    for (const std::uint32_t u : graph.neighbors(v)) {
      pace.step();
      if (!seen[u]) seen[u] = 1, front.push_back(u);
    }
  }
  for (std::uint32_t v = 0; v < n; ++v) {
    if (side[v] != kRight) continue;
    for (const std::uint32_t u : graph.neighbors(v)) {
      if (side[u] == kLeft) {
        side[v] = kSeparator;
        break;
      }
    }
  }
  return side;
}

/// The sides of all vertices, and the cost of this division.
struct Parted {
  std::vector<Side> side;
  double cost;
};

Parted part_coarsest(const WeightedGraph& graph, PacedStop& pace) {
  Parted best{{}, 0};
  const std::uint32_t n = graph.vertices();
  for (std::uint32_t k = 0; k < kSeeds; ++k) {
    std::vector<Side> side =
        grow_from(graph, static_cast<std::uint32_t>(std::uint64_t{k} * n / kSeeds), pace);
    Refiner refiner(graph, side, pace);
    refiner.run();
    if (best.side.empty() || refiner.cost() < best.cost) best = {std::move(side), refiner.cost()};
  }
  return best;
}

/// Coarsens the graph, divides the coarsest graph, and refines the division on the way back.
Parted part(const WeightedGraph& graph, std::uint32_t salt, PacedStop& pace) {
  if (graph.vertices() <= kCoarsest) return part_coarsest(graph, pace);
  std::vector<std::uint32_t> coarse_of;
  const WeightedGraph coarse = contract(graph, heavy_edge_matching(graph, salt, pace), coarse_of, pace);
  if (coarse.vertices() >= kLeastShrinkage * graph.vertices()) return part_coarsest(graph, pace);
  const std::vector<Side> parted = part(coarse, salt, pace).side;
  std::vector<Side> side(graph.vertices());
  for (std::uint32_t v = 0; v < graph.vertices(); ++v) side[v] = parted[coarse_of[v]];
  Refiner refiner(graph, side, pace);
  refiner.run();
  return {std::move(side), refiner.cost()};
}

}  // namespace

std::int64_t WeightedGraph::total() const {
  return std::accumulate(weight.begin(), weight.end(), std::int64_t{0});
}

std::vector<Side> find_separator(const WeightedGraph& graph, const StopToken& stop) {
  if (graph.vertices() == 0) return {};
  PacedStop pace(stop);
  Parted best = part(graph, 0, pace);
  for (std::uint32_t salt = 1; salt < kTries; ++salt) {
    Parted next = part(graph, scramble(salt), pace);
    if (next.cost < best.cost) best = std::move(next);
  }
  return std::move(best.side);
}

}  // namespace boxplus
