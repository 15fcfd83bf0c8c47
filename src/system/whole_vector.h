// SPDX-License-Identifier: BSD-3-Clause
// Norms and products of vectors of a System, of which each process may have only a part.
#pragma once

#include <span>

#include "base/vector_math.h"
#include "boxplus/system/system.h"

namespace boxplus {

inline double dot(const System& system, std::span<const double> a, std::span<const double> b) {
  return system.sum(dot(a, b));
}

inline double max_abs(const System& system, std::span<const double> a) {
  return system.max(max_abs(a));
}

/// Whether any process says so.
inline bool any(const System& system, bool here) {
  return system.max(here ? 1 : 0) > 0;
}

/// model_decrease() of the whole step.
inline double model_decrease(const System& system, std::span<const double> step, double curvature) {
  return -(2 * dot(system, system.gradient(), step) + curvature);
}

}  // namespace boxplus
