// SPDX-License-Identifier: BSD-3-Clause
// The absolute measurement of a vertex.
#pragma once

#include <utility>

#include "boxplus/graph/stored_estimate.h"
#include "boxplus/graph/typed_edge_pool.h"
#include "boxplus/types/pose_math.h"
#include "boxplus/types/type_label.h"
#include "boxplus/types/vertex_pools.h"

namespace boxplus {

namespace detail {
struct PriorText {
  static constexpr std::string_view kText = "Prior";
};
}  // namespace detail

/// z measures x in the world. Error: x ⊟ z. The table shows the error for each T, and the tag in g2o files:
///   SE2  (x, y, θ) of z⁻¹ x           EDGE_PRIOR_SE2
///   SE3  (t, q_v) of z⁻¹ x            none; see OffsetPrior
///   Vector2, Vector3  x − z           EDGE_PRIOR_XY, EDGE_POINTXYZ_PRIOR
template <class T>
struct Prior {
  static constexpr std::string_view kName = detail::TypeLabel<detail::PriorText, T>::kValue;
  static constexpr bool kRigid = detail::kIsPose<T>;
  T measurement;

  explicit Prior(T z) : measurement(std::move(z)) {}

  template <class X>
  auto error(const X& x) const {
    return detail::difference(x, measurement);
  }

  detail::RelativeFrame relative_frame(const T&) const requires detail::FrameType<T> {
    return detail::relative_pose(detail::RelativeFrame::kWorld, 0, measurement);
  }
};

template <class T>
Prior(T) -> Prior<detail::StoredEstimate<T>>;

}  // namespace boxplus

namespace boxplus::detail {

extern template class TypedEdgePool<Prior<SE2>, SE2>;
extern template class TypedEdgePool<Prior<SE3>, SE3>;
extern template class TypedEdgePool<Prior<Vector2>, Vector2>;
extern template class TypedEdgePool<Prior<Vector3>, Vector3>;

}  // namespace boxplus::detail
