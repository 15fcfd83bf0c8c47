// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/pairwise_sum.h"

namespace boxplus {

double pairwise_sum(std::span<const double> values) {
  constexpr std::size_t kLeaf = 32;
  if (values.size() <= kLeaf) {
    double sum = 0;
    for (double v : values) sum += v;
    return sum;
  }
  const std::size_t half = values.size() / 2;
  return pairwise_sum(values.first(half)) + pairwise_sum(values.subspan(half));
}

}  // namespace boxplus
