// SPDX-License-Identifier: BSD-3-Clause
// The absolute measurement of a vertex.
#pragma once

#include <utility>

#include "boxplus/graph/stored_estimate.h"
#include "boxplus/types/pose_math.h"
#include "boxplus/types/type_label.h"

namespace boxplus {

struct PriorText {
  static constexpr std::string_view kText = "Prior";
};

/// z measures x in the world. Error: x ⊟ z:
///   SE2  vec(z⁻¹ x)                   EDGE_PRIOR_SE2
///   SE3  (t, q_v) of z⁻¹ x
///   Vector2, Vector3  x − z           EDGE_PRIOR_XY, EDGE_POINTXYZ_PRIOR
template <class T>
struct Prior {
  static constexpr std::string_view kName = TypeLabel<PriorText, T>::kValue;
  static constexpr bool kRigid = kIsPose<T>;
  T measurement;

  explicit Prior(T z) : measurement(std::move(z)) {}

  template <class X>
  auto error(const X& x) const {
    return difference(x, measurement);
  }

  RelativeFrame relative_frame(const T&) const requires FrameType<T> {
    return relative_pose(RelativeFrame::kWorld, 0, measurement);
  }
};

template <class T>
Prior(T) -> Prior<StoredEstimate<T>>;

}  // namespace boxplus
