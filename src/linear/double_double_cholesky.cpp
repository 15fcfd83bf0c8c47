// SPDX-License-Identifier: BSD-3-Clause
#include "linear/double_double_cholesky.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "linear/ordering/amd_ordering.h"

namespace boxplus {
namespace {

constexpr std::uint32_t kNone = BlockStructure::kAbsent;
constexpr double kLost = 1e-28;
/// The factorization checks the stop token after this many rows.
constexpr std::uint32_t kRowsBetweenStops = 16;

}  // namespace

void DoubleDoubleCholesky::analyze(const BlockStructure& structure, std::span<const std::uint32_t> last,
                                   const StopToken& stop) {
  const std::vector<std::uint32_t> order = amd_ordering(structure, last, stop);
  list_entries(structure, order);
  count_columns(stop);
}

/// Lists the entries of each row of the permuted matrix, from the first column to the diagonal.
void DoubleDoubleCholesky::list_entries(const BlockStructure& structure,
                                        std::span<const std::uint32_t> order) {
  const std::uint32_t n = structure.scalars();
  std::vector<std::uint32_t> row_of(n);
  scalar_of_.clear();
  block_of_.clear();
  for (const std::uint32_t block : order) {
    for (std::uint32_t scalar = structure.offset[block]; scalar < structure.offset[block + 1]; ++scalar) {
      row_of[scalar] = static_cast<std::uint32_t>(scalar_of_.size());
      scalar_of_.push_back(scalar);
      block_of_.push_back(block);
    }
  }
  const auto for_each_entry = [&](auto&& f) {
    for (std::uint32_t column = 0; column < structure.blocks(); ++column) {
      for (std::uint32_t k = structure.column_start[column]; k < structure.column_start[column + 1]; ++k) {
        const std::uint32_t row = structure.row[k], rows = structure.dim(row);
        for (std::uint32_t c = 0; c < structure.dim(column); ++c) {
          for (std::uint32_t r = row == column ? c : 0; r < rows; ++r) {
            const auto [first, last] =
                std::minmax(row_of[structure.offset[row] + r], row_of[structure.offset[column] + c]);
            f(last, first, structure.value_start[k] + c * rows + r);
          }
        }
      }
    }
  };
  row_start_.assign(n + 1, 0);
  for_each_entry([&](std::uint32_t row, std::uint32_t, std::uint32_t) { ++row_start_[row + 1]; });
  std::partial_sum(row_start_.begin(), row_start_.end(), row_start_.begin());
  std::vector<std::uint32_t> next(row_start_.begin(), row_start_.end() - 1);
  entries_.resize(row_start_.back());
  for_each_entry([&](std::uint32_t row, std::uint32_t column, std::uint32_t value) {
    entries_[next[row]++] = {column, value};
  });
}

/// Computes the elimination tree and the number of values in each column of L.
void DoubleDoubleCholesky::count_columns(const StopToken& stop) {
  const auto n = static_cast<std::uint32_t>(scalar_of_.size());
  parent_.assign(n, kNone);
  visited_.assign(n, kNone);
  column_start_.assign(n + 1, 0);
  for (std::uint32_t row = 0; row < n; ++row) {
    if (row % kRowsBetweenStops == 0) stop.check();
    visited_[row] = row;
    for (const Entry& entry : entries_of(row)) {
      for (std::uint32_t column = entry.column; visited_[column] != row; column = parent_[column]) {
        if (parent_[column] == kNone) parent_[column] = row;
        visited_[column] = row;
        ++column_start_[column + 1];
      }
    }
  }
  multiplications_ = 0;
  for (std::uint32_t column = 0; column < n; ++column) {
    const auto count = static_cast<double>(column_start_[column + 1]);
    multiplications_ += count * (count + 1) / 2;
  }
  std::partial_sum(column_start_.begin(), column_start_.end(), column_start_.begin());
  column_end_.resize(n);
  rows_.resize(column_start_.back());
  lower_.resize(column_start_.back());
  reach_.resize(n);
  pivots_.resize(n);
  diagonal_.resize(n);
}

/// Computes a row of L and its pivot. `added` is the damping of the diagonal entry. work_ is zero before and
/// after.
void DoubleDoubleCholesky::eliminate(std::uint32_t row, std::span<const DoubleDouble> values, double added) {
  std::size_t top = reach_.size();
  visited_[row] = row;
  std::size_t length = 0;
  for (const Entry& entry : entries_of(row)) {
    work_[entry.column] += values[entry.value];
    for (std::uint32_t column = entry.column; visited_[column] != row; column = parent_[column]) {
      visited_[column] = row;
      reach_[length++] = column;
    }
    while (length > 0) reach_[--top] = reach_[--length];
  }
  DoubleDouble pivot = work_[row] + added;
  diagonal_[row] = pivot.high;
  work_[row] = 0;
  for (; top < reach_.size(); ++top) {  // children before their parents
    const std::uint32_t column = reach_[top];
    const DoubleDouble y = work_[column];
    work_[column] = 0;
    for (std::uint64_t k = column_start_[column]; k < column_end_[column]; ++k)
      work_[rows_[k]] -= lower_[k] * y;
    const DoubleDouble l = y / pivots_[column];
    pivot -= l * y;
    rows_[column_end_[column]] = row;
    lower_[column_end_[column]++] = l;
  }
  pivots_[row] = pivot;
}

FactorResult DoubleDoubleCholesky::factorize(std::span<const DoubleDouble> values, const Damping& damping,
                                             const StopToken& stop) {
  const auto n = static_cast<std::uint32_t>(scalar_of_.size());
  std::copy_n(column_start_.begin(), n, column_end_.begin());
  std::fill(visited_.begin(), visited_.end(), kNone);
  work_.assign(n, 0.0);
  double least = std::numeric_limits<double>::infinity();
  std::uint32_t weakest = 0;
  for (std::uint32_t row = 0; row < n; ++row) {
    if (row % kRowsBetweenStops == 0 && stop.raised()) return {LinearStatus::kStopped};
    eliminate(row, values, damping(scalar_of_[row]));
    const double ratio = pivots_[row].high / std::abs(diagonal_[row]);
    if (!(ratio > kLost)) return lost(row);
    if (ratio < least) weakest = row;
    least = std::min(least, ratio);
  }
  return n > 0 && !(pivots_[weakest].high > kLost * energy(weakest)) ? lost(weakest) : FactorResult{};
}

FactorResult DoubleDoubleCholesky::lost(std::uint32_t row) const {
  return {LinearStatus::kNotPositiveDefinite, block_of_[row], scalar_of_[row]};
}

/// vᵀ diag(A + λD) v for the v of this row (lost_pivot.h).
double DoubleDoubleCholesky::energy(std::uint32_t row) const {
  std::vector<double> v(row + 1);
  v[row] = 1;
  double sum = diagonal_[row];
  for (std::uint32_t column = row; column-- > 0;) {
    for (std::uint64_t k = column_start_[column]; k < column_end_[column] && rows_[k] <= row; ++k)
      v[column] -= lower_[k].high * v[rows_[k]];
    sum += diagonal_[column] * v[column] * v[column];
  }
  return sum;
}

void DoubleDoubleCholesky::solve(std::span<DoubleDouble> b) const {
  const auto n = static_cast<std::uint32_t>(scalar_of_.size());
  std::vector<DoubleDouble> x(n);
  for (std::uint32_t row = 0; row < n; ++row) x[row] = b[scalar_of_[row]];
  for (std::uint32_t column = 0; column < n; ++column) {
    for (std::uint64_t k = column_start_[column]; k < column_end_[column]; ++k)
      x[rows_[k]] -= lower_[k] * x[column];
  }
  for (std::uint32_t column = n; column-- > 0;) {
    x[column] /= pivots_[column];
    for (std::uint64_t k = column_start_[column]; k < column_end_[column]; ++k)
      x[column] -= lower_[k] * x[rows_[k]];
    b[scalar_of_[column]] = x[column];
  }
}

}  // namespace boxplus
