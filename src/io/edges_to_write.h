// SPDX-License-Identifier: BSD-3-Clause
// The order in which a file lists the edges of a graph.
#pragma once

#include <vector>

#include "boxplus/io/file_format.h"

namespace boxplus {

/// The edges in the order of the file, then those that were added later. An edge of the file that was
/// removed, or is listed a second time, is EdgeRef{}.
std::vector<EdgeRef> edges_to_write(const GraphFileView& file);

}  // namespace boxplus
