// SPDX-License-Identifier: BSD-3-Clause
// Under a sanitizer, tests make fewer repetitions, because each repetition takes 10 to 100 times as long.
#pragma once

namespace boxplus {

#ifdef BOXPLUS_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace boxplus
