// SPDX-License-Identifier: BSD-3-Clause
// A table of all robust kernels that can be chosen by name.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "boxplus/robust/robust_kernel.h"

namespace boxplus::detail {

struct KernelEntry {
  /// The name on command lines, such as "Huber". "Barron:ALPHA" takes a parameter, the shape.
  std::string_view name;
  /// `parameter` is the text after the colon. Throws InvalidArgument if the parameter or the width is
  /// invalid.
  std::unique_ptr<RobustKernel> (*make)(std::string_view parameter, double delta);
  bool width_is_squared = false;  ///< the width is in units of e², not of √e²

  bool takes_parameter() const { return name.find(':') != std::string_view::npos; }
};

/// One entry per kernel, in alphabetical order, which is the order of help texts.
std::span<const KernelEntry> kernel_table();

}  // namespace boxplus::detail
