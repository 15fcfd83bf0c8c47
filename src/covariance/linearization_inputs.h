// SPDX-License-Identifier: BSD-3-Clause
// A copy of everything that H is a function of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "linearize/linearizer.h"

namespace boxplus {

/// Compares the estimates, measurements, Ω and enabled flags of a graph with earlier ones, bit by bit. This
/// takes much less time than a linearization. It is possible if the graph contains only types of the library
/// that keep all of their data in themselves. Error functions of other types may refer to anything, and
/// robust kernels may be shared with the caller.
class LinearizationInputs {
 public:
  /// Copies the inputs. Returns false if some of them cannot be copied; then equal() returns false.
  bool take(const Graph& graph, const Plan& plan, const LinearizeOptions& options);
  /// Whether the graph has the inputs of the last take(). The structure of the graph and the plan must be the
  /// same.
  bool equal(const Graph& graph, const Plan& plan, const LinearizeOptions& options);

 private:
  bool is_taken_ = false;
  LinearizeOptions options_;
  std::vector<std::byte> copy_;
  std::vector<std::uint8_t> flags_;  // scratch memory
};

}  // namespace boxplus
