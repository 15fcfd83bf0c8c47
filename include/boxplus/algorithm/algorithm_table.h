// SPDX-License-Identifier: BSD-3-Clause
// A table of all algorithms of the library.
#pragma once

#include <memory>
#include <span>

#include "boxplus/algorithm/algorithm.h"

namespace boxplus::detail {

struct AlgorithmEntry {
  AlgorithmKind kind;
  /// Null for kAutomatic, because the optimizer replaces kAutomatic by another kind as soon as the plan is
  /// known.
  std::unique_ptr<Algorithm> (*make)();
};

/// One entry per AlgorithmKind, in the order of help texts.
std::span<const AlgorithmEntry> algorithm_table();

}  // namespace boxplus::detail

namespace boxplus {

/// Throws InvalidArgument for kAutomatic and for values that are not in the table.
std::unique_ptr<Algorithm> make_algorithm(AlgorithmKind kind);

}  // namespace boxplus
