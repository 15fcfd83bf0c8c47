// SPDX-License-Identifier: BSD-3-Clause
// Reads a field of a text file that consists of one number.
#pragma once

#include "io/characters.h"
#include "io/decimal.h"

namespace boxplus {

/// Whether a field ends at `at`.
inline bool ends_field(const char* at, const char* end) {
  return at == end || is_blank(*at);
}

/// The finite number that makes up the whole field at `at`. If the field is anything else, the result has no
/// `end`. `is_integer` is true if the field is an integer of at most 15 digits, which a double holds exactly.
Decimal read_number_field(const char* at, const char* end);

}  // namespace boxplus
