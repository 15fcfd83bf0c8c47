// SPDX-License-Identifier: BSD-3-Clause
// Numbers as a file printed them, where reading changed them: few digits that read back to the same value.
#pragma once

#include "boxplus/manifold/quaternion.h"

namespace boxplus {

/// A quaternion of fewer digits that normalising turns into `q`, bit for bit; `q` where there is none.
Quaternion<double> as_printed(const Quaternion<double>& q);

/// An angle a little beyond ±π, of few digits, that is wrapped to `theta`, bit for bit; `theta` where there
/// is none.
double as_printed(double theta);

}  // namespace boxplus
