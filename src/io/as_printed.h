// SPDX-License-Identifier: BSD-3-Clause
// Finds decimal numbers with few digits that a reader turns into exactly the given quaternion or angle, when
// it normalizes the quaternion or wraps the angle.
#pragma once

#include "boxplus/manifold/quaternion.h"

namespace boxplus {

/// A quaternion with few digits that becomes `q`, bit for bit, when it is normalized. Its length differs from
/// 1 by less than `tolerance`. Returns `q` itself if there is no such quaternion.
detail::Quaternion<double> as_printed(const detail::Quaternion<double>& q, double tolerance);

/// An angle with few digits, slightly beyond ±π, that becomes `theta`, bit for bit, when it is wrapped.
/// Returns `theta` itself if there is no such angle.
double as_printed(double theta);

}  // namespace boxplus
