// SPDX-License-Identifier: BSD-3-Clause
// One line that checks an edge's Jacobians in a test.
#pragma once

#include <gtest/gtest.h>

#include "boxplus/testing/check_jacobians.h"

namespace boxplus {

template <class E, class... X>
void expect_right_jacobians(const E& edge, const X&... x) {
  const JacobianCheck check = check_jacobians(edge, x...);
  EXPECT_TRUE(check.ok) << type_name<E>() << "\n" << check.message;
}

/// An arbitrary pose of space, with a rotation by |rotation_vector| radians.
inline SE3 pose(double x, double y, double z, double rx, double ry, double rz) {
  return SE3(Vector3(x, y, z), RotationVectorChart::exp(rx, ry, rz));
}

}  // namespace boxplus
