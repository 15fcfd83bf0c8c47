// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "boxplus/graph/vertex_pool.h"

namespace boxplus::detail {

/// One entry of the stack of Graph::push().
struct SavedState {
  struct Part {
    std::vector<std::uint32_t> slots, generations;
    std::unique_ptr<SavedEstimates> estimates;
  };
  SavedState() = default;
  SavedState(SavedState&&) = default;
  SavedState& operator=(SavedState&&) = default;
  SavedState(const SavedState& other) {
    for (const Part& part : other.parts)
      parts.push_back({part.slots, part.generations, part.estimates ? part.estimates->clone() : nullptr});
  }
  std::vector<Part> parts;  // per pool
};

}  // namespace boxplus::detail
