// SPDX-License-Identifier: BSD-3-Clause
#include "linear/schur/schur.h"

#include <algorithm>

#include "base/paced_stop.h"
#include "boxplus/base/parallel.h"
#include "linear/schur/small_cholesky.h"

namespace boxplus {
namespace {

/// y += A x. A is rows × cols, column-major.
void add_multiply(const double* a, int rows, int cols, const double* x, double* y) {
  for (int c = 0; c < cols; ++c) {
    for (int r = 0; r < rows; ++r) y[r] += a[r + c * rows] * x[c];
  }
}

/// y += Aᵀ x.
void add_transposed_multiply(const double* a, int rows, int cols, const double* x, double* y) {
  for (int c = 0; c < cols; ++c) {
    double sum = 0;
    for (int r = 0; r < rows; ++r) sum += a[r + c * rows] * x[r];
    y[c] += sum;
  }
}

void solve_small(const double* l, int dim, double* x) {
  with_small_size(dim, [&](auto n) { small_solve(l, n, x); });
}

}  // namespace

/// Calls f for each slice, with several threads.
void Schur::for_each_slice(detail::FunctionRef<void(Slice&)> f) {
  const int threads = std::clamp(threads_, 1, slices());
  detail::parallel_tasks(threads, [&](int thread) {
    for (int s = slices() * thread / threads; s < slices() * (thread + 1) / threads; ++s) f(slices_[s]);
  });
}

FactorResult Schur::eliminate(std::span<const double> values, const Damping& damping, const StopToken& stop,
                              const double* r, double* reduced_r) {
  begin(damping, r);
  for_each_slice([&](Slice& slice) {
    const double* const first =
        values.data() + structure_->value_start[structure_->column_start[slice.first]];
    eliminate_columns(static_cast<int>(&slice - slices_.data()), slice.first, slice.last, first, stop);
  });
  return finish(values, reduced_r);
}

void Schur::begin(const Damping& damping, const double* r) {
  damping_ = damping;
  r_ = r;
}

/// Clears the copies of a slice, and lets it begin with its first column.
void Schur::clear(Slice& slice) {
  std::fill_n(slice.values, reduced_values_.size(), 0.0);
  std::fill_n(slice.reduced_r, reduced_.scalars(), 0.0);
  if (!pair_target_.empty()) slice.next_target = pair_target_.data() + slice.first_pair;
  slice.result = {};
}

void Schur::eliminate_columns(int index, std::uint32_t first, std::uint32_t last, const double* values,
                              const StopToken& stop) {
  Slice& slice = slices_[index];
  if (first == slice.first) clear(slice);
  PacedStop pace(stop);
  for (std::uint32_t e = first; e < last && slice.result.status == LinearStatus::kOk; ++e) {
    double* const l = factors_.data() + factor_start_[e];
    const std::uint32_t blocks = structure_->column_start[e + 1] - structure_->column_start[e] - 1;
    const std::uint32_t* const start = structure_->value_start.data() + structure_->column_start[e];
    const double *const v = values, *const w = v + (start[1] - start[0]);
    values += start[1 + blocks] - start[0];
    if (pace.is_raised_after(4 + (reduced_values_.empty() ? 0 : std::int64_t{blocks} * blocks))) {
      slice.result = {LinearStatus::kStopped};
      return;
    }
    slice.result = factorize_block(e, v, l);
    if (slice.result.status != LinearStatus::kOk) return;
    if (r_ != nullptr) reduce_column(e, w, r_, slice);
    if (reduced_values_.empty()) continue;
    const std::uint32_t reduced_blocks = whiten_column(e, w, l, slice);
    subtract_products(static_cast<int>(structure_->dim(e)), reduced_blocks, slice.next_target, slice);
    slice.next_target += reduced_blocks * (reduced_blocks + 1) / 2;
  }
}

FactorResult Schur::finish(std::span<const double> values, double* reduced_r) {
  values_ = values;
  for (const Slice& slice : slices_) {
    if (slice.result.status != LinearStatus::kOk) return slice.result;
  }
  if (!reduced_values_.empty()) {
    const auto kept = values.last(structure_->nonzero_values() - first_kept_value());
    add_copies(kept);
    clear_left_out(kept);
  }
  if (r_ != nullptr) add_reduced_copies(r_, reduced_r);
  return {};
}

/// Clears what leave_out() has named.
void Schur::clear_left_out(std::span<const double> kept_values) {
  for (const std::uint32_t value : left_out_.values) reduced_values_[value] = 0;
  for (const auto& [value, kept] : left_out_.diagonals) reduced_values_[value] = kept_values[kept];
}

/// Adds the copies of S, and U, whose values are `values`.
void Schur::add_copies(std::span<const double> values) {
  const std::size_t size = reduced_values_.size();
  constexpr std::size_t kFewest = 1 << 14;  // additions that are worth several threads
  const int threads = size * slices_.size() < kFewest ? 1 : threads_;
  detail::parallel_tasks(threads, [&](int thread) {
    const auto bound = [&](int t) {
      return size * static_cast<std::size_t>(t) / static_cast<std::size_t>(threads);
    };
    for (std::size_t s = 1; s < slices_.size(); ++s) {
      for (std::size_t i = bound(thread); i < bound(thread + 1); ++i)
        reduced_values_[i] += slices_[s].values[i];
    }
  });
  const std::uint32_t* target = kept_target_.data();
  for_each_block_of_u([&](std::uint32_t row, std::uint32_t column, std::uint32_t k) {
    const double* const block = values.data() + (structure_->value_start[k] - first_kept_value());
    add_block_of_u(row, column, block, reduced_values_.data() + *target++);
  });
}

/// Adds a block of U to S, whose entry for the first entry of the block is `to`.
void Schur::add_block_of_u(std::uint32_t row, std::uint32_t column, const double* block, double* to) const {
  const std::uint32_t rows = structure_->dim(row), cols = structure_->dim(column);
  const Place at_row = place_of(row), at_column = place_of(column);
  const std::uint32_t stride = reduced_.dim(at_row.block);
  for (std::uint32_t c = 0; c < cols; ++c) {
    for (std::uint32_t r = 0; r < rows; ++r) to[r + c * stride] += block[r + c * rows];
  }
  if (row == column || at_row.block != at_column.block) return;
  // A block on the diagonal of S has both triangles.
  double* const diagonal = to - at_row.first - at_column.first * stride;
  double* const upper = diagonal + at_column.first + at_row.first * stride;
  for (std::uint32_t r = 0; r < rows; ++r) {
    for (std::uint32_t c = 0; c < cols; ++c) upper[c + r * stride] += block[r + c * rows];
  }
}

/// reduced_r = r_kept, plus what each slice has subtracted from it.
void Schur::add_reduced_copies(const double* r, double* reduced_r) const {
  std::copy(r + eliminated_scalars(), r + structure_->scalars(), reduced_r);
  for (const Slice& slice : slices_) {
    for (std::uint32_t i = 0; i < reduced_.scalars(); ++i) reduced_r[i] += slice.reduced_r[i];
  }
  for (const std::uint32_t scalar : left_out_.scalars) reduced_r[scalar] = 0;
}

FactorResult Schur::factorize_block(std::uint32_t block, const double* v, double* l) const {
  const int n = static_cast<int>(structure_->dim(block));
  std::copy_n(v, n * n, l);
  for (int i = 0; i < n; ++i)
    l[i + i * n] += damping_(structure_->offset[block] + static_cast<std::uint32_t>(i));
  const int good = with_small_size(n, [&](auto size) { return small_cholesky(l, size); });
  return good < n ? failure(block, v, static_cast<std::uint32_t>(good)) : FactorResult{};
}

FactorResult Schur::failure(std::uint32_t block, const double* v, std::uint32_t pivot) const {
  const std::uint32_t n = structure_->dim(block), first = structure_->offset[block];
  bool finite = std::all_of(v, v + n * n, [](double x) { return std::isfinite(x); });
  for (std::uint32_t i = 0; i < n; ++i) finite = finite && std::isfinite(damping_(first + i));
  if (!finite) return {LinearStatus::kNotFinite, block};
  return {LinearStatus::kNotPositiveDefinite, block, first + pivot};
}

void Schur::solve_eliminated(std::uint32_t block, double* x) const {
  solve_small(factors_.data() + factor_start_[block], static_cast<int>(structure_->dim(block)), x);
}

Damping Schur::reduced_damping(const Damping& damping) const {
  return {damping.lambda, damping.diagonal ? damping.diagonal + eliminated_scalars() : nullptr};
}

/// Computes W L⁻ᵀ of a column in slice.half_column, and sets slice.half_rows. Returns the number of blocks
/// of S in the column.
std::uint32_t Schur::whiten_column(std::uint32_t column, const double* w, const double* l,
                                   Slice& slice) const {
  const int n = static_cast<int>(structure_->dim(column));
  double* half = slice.half_column.data();
  std::uint32_t blocks = 0;
  for_each_coupled(column, w, [&](std::uint32_t row, const double* block, int rows) {
    const auto [at, first] = places_[row];
    const int all_rows = static_cast<int>(reduced_.dim(at));
    kernels_(rows, n).whitened_block(rows, n, l, block, half + first, all_rows);
    if (static_cast<int>(first) + rows < all_rows) return;
    slice.half_rows[blocks++] = all_rows;
    half += all_rows * n;
  });
  return blocks;
}

/// Subtracts the products of all pairs of blocks in slice.half_column, whose columns are those of an
/// eliminated block of `dim` scalars, from the slice's copy of S. `target` are their targets.
void Schur::subtract_products(int dim, std::uint32_t blocks, const std::uint32_t* target,
                              Slice& slice) const {
  const double* half = slice.half_column.data();
  for (std::uint32_t a = 0; a < blocks; ++a) {
    const int rows = slice.half_rows[a];
    kernels_(rows, dim).subtract_block_products(
        rows, dim, half,
        {slice.half_column.data(), slice.half_rows.data(), static_cast<int>(a + 1), target, slice.values});
    half += rows * dim;
    target += a + 1;
  }
}

/// Subtracts W V⁻¹ r of one column from the slice's copy of reduced_r.
void Schur::reduce_column(std::uint32_t column, const double* w, const double* r, Slice& slice) const {
  const int n = static_cast<int>(structure_->dim(column));
  double* const small = slice.small.data();
  std::copy_n(r + structure_->offset[column], n, small);
  solve_eliminated(column, small);
  for_each_coupled(column, w, [&](std::uint32_t row, const double* block, int rows) {
    kernels_(rows, n).subtract_block_multiple(rows, n, block, small, slice.reduced_r + reduced_offset(row));
  });
}

void Schur::reduce(const double* r, double* reduced_r) {
  for_each_slice([&](Slice& slice) {
    std::fill_n(slice.reduced_r, reduced_.scalars(), 0.0);
    for (std::uint32_t e = slice.first; e < slice.last; ++e) reduce_column(e, blocks_of_w(e), r, slice);
  });
  add_reduced_copies(r, reduced_r);
}

void Schur::back_substitute(const double* r, const double* reduced_x, double* x) {
  for_each_slice([&](Slice& slice) {
    for (std::uint32_t e = slice.first; e < slice.last; ++e) {
      const int n = static_cast<int>(structure_->dim(e));
      double* out = x + structure_->offset[e];
      std::copy_n(r + structure_->offset[e], n, out);
      for_each_coupled(e, [&](std::uint32_t row, const double* w, int rows) {
        kernels_(rows, n).subtract_transposed_multiple(rows, n, w, reduced_x + reduced_offset(row), out);
      });
      solve_eliminated(e, out);
    }
  });
  std::copy_n(reduced_x, reduced_.scalars(), x + eliminated_scalars());
}

/// y = U x.
void Schur::kept_multiply(const double* x, double* y) const {
  std::fill_n(y, reduced_.scalars(), 0.0);
  for_each_block_of_u([&](std::uint32_t row, std::uint32_t column, std::uint32_t k) {
    const int rows = static_cast<int>(structure_->dim(row)), cols = static_cast<int>(structure_->dim(column));
    const std::uint32_t at_row = reduced_offset(row - eliminated_), at = reduced_offset(column - eliminated_);
    const double* block = values_.data() + structure_->value_start[k];
    add_multiply(block, rows, cols, x + at, y + at_row);
    if (row != column) add_transposed_multiply(block, rows, cols, x + at_row, y + at);
  });
}

void Schur::multiply(const double* x, double* y) {
  for_each_slice([&](Slice& slice) {
    double* const small = slice.small.data();
    std::fill_n(slice.reduced_r, reduced_.scalars(), 0.0);
    for (std::uint32_t e = slice.first; e < slice.last; ++e) {
      const int n = static_cast<int>(structure_->dim(e));
      std::fill_n(small, n, 0.0);
      for_each_coupled(e, [&](std::uint32_t row, const double* w, int rows) {
        kernels_(rows, n).subtract_transposed_multiple(rows, n, w, x + reduced_offset(row), small);
      });
      solve_eliminated(e, small);
      for (int i = 0; i < n; ++i) small[i] = -small[i];
      for_each_coupled(e, [&](std::uint32_t row, const double* w, int rows) {
        kernels_(rows, n).subtract_block_multiple(rows, n, w, small, slice.reduced_r + reduced_offset(row));
      });
    }
  });
  kept_multiply(x, y);
  for (const Slice& slice : slices_) {
    for (std::uint32_t i = 0; i < reduced_.scalars(); ++i) y[i] += slice.reduced_r[i];
  }
}

void Schur::block_diagonal(double* out) {
  std::fill_n(out, diagonal_start_.back(), 0.0);
  for_each_block_of_u([&](std::uint32_t row, std::uint32_t column, std::uint32_t k) {
    const Place at_row = place_of(row), at_column = place_of(column);
    if (at_row.block != at_column.block) return;
    add_block_of_u(
        row, column, values_.data() + structure_->value_start[k],
        out + diagonal_start_[at_row.block] + at_row.first + at_column.first * reduced_.dim(at_row.block));
  });
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const int n = static_cast<int>(structure_->dim(e));
    Slice& slice = slices_.front();
    whiten_column(e, blocks_of_w(e), factors_.data() + factor_start_[e], slice);
    const double* half = slice.half_column.data();
    for_each_coupled(e, [&](std::uint32_t row, const double*, int) {
      const auto [block, first] = places_[row];
      if (first > 0) return;
      const int rows = static_cast<int>(reduced_.dim(block));
      kernels_(rows, n).subtract_block_products(rows, n, half,
                                                {half, &rows, 1, &diagonal_start_[block], out});
      half += rows * n;
    });
  }
}

}  // namespace boxplus
