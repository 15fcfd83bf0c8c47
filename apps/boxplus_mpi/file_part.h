// SPDX-License-Identifier: BSD-3-Clause
// Reads what a process needs of a file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"

namespace boxplus::app {

struct FilePart {
  /// The graph has all cameras, and the points of this process with their observations, as edges_of_part()
  /// chooses them. GraphFile::edges has only these.
  GraphFile file;
  /// The graph also has a few points of other processes, so that its connected components have the same
  /// cameras as those of the whole problem. These are the edges of these points.
  std::vector<EdgeRef> others = {};
  std::size_t all_edges = 0;  ///< the number of edges of the whole problem
};

/// Returns nothing if only the whole file can be read: if it is neither a BAL file nor a folder of COLMAP, or
/// has no observations. While it reads, needs 8 bytes per observation of the whole problem. It reads a BAL
/// file twice, and also holds COLMAP's points and 2-D points. Throws what read_graph() throws.
std::optional<FilePart> read_part(const std::string& path, const ReadOptions& options, int part, int parts);

}  // namespace boxplus::app
