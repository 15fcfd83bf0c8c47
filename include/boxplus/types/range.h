// SPDX-License-Identifier: BSD-3-Clause
// The distance between two vertices, of the plane or of space.
#pragma once

#include "boxplus/types/pose_math.h"

namespace boxplus {

/// z measures the distance (metres) between the positions of a and b, each a pose or a point. Error: |b − a|
/// − z. It has no derivative where a and b coincide: 0 is taken for it there, so do not begin there.
struct Range {
  static constexpr std::string_view kName = "Range";
  double measurement;

  explicit Range(double z) : measurement(z) {}

  template <class A, class B>
  ScalarOf<A> error(const A& a, const B& b) const {
    using std::sqrt;
    using S = ScalarOf<A>;
    const auto d = (position(b) - position(a)).eval();
    S sum = d[0] * d[0];
    for (Eigen::Index i = 1; i < d.size(); ++i) sum += d[i] * d[i];
    return sqrt(sum) - measurement;
  }
};

}  // namespace boxplus
