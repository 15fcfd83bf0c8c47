// SPDX-License-Identifier: BSD-3-Clause
// A drive through a town of square blocks.
#pragma once

#include <vector>

#include "boxplus/base/matrix.h"
#include "testing/random_numbers.h"

namespace boxplus {

/// Streets are the lines x = i · kBlock and y = j · kBlock for all integers i and j, and as wide as 2
/// kHalfStreet. In meters.
struct Town {
  static constexpr double kBlock = 80, kHalfStreet = 8;
};

/// A drive in the middle of the streets. Turns are quarter circles; the car takes them at half speed.
class TownRoute {
 public:
  struct Place {
    Vector2 position;
    double heading;  ///< radians, from the x-axis to the y-axis
  };

  /// A route of at least `length` meters. It begins at the crossing (0, 0), in the direction of x. If
  /// `returns` is true, it stays within a square of blocks, so that it visits each street about three times.
  /// Otherwise, it never drives towards −x or −y, and visits no street twice.
  TownRoute(double length, bool returns, RandomNumbers& random);

  /// The place after `time` seconds at 1 m/s (0.5 m/s in turns). Takes O(log pieces).
  Place at(double time) const;

 private:
  struct Piece {
    double begin_time;
    Vector2 begin;
    int direction;  // 0: x, 1: y, 2: −x, 3: −y
    int turn;       // 1: to the left, 0: straight on, −1: to the right
  };

  void drive(double length, int direction, int turn);

  std::vector<Piece> pieces_;
  double time_ = 0;
  Vector2 end_{Town::kHalfStreet, 0};
};

}  // namespace boxplus
