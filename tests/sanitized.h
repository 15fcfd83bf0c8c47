// SPDX-License-Identifier: BSD-3-Clause
// Under a sanitizer or an emulator, tests make fewer repetitions, because each repetition takes 10 to 100
// times as long.
#pragma once

#include <cstdlib>

namespace boxplus {

#ifdef BOXPLUS_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// Whether an emulator runs the program. It cannot start itself again.
inline bool is_emulated() {
  return std::getenv("BOXPLUS_EMULATED") != nullptr;
}

}  // namespace boxplus
