// SPDX-License-Identifier: BSD-3-Clause
// The representation of inertial measurements in a file (io/file_fields.h).
#pragma once

#include "boxplus/io/file_fields.h"
#include "boxplus/manifold/s2.h"
#include "boxplus/types/inertial.h"

namespace boxplus {

/// x y z of the direction. The vector must not be zero. Its length becomes 1, unless it is 1 up to rounding.
template <>
struct FileFields<S2> {
  static S2 read(FieldReader& in);
  static void write(const S2& x, FieldWriter& out);
};

/// Δp and ΔR as x y z qx qy qz qw, Δv, Δt, the six biases, their derivatives (9 × 6, by rows: ΔR, Δv, Δp),
/// and the acceleration of a falling body.
template <>
struct EdgeFields<InertialBetween> {
  static InertialBetween read(FieldReader& in);
  static void write(const InertialBetween& edge, FieldWriter& out);
};

}  // namespace boxplus
