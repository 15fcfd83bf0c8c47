// SPDX-License-Identifier: BSD-3-Clause
// The source of the Jacobians of an edge type.
#pragma once

#include <cstdint>
#include <string_view>

#include "boxplus/base/abi.h"

namespace boxplus::detail {

enum class JacobianSource : std::uint8_t {
  kAnalytic,   ///< "analytic": the member jacobians() of the edge type
  kAutomatic,  ///< "exact": error() on dual numbers
  kNumeric     ///< "numeric": differences of error()
};
std::string_view to_string(JacobianSource source);

}  // namespace boxplus::detail
