// SPDX-License-Identifier: BSD-3-Clause
#include "engine/edge_batch.h"

#include <algorithm>

namespace g2o {
namespace internal {

std::optional<EdgeAdder> EdgeAdder::find(const EdgeKind& kind, std::uint32_t mask) {
  EdgeAdder adder;
  for (int n = 0; n < static_cast<int>(kind.dims.size()); ++n) {
    if ((mask >> n & 1u) != 0) adder.positions.push_back(n);
  }
  if (adder.choose(kind)) return adder;
  std::reverse(adder.positions.begin(), adder.positions.end());
  if (adder.choose(kind)) return adder;
  return std::nullopt;
}

bool EdgeAdder::choose(const EdgeKind& kind) {
  std::vector<int> dims;
  for (const int n : positions) dims.push_back(kind.dims[n]);
  const boxplus::dense::KernelTable& kernels = boxplus::dense::kernels();
  if (dims.size() == 1) {
    unary = kernels.add_unary_edges_for(kind.rows, dims[0]);
  } else if (dims.size() > 1) {
    in_lanes = kernels.add_edges_for(kind.rows, dims.data(), static_cast<int>(dims.size()));
  }
  return in_lanes != nullptr || unary != nullptr;
}

}  // namespace internal
}  // namespace g2o
