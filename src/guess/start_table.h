// SPDX-License-Identifier: BSD-3-Clause
// A table of the values of Start, with their functions.
#pragma once

#include <span>

#include "boxplus/options/options.h"
#include "guess/initial_guess.h"

namespace boxplus::detail {

struct StartEntry {
  Start start;
  /// Null for kCurrent, which makes no guess, and for kAutomatic, which chooses one.
  GuessResult (*guess)(Graph&, const Plan&, const GuessLimits&);
};

/// One entry per Start, in the order of help texts.
std::span<const StartEntry> start_table();

}  // namespace boxplus::detail
