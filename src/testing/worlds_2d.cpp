// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>

#include "boxplus/types/slam2d.h"
#include "testing/simulator.h"
#include "testing/worlds.h"

namespace boxplus {
namespace {

/// A walk along the streets of a square town, in steps of one meter.
class StreetWalk {
 public:
  StreetWalk(int half_size, int block) : half_size_(half_size), block_(block) {}

  int x() const { return x_; }
  int y() const { return y_; }
  SE2 pose() const { return {static_cast<double>(x_), static_cast<double>(y_), direction_ * kPi / 2}; }

  void step(RandomNumbers& random) {
    if (x_ % block_ == 0 && y_ % block_ == 0) turn(random);
    x_ += kDx[direction_];
    y_ += kDy[direction_];
  }

 private:
  static constexpr int kDx[] = {1, 0, -1, 0}, kDy[] = {0, 1, 0, -1};

  /// Goes straight on or turns left or right, but never leaves the town.
  void turn(RandomNumbers& random) {
    const int before = direction_;
    do {
      const double choice = random.uniform();
      direction_ = (before + (choice < 0.4 ? 0 : choice < 0.7 ? 1 : 3)) % 4;
    } while (std::abs(x_ + kDx[direction_]) > half_size_ || std::abs(y_ + kDy[direction_]) > half_size_);
  }

  int half_size_, block_, x_ = 0, y_ = 0, direction_ = 0;
};

/// Half the side of a town for a walk of `poses` steps, rounded to whole blocks.
int half_size_for(int poses, int block) {
  return block *
         std::max(2, static_cast<int>(std::lround(0.45 * std::sqrt(static_cast<double>(poses)) / block)));
}

}  // namespace

Simulation simulate_manhattan(const SimulationOptions& options) {
  constexpr int kBlock = 5, kLeastGap = 30;
  constexpr double kRecognized = 0.5;
  Simulator<SE2> simulator(options, {0.05, 0.015});
  StreetWalk walk(half_size_for(options.poses, kBlock), kBlock);
  std::map<std::pair<int, int>, int> last_visit;
  for (int k = 0; k < options.poses; ++k) {
    simulator.drive_to(walk.pose());
    const auto [visit, fresh] = last_visit.try_emplace({walk.x(), walk.y()}, k);
    if (!fresh && k - visit->second >= kLeastGap && simulator.random.uniform() < kRecognized) {
      simulator.recognize(visit->second, k);
    }
    visit->second = k;
    walk.step(simulator.random);
  }
  return simulator.take();
}

}  // namespace boxplus
