// SPDX-License-Identifier: BSD-3-Clause
#include "linear/schur/schur.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/paced_stop.h"
#include "boxplus/base/parallel.h"
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

/// The predicted time to subtract one product of blocks, and the least work of a thread.
constexpr double kNanosecondsPerProduct = 30, kMinShareNanoseconds = 100e3;

}  // namespace

Schur::Schur(const BlockStructure& structure, std::uint32_t eliminated_blocks, bool explicit_values,
             int threads, const StopToken& stop)
    : structure_(&structure), eliminated_(eliminated_blocks) {
  PacedStop pace(stop);
  std::vector<std::uint32_t> dims;
  for (std::uint32_t block = eliminated_; block < structure.blocks(); ++block)
    dims.push_back(structure.dim(block));
  std::size_t factor_values = 0;
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
  make_shares(threads, pace);
}

/// Sets kept_target_ and pair_target_, and allocates S.
void Schur::set_targets(PacedStop& pace) {
  reduced_values_.resize(reduced_.nonzero_values());
  const BlockStructure& structure = *structure_;
  for (std::uint32_t column = 0; column < structure.blocks(); ++column) {
    const std::uint32_t begin = structure.column_start[column], end = structure.column_start[column + 1];
    for (std::uint32_t a = column < eliminated_ ? begin + 1 : begin; a < end; ++a) {
      const std::uint32_t row = structure.row[a] - eliminated_;
      if (column >= eliminated_) {
        kept_target_.push_back(reduced_.value_start[reduced_.find(row, column - eliminated_)]);
        continue;
      }
      for (std::uint32_t b = begin + 1; b <= a; ++b) {
        pace.step();
        pair_target_.push_back(reduced_.value_start[reduced_.find(row, structure.row[b] - eliminated_)]);
      }
    }
  }
}

/// Divides the work among threads: the columns of S by the products that they receive, and the eliminated
/// blocks by the size of their columns.
void Schur::make_shares(int threads, PacedStop& pace) {
  const BlockStructure& structure = *structure_;
  const std::uint32_t kept = reduced_.blocks();
  std::vector<double> work(kept, 0);  // predicted nanoseconds per column of S
  std::size_t longest = 0, largest = 1, most_blocks = 0;
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const std::uint32_t begin = structure.column_start[e] + 1, end = structure.column_start[e + 1];
    pace.step(end - begin);
    largest = std::max<std::size_t>(largest, structure.dim(e));
    longest = std::max<std::size_t>(longest, structure.value_start[end] - structure.value_start[begin]);
    most_blocks = std::max<std::size_t>(most_blocks, end - begin);
    for (std::uint32_t k = begin; k < end; ++k)
      work[structure.row[k] - eliminated_] +=
          kNanosecondsPerProduct * (reduced_values_.empty() ? 1 : end - k);
  }
  const double total = std::accumulate(work.begin(), work.end(), 0.0);
  const int count = std::clamp(static_cast<int>(total / kMinShareNanoseconds), 1,
                               std::max(1, std::min(threads, static_cast<int>(kept))));
  const double eliminated_values = structure.value_start[structure.column_start[eliminated_]];
  double done = 0;
  std::uint32_t column = 0, block = 0;
  for (int t = 1; t <= count; ++t) {
    Share share;
    share.first_kept = column;
    share.first_eliminated = block;
    const double part = static_cast<double>(t) / count;
    while (column < kept && (t == count || done + work[column] / 2 < part * total)) done += work[column++];
    while (block < eliminated_ &&
           (t == count || structure.value_start[structure.column_start[block]] < part * eliminated_values))
      ++block;
    share.last_kept = column;
    share.last_eliminated = block;
    share.factor.resize(largest * largest);
    share.half_column.resize(longest);
    share.half_rows.resize(most_blocks);
    share.small.resize(largest);
    shares_.push_back(std::move(share));
  }
}

FactorResult Schur::eliminate(std::span<const double> values, const Damping& damping, const StopToken& stop,
                              const double* r, double* reduced_r) {
  values_ = values;
  detail::parallel_tasks(static_cast<int>(shares_.size()), [&](int thread) {
    eliminate_share(shares_[static_cast<std::size_t>(thread)], damping, stop, r, reduced_r);
  });
  for (const Share& share : shares_) {
    if (share.result.status != LinearStatus::kOk) return share.result;
  }
  return {};
}

/// Every thread factorizes every block of V, because this takes less time than to wait for another thread. It
/// stores only the factors of the blocks that its share owns.
void Schur::eliminate_share(Share& share, const Damping& damping, const StopToken& stop, const double* r,
                            double* reduced_r) {
  PacedStop pace(stop);
  if (!reduced_values_.empty()) copy_kept_values(share);
  if (r != nullptr) {
    std::copy(r + structure_->offset[eliminated_ + share.first_kept],
              r + structure_->offset[eliminated_ + share.last_kept],
              reduced_r + reduced_.offset[share.first_kept]);
  }
  const std::uint32_t* target = pair_target_.data();
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const bool owned = e >= share.first_eliminated && e < share.last_eliminated;
    double* l = owned ? factors_.data() + factor_start_[e] : share.factor.data();
    const std::uint32_t begin = structure_->column_start[e] + 1, end = structure_->column_start[e + 1];
    const std::uint32_t blocks = end - begin;
    if (pace.is_raised_after(4 + (reduced_values_.empty() ? 0 : std::int64_t{blocks} * blocks))) {
      share.result = {LinearStatus::kStopped};
      return;
    }
    share.result = factorize_block(e, damping, l);
    if (share.result.status != LinearStatus::kOk) return;
    if (r != nullptr) reduce_column(e, share, l, r, share.small.data(), reduced_r);
    if (reduced_values_.empty()) continue;
    subtract_products(e, l, target, share);
    target += blocks * (blocks + 1) / 2;
  }
}

FactorResult Schur::factorize_block(std::uint32_t block, const Damping& damping, double* l) const {
  const int n = static_cast<int>(structure_->dim(block));
  std::copy_n(values_.data() + structure_->value_start[structure_->column_start[block]], n * n, l);
  for (int i = 0; i < n; ++i)
    l[i + i * n] += damping(structure_->offset[block] + static_cast<std::uint32_t>(i));
  const int good = with_small_size(n, [&](auto size) { return small_cholesky(l, size); });
  return good < n ? failure(block, static_cast<std::uint32_t>(good), damping) : FactorResult{};
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

/// Copies U to the columns of S that `share` owns, and sets their other values to zero.
void Schur::copy_kept_values(const Share& share) {
  const auto value_of = [&](std::uint32_t column) {
    return reduced_values_.begin() + reduced_.value_start[reduced_.column_start[column]];
  };
  std::fill(value_of(share.first_kept), value_of(share.last_kept), 0.0);
  const std::uint32_t first = structure_->column_start[eliminated_];
  for (std::uint32_t k = structure_->column_start[eliminated_ + share.first_kept];
       k < structure_->column_start[eliminated_ + share.last_kept]; ++k) {
    std::copy(values_.begin() + structure_->value_start[k], values_.begin() + structure_->value_start[k + 1],
              reduced_values_.begin() + kept_target_[k - first]);
  }
}

/// Computes W L⁻ᵀ of a column, from its block `first` on, in share.half_column, and sets share.half_rows.
void Schur::halve_column(std::uint32_t column, std::uint32_t first, const double* l, Share& share) const {
  const int n = static_cast<int>(structure_->dim(column));
  const std::uint32_t end = structure_->column_start[column + 1];
  double* half = share.half_column.data();
  for (std::uint32_t k = first; k < end; ++k) {
    const int rows = static_cast<int>(structure_->dim(structure_->row[k]));
    elimination_kernels(rows, n).half_block(rows, n, l, values_.data() + structure_->value_start[k], half);
    half += rows * n;
    share.half_rows[k - first] = rows;
  }
}

/// Subtracts the products of the blocks of a column from the columns of S that the share owns. `target` are
/// the targets of all pairs of blocks of the column.
void Schur::subtract_products(std::uint32_t column, const double* l, const std::uint32_t* target,
                              Share& share) {
  const std::uint32_t begin = structure_->column_start[column] + 1,
                      end = structure_->column_start[column + 1];
  // The rows of the blocks [first, last) are the columns of S that the share owns.
  std::uint32_t first = begin;
  while (first < end && structure_->row[first] - eliminated_ < share.first_kept) ++first;
  std::uint32_t last = first;
  while (last < end && structure_->row[last] - eliminated_ < share.last_kept) ++last;
  if (first == last) return;
  const int n = static_cast<int>(structure_->dim(column));
  halve_column(column, first, l, share);
  const double* half = share.half_column.data();
  for (std::uint32_t a = first; a < end; ++a) {
    const int rows = share.half_rows[a - first];
    const std::uint32_t pair = (a - begin) * (a - begin + 1) / 2 + (first - begin);
    elimination_kernels(rows, n).subtract_block_products(
        rows, n, half,
        {share.half_column.data(), share.half_rows.data(), static_cast<int>(std::min(a + 1, last) - first),
         target + pair, reduced_values_.data()});
    half += rows * n;
  }
}

/// Subtracts W V⁻¹ r of one column from the entries of reduced_r that `share` owns.
void Schur::reduce_column(std::uint32_t column, const Share& share, const double* l, const double* r,
                          double* small, double* reduced_r) const {
  const int n = static_cast<int>(structure_->dim(column));
  std::copy_n(r + structure_->offset[column], n, small);
  solve_small(l, n, small);
  for_each_joined(column, [&](std::uint32_t row, const double* w, int rows) {
    if (row < share.first_kept || row >= share.last_kept) return;
    elimination_kernels(rows, n).subtract_block_multiple(rows, n, w, small, reduced_r + reduced_.offset[row]);
  });
}

void Schur::reduce(const double* r, double* reduced_r) {
  std::copy(r + eliminated_scalars(), r + structure_->scalars(), reduced_r);
  detail::parallel_tasks(static_cast<int>(shares_.size()), [&](int thread) {
    Share& share = shares_[static_cast<std::size_t>(thread)];
    for (std::uint32_t e = 0; e < eliminated_; ++e)
      reduce_column(e, share, factors_.data() + factor_start_[e], r, share.small.data(), reduced_r);
  });
}

void Schur::back_substitute(const double* r, const double* reduced_x, double* x) const {
  detail::parallel_tasks(static_cast<int>(shares_.size()), [&](int thread) {
    const Share& share = shares_[static_cast<std::size_t>(thread)];
    for (std::uint32_t e = share.first_eliminated; e < share.last_eliminated; ++e) {
      const int n = static_cast<int>(structure_->dim(e));
      double* out = x + structure_->offset[e];
      std::copy_n(r + structure_->offset[e], n, out);
      for_each_joined(e, [&](std::uint32_t row, const double* w, int rows) {
        elimination_kernels(rows, n).subtract_transposed_multiple(rows, n, w,
                                                                  reduced_x + reduced_.offset[row], out);
      });
      solve_eliminated(e, out);
    }
  });
  std::copy_n(reduced_x, reduced_.scalars(), x + eliminated_scalars());
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
  double* small = shares_.front().small.data();
  for (std::uint32_t e = 0; e < eliminated_; ++e) {
    const int n = static_cast<int>(structure_->dim(e));
    std::fill_n(small, n, 0.0);
    for_each_joined(e, [&](std::uint32_t row, const double* w, int rows) {
      elimination_kernels(rows, n).subtract_transposed_multiple(rows, n, w, x + reduced_.offset[row], small);
    });
    solve_eliminated(e, small);
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
    Share& share = shares_.front();
    halve_column(e, structure_->column_start[e] + 1, factors_.data() + factor_start_[e], share);
    const double* half = share.half_column.data();
    for_each_joined(e, [&](std::uint32_t row, const double*, int rows) {
      elimination_kernels(rows, n).subtract_block_products(rows, n, half,
                                                           {half, &rows, 1, &diagonal_start_[row], out});
      half += rows * n;
    });
  }
}

}  // namespace boxplus
