// SPDX-License-Identifier: BSD-3-Clause
// The absolute measurement of a sensor that is mounted on a pose.
#pragma once

#include "boxplus/types/pose_math.h"
#include "boxplus/types/type_label.h"

namespace boxplus {

namespace detail {
struct OffsetPriorText {
  static constexpr std::string_view kText = "OffsetPrior";
};
}  // namespace detail

/// z measures the sensor pose x·p in the world; p is the pose of the sensor on the body. Error: (x p) ⊟ z.
/// The tag in g2o files is EDGE_SE3_PRIOR (for SE3).
template <class T>
struct OffsetPrior {
  static constexpr std::string_view kName = detail::TypeLabel<detail::OffsetPriorText, T>::kValue;
  T measurement;

  explicit OffsetPrior(const T& z) : measurement(z) {}

  template <class X>
  auto error(const X& x, const X& p) const {
    return detail::difference(X(x * p), measurement);
  }

  detail::RelativeFrame relative_frame(const T&, const T& p) const {
    return detail::relative_pose(detail::RelativeFrame::kWorld, 0, T(measurement * p.inverse()));
  }
};

}  // namespace boxplus
