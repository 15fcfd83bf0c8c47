// SPDX-License-Identifier: BSD-3-Clause
// A guess that is stopped leaves no trace.
#pragma once

#include "boxplus/optimize/initial_guess.h"
#include "optimize/estimates.h"
#include "optimize/initial_guess/notes.h"

namespace boxplus::guess {

/// make(), a GuessResult; if it is stopped, the estimates are put back and no guess is made.
template <class Make>
GuessResult guess_or_restore(Graph& graph, const Plan& plan, Make&& make) {
  const Estimates before(graph, plan);
  try {
    return make();
  } catch (const Stopped&) {
    before.put_back(graph, plan);
    return {false, kStopped};
  }
}

}  // namespace boxplus::guess
