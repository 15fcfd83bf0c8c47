// SPDX-License-Identifier: BSD-3-Clause
// Tests that repeat work do less of it under a sanitizer, because each step then takes 10 to 100 times as
// long.
#pragma once

namespace boxplus {

#ifdef BOXPLUS_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace boxplus
