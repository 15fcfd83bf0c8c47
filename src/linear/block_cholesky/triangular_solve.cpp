// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/triangular_solve.h"

#include <algorithm>
#include <cstddef>

#include "kernels/dense_kernels.h"
#include "kernels/kernel_table.h"

namespace boxplus {
namespace {

/// Several right-hand sides: the rows of x below the front's columns, one after the other.
void gather(const SymbolicFactor& symbolic, const Front& front, std::size_t columns, const double* x,
            double* work) {
  for (const ScalarRun& run : symbolic.row_runs_of(front)) {
    std::copy_n(x + run.destination * columns, run.length * columns, work + run.source * columns);
  }
}

void scatter(const SymbolicFactor& symbolic, const Front& front, std::size_t columns, const double* work,
             double* x) {
  for (const ScalarRun& run : symbolic.row_runs_of(front)) {
    std::copy_n(work + run.source * columns, run.length * columns, x + run.destination * columns);
  }
}

struct FrontView {
  const double* panel;
  int columns, below, leading;
  double* pivots;  // of x

  FrontView(const SymbolicFactor& symbolic, const Front& front, const double* panels, std::size_t stride,
            double* x)
      : panel(panels + front.panel),
        columns(static_cast<int>(front.columns)),
        below(static_cast<int>(front.below)),
        leading(static_cast<int>(front.leading)),
        pivots(x + symbolic.offset[front.first_block] * stride) {}
};

/// One right-hand side: the rows of a front, side by side in `work`.
class FrontRows {
 public:
  FrontRows(const SymbolicFactor& symbolic, const Front& front)
      : pivots_{0, symbolic.offset[front.first_block], front.columns},
        below_(symbolic.row_runs_of(front)),
        columns_(front.columns) {}
  void gather(const double* x, double* work) const {
    kernels_.gather_runs(&pivots_, 1, x, work);
    kernels_.gather_runs(below_.data(), static_cast<int>(below_.size()), x, work + columns_);
  }
  void scatter_pivots(const double* work, double* x) const { kernels_.scatter_runs(&pivots_, 1, work, x); }
  void scatter(const double* work, double* x) const {
    scatter_pivots(work, x);
    kernels_.scatter_runs(below_.data(), static_cast<int>(below_.size()), work + columns_, x);
  }

 private:
  const dense::KernelTable& kernels_ = dense::kernels();
  ScalarRun pivots_;
  std::span<const ScalarRun> below_;
  std::uint32_t columns_;
};

void solve_lower_one(const SymbolicFactor& symbolic, const double* panels, double* x, double* work) {
  for (const Front& front : symbolic.fronts) {
    const FrontView f(symbolic, front, panels, 1, x);
    const FrontRows rows(symbolic, front);
    rows.gather(x, work);
    dense::solve_forward(f.panel, f.columns + f.below, f.columns, f.leading, work);
    rows.scatter(work, x);
  }
}

}  // namespace

void solve_lower(const SymbolicFactor& symbolic, const double* panels, int columns, double* x, double* work) {
  if (columns == 1) return solve_lower_one(symbolic, panels, x, work);
  const auto stride = static_cast<std::size_t>(columns);
  for (const Front& front : symbolic.fronts) {
    const FrontView f(symbolic, front, panels, stride, x);
    dense::divide_by_transposed(f.pivots, columns, f.panel, f.leading, columns, f.columns);
    gather(symbolic, front, stride, x, work);
    dense::subtract_product_transposed(work, columns, f.pivots, columns, f.panel + f.columns, f.leading,
                                       columns, f.below, f.columns);
    scatter(symbolic, front, stride, work, x);
  }
}

void solve_upper_from(const SymbolicFactor& symbolic, const double* panels, std::uint32_t last_front,
                      double* x, double* work) {
  for (std::uint32_t s = last_front + 1; s-- > 0;) {
    const Front& front = symbolic.fronts[s];
    const FrontView f(symbolic, front, panels, 1, x);
    const FrontRows rows(symbolic, front);
    rows.gather(x, work);
    dense::solve_backward(f.panel, f.columns + f.below, f.columns, f.leading, work);
    rows.scatter_pivots(work, x);
  }
}

void solve_upper(const SymbolicFactor& symbolic, const double* panels, int columns, double* x, double* work) {
  const auto count = static_cast<std::uint32_t>(symbolic.fronts.size());
  if (columns == 1) return solve_upper_from(symbolic, panels, count - 1, x, work);
  const auto stride = static_cast<std::size_t>(columns);
  for (std::uint32_t s = count; s-- > 0;) {
    const Front& front = symbolic.fronts[s];
    const FrontView f(symbolic, front, panels, stride, x);
    gather(symbolic, front, stride, x, work);
    dense::subtract_product(f.pivots, columns, work, columns, f.panel + f.columns, f.leading, columns,
                            f.columns, f.below);
    dense::divide_by(f.pivots, columns, f.panel, f.leading, columns, f.columns);
  }
}

}  // namespace boxplus
