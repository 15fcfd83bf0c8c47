// SPDX-License-Identifier: BSD-3-Clause
// Finds things near a place of the plane.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "boxplus/base/matrix.h"

namespace boxplus {

/// Sorts indices into square cells of the plane.
class PlaneCells {
 public:
  explicit PlaneCells(double width) : width_(width) {}

  void add(const Vector2& place, int index) { cells_[key(cell(place[0]), cell(place[1]))].push_back(index); }

  /// Calls visit(index) for everything in the cells that a square around `center` touches. The square has
  /// sides of 2 `radius`. The order is that of the cells, and then that of the calls of add().
  template <class Visit>
  void around(const Vector2& center, double radius, Visit&& visit) const {
    for (std::int64_t y = cell(center[1] - radius); y <= cell(center[1] + radius); ++y) {
      for (std::int64_t x = cell(center[0] - radius); x <= cell(center[0] + radius); ++x) {
        const auto found = cells_.find(key(x, y));
        if (found == cells_.end()) continue;
        for (int index : found->second) visit(index);
      }
    }
  }

 private:
  std::int64_t cell(double coordinate) const {
    return static_cast<std::int64_t>(std::floor(coordinate / width_));
  }
  static std::int64_t key(std::int64_t x, std::int64_t y) { return y * (std::int64_t{1} << 32) + x; }

  double width_;
  std::unordered_map<std::int64_t, std::vector<int>> cells_;
};

}  // namespace boxplus
