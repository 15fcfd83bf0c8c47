// SPDX-License-Identifier: BSD-3-Clause
// Restores the estimates if a guess is stopped.
#pragma once

#include "guess/initial_guess.h"
#include "guess/notes.h"
#include "plan/estimates.h"

namespace boxplus::guess {

/// Returns the GuessResult of make(). If make() throws Stopped, restores the estimates and returns a
/// GuessResult with the note kStopped.
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
