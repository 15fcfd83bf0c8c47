// SPDX-License-Identifier: BSD-3-Clause
// What can move without changing any error, and what to do about it.
#pragma once

#include <cstdint>
#include <string_view>

#include "boxplus/graph/handle.h"

namespace boxplus {

/// What to do about a connected component that can move without changing any error.
enum class GaugePolicy : std::uint8_t {
  /// Hold its lowest-id vertex of largest dimension for the solve, if all of that vertex is gauge; its
  /// estimate and flag stay untouched. Of other freedom (a scale, a heading) hold single directions, unless
  /// damping does.
  kFixFirst,
  kDamp,  ///< add 1e-10 of itself to each diagonal entry of H
  kError  ///< stop with Status::kGaugeFreedom
};

/// Motions of a component, with all of its poses and points, that change no error.
struct GaugeFreedom {
  VertexRef vertex;  ///< of the component
  Id id = 0;
  int directions = 0;  ///< how many independent motions
  bool translation = false, rotation = false, scale = false;
};
/// "rotation and scale"
std::string_view to_string(const GaugeFreedom& freedom);

}  // namespace boxplus
