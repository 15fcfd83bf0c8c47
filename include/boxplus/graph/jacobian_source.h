// SPDX-License-Identifier: BSD-3-Clause
// Where the Jacobians of an edge type come from.
#pragma once

#include <cstdint>
#include <string_view>

#include "boxplus/base/abi.h"

namespace boxplus {

enum class JacobianSource : std::uint8_t {
  kAnalytic,   ///< "own": the type's member jacobians()
  kAutomatic,  ///< "exact": dual numbers through error()
  kNumeric     ///< "numeric": differences of error()
};
std::string_view to_string(JacobianSource source);

}  // namespace boxplus
