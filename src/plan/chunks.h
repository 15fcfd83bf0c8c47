// SPDX-License-Identifier: BSD-3-Clause
// Divides the columns of H and the active edges into chunks.
#pragma once

#include "plan/active_set.h"
#include "plan/plan.h"

namespace boxplus {

/// Adds the chunks of a plan whose structure and edges are known, if no vertex is eliminated: one for each of
/// plan.workers.
void add_chunks_by_owner(const Graph& graph, const ActiveSet& active, const StopToken& stop, Plan& plan);

/// Adds the chunks if vertices are eliminated: at most `count`. plan.columns must be known.
void add_chunks_with_copies(const Graph& graph, const ActiveSet& active, int count, const StopToken& stop,
                            Plan& plan);

}  // namespace boxplus
