// SPDX-License-Identifier: BSD-3-Clause
// The relative measurement between two sensors that are mounted on two poses.
#pragma once

#include "boxplus/types/pose_math.h"
#include "boxplus/types/type_label.h"

namespace boxplus {

namespace detail {
struct OffsetBetweenText {
  static constexpr std::string_view kText = "OffsetBetween";
};
}  // namespace detail

/// z measures the sensor pose xj·pj relative to the sensor pose xi·pi. pi and pj are the poses of the sensors
/// on the body. They are parameters or, if they are to be calibrated, vertices. Error: (xi pi)⁻¹ (xj pj) ⊟ z.
/// Vertices: xi, xj, pi, pj (tags in g2o files: EDGE_SE2_OFFSET, EDGE_SE3_OFFSET), or xi, xj, p if both ends
/// have the same sensor (EDGE_SE2_CALIB).
template <class T>
struct OffsetBetween {
  static constexpr std::string_view kName = detail::TypeLabel<detail::OffsetBetweenText, T>::kValue;
  T measurement;

  explicit OffsetBetween(const T& z) : measurement(z) {}

  template <class X>
  auto error(const X& xi, const X& xj, const X& pi, const X& pj) const {
    return detail::difference(detail::motion_between(X(xi * pi), X(xj * pj)), measurement);
  }
  template <class X>
  auto error(const X& xi, const X& xj, const X& p) const {
    return error(xi, xj, p, p);
  }

  detail::RelativeFrame relative_frame(const T&, const T&, const T& pi, const T& pj) const {
    return detail::relative_pose(0, 1, T(pi * measurement * pj.inverse()));
  }
  detail::RelativeFrame relative_frame(const T& xi, const T& xj, const T& p) const {
    return relative_frame(xi, xj, p, p);
  }
};

}  // namespace boxplus
