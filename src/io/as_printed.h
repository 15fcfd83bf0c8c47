// SPDX-License-Identifier: BSD-3-Clause
// Finds short decimal numbers that read back to the same value, although reading normalizes or wraps them.
#pragma once

#include "boxplus/manifold/quaternion.h"

namespace boxplus {

/// A quaternion with fewer digits that becomes `q`, bit for bit, when it is normalized; `q` if there is none.
detail::Quaternion<double> as_printed(const detail::Quaternion<double>& q);

/// An angle with few digits, slightly beyond ±π, that becomes `theta`, bit for bit, when it is wrapped;
/// `theta` if there is none.
double as_printed(double theta);

}  // namespace boxplus
