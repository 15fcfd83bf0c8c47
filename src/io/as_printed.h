// SPDX-License-Identifier: BSD-3-Clause
// Undoes what reading did to printed numbers: finds few digits that read back to the same value.
#pragma once

#include "boxplus/manifold/quaternion.h"

namespace boxplus {

/// A quaternion of fewer digits that becomes `q`, bit for bit, when it is normalized; `q` if there is none.
Quaternion<double> as_printed(const Quaternion<double>& q);

/// An angle of few digits, a little beyond ±π, that becomes `theta`, bit for bit, when it is wrapped; `theta`
/// if there is none.
double as_printed(double theta);

}  // namespace boxplus
