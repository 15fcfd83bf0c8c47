// SPDX-License-Identifier: BSD-3-Clause
// The absolute measurement of the position of a sensor that is mounted on a pose, for example of the antenna
// of a satellite receiver.
#pragma once

#include "boxplus/graph/stored_estimate.h"
#include "boxplus/types/pose_math.h"
#include "boxplus/types/type_label.h"

namespace boxplus {

namespace detail {
struct OffsetPositionPriorText {
  static constexpr std::string_view kText = "OffsetPositionPrior";
};
}  // namespace detail

/// z measures the position in the world of a point l that is fixed to the body (the lever arm, in the frame
/// of the body). Error: X l − z, in meters, along the axes of the world. Vertices: the pose X (T_world_body),
/// l.
template <class V>
struct OffsetPositionPrior {
  static constexpr std::string_view kName = detail::TypeLabel<detail::OffsetPositionPriorText, V>::kValue;
  V measurement;

  explicit OffsetPositionPrior(const V& z) : measurement(z) {}

  template <class X, class Arm>
  auto error(const X& x, const Arm& lever_arm) const {
    return Vector<detail::ScalarOf<X>, V::SizeAtCompileTime>(x * lever_arm - measurement);
  }

  /// The position of the body, if its rotation is right.
  template <class X>
  detail::RelativeFrame relative_frame(const X& x, const V& lever_arm) const {
    return detail::relative_pose(detail::RelativeFrame::kWorld, 0, V(measurement - x.rotation() * lever_arm));
  }
};

template <class V>
OffsetPositionPrior(const V&) -> OffsetPositionPrior<detail::StoredEstimate<V>>;

}  // namespace boxplus
