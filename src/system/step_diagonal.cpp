// SPDX-License-Identifier: BSD-3-Clause
#include "system/step_diagonal.h"

#include <algorithm>
#include <cmath>

#include "base/vector_math.h"

namespace boxplus {

void StepDiagonal::resize(std::uint32_t scalars) {
  for (auto* vector : {&diagonal_, &scale_, &added_, &largest_}) vector->resize(scalars);
}

void StepDiagonal::begin_run() {
  std::ranges::fill(largest_, 0);
}

void StepDiagonal::set(std::uint32_t scalar, double entry) {
  constexpr double kMemory = 1e-7;  // the least scale, as a fraction of the largest entry
  double& largest = largest_[scalar];
  largest = std::max(largest, entry);
  diagonal_[scalar] = entry;
  scale_[scalar] = std::max(entry, kMemory * largest);
}

void StepDiagonal::find_floor() {
  constexpr double kFraction = 1e-20;  // smaller entries are rounding errors of Jacobians that are zero
  constexpr double kBits = 3;
  const double floor = std::max(kFraction * max_abs(diagonal_), 1e-300);
  floor_ = std::isfinite(floor) ? std::exp2(kBits * std::floor(std::ilogb(floor) / kBits)) : floor;
}

void StepDiagonal::fill(const StepDamping& damping, double gauge, double floor, std::uint32_t first,
                        std::uint32_t last) {
  const bool uniform = is_uniform(damping);
  for (std::uint32_t i = first; i < last; ++i) {
    const double scale = std::max(scale_[i], floor);
    added_[i] = damping.lambda * (uniform ? 1 : scale) + gauge * scale;
  }
}

void StepDiagonal::hold(std::uint32_t scalar, double times) {
  added_[scalar] += times * std::max(diagonal_[scalar], floor_);
}

bool StepDiagonal::depends_on_floor(const StepDamping& damping, double gauge, double a, double b,
                                    std::uint32_t count) const {
  if (a == b || (is_uniform(damping) && gauge == 0)) return false;
  return std::any_of(diagonal_.begin(), diagonal_.begin() + count,
                     [&](double entry) { return entry < std::max(a, b); });
}

}  // namespace boxplus
