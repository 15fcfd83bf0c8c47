// SPDX-License-Identifier: BSD-3-Clause
// Checks the Jacobians of an edge, and makes poses for such tests.
#pragma once

#include <gtest/gtest.h>

#include "boxplus/testing/check_jacobians.h"

namespace boxplus {

template <class E, class... X>
void expect_correct_jacobians(const E& edge, const X&... x) {
  const JacobianCheck check = check_jacobians(edge, x...);
  EXPECT_TRUE(check.ok) << detail::type_name<E>() << "\n" << check.message;
}

/// A pose in space with the position (x, y, z) and the rotation vector (rx, ry, rz) in radians.
inline SE3 pose(double x, double y, double z, double rx, double ry, double rz) {
  return SE3(Vector3(x, y, z), detail::RotationVectorChart::exp(rx, ry, rz));
}

}  // namespace boxplus
