// SPDX-License-Identifier: BSD-3-Clause
// Covariances of a few blocks, from the fronts between them and the roots: with H = L Lᵀ and unit columns E,
// the part of H⁻¹ is (L⁻¹E)ᵀ (L⁻¹E).
#include <algorithm>

#include "kernels/dense_kernels.h"
#include "linear/incremental/incremental_factor.h"

namespace boxplus {

void IncrementalFactor::covariance(std::span<const Index> blocks, std::vector<double>& out) {
  std::vector<Index> path;
  std::size_t count = 0;
  const std::uint32_t mark = ++marks_;
  for (const Index b : blocks) {
    count += dim(b);
    for (Index f = blocks_[b].front; f != kNone && mark_[fronts_[f].blocks[0]] != mark;
         f = fronts_[f].parent) {
      mark_[fronts_[f].blocks[0]] = mark;  // the first pivot of a front identifies it
      path.push_back(f);
    }
  }
  std::sort(path.begin(), path.end(), [&](Index a, Index b) {
    return blocks_[fronts_[a].blocks[0]].sequence < blocks_[fronts_[b].blocks[0]].sequence;
  });
  // The columns of L⁻¹E. Each scalar of a block on the path has `count` contiguous values.
  columns_.clear();
  for (const Index f : path) {
    for (const Index b : fronts_[f].pivot_blocks()) {
      local_[b] = static_cast<std::uint32_t>(columns_.size());
      columns_.resize(columns_.size() + dim(b) * count, 0.0);
    }
  }
  std::size_t next = 0;
  for (const Index b : blocks) {
    for (std::uint32_t i = 0; i < dim(b); ++i, ++next) columns_[local_[b] + i * count + next] = 1;
  }
  out.assign(count * count, 0.0);
  const int size = static_cast<int>(count);
  for (const Index f : path) {
    const Front& front = fronts_[f];
    const int columns = static_cast<int>(front.columns), below = static_cast<int>(front.below) - 1;
    const int leading = static_cast<int>(front.leading);
    double* const pivots = columns_.data() + local_[front.blocks[0]];
    dense::divide_by_transposed(pivots, size, front.values, leading, size, columns);
    for (std::size_t k = 0; k < front.columns; ++k) {
      const double* const column = pivots + k * count;
      for (std::size_t j = 0; j < count; ++j) {
        if (column[j] == 0) continue;
        for (std::size_t i = 0; i < count; ++i) out[j * count + i] += column[i] * column[j];
      }
    }
    work_.assign(std::max(work_.size(), static_cast<std::size_t>(below) * count), 0.0);
    dense::subtract_product_transposed(work_.data(), size, pivots, size, front.values + front.columns,
                                       leading, size, below, columns);
    const double* from = work_.data();
    for (const Index b : front.separator()) {
      double* const to = columns_.data() + local_[b];
      for (std::size_t i = 0; i < dim(b) * count; ++i) to[i] += *from++;
    }
  }
}

}  // namespace boxplus
