// SPDX-License-Identifier: BSD-3-Clause
// The streets of a simulated town, and a route that drives each of them 2 to 4 times.
#pragma once

#include <array>
#include <vector>

#include "boxplus/base/matrix.h"
#include "boxplus/manifold/se2.h"
#include "testing/random_numbers.h"

namespace boxplus {

/// A slightly curved street between two crossings, driven in steps of about a meter.
struct Street {
  int from = 0, to = 0;  ///< the crossings at its ends
  int steps = 0;         ///< the number of steps; positions go from 0 (at `from`) to `steps` (at `to`)
  double bow = 0;        ///< how far its middle is to the left of the straight line between its ends
  int passes = 2;        ///< how often a route drives along the street
};

/// One drive along a whole street.
struct Leg {
  int street = 0;
  bool forward = true;  ///< whether the drive goes from Street::from to Street::to
};

/// Streets between the crossings of a lattice. The lattice is bent as a whole, and crossings are also
/// displaced at random. Avenues are complete, but some other streets are missing.
class StreetNetwork {
 public:
  /// Makes streets of about `block` steps. Makes as many streets as a route of about `steps` steps can drive
  /// 2 to 4 times each. No street has fewer than 4/5 `block` steps.
  StreetNetwork(int steps, int block, RandomNumbers& random);

  const std::vector<Vector2>& crossings() const { return crossings_; }
  const std::vector<Street>& streets() const { return streets_; }
  const Street& street(const Leg& leg) const { return streets_[leg.street]; }

  /// A closed tour (Hierholzer 1873) in which each street appears as often as it has passes. The robot rarely
  /// turns around and drives back.
  std::vector<Leg> route(RandomNumbers& random) const;

  /// A pose on the right-hand side of the street, in the direction of the drive. `position` is counted from
  /// Street::from for both directions of the drive.
  SE2 pose(const Leg& leg, int position) const;
  /// The point `left` meters to the left of the street's middle line, seen from Street::from.
  Vector2 beside(const Street& street, double position, double left) const;
  double length(const Street& street) const;

 private:
  int crossing(int column, int row) const { return row * columns_ + column; }
  void lay_crossings(int block, RandomNumbers& random);
  void lay_streets(int block, RandomNumbers& random);
  void add_passes(int steps, RandomNumbers& random);
  std::vector<std::array<int, 4>> blocks() const;
  Vector2 tangent(const Street& street, double position) const;

  int columns_, rows_;
  std::vector<Vector2> crossings_;
  std::vector<Street> streets_;
};

}  // namespace boxplus
