// SPDX-License-Identifier: BSD-3-Clause
#include "testing/street_network.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

namespace boxplus {
namespace {

constexpr int kNone = -1;
constexpr double kJitter = 0.1, kBend = 0.35, kMostBow = 0.06;  // lengths relative to a block
constexpr double kMissing = 0.2;  // the share of streets that are missing; avenues are complete
constexpr double kLane = 1.5;     // the meters from the middle line to the lane
constexpr int kLaneChange = 12;   // the number of steps to get into the lane

/// Whether a column or a row of the lattice is an avenue. Every fifth column and every fifth row is.
bool is_avenue(int line) {
  return line % 5 == 1;
}

/// The approximate number of steps that it takes to drive every street of a lattice twice.
double steps_for_two_passes(int columns, int rows, int block) {
  constexpr double kPresent = 0.88;
  return 2.0 * block * kPresent * (columns * (rows - 1) + rows * (columns - 1));
}

/// The sets of crossings that streets connect (union-find).
class Components {
 public:
  explicit Components(std::size_t crossings) : parents_(crossings) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }
  /// Joins two sets. Returns whether they were separate.
  bool join(int a, int b) {
    const int root_a = root(a), root_b = root(b);
    parents_[root_a] = root_b;
    return root_a != root_b;
  }

 private:
  int root(int crossing) {
    int& parent = parents_[crossing];
    return parent == crossing ? crossing : parent = root(parent);
  }
  std::vector<int> parents_;
};

template <class T>
std::vector<T> shuffled(std::vector<T> items, RandomNumbers& random) {
  for (std::size_t left = items.size(); left > 1; --left) {
    std::swap(items[left - 1], items[random.below(static_cast<int>(left))]);
  }
  return items;
}

}  // namespace

StreetNetwork::StreetNetwork(int steps, int block, RandomNumbers& random) : columns_(2), rows_(2) {
  constexpr double kShareOfTwoPasses = 0.73;  // the rest is for third and fourth passes
  while (true) {
    const int columns = columns_ + (columns_ == rows_), rows = rows_ + (columns_ != rows_);
    if (steps_for_two_passes(columns, rows, block) > kShareOfTwoPasses * steps) break;
    columns_ = columns;
    rows_ = rows;
  }
  lay_crossings(block, random);
  lay_streets(block, random);
  add_passes(steps, random);
}

void StreetNetwork::lay_crossings(int block, RandomNumbers& random) {
  const double jitter = kJitter * block, bend = kBend * block;
  const double phase_x = random.uniform(0, 2 * kPi), phase_y = random.uniform(0, 2 * kPi);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const double dx = random.uniform(-jitter, jitter), dy = random.uniform(-jitter, jitter);
      crossings_.emplace_back(
          block * column + bend * std::sin(0.7 * row + phase_x) + (is_avenue(column) ? 0 : dx),
          block * row + bend * std::sin(0.6 * column + phase_y) + (is_avenue(row) ? 0 : dy));
    }
  }
}

/// Adds streets between neighboring crossings of the lattice. Leaves out some streets, but keeps at least two
/// streets at each crossing, and a path between every two crossings.
void StreetNetwork::lay_streets(int block, RandomNumbers& random) {
  std::vector<Street> spare;
  std::vector<int> degree(crossings_.size());
  Components components(crossings_.size());
  const auto lay = [&](const Street& street) {
    streets_.push_back(street);
    streets_.back().steps = static_cast<int>(std::ceil(length(street)));
    for (int end : {street.from, street.to}) ++degree[end];
  };
  const auto plan = [&](int from, int to, bool avenue) {
    const bool is_spare = random.uniform() < kMissing && !avenue;
    const Street street{from, to, 0, random.uniform(-kMostBow, kMostBow) * block * !avenue};
    if (is_spare) {
      spare.push_back(street);
    } else {
      lay(street);
      components.join(from, to);
    }
  };
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const int here = crossing(column, row);
      if (column + 1 < columns_) plan(here, crossing(column + 1, row), is_avenue(row));
      if (row + 1 < rows_) plan(here, crossing(column, row + 1), is_avenue(column));
    }
  }
  for (const Street& street : spare) {
    const bool is_bridge = components.join(street.from, street.to);
    const int least = std::min(degree[street.from], degree[street.to]);
    if (is_bridge || least < 2) lay(street);
  }
}

/// Adds a third pass to all four streets of some blocks. Then adds a third and a fourth pass, there and back,
/// to some single streets. Stops when all passes together have `steps` steps. The number of passes that end
/// at a crossing stays even, as a closed tour requires.
void StreetNetwork::add_passes(int steps, RandomNumbers& random) {
  std::int64_t missing = steps;
  for (const Street& street : streets_) missing -= std::int64_t{street.passes} * street.steps;
  const auto add = [&](int index, int passes) {
    Street& street = streets_[index];
    street.passes += passes;
    missing -= std::int64_t{passes} * street.steps;
  };
  for (const std::array<int, 4>& block : shuffled(blocks(), random)) {
    const bool is_fresh =
        std::all_of(block.begin(), block.end(), [&](int street) { return streets_[street].passes == 2; });
    if (missing <= 0) return;
    if (!is_fresh) continue;
    for (int street : block) add(street, 1);
  }
  std::vector<int> order(streets_.size());
  std::iota(order.begin(), order.end(), 0);
  for (int street : shuffled(std::move(order), random)) {
    if (missing <= 0) return;
    if (streets_[street].passes == 2) add(street, 2);
  }
}

/// The four streets around each cell of the lattice. Leaves out cells with a missing street.
std::vector<std::array<int, 4>> StreetNetwork::blocks() const {
  std::map<std::pair<int, int>, int> street_between;
  for (std::size_t i = 0; i < streets_.size(); ++i) {
    street_between[{streets_[i].from, streets_[i].to}] = static_cast<int>(i);
  }
  std::vector<std::array<int, 4>> blocks;
  for (int a = 0; a < crossing(0, rows_ - 1); ++a) {
    const int b = a + 1, c = a + columns_, d = c + 1;
    const auto south = street_between.find({a, b}), west = street_between.find({a, c}),
               east = street_between.find({b, d}), north = street_between.find({c, d}),
               none = street_between.end();
    if (south == none || west == none || east == none || north == none) continue;
    blocks.push_back({south->second, west->second, east->second, north->second});
  }
  return blocks;
}

std::vector<Leg> StreetNetwork::route(RandomNumbers& random) const {
  std::vector<std::vector<int>> streets_at(crossings_.size());
  std::vector<int> left;  // the number of passes of each street that are still to be driven
  for (std::size_t i = 0; i < streets_.size(); ++i) {
    for (int end : {streets_[i].from, streets_[i].to}) {
      streets_at[end].push_back(static_cast<int>(i));
    }
    left.push_back(streets_[i].passes);
  }
  // Chooses a random street with a pass left. Turns back only if there is no other such street.
  const auto choose = [&](int at, int arrived_by) {
    std::vector<int> choices;
    for (int street : streets_at[at]) {
      if (left[street] > 0 && street != arrived_by) choices.push_back(street);
    }
    if (!choices.empty()) return choices[random.below(static_cast<int>(choices.size()))];
    return arrived_by != kNone && left[arrived_by] > 0 ? arrived_by : kNone;
  };
  std::vector<Leg> tour, open{{kNone, true}};
  const int start = crossing(1, 1);
  const auto end_of = [&](const Leg& leg) {
    if (leg.street == kNone) return start;
    const Street& street = streets_[leg.street];
    return leg.forward ? street.to : street.from;
  };
  while (!open.empty()) {
    const int here = end_of(open.back()), next = choose(here, open.back().street);
    if (next != kNone) {
      --left[next];
      open.push_back({next, streets_[next].from == here});
    } else {
      if (open.back().street != kNone) tour.push_back(open.back());
      open.pop_back();
    }
  }
  std::reverse(tour.begin(), tour.end());
  return tour;
}

double StreetNetwork::length(const Street& street) const {
  return (crossings_[street.to] - crossings_[street.from]).norm();
}

/// The direction of the middle line, which is a straight line plus half a sine wave of height `bow` across
/// it.
Vector2 StreetNetwork::tangent(const Street& street, double position) const {
  const Vector2 along = crossings_[street.to] - crossings_[street.from];
  const Vector2 across = Vector2(-along[1], along[0]) / along.norm();
  return along + street.bow * kPi * std::cos(kPi * position / street.steps) * across;
}

Vector2 StreetNetwork::beside(const Street& street, double position, double left) const {
  const Vector2 from = crossings_[street.from], along = crossings_[street.to] - from,
                across = Vector2(-along[1], along[0]) / along.norm(), forward = tangent(street, position);
  const double part = position / street.steps;
  return from + part * along + street.bow * std::sin(kPi * part) * across +
         left / forward.norm() * Vector2(-forward[1], forward[0]);
}

SE2 StreetNetwork::pose(const Leg& leg, int position) const {
  const Street& street = streets_[leg.street];
  const double part = std::min({1.0, static_cast<double>(position) / kLaneChange,
                                static_cast<double>(street.steps - position) / kLaneChange});
  const double in_lane = part * part * (3 - 2 * part);
  const Vector2 at = beside(street, position, (leg.forward ? -1 : 1) * kLane * in_lane);
  const Vector2 forward = tangent(street, position);
  const double heading = std::atan2(forward[1], forward[0]) + (leg.forward ? 0 : kPi);
  return {at[0], at[1], heading};
}

}  // namespace boxplus
