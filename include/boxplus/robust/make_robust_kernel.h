// SPDX-License-Identifier: BSD-3-Clause
// Robust kernels by name, as the command line and files give them.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "boxplus/robust/robust_kernel.h"

namespace boxplus {

/// The names that make_robust_kernel knows, for help texts, in alphabetical order. "Barron:ALPHA" stands for
/// Barron's kernel of any shape.
std::span<const std::string_view> robust_kernel_names();

/// The kernel of that name and width. "Barron:ALPHA" gives Barron's kernel with shape ALPHA ("Barron:-inf"
/// too). Throws InvalidArgument for an unknown name (the message lists the known ones) or a width that is not
/// positive.
std::unique_ptr<RobustKernel> make_robust_kernel(std::string_view name, double delta);

/// The same with the default width for errors of `rows` rows (robust/default_width.h): default_width(rows),
/// or its square for the kernels whose width is in units of e². Throws InvalidArgument as above, or if rows
/// < 1.
std::unique_ptr<RobustKernel> make_default_kernel(std::string_view name, int rows);

}  // namespace boxplus
