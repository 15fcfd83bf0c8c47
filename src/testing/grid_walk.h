// SPDX-License-Identifier: BSD-3-Clause
// The path of a robot that goes straight on or turns by 90°.
#pragma once

#include <array>
#include <cmath>

#include "boxplus/manifold/se2.h"
#include "testing/plane_cells.h"
#include "testing/random_numbers.h"

namespace boxplus {

class GridWalk {
 public:
  /// The walk begins at the center of a square with this side, and stays in it.
  explicit GridWalk(double world_size) : half_size_(static_cast<int>(world_size / 2)) {}

  SE2 pose() const { return {static_cast<double>(x_), static_cast<double>(y_), direction_ * kPi / 2}; }

  void step(RandomNumbers& random) {
    constexpr double kStraight = 0.7;
    const double choice = random.uniform();
    const int x = x_ + kDx[direction_], y = y_ + kDx[(direction_ + 3) % 4];
    const bool is_inside = std::abs(x) <= half_size_ && std::abs(y) <= half_size_;
    if (choice < kStraight && is_inside) {
      x_ = x;
      y_ = y;
    } else {
      direction_ = (direction_ + (random.uniform() < 0.5 ? 1 : 3)) % 4;
    }
  }

 private:
  static constexpr int kDx[] = {1, 0, -1, 0};  // the step along y is that of the direction before
  int half_size_, x_ = 0, y_ = 0, direction_ = 0;
};

/// What a sensor reaches in the plane of the robot.
struct Reach {
  static constexpr double kRange = 5, kHalfView = 0.75 * kPi;
  template <class Point>
  static bool has(const Point& in_body) {
    const double distance = std::hypot(in_body[0], in_body[1]);
    return distance <= kRange && std::abs(std::atan2(in_body[1], in_body[0])) <= kHalfView;
  }
};

/// Recognizes poses at earlier visits: some of those in reach, from which the robot has moved on since.
class Revisits {
 public:
  /// Calls recognize(pose) for what the last pose recognizes, and adds this pose.
  template <class Recognize>
  void arrive(const Vector2& place, RandomNumbers& random, Recognize&& recognize) {
    constexpr int kLeastGap = 10;
    constexpr double kRecognized = 0.2;
    cells_.around(place, Reach::kRange, [&](int pose) {
      const bool is_near = (places_[pose] - place).norm() <= Reach::kRange;
      const bool is_earlier = static_cast<int>(places_.size()) - pose >= kLeastGap;
      if (is_near && is_earlier && random.uniform() < kRecognized) recognize(pose);
    });
    cells_.add(place, static_cast<int>(places_.size()));
    places_.push_back(place);
  }

 private:
  PlaneCells cells_{Reach::kRange};
  std::vector<Vector2> places_;
};

}  // namespace boxplus
