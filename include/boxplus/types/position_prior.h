// SPDX-License-Identifier: BSD-3-Clause
// The absolute measurement of the position of a pose, for example by GPS.
#pragma once

#include "boxplus/graph/stored_estimate.h"
#include "boxplus/types/pose_math.h"
#include "boxplus/types/type_label.h"

namespace boxplus {

namespace detail {
struct PositionPriorText {
  static constexpr std::string_view kText = "PositionPrior";
};
}  // namespace detail

/// z measures the position of a pose in the world. Error: t(x) − z, with the translation t(x) of the pose.
/// The tags in g2o files are EDGE_PRIOR_SE2_XY and EDGE_SE3_XYZ_PRIOR. A line EDGE_SE3_XYZ_PRIOR also names a
/// sensor offset, although the error does not depend on it. This edge has the offset as its second vertex, so
/// that a writer can write the offset back to the file.
template <class V>
struct PositionPrior {
  static constexpr std::string_view kName = detail::TypeLabel<detail::PositionPriorText, V>::kValue;
  V measurement;

  explicit PositionPrior(const V& z) : measurement(z) {}

  template <class X>
  auto error(const X& x) const {
    using S = detail::ScalarOf<X>;
    return Vector<S, V::SizeAtCompileTime>(x.translation() - measurement);
  }
  template <class X>
  auto error(const X& x, const X& /*offset*/) const {
    return error(x);
  }

  template <class X, class... Offset>
  detail::RelativeFrame relative_frame(const X&, const Offset&...) const {
    return detail::relative_pose(detail::RelativeFrame::kWorld, 0, measurement);
  }
};

template <class V>
PositionPrior(const V&) -> PositionPrior<detail::StoredEstimate<V>>;

}  // namespace boxplus
