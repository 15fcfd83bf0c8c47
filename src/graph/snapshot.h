// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus::outliers {

/// A copy of all estimates of a graph.
class Snapshot {
 public:
  void take(const Graph& graph);
  void put_back(const Graph& graph) const;

 private:
  struct Part {
    std::vector<std::uint32_t> slots;
    std::unique_ptr<detail::SavedEstimates> estimates;
  };
  std::vector<Part> parts_;  // by pool
};

}  // namespace boxplus::outliers
