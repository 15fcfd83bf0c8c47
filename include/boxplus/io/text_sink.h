// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "boxplus/base/function_ref.h"

namespace boxplus {

/// Receives text piece by piece.
using TextSink = detail::FunctionRef<void(std::string_view)>;

}  // namespace boxplus
