// SPDX-License-Identifier: BSD-3-Clause
// Checks of sizes that are chosen at run time.
#pragma once

#include <string>

#include "boxplus/base/error.h"
#include "boxplus/manifold/manifold.h"

namespace boxplus::detail {

/// Throws InvalidArgument unless the sizes are equal: "expected 5 entries, as the measurement has, got 3".
inline void require_size(int expected, const char* owner, int actual) {
  if (expected == actual) return;
  throw InvalidArgument("expected " + std::to_string(expected) + " entries, as " + owner + " has, got " +
                        std::to_string(actual));
}

/// Throws InvalidArgument unless x has the size of z. Costs nothing if both sizes are fixed.
template <class Z, class X>
void require_same_size(const Z& z, const char* owner_of_z, const X& x) {
  if constexpr (Manifold<X>::kDim == kDynamic || Manifold<Z>::kDim == kDynamic)
    require_size(tangent_dim(z), owner_of_z, tangent_dim(x));
}

}  // namespace boxplus::detail
