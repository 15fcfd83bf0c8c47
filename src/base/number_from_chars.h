// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>

namespace boxplus {

/// std::from_chars() for double, which libc++ lacks.
std::from_chars_result number_from_chars(const char* begin, const char* end, double& value);

}  // namespace boxplus
