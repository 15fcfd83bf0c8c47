// SPDX-License-Identifier: BSD-3-Clause
// Gauge freedom: motions of a graph that change no error, and the policies that remove them.
#pragma once

#include <cstdint>
#include <string_view>

#include "boxplus/graph/handle.h"

namespace boxplus {

/// How to treat a connected component that can move without changing any error.
enum class GaugePolicy : std::uint8_t {
  /// Of the vertices with the largest dimension, take the vertex with the lowest id. If all of its directions
  /// are gauge freedom, hold it at its estimate during the solve. Its fixed flag does not change. For other
  /// gauge freedom (a scale, a heading), hold single directions, unless the algorithm damps H anyway.
  kFixFirst,
  kDamp,  ///< multiply each diagonal entry of H by 1 + 1e-10
  kError  ///< stop with Report::Reason::kGaugeFreedom
};

}  // namespace boxplus

namespace boxplus::detail {

/// A vertex that is held at its estimate to remove the gauge freedom of its component.
struct GaugeVertex {
  VertexRef vertex;
  Id id = 0;
};

/// Motions of all poses and points of a component that change no error. Vertices without a frame, such as a
/// focal length, may have to change along with them.
struct GaugeFreedom {
  VertexRef vertex;  ///< a vertex of the component
  Id id = 0;
  int directions = 0;  ///< number of independent motions
  bool translation = false, rotation = false, scale = false;
};
/// "rotation and scale"
std::string_view to_string(const GaugeFreedom& freedom);

}  // namespace boxplus::detail
