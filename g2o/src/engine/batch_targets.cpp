// SPDX-License-Identifier: BSD-3-Clause
#include "engine/batch_targets.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace g2o {
namespace internal {

namespace {

/// The sums of a part, by the Hessian index of their vertex.
class SumsByVertex {
 public:
  explicit SumsByVertex(const std::vector<BatchPart::Sum>& sums) {
    for (const BatchPart::Sum& sum : sums) {
      by_index_.resize(std::max(by_index_.size(), static_cast<std::size_t>(sum.vertex) + 1), nullptr);
      by_index_[sum.vertex] = &sum;
    }
  }
  /// Returns nullptr if edges add to the vertex directly.
  const BatchPart::Sum* find(int h) const {
    return static_cast<std::size_t>(h) < by_index_.size() ? by_index_[h] : nullptr;
  }

 private:
  std::vector<const BatchPart::Sum*> by_index_;
};

void lay_out_targets(const HessianPlaces& places, const SumsByVertex& sums, EdgeBatch& batch) {
  const std::uint32_t values = places.values(), scalars = places.scalars();
  batch.targets.clear();
  batch.targets.reserve(batch.edges.size() * batch.targets_per_edge());
  const std::size_t arity = batch.adder.positions.size();
  for (std::size_t first = 0; first < batch.vertices.size(); first += arity) {
    const auto at = [&](std::size_t i) { return batch.vertices[first + i]; };
    for (std::size_t i = 0; i < arity; ++i) {
      const BatchPart::Sum* sum = sums.find(at(i));
      batch.targets.push_back(sum != nullptr ? scalars + sum->from_scalar : places.gradient(at(i)));
    }
    for (std::size_t i = 0; i < arity; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const BatchPart::Sum* sum = i == j ? sums.find(at(i)) : nullptr;
        const HessianPlaces::Block block = places.block(at(i), at(j));
        batch.targets.push_back(
            sum != nullptr ? values + sum->from_value
                           : block.offset | (block.transposed ? boxplus::dense::kTransposedTarget : 0));
      }
    }
  }
}

}  // namespace

bool lay_out_targets(const HessianPlaces& places, BatchPart& part) {
  for (BatchPart::Sum& sum : part.sums) {
    sum.to_value = places.block(sum.vertex, sum.vertex).offset;
    sum.to_scalar = places.gradient(sum.vertex);
  }
  const SumsByVertex sums(part.sums);
  for (EdgeBatch& batch : part.batches) {
    for (std::size_t k = 0; k < batch.edges.size(); ++k) {
      if (!batch.is_current(k)) return false;
    }
    lay_out_targets(places, sums, batch);
  }
  return true;
}

}  // namespace internal
}  // namespace g2o
