// SPDX-License-Identifier: BSD-3-Clause
// The distance between two vertices, in the plane or in space.
#pragma once

#include "boxplus/types/pose_math.h"

namespace boxplus {

/// z measures the distance (meters) between the positions of a and b, each a pose or a point. Error: |b − a|
/// − z. If a and b coincide, the error has no derivative, and the Jacobian is 0. If nothing else moves
/// them apart, optimize() displaces them in an arbitrary direction (Report::displaced_directions), so better
/// start from other estimates.
struct Range {
  static constexpr std::string_view kName = "Range";
  double measurement;

  explicit Range(double z) : measurement(z) {}

  template <class A, class B>
  detail::ScalarOf<A> error(const A& a, const B& b) const {
    using std::sqrt;
    using S = detail::ScalarOf<A>;
    detail::require_size(static_cast<int>(detail::position(a).size()), "the first vertex",
                         static_cast<int>(detail::position(b).size()));
    const auto d = (detail::position(b) - detail::position(a)).eval();
    S sum = d[0] * d[0];
    for (Eigen::Index i = 1; i < d.size(); ++i) sum += d[i] * d[i];
    return sqrt(sum) - measurement;
  }
};

}  // namespace boxplus
