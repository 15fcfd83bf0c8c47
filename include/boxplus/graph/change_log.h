// SPDX-License-Identifier: BSD-3-Clause
// What has changed in a graph since an observer looked.
#pragma once

#include <vector>

#include "boxplus/graph/handle.h"

namespace boxplus::detail {

/// The graph appends to the log of its observer (Graph::set_change_log()), and the observer clears it.
/// Elements may appear several times, in the order of the changes; removed ones, too.
struct ChangeLog {
  std::vector<VertexRef> vertices;  ///< added, removed, moved, resized, or with other flags
  std::vector<EdgeRef> edges;  ///< added, removed, or with another measurement, Ω, kernel, flag or level
  bool everything = false;     ///< estimates have changed that `vertices` does not list

  void clear() {
    vertices.clear();
    edges.clear();
    everything = false;
  }
};

}  // namespace boxplus::detail
