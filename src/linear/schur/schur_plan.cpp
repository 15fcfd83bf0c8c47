// SPDX-License-Identifier: BSD-3-Clause
// What Schur computes once per structure: the structure of S, the targets of products, and the slices.
#include <algorithm>
#include <numeric>
#include <utility>

#include "base/paced_stop.h"
#include "kernels/kernel_table.h"
#include "linear/schur/first_values.h"
#include "linear/schur/schur.h"

namespace boxplus {
namespace {

/// The blocks of W by their rows.
class RowsOfW {
 public:
  RowsOfW(const BlockStructure& structure, std::uint32_t eliminated, PacedStop& pace)
      : start_(structure.blocks() - eliminated + 1, 0) {
    const std::uint32_t end = structure.column_start[eliminated];
    for (std::uint32_t k = 0; k < end; ++k) {
      if (structure.row[k] >= eliminated) ++start_[structure.row[k] - eliminated + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    entries_.resize(start_.back());
    std::vector<std::uint32_t> next(start_);
    for (std::uint32_t k = 0; k < end; ++k) {
      pace.step();
      if (structure.row[k] >= eliminated) entries_[next[structure.row[k] - eliminated]++] = k;
    }
  }

  /// The indices of the blocks of a row in the structure of H, ascending.
  std::span<const std::uint32_t> operator()(std::uint32_t kept) const {
    return std::span(entries_).subspan(start_[kept], start_[kept + 1] - start_[kept]);
  }

 private:
  std::vector<std::uint32_t> start_, entries_;
};

/// Whether each block of row b is followed by a block of row b + 1 in the same column, and row b + 1 has no
/// other blocks.
bool are_coupled_alike(const RowsOfW& rows, std::uint32_t b) {
  const auto next = [](std::uint32_t here, std::uint32_t there) { return there == here + 1; };
  return !rows(b).empty() && std::ranges::equal(rows(b), rows(b + 1), next);
}

/// Chooses the block of S for each kept block. Blocks are joined only if there are kernels for the result.
std::vector<Schur::Place> place_blocks(const BlockStructure& structure, const AnalyzeHints& hints,
                                       const RowsOfW& rows, KeptBlocks kept) {
  const std::uint32_t eliminated = hints.eliminated_blocks;
  std::vector<Schur::Place> places;
  std::uint32_t size = 0;  // of the last block of S
  const auto can_join = [&](std::uint32_t block, std::uint32_t joined) {
    const bool is_last = std::find(hints.last.begin(), hints.last.end(), block - 1) != hints.last.end();
    return !is_last && structure.dim(block) > 0 && size > 0 &&
           are_coupled_alike(rows, block - 1 - eliminated) &&
           dense::kernels().elimination_kernels_for(static_cast<int>(joined), 1) != nullptr;
  };
  for (std::uint32_t block = eliminated; block < structure.blocks(); ++block) {
    const bool is_first = block == eliminated;
    const std::uint32_t joined = size + structure.dim(block);
    if (!is_first && kept == KeptBlocks::kJoined && can_join(block, joined)) {
      places.push_back({places.back().block, size});
      size = joined;
    } else {
      places.push_back({is_first ? 0 : places.back().block + 1, 0});
      size = structure.dim(block);
    }
  }
  return places;
}

/// The off-diagonal blocks of S: those of U and, with `products`, every pair of blocks that an eliminated
/// block joins. Each of the latter is listed once.
std::vector<BlockCoordinate> kept_pairs(const BlockStructure& structure, std::uint32_t eliminated,
                                        const RowsOfW& rows, const std::vector<Schur::Place>& places,
                                        bool products, PacedStop& pace) {
  std::vector<BlockCoordinate> pairs;
  const auto add = [&](std::uint32_t row, std::uint32_t column) {
    if (row != column) pairs.push_back({row, column});
  };
  const std::uint32_t end = structure.column_start[eliminated];
  for (std::uint32_t column = eliminated; column < structure.blocks(); ++column) {
    for (std::uint32_t k = structure.column_start[column] + 1; k < structure.column_start[column + 1]; ++k)
      add(places[structure.row[k] - eliminated].block, places[column - eliminated].block);
  }
  if (!products) return pairs;
  std::vector<std::uint32_t> seen_by(places.size(), BlockStructure::kAbsent);
  for (std::uint32_t b = 0; b < places.size(); ++b) {
    const auto [column, first] = places[b];
    if (first > 0) continue;  // the first of the joined blocks has the same partners
    for (const std::uint32_t entry : rows(b)) {
      // The column ends where the next column begins: with a diagonal block, whose row is below `eliminated`.
      for (std::uint32_t k = entry + 1; k < end && structure.row[k] >= eliminated; ++k) {
        pace.step();
        const std::uint32_t row = places[structure.row[k] - eliminated].block;
        if (std::exchange(seen_by[row], column) != column) add(row, column);
      }
    }
  }
  return pairs;
}

/// The most slices, the fewest values of H per slice, and the fewest values of H per value in the copies of
/// S.
constexpr std::uint32_t kMostSlices = 8, kValuesPerSlice = 1u << 14, kValuesPerCopiedValue = 4;

}  // namespace

Schur::Schur(const BlockStructure& structure, const AnalyzeHints& hints, bool explicit_values,
             KeptBlocks kept, const StopToken& stop)
    : structure_(&structure), eliminated_(hints.eliminated_blocks), threads_(hints.threads) {
  PacedStop pace(stop);
  const RowsOfW rows(structure, eliminated_, pace);
  places_ = place_blocks(structure, hints, rows, kept);
  std::vector<std::uint32_t> dims(places_.empty() ? 0 : places_.back().block + 1, 0);
  for (std::uint32_t b = 0; b < places_.size(); ++b) dims[places_[b].block] += structure.dim(eliminated_ + b);
  std::size_t factor_values = 0;
  factor_start_.reserve(eliminated_);
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    factor_start_.push_back(static_cast<std::uint32_t>(factor_values));
    factor_values += std::size_t{structure.dim(e)} * structure.dim(e);
  }
  factors_.resize(factor_values);
  reduced_ = make_block_structure(
      dims, kept_pairs(structure, eliminated_, rows, places_, explicit_values, pace), stop);
  diagonal_start_.push_back(0);
  for (const std::uint32_t dim : dims) diagonal_start_.push_back(diagonal_start_.back() + dim * dim);
  if (explicit_values) set_targets(pace);
  make_slices(hints.elimination_bounds, pace);
}

/// The number of blocks of S that an eliminated column is coupled with.
std::uint32_t Schur::count_reduced_blocks(std::uint32_t column) const {
  std::uint32_t count = 0;
  for (std::uint32_t k = structure_->column_start[column] + 1; k < structure_->column_start[column + 1]; ++k)
    count += places_[structure_->row[k] - eliminated_].first == 0;
  return count;
}

/// Sets kept_target_ and pair_target_, and allocates S.
void Schur::set_targets(PacedStop& pace) {
  reduced_values_.resize(reduced_.nonzero_values());
  const BlockStructure& structure = *structure_;
  const FirstValues first_value(reduced_);
  std::size_t pairs = 0;
  for (std::uint32_t column = 0; column < eliminated_; ++column) {
    const std::size_t blocks = count_reduced_blocks(column);
    pairs += blocks * (blocks + 1) / 2;
  }
  pair_target_.reserve(pairs);
  std::vector<std::uint32_t> blocks;
  for (std::uint32_t column = 0; column < eliminated_; ++column) {
    blocks.clear();
    for (std::uint32_t k = structure.column_start[column] + 1; k < structure.column_start[column + 1]; ++k) {
      const Place place = places_[structure.row[k] - eliminated_];
      if (place.first == 0) blocks.push_back(place.block);
    }
    for (auto row = blocks.begin(); row != blocks.end(); ++row) {
      for (auto other = blocks.begin(); other <= row; ++other) {
        pace.step();
        pair_target_.push_back(first_value(*row, *other));
      }
    }
  }
  for_each_block_of_u([&](std::uint32_t row, std::uint32_t column, std::uint32_t) {
    const Place at_row = place_of(row), at_column = place_of(column);
    kept_target_.push_back(first_value(at_row.block, at_column.block) + at_row.first +
                           at_column.first * reduced_.dim(at_row.block));
  });
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
      const std::size_t blocks = count_reduced_blocks(e);
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
  const auto list_column = [&](std::uint32_t column, std::uint32_t k, std::uint32_t c) {
    const std::uint32_t row = reduced_.row[k], rows = reduced_.dim(row);
    const bool is_column_out = is_out[reduced_.offset[column] + c] != 0;
    for (std::uint32_t r = 0; r < rows; ++r) {
      const bool is_diagonal = row == column && r == c;
      if (!is_diagonal && (is_column_out || is_out[reduced_.offset[row] + r] != 0))
        left_out_.values.push_back(reduced_.value_start[k] + c * rows + r);
    }
  };
  for (std::uint32_t column = 0; column < reduced_.blocks(); ++column) {
    for (std::uint32_t k = reduced_.column_start[column]; k < reduced_.column_start[column + 1]; ++k) {
      for (std::uint32_t c = 0; c < reduced_.dim(column); ++c) list_column(column, k, c);
    }
  }
  for (const std::uint32_t scalar : left_out_.scalars) {
    const std::uint32_t block = block_with(scalar), dim = structure_->dim(block);
    const Place place = place_of(block);
    const std::uint32_t i = scalar - reduced_offset(block - eliminated_);
    const std::uint32_t diagonal_of_s = reduced_.value_start[reduced_.column_start[place.block]] +
                                        (place.first + i) * (reduced_.dim(place.block) + 1);
    left_out_.diagonals.emplace_back(diagonal_of_s, structure_->value_start[structure_->column_start[block]] -
                                                        first_kept_value() + i * (dim + 1));
  }
}

std::uint32_t Schur::block_with(std::uint32_t reduced_scalar) const {
  const auto begin = structure_->offset.begin();
  const auto after =
      std::upper_bound(begin + eliminated_, structure_->offset.end(), reduced_scalar + eliminated_scalars());
  return static_cast<std::uint32_t>(after - begin) - 1;
}

}  // namespace boxplus
