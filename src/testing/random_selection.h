// SPDX-License-Identifier: BSD-3-Clause
// A random part of a sequence.
#pragma once

#include <cmath>

#include "testing/random_numbers.h"

namespace boxplus {

/// Selects each element of a sequence with the probability `chance`. Draws one random number per selected
/// element, not per element.
class RandomSelection {
 public:
  RandomSelection(double chance, RandomNumbers& random)
      : log_of_others_(std::log1p(-chance)), random_(random) {
    draw_gap();
  }

  /// Whether the next element is selected.
  bool takes_next() {
    if (gap_ > 0) {
      --gap_;
      return false;
    }
    draw_gap();
    return true;
  }

 private:
  /// The number of elements before the next selected one is geometrically distributed.
  void draw_gap() {
    if (std::isfinite(log_of_others_)) gap_ = std::floor(std::log1p(-random_.uniform()) / log_of_others_);
  }

  double log_of_others_;  // ln(1 − chance)
  RandomNumbers& random_;
  double gap_ = 0;
};

}  // namespace boxplus
