// SPDX-License-Identifier: BSD-3-Clause
// Random numbers that are the same with every standard library.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "boxplus/manifold/angle.h"

namespace boxplus {

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  /// A uniformly distributed number in [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// A uniformly distributed number in {0, …, count − 1}.
  int below(int count) { return static_cast<int>(uniform() * count); }
  /// A normally distributed number with mean 0 and variance 1 (Box & Muller 1958).
  double normal() {
    const double radius = std::sqrt(-2 * std::log1p(-uniform())), angle = 2 * kPi * uniform();
    return radius * std::cos(angle);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace boxplus
