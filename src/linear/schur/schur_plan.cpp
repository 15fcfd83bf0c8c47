// SPDX-License-Identifier: BSD-3-Clause
// What Schur computes once per structure: the structure of S, the targets of products, and the slices.
#include <algorithm>
#include <numeric>
#include <utility>

#include "base/paced_stop.h"
#include "linear/schur/first_values.h"
#include "linear/schur/schur.h"

namespace boxplus {
namespace {

/// The off-diagonal blocks of S: those of U and, with `products`, every pair of kept blocks that an
/// eliminated block joins. Each of the latter is listed once.
std::vector<BlockCoordinate> kept_pairs(const BlockStructure& structure, std::uint32_t eliminated,
                                        bool products, PacedStop& pace) {
  std::vector<BlockCoordinate> pairs;
  const std::uint32_t first = structure.column_start[eliminated];
  for (std::uint32_t column = eliminated; column < structure.blocks(); ++column) {
    for (std::uint32_t k = structure.column_start[column] + 1; k < structure.column_start[column + 1]; ++k)
      pairs.push_back({structure.row[k] - eliminated, column - eliminated});
  }
  if (!products) return pairs;
  const std::uint32_t kept = structure.blocks() - eliminated;
  std::vector<std::uint32_t> start(kept + 1, 0);  // the entries of W by their rows
  for (std::uint32_t k = 0; k < first; ++k) {
    if (structure.row[k] >= eliminated) ++start[structure.row[k] - eliminated + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> entries(start.back()), next(start);
  for (std::uint32_t k = 0; k < first; ++k) {
    pace.step();
    if (structure.row[k] >= eliminated) entries[next[structure.row[k] - eliminated]++] = k;
  }
  std::vector<std::uint32_t> seen_by(kept, kept);
  for (std::uint32_t b = 0; b < kept; ++b) {
    for (std::uint32_t i = start[b]; i < start[b + 1]; ++i) {
      // The column ends where the next column begins: with a diagonal block, whose row is below `eliminated`.
      for (std::uint32_t k = entries[i] + 1; k < first && structure.row[k] >= eliminated; ++k) {
        pace.step();
        const std::uint32_t a = structure.row[k] - eliminated;
        if (std::exchange(seen_by[a], b) != b) pairs.push_back({a, b});
      }
    }
  }
  return pairs;
}

/// The most slices, the fewest values of H per slice, and the fewest values of H per value in the copies of
/// S.
constexpr std::uint32_t kMostSlices = 8, kValuesPerSlice = 1u << 14, kValuesPerCopiedValue = 4;

}  // namespace

Schur::Schur(const BlockStructure& structure, std::uint32_t eliminated_blocks, bool explicit_values,
             int threads, std::span<const std::uint32_t> bounds, const StopToken& stop)
    : structure_(&structure), eliminated_(eliminated_blocks), threads_(threads) {
  PacedStop pace(stop);
  std::vector<std::uint32_t> dims;
  for (std::uint32_t block = eliminated_; block < structure.blocks(); ++block)
    dims.push_back(structure.dim(block));
  std::size_t factor_values = 0;
  factor_start_.reserve(eliminated_);
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    factor_start_.push_back(static_cast<std::uint32_t>(factor_values));
    factor_values += std::size_t{structure.dim(e)} * structure.dim(e);
  }
  factors_.resize(factor_values);
  reduced_ = make_block_structure(dims, kept_pairs(structure, eliminated_, explicit_values, pace), stop);
  std::uint32_t diagonal = 0;
  for (std::uint32_t dim : dims) {
    diagonal_start_.push_back(diagonal);
    diagonal += dim * dim;
  }
  if (explicit_values) set_targets(pace);
  make_slices(bounds, pace);
}

/// Sets kept_target_ and pair_target_, and allocates S.
void Schur::set_targets(PacedStop& pace) {
  reduced_values_.resize(reduced_.nonzero_values());
  const BlockStructure& structure = *structure_;
  const FirstValues first_value(reduced_);
  std::size_t pairs = 0;
  for (std::uint32_t column = 0; column < eliminated_; ++column) {
    const std::size_t blocks = structure.column_start[column + 1] - structure.column_start[column] - 1;
    pairs += blocks * (blocks + 1) / 2;
  }
  pair_target_.reserve(pairs);
  kept_target_.reserve(structure.column_start[structure.blocks()] - structure.column_start[eliminated_]);
  for (std::uint32_t column = 0; column < structure.blocks(); ++column) {
    const std::uint32_t begin = structure.column_start[column], end = structure.column_start[column + 1];
    for (std::uint32_t a = column < eliminated_ ? begin + 1 : begin; a < end; ++a) {
      const std::uint32_t row = structure.row[a] - eliminated_;
      if (column >= eliminated_) {
        kept_target_.push_back(first_value(row, column - eliminated_));
        continue;
      }
      for (std::uint32_t b = begin + 1; b <= a; ++b) {
        pace.step();
        pair_target_.push_back(first_value(row, structure.row[b] - eliminated_));
      }
    }
  }
}

/// The bounds of `count` parts of the eliminated columns with about the same number of values.
std::vector<std::uint32_t> Schur::bounds_of_equal_parts(std::uint32_t count) const {
  const std::uint64_t total = first_kept_value();
  std::vector<std::uint32_t> bounds{0};
  for (std::uint32_t e = 1; e < eliminated_; ++e) {
    if (structure_->value_start[structure_->column_start[e]] * std::uint64_t{count} >= total * bounds.size())
      bounds.push_back(e);
  }
  bounds.push_back(eliminated_);
  return bounds;
}

void Schur::make_slices(std::span<const std::uint32_t> bounds, PacedStop& pace) {
  const BlockStructure& structure = *structure_;
  const std::uint32_t values = first_kept_value();
  const std::size_t copied = std::max<std::size_t>(reduced_values_.size() + reduced_.scalars(), 1);
  std::uint32_t count = std::min(kMostSlices, values / kValuesPerSlice);
  count = static_cast<std::uint32_t>(
      std::clamp<std::size_t>(values / (kValuesPerCopiedValue * copied), 1, std::max(count, 1u)));
  std::vector<std::uint32_t> equal_parts;
  if (bounds.empty()) {
    equal_parts = bounds_of_equal_parts(count);
    bounds = equal_parts;
  }
  const std::size_t parts = bounds.size() - 1;
  count = static_cast<std::uint32_t>(std::min<std::size_t>(count, parts));
  copies_.resize((count - 1) * reduced_values_.size());
  reduced_copies_.resize(std::size_t{count} * reduced_.scalars());
  std::size_t pair = 0, longest = 0, largest = 1, most_blocks = 0;
  for (std::uint32_t s = 0; s < count; ++s) {
    Slice slice{};
    slice.first = bounds[parts * s / count];
    slice.last = bounds[parts * (s + 1) / count];
    slice.first_pair = pair;
    slice.values = s == 0 ? reduced_values_.data() : copies_.data() + (s - 1) * reduced_values_.size();
    slice.reduced_r = reduced_copies_.data() + std::size_t{s} * reduced_.scalars();
    for (std::uint32_t e = slice.first; e < slice.last; ++e) {
      pace.step();
      const std::uint32_t begin = structure.column_start[e] + 1, end = structure.column_start[e + 1];
      const std::size_t blocks = end - begin;
      largest = std::max<std::size_t>(largest, structure.dim(e));
      longest = std::max<std::size_t>(longest, structure.value_start[end] - structure.value_start[begin]);
      most_blocks = std::max(most_blocks, blocks);
      pair += blocks * (blocks + 1) / 2;
    }
    slices_.push_back(std::move(slice));
  }
  for (Slice& slice : slices_) {
    slice.half_column.resize(longest);
    slice.half_rows.resize(most_blocks);
    slice.small.resize(largest);
  }
}

void Schur::leave_out(std::span<const std::uint32_t> scalars) {
  left_out_ = {};
  std::vector<std::uint8_t> is_out(reduced_.scalars());
  for (const std::uint32_t scalar : scalars) {
    if (scalar < eliminated_scalars()) continue;
    is_out[scalar - eliminated_scalars()] = 1;
    left_out_.scalars.push_back(scalar - eliminated_scalars());
  }
  if (left_out_.scalars.empty() || reduced_values_.empty()) return;
  for (std::uint32_t column = 0; column < reduced_.blocks(); ++column) {
    for (std::uint32_t k = reduced_.column_start[column]; k < reduced_.column_start[column + 1]; ++k) {
      const std::uint32_t row = reduced_.row[k], rows = reduced_.dim(row);
      for (std::uint32_t c = 0; c < reduced_.dim(column); ++c) {
        for (std::uint32_t r = 0; r < rows; ++r) {
          const bool is_column_out = is_out[reduced_.offset[column] + c] != 0;
          if (!is_column_out && is_out[reduced_.offset[row] + r] == 0) continue;
          const std::uint32_t value = reduced_.value_start[k] + c * rows + r;
          if (row != column || r != c) {
            left_out_.values.push_back(value);
            continue;
          }
          const std::uint32_t of_h =
              structure_->value_start[structure_->find(row + eliminated_, column + eliminated_)];
          left_out_.diagonals.emplace_back(value, of_h - first_kept_value() + c * rows + r);
        }
      }
    }
  }
}

}  // namespace boxplus
