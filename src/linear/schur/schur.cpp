// SPDX-License-Identifier: BSD-3-Clause
#include "linear/schur/schur.h"

#include <algorithm>

#include "base/paced_stop.h"
#include "linear/schur/elimination_reference.h"
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

Schur::Schur(const BlockStructure& structure, std::uint32_t eliminated_blocks, bool explicit_values,
             const StopToken& stop)
    : structure_(&structure), eliminated_(eliminated_blocks) {
  PacedStop pace(stop);
  const std::uint32_t kept = structure.blocks() - eliminated_;
  std::vector<std::uint32_t> dims;
  for (std::uint32_t i = 0; i < kept; ++i) dims.push_back(structure.dim(eliminated_ + i));
  std::vector<BlockCoordinate> pairs;
  std::size_t longest = 0, largest = 1, most_blocks = 0;
  for (std::uint32_t column = 0; column < structure.blocks(); ++column) {
    const std::uint32_t begin = structure.column_start[column] + 1, end = structure.column_start[column + 1];
    largest = std::max<std::size_t>(largest, structure.dim(column));
    if (column >= eliminated_) {
      for (std::uint32_t k = begin; k < end; ++k)
        pairs.push_back({structure.row[k] - eliminated_, column - eliminated_});
      continue;
    }
    factor_start_.push_back(static_cast<std::uint32_t>(factors_.size()));
    factors_.resize(factors_.size() + std::size_t{structure.dim(column)} * structure.dim(column));
    longest = std::max<std::size_t>(longest, structure.value_start[end] - structure.value_start[begin]);
    most_blocks = std::max<std::size_t>(most_blocks, end - begin);
    if (!explicit_values) continue;
    for (std::uint32_t a = begin; a < end; ++a) {
      for (std::uint32_t b = begin; b < a; ++b) {
        pace.step();
        pairs.push_back({structure.row[a] - eliminated_, structure.row[b] - eliminated_});
      }
    }
  }
  reduced_ = make_block_structure(dims, pairs, stop);
  std::uint32_t diagonal = 0;
  for (std::uint32_t dim : dims) {
    diagonal_start_.push_back(diagonal);
    diagonal += dim * dim;
  }
  half_column_.resize(longest);
  half_rows_.resize(most_blocks);
  small_.resize(largest);
  if (!explicit_values) return;
  reduced_values_.resize(reduced_.nonzero_values());
  for (std::uint32_t column = 0; column < structure.blocks(); ++column) {
    const std::uint32_t begin = structure.column_start[column], end = structure.column_start[column + 1];
    for (std::uint32_t a = column < eliminated_ ? begin + 1 : begin; a < end; ++a) {
      const std::uint32_t row = structure.row[a] - eliminated_;
      if (column >= eliminated_) {
        kept_target_.push_back(reduced_.value_start[reduced_.find(row, column - eliminated_)]);
        continue;
      }
      for (std::uint32_t b = begin + 1; b <= a; ++b) {
        pace.step(4);
        pair_target_.push_back(reduced_.value_start[reduced_.find(row, structure.row[b] - eliminated_)]);
      }
    }
  }
}

FactorResult Schur::eliminate(std::span<const double> values, const Damping& damping, const StopToken& stop) {
  values_ = values;
  PacedStop pace(stop);
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    if (pace.is_raised_after(4)) return {LinearStatus::kStopped};
    const int n = static_cast<int>(structure_->dim(e));
    const double* v = values.data() + structure_->value_start[structure_->column_start[e]];
    double* l = factors_.data() + factor_start_[e];
    std::copy_n(v, n * n, l);
    for (int i = 0; i < n; ++i)
      l[i + i * n] += damping(structure_->offset[e] + static_cast<std::uint32_t>(i));
    const int good = with_small_size(n, [&](auto size) { return small_cholesky(l, size); });
    if (good < n) return failure(e, static_cast<std::uint32_t>(good), damping);
  }
  if (!reduced_values_.empty() && !form_reduced_values(pace)) return {LinearStatus::kStopped};
  return {};
}

FactorResult Schur::failure(std::uint32_t block, std::uint32_t pivot, const Damping& damping) const {
  const double* v = values_.data() + structure_->value_start[structure_->column_start[block]];
  const std::uint32_t n = structure_->dim(block), first = structure_->offset[block];
  bool finite = std::all_of(v, v + n * n, [](double x) { return std::isfinite(x); });
  for (std::uint32_t i = 0; i < n; ++i) finite = finite && std::isfinite(damping(first + i));
  if (!finite) return {LinearStatus::kNotFinite, block};
  return {LinearStatus::kNotPositiveDefinite, block, first + pivot};
}

void Schur::solve_eliminated(std::uint32_t block, double* x) const {
  solve_small(factors_.data() + factor_start_[block], static_cast<int>(structure_->dim(block)), x);
}

Damping Schur::reduced_damping(const Damping& damping) const {
  return {damping.lambda, damping.diagonal ? damping.diagonal + eliminated_scalars() : nullptr};
}

/// Computes W L⁻ᵀ of one column in half_column_, and sets half_rows_. Returns the number of blocks in the
/// column.
std::uint32_t Schur::halve_column(std::uint32_t column) {
  const int n = static_cast<int>(structure_->dim(column));
  const double* l = factors_.data() + factor_start_[column];
  double* half = half_column_.data();
  std::uint32_t blocks = 0;
  for_each_joined(column, [&](std::uint32_t, const double* w, int rows) {
    elimination_kernels(rows, n).half_block(rows, n, l, w, half);
    half += rows * n;
    half_rows_[blocks++] = rows;
  });
  return blocks;
}

/// Computes the values of S. Returns false if the token was raised.
bool Schur::form_reduced_values(PacedStop& pace) {
  std::fill(reduced_values_.begin(), reduced_values_.end(), 0.0);
  const std::uint32_t* target = kept_target_.data();
  for (std::uint32_t k = structure_->column_start[eliminated_]; k < structure_->nonzero_blocks();
       ++k, ++target) {
    std::copy(values_.begin() + structure_->value_start[k], values_.begin() + structure_->value_start[k + 1],
              reduced_values_.begin() + *target);
  }
  target = pair_target_.data();
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const int n = static_cast<int>(structure_->dim(e));
    const auto blocks = static_cast<int>(halve_column(e));
    if (pace.is_raised_after(std::int64_t{blocks} * blocks)) return false;
    const double* half = half_column_.data();
    for (int a = 0; a < blocks; ++a) {
      const int rows = half_rows_[static_cast<std::size_t>(a)];
      elimination_kernels(rows, n).subtract_block_products(
          rows, n, half, {half_column_.data(), half_rows_.data(), a + 1, target, reduced_values_.data()});
      half += rows * n;
      target += a + 1;
    }
  }
  return true;
}

void Schur::reduce(const double* r, double* reduced_r) {
  std::copy(r + eliminated_scalars(), r + structure_->scalars(), reduced_r);
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const int n = static_cast<int>(structure_->dim(e));
    const double* l = factors_.data() + factor_start_[e];
    std::copy_n(r + structure_->offset[e], n, small_.data());
    solve_small(l, n, small_.data());
    for_each_joined(e, [&](std::uint32_t row, const double* w, int rows) {
      elimination_kernels(rows, n).subtract_block_multiple(rows, n, w, small_.data(),
                                                           reduced_r + reduced_.offset[row]);
    });
  }
}

void Schur::back_substitute(const double* r, const double* reduced_x, double* x) const {
  std::copy_n(reduced_x, reduced_.scalars(), x + eliminated_scalars());
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const int n = static_cast<int>(structure_->dim(e));
    const double* l = factors_.data() + factor_start_[e];
    double* out = x + structure_->offset[e];
    std::copy_n(r + structure_->offset[e], n, out);
    for_each_joined(e, [&](std::uint32_t row, const double* w, int rows) {
      elimination_kernels(rows, n).subtract_transposed_multiple(rows, n, w, reduced_x + reduced_.offset[row],
                                                                out);
    });
    solve_small(l, n, out);
  }
}

/// y = U x.
void Schur::kept_multiply(const double* x, double* y) const {
  std::fill_n(y, reduced_.scalars(), 0.0);
  for (std::uint32_t column = eliminated_; column < structure_->blocks(); ++column) {
    const int cols = static_cast<int>(structure_->dim(column));
    const std::uint32_t at = structure_->offset[column] - eliminated_scalars();
    for (std::uint32_t k = structure_->column_start[column]; k < structure_->column_start[column + 1]; ++k) {
      const std::uint32_t row = structure_->row[k];
      const int rows = static_cast<int>(structure_->dim(row));
      const std::uint32_t row_at = structure_->offset[row] - eliminated_scalars();
      const double* block = values_.data() + structure_->value_start[k];
      add_multiply(block, rows, cols, x + at, y + row_at);
      if (row != column) add_transposed_multiply(block, rows, cols, x + row_at, y + at);
    }
  }
}

void Schur::multiply(const double* x, double* y) {
  kept_multiply(x, y);
  double* small = small_.data();
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const int n = static_cast<int>(structure_->dim(e));
    std::fill_n(small, n, 0.0);
    for_each_joined(e, [&](std::uint32_t row, const double* w, int rows) {
      elimination_kernels(rows, n).subtract_transposed_multiple(rows, n, w, x + reduced_.offset[row], small);
    });
    solve_small(factors_.data() + factor_start_[e], n, small);
    for (int i = 0; i < n; ++i) small[i] = -small[i];
    for_each_joined(e, [&](std::uint32_t row, const double* w, int rows) {
      elimination_kernels(rows, n).subtract_block_multiple(rows, n, w, small, y + reduced_.offset[row]);
    });
  }
}

void Schur::block_diagonal(double* out) {
  for (std::uint32_t block = 0; block < reduced_.blocks(); ++block) {
    const std::uint32_t k = structure_->column_start[eliminated_ + block];
    std::copy(values_.begin() + structure_->value_start[k], values_.begin() + structure_->value_start[k + 1],
              out + diagonal_start_[block]);
  }
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const int n = static_cast<int>(structure_->dim(e));
    halve_column(e);
    const double* half = half_column_.data();
    for_each_joined(e, [&](std::uint32_t row, const double*, int rows) {
      elimination_kernels(rows, n).subtract_block_products(rows, n, half,
                                                           {half, &rows, 1, &diagonal_start_[row], out});
      half += rows * n;
    });
  }
}

}  // namespace boxplus
