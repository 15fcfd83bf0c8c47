// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "optimize/batch_system.h"

namespace boxplus {

/// "the edge Between<SE2> between vertices 3 4"
std::string edge_text(const Graph& graph, const EdgeRef& edge);

/// What is not finite about the problem at the current estimates, and the edge that is to blame, after chi2
/// was evaluated there: "the error (or its robust kernel) of the edge …".
std::string describe_non_finite(const Graph& graph, BatchSystem& system);

}  // namespace boxplus
