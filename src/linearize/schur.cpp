// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/linearize/schur.h"

#include <algorithm>

#include "linearize/small_cholesky.h"

namespace boxplus {
namespace {

/// y += sign · A x, A rows × cols column-major.
void add_multiply(double sign, const double* a, int rows, int cols, const double* x, double* y) {
  for (int c = 0; c < cols; ++c) {
    for (int r = 0; r < rows; ++r) y[r] += sign * a[r + c * rows] * x[c];
  }
}

/// y += sign · Aᵀ x.
void add_transposed_multiply(double sign, const double* a, int rows, int cols, const double* x, double* y) {
  for (int c = 0; c < cols; ++c) {
    double sum = 0;
    for (int r = 0; r < rows; ++r) sum += a[r + c * rows] * x[r];
    y[c] += sign * sum;
  }
}

/// C −= A Bᵀ; A m × k, B n × k, C m × n.
void subtract_product(const double* a, int m, const double* b, int n, int k, double* c) {
  for (int p = 0; p < k; ++p) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < m; ++i) c[i + j * m] -= a[i + p * m] * b[j + p * n];
    }
  }
}

}  // namespace

/// Calls f(kept block, values of W's block, its rows) for the rows below the diagonal of an eliminated
/// column.
template <class F>
void Schur::for_each_row(std::uint32_t column, F&& f) const {
  for (std::uint32_t k = structure_->column_start[column] + 1; k < structure_->column_start[column + 1];
       ++k) {
    f(structure_->row[k] - eliminated_, values_.data() + structure_->value_start[k],
      static_cast<int>(structure_->dim(structure_->row[k])));
  }
}

Schur::Schur(const BlockStructure& structure, std::uint32_t eliminated_blocks, bool explicit_values)
    : structure_(&structure), eliminated_(eliminated_blocks) {
  const std::uint32_t kept = structure.blocks() - eliminated_;
  std::vector<std::uint32_t> dims;
  for (std::uint32_t i = 0; i < kept; ++i) dims.push_back(structure.dim(eliminated_ + i));
  std::vector<BlockCoordinate> pairs;
  std::size_t longest = 0, largest = 1;
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
    if (!explicit_values) continue;
    for (std::uint32_t a = begin; a < end; ++a) {
      for (std::uint32_t b = begin; b < a; ++b) {
        pairs.push_back({structure.row[a] - eliminated_, structure.row[b] - eliminated_});
      }
    }
  }
  reduced_ = make_block_structure(dims, pairs);
  std::uint32_t diagonal = 0;
  for (std::uint32_t dim : dims) {
    diagonal_start_.push_back(diagonal);
    diagonal += dim * dim;
  }
  half_column_.resize(longest);
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
        pair_target_.push_back(reduced_.value_start[reduced_.find(row, structure.row[b] - eliminated_)]);
      }
    }
  }
}

FactorResult Schur::eliminate(std::span<const double> values, const Damping& damping) {
  values_ = values;
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const int n = static_cast<int>(structure_->dim(e));
    const double* v = values.data() + structure_->value_start[structure_->column_start[e]];
    double* l = factors_.data() + factor_start_[e];
    std::copy_n(v, n * n, l);
    for (int i = 0; i < n; ++i)
      l[i + i * n] += damping(structure_->offset[e] + static_cast<std::uint32_t>(i));
    if (!small_cholesky(l, n)) {
      const bool finite = std::all_of(v, v + n * n, [](double x) { return std::isfinite(x); });
      return {finite ? LinearStatus::kNotPositiveDefinite : LinearStatus::kNotFinite, e};
    }
  }
  if (!reduced_values_.empty()) form_reduced_values();
  return {};
}

Damping Schur::reduced_damping(const Damping& damping) const {
  return {damping.lambda, damping.diagonal ? damping.diagonal + eliminated_scalars() : nullptr};
}

void Schur::form_reduced_values() {
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
    const double* l = factors_.data() + factor_start_[e];
    double* y = half_column_.data();
    for_each_row(e, [&](std::uint32_t, const double* w, int rows) {
      std::copy_n(w, rows * n, y);
      for (int r = 0; r < rows; ++r) small_forward(l, n, y + r, rows);
      y += rows * n;
    });
    const double* ya = half_column_.data();
    for_each_row(e, [&](std::uint32_t a, const double*, int rows_a) {
      const double* yb = half_column_.data();
      for_each_row(e, [&](std::uint32_t b, const double*, int rows_b) {
        if (b > a) return;
        subtract_product(ya, rows_a, yb, rows_b, n, reduced_values_.data() + *target++);
        yb += rows_b * n;
      });
      ya += rows_a * n;
    });
  }
}

void Schur::reduce(const double* r, double* reduced_r) {
  std::copy(r + eliminated_scalars(), r + structure_->scalars(), reduced_r);
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const int n = static_cast<int>(structure_->dim(e));
    const double* l = factors_.data() + factor_start_[e];
    std::copy_n(r + structure_->offset[e], n, small_.data());
    small_forward(l, n, small_.data());
    small_backward(l, n, small_.data());
    for_each_row(e, [&](std::uint32_t row, const double* w, int rows) {
      add_multiply(-1, w, rows, n, small_.data(), reduced_r + reduced_.offset[row]);
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
    for_each_row(e, [&](std::uint32_t row, const double* w, int rows) {
      add_transposed_multiply(-1, w, rows, n, reduced_x + reduced_.offset[row], out);
    });
    small_forward(l, n, out);
    small_backward(l, n, out);
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
      add_multiply(1, block, rows, cols, x + at, y + row_at);
      if (row != column) add_transposed_multiply(1, block, rows, cols, x + row_at, y + at);
    }
  }
}

void Schur::multiply(const double* x, double* y) {
  kept_multiply(x, y);
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const int n = static_cast<int>(structure_->dim(e));
    const double* l = factors_.data() + factor_start_[e];
    std::fill_n(small_.data(), n, 0.0);
    for_each_row(e, [&](std::uint32_t row, const double* w, int rows) {
      add_transposed_multiply(1, w, rows, n, x + reduced_.offset[row], small_.data());
    });
    small_forward(l, n, small_.data());
    small_backward(l, n, small_.data());
    for_each_row(e, [&](std::uint32_t row, const double* w, int rows) {
      add_multiply(-1, w, rows, n, small_.data(), y + reduced_.offset[row]);
    });
  }
}

void Schur::block_diagonal(double* out) {
  for (std::uint32_t block = 0; block < reduced_.blocks(); ++block) {
    const std::uint32_t k = structure_->column_start[eliminated_ + block];
    std::copy(values_.begin() + structure_->value_start[k], values_.begin() + structure_->value_start[k + 1],
              out + diagonal_start_[block]);
  }
  double* half = half_column_.data();
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const int n = static_cast<int>(structure_->dim(e));
    for_each_row(e, [&](std::uint32_t row, const double* w, int rows) {
      std::copy_n(w, rows * n, half);
      for (int r = 0; r < rows; ++r) small_forward(factors_.data() + factor_start_[e], n, half + r, rows);
      subtract_product(half, rows, half, rows, n, out + diagonal_start_[row]);
    });
  }
}

}  // namespace boxplus
