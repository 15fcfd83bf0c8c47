// SPDX-License-Identifier: BSD-3-Clause
// Changes of a graph that the user makes in its picture.
#pragma once

#include <cstdint>
#include <string>

#include "boxplus/graph/graph.h"
#include "viewer/scene/element.h"
#include "viewer/scene/structure.h"

namespace boxplus::viewer {

struct Edit {
  enum class Kind : std::uint8_t {
    kFix,      ///< a vertex keeps its estimate
    kFree,     ///< a vertex moves in all directions
    kRemove,   ///< a vertex with all of its edges, or an edge
    kDisable,  ///< an edge has no influence
    kEnable,
    kScale  ///< Ω of an edge is multiplied by `factor`
  };
  Kind kind;
  ElementName element;
  double factor = 1;
};

/// Returns what was done, as a sentence. Throws InvalidArgument, and changes nothing, if the graph has no
/// such element, if the edit makes no sense for it or would change nothing, if the last vertex would be
/// removed, or if the factor is not in [1e-9, 1e9] or makes Ω infinite.
std::string apply(const Edit& edit, Graph& graph, const Structure& structure);

}  // namespace boxplus::viewer
