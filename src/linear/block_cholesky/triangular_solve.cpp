// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/triangular_solve.h"

#include <algorithm>
#include <cstddef>

#include "kernels/dense_kernels.h"
#include "kernels/kernel_table.h"

namespace boxplus {
namespace {

/// Several right-hand sides: the rows of x below the front's columns, one after the other.
template <class Scalar>
void gather(const SymbolicFactor& symbolic, const Front& front, std::size_t columns, const Scalar* x,
            Scalar* work) {
  for (const ScalarRun& run : symbolic.row_runs_of(front)) {
    std::copy_n(x + run.destination * columns, run.length * columns, work + run.source * columns);
  }
}

template <class Scalar>
void scatter(const SymbolicFactor& symbolic, const Front& front, std::size_t columns, const Scalar* work,
             Scalar* x) {
  for (const ScalarRun& run : symbolic.row_runs_of(front)) {
    std::copy_n(work + run.source * columns, run.length * columns, x + run.destination * columns);
  }
}

template <class Scalar>
struct FrontView {
  const Scalar* panel;
  int columns, below, leading;
  Scalar* pivots;  // of x

  FrontView(const SymbolicFactor& symbolic, const Front& front, const Scalar* panels, std::size_t stride,
            Scalar* x)
      : panel(panels + front.panel),
        columns(static_cast<int>(front.columns)),
        below(static_cast<int>(front.below)),
        leading(static_cast<int>(front.leading)),
        pivots(x + symbolic.offset[front.first_block] * stride) {}
};

/// One right-hand side: the rows of a front, side by side in `work`.
template <class Scalar>
class FrontRows {
 public:
  FrontRows(const SymbolicFactor& symbolic, const Front& front)
      : pivots_{0, symbolic.offset[front.first_block], front.columns},
        below_(symbolic.row_runs_of(front)),
        columns_(front.columns) {}
  void gather(const Scalar* x, Scalar* work) const {
    kernels_.gather_runs(&pivots_, 1, x, work);
    kernels_.gather_runs(below_.data(), static_cast<int>(below_.size()), x, work + columns_);
  }
  void scatter_pivots(const Scalar* work, Scalar* x) const { kernels_.scatter_runs(&pivots_, 1, work, x); }
  void scatter(const Scalar* work, Scalar* x) const {
    scatter_pivots(work, x);
    kernels_.scatter_runs(below_.data(), static_cast<int>(below_.size()), work + columns_, x);
  }

 private:
  const dense::FactorKernels<Scalar>& kernels_ = dense::factor_kernels<Scalar>();
  ScalarRun pivots_;
  std::span<const ScalarRun> below_;
  std::uint32_t columns_;
};

template <class Scalar>
void solve_lower_one(const SymbolicFactor& symbolic, const Scalar* panels, Scalar* x, Scalar* work) {
  for (const Front& front : symbolic.fronts) {
    const FrontView<Scalar> f(symbolic, front, panels, 1, x);
    const FrontRows<Scalar> rows(symbolic, front);
    rows.gather(x, work);
    dense::solve_forward(f.panel, f.columns + f.below, f.columns, f.leading, work);
    rows.scatter(work, x);
  }
}

}  // namespace

template <class Scalar>
void solve_lower(const SymbolicFactor& symbolic, const Scalar* panels, int columns, Scalar* x, Scalar* work) {
  if (columns == 1) return solve_lower_one(symbolic, panels, x, work);
  const auto stride = static_cast<std::size_t>(columns);
  for (const Front& front : symbolic.fronts) {
    const FrontView<Scalar> f(symbolic, front, panels, stride, x);
    dense::divide_by_transposed(f.pivots, columns, f.panel, f.leading, columns, f.columns);
    gather(symbolic, front, stride, x, work);
    dense::subtract_product_transposed(work, columns, f.pivots, columns, f.panel + f.columns, f.leading,
                                       columns, f.below, f.columns);
    scatter(symbolic, front, stride, work, x);
  }
}

template <class Scalar>
void solve_upper_from(const SymbolicFactor& symbolic, const Scalar* panels, std::uint32_t last_front,
                      Scalar* x, Scalar* work) {
  for (std::uint32_t s = last_front + 1; s-- > 0;) {
    const Front& front = symbolic.fronts[s];
    const FrontView<Scalar> f(symbolic, front, panels, 1, x);
    const FrontRows<Scalar> rows(symbolic, front);
    rows.gather(x, work);
    dense::solve_backward(f.panel, f.columns + f.below, f.columns, f.leading, work);
    rows.scatter_pivots(work, x);
  }
}

template <class Scalar>
void solve_upper(const SymbolicFactor& symbolic, const Scalar* panels, int columns, Scalar* x, Scalar* work) {
  const auto count = static_cast<std::uint32_t>(symbolic.fronts.size());
  if (columns == 1) return solve_upper_from(symbolic, panels, count - 1, x, work);
  const auto stride = static_cast<std::size_t>(columns);
  for (std::uint32_t s = count; s-- > 0;) {
    const Front& front = symbolic.fronts[s];
    const FrontView<Scalar> f(symbolic, front, panels, stride, x);
    gather(symbolic, front, stride, x, work);
    dense::subtract_product(f.pivots, columns, work, columns, f.panel + f.columns, f.leading, columns,
                            f.columns, f.below);
    dense::divide_by(f.pivots, columns, f.panel, f.leading, columns, f.columns);
  }
}

template <class Scalar>
void solve_with(const SymbolicFactor& symbolic, const BlockStructure& structure,
                const NumericFactor<Scalar>& factor, const double* b, int columns, double* x) {
  const std::size_t scalars = structure.scalars(), stride = static_cast<std::size_t>(columns);
  const auto for_all = [&](auto&& move) {
    Scalar* permuted = factor.x();
    for (const std::uint32_t block : symbolic.order) {
      for (std::uint32_t i = structure.offset[block]; i < structure.offset[block + 1]; ++i) {
        for (std::size_t c = 0; c < stride; ++c) move(*permuted++, c * scalars + i);
      }
    }
  };
  for_all([b](Scalar& to, std::size_t i) { to = static_cast<Scalar>(b[i]); });
  solve_lower(symbolic, factor.arena(), columns, factor.x(), factor.work());
  solve_upper(symbolic, factor.arena(), columns, factor.x(), factor.work());
  for_all([x](Scalar from, std::size_t i) { x[i] = from; });
}

template void solve_lower(const SymbolicFactor&, const double*, int, double*, double*);
template void solve_upper(const SymbolicFactor&, const double*, int, double*, double*);
template void solve_upper_from(const SymbolicFactor&, const double*, std::uint32_t, double*, double*);
template void solve_with(const SymbolicFactor&, const BlockStructure&, const NumericFactor<double>&,
                         const double*, int, double*);
template void solve_lower(const SymbolicFactor&, const float*, int, float*, float*);
template void solve_upper(const SymbolicFactor&, const float*, int, float*, float*);
template void solve_upper_from(const SymbolicFactor&, const float*, std::uint32_t, float*, float*);
template void solve_with(const SymbolicFactor&, const BlockStructure&, const NumericFactor<float>&,
                         const double*, int, double*);

}  // namespace boxplus
