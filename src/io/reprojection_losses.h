// SPDX-License-Identifier: BSD-3-Clause
// What formats of bundle adjustment leave out, because they have only reprojection errors with Ω = I.
#pragma once

#include <string>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "boxplus/graph/graph.h"

namespace boxplus {

/// Sentences about all other edges, and about the information of the reprojection errors.
std::vector<std::string> reprojection_losses(const Graph& graph,
                                             detail::FunctionRef<bool(EdgeRef)> is_reprojection);

}  // namespace boxplus
