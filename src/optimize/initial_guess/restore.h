// SPDX-License-Identifier: BSD-3-Clause
// A guess that is stopped leaves no trace.
#pragma once

#include "boxplus/optimize/initial_guess.h"
#include "optimize/initial_guess/notes.h"

namespace boxplus::guess {

/// make(), a GuessResult; if it is stopped, the estimates are put back and no guess is made. Uses
/// VertexPool::kBestLevel.
template <class Make>
GuessResult guess_or_restore(Graph& graph, const Plan& plan, Make&& make) {
  const auto pool_of = [&](const VertexList& list) -> VertexPool& {
    return *graph.vertex_pools()[list.pool];
  };
  for (const VertexList& list : plan.vertices) pool_of(list).save(list.slots, VertexPool::kBestLevel);
  try {
    return make();
  } catch (const Stopped&) {
    for (const VertexList& list : plan.vertices) pool_of(list).restore(list.slots, VertexPool::kBestLevel);
    return {false, kStopped};
  }
}

}  // namespace boxplus::guess
