// SPDX-License-Identifier: BSD-3-Clause
// Robust kernels by name. kernel_table.h lists the names.
#pragma once

#include <memory>
#include <string_view>

#include "boxplus/robust/robust_kernel.h"

namespace boxplus {

/// The kernel with the given name and width. "Barron:1.5" gives Barron's kernel with the shape 1.5; the shape
/// may also be -inf. Throws InvalidArgument for an unknown name (the message lists the known ones) or a width
/// that is not positive, or not from 1e-100 to 1e100.
std::unique_ptr<RobustKernel> make_robust_kernel(std::string_view name, double delta);

}  // namespace boxplus
