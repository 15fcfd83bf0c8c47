// SPDX-License-Identifier: BSD-3-Clause
#include "robust/is_redescending.h"

#include <algorithm>

namespace boxplus {

// The derivative of the influence with respect to |e| is ρ′ + 2e²ρ″. If the influence is proportional to
// |e|^p, the derivative is p ρ′. Because of rounding, p counts as negative only if it is below -0.01.
bool is_redescending(const RobustKernel& kernel) {
  constexpr double kFar = 1e8, kExponent = -0.01;
  const double delta = kernel.delta();
  const double e2 = kFar * std::max(delta, delta * delta);  // the width is in units of |e| or of e²
  const RobustKernel::Rho rho = kernel(e2);
  return rho.first <= 0 || rho.first + 2 * e2 * rho.second < kExponent * rho.first;
}

}  // namespace boxplus
