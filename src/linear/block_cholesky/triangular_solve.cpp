// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/triangular_solve.h"

#include <algorithm>
#include <cstddef>

#include "boxplus/base/parallel.h"
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

/// One right-hand side. Each front has its rows of it side by side in memory of its own: forward, what its
/// children subtract from rows that come later arrives there in their order, whoever works on them.
template <class Scalar>
class Substitution {
 public:
  Substitution(const SymbolicFactor& symbolic, const Scalar* panels, Scalar* x, Scalar* work)
      : symbolic_(symbolic), panels_(panels), x_(x), work_(work) {}

  void forward(const Front& front) const {
    const FrontView<Scalar> f(symbolic_, front, panels_, 1, x_);
    Scalar* const rows = work_ + front.first_row;
    const ScalarRun pivots = pivots_of(front);
    kernels_.gather_runs(&pivots, 1, x_, rows);
    std::fill_n(rows + f.columns, f.below, Scalar{0});
    for (const std::uint32_t c : symbolic_.children_of(front)) {
      const Front& child = symbolic_.fronts[c];
      const auto runs = symbolic_.all_runs(child);
      kernels_.add_runs(runs.data(), static_cast<int>(runs.size()), work_ + child.first_row + child.columns,
                        rows);
    }
    dense::solve_forward(f.panel, f.columns + f.below, f.columns, f.leading, rows);
    kernels_.scatter_runs(&pivots, 1, rows, x_);
  }

  void backward(const Front& front) const {
    const FrontView<Scalar> f(symbolic_, front, panels_, 1, x_);
    Scalar* const rows = work_ + front.first_row;
    const ScalarRun pivots = pivots_of(front);
    const auto below = symbolic_.row_runs_of(front);
    kernels_.gather_runs(&pivots, 1, x_, rows);
    kernels_.gather_runs(below.data(), static_cast<int>(below.size()), x_, rows + f.columns);
    dense::solve_backward(f.panel, f.columns + f.below, f.columns, f.leading, rows);
    kernels_.scatter_runs(&pivots, 1, rows, x_);
  }

  void forward_all() const {
    if (!in_parallel()) {
      for (const Front& front : symbolic_.fronts) forward(front);
      return;
    }
    for_each_share([&](const TreeSchedule::Subtree& subtree) {
      for (std::uint32_t s = subtree.begin; s < subtree.end; ++s) forward(symbolic_.fronts[s]);
    });
    for (const std::uint32_t s : symbolic_.schedule.top) forward(symbolic_.fronts[s]);
  }

  void backward_all() const {
    if (!in_parallel()) return backward_from(static_cast<std::uint32_t>(symbolic_.fronts.size()) - 1);
    const auto& top = symbolic_.schedule.top;
    std::for_each(top.rbegin(), top.rend(), [&](std::uint32_t s) { backward(symbolic_.fronts[s]); });
    for_each_share([&](const TreeSchedule::Subtree& subtree) {
      for (std::uint32_t s = subtree.end; s-- > subtree.begin;) backward(symbolic_.fronts[s]);
    });
  }

  void backward_from(std::uint32_t last) const {
    for (std::uint32_t s = last + 1; s-- > 0;) backward(symbolic_.fronts[s]);
  }

 private:
  bool in_parallel() const {
    constexpr std::uint64_t kWorthThreads = 200'000;  // numbers of the factor, about 50 µs
    return symbolic_.schedule.is_parallel() && symbolic_.panel_size >= kWorthThreads;
  }

  /// The subtrees of each thread, side by side.
  template <class F>
  void for_each_share(F&& work_on) const {
    const auto& shares = symbolic_.schedule.threads;
    parallel_tasks(static_cast<int>(shares.size()), [&](int thread) {
      for (const auto& subtree : shares[static_cast<std::size_t>(thread)]) work_on(subtree);
    });
  }

  ScalarRun pivots_of(const Front& front) const {
    return {0, symbolic_.offset[front.first_block], front.columns};
  }

  const SymbolicFactor& symbolic_;
  const Scalar* panels_;
  Scalar *x_, *work_;
  const dense::FactorKernels<Scalar>& kernels_ = dense::factor_kernels<Scalar>();
};

}  // namespace

template <class Scalar>
void solve_lower(const SymbolicFactor& symbolic, const Scalar* panels, int columns, Scalar* x, Scalar* work) {
  if (columns == 1) return Substitution<Scalar>(symbolic, panels, x, work).forward_all();
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
  Substitution<Scalar>(symbolic, panels, x, work).backward_from(last_front);
}

template <class Scalar>
void solve_upper(const SymbolicFactor& symbolic, const Scalar* panels, int columns, Scalar* x, Scalar* work) {
  if (columns == 1) return Substitution<Scalar>(symbolic, panels, x, work).backward_all();
  const auto stride = static_cast<std::size_t>(columns);
  for (auto s = static_cast<std::uint32_t>(symbolic.fronts.size()); s-- > 0;) {
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
