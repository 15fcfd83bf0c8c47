// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "optimize/batch_system.h"

namespace boxplus {

/// Describes an edge for a message, such as "the edge Between<SE2> between vertices 3 4".
std::string edge_text(const Graph& graph, const EdgeRef& edge);

/// Describes the part of the problem that is not finite at the current estimates, and the edge that causes
/// it: "the error (or its robust kernel) of the edge …". chi2 must have been evaluated at these estimates.
std::string describe_non_finite(const Graph& graph, BatchSystem& system);

}  // namespace boxplus
