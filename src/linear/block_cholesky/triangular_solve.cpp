// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/triangular_solve.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>

#include "base/flush_subnormals.h"
#include "base/paced_stop.h"
#include "boxplus/base/parallel.h"
#include "kernels/dense_kernels.h"
#include "kernels/kernel_table.h"

namespace boxplus {
namespace {

/// The number of values of the factor between two checks of the token, for several right-hand sides.
constexpr std::int64_t kNumbersOfSeveral = 1 << 13;

/// For several right-hand sides, copies the rows of x below the front's columns to `work`, one after the
/// other.
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
  Scalar* pivots;  // the part of x that belongs to the front's columns

  FrontView(const SymbolicFactor& symbolic, const Front& front, const Scalar* panels, std::size_t stride,
            Scalar* x)
      : panel(panels + front.panel),
        columns(static_cast<int>(front.columns)),
        below(static_cast<int>(front.below)),
        leading(static_cast<int>(front.leading)),
        pivots(x + symbolic.offset[front.first_block] * stride) {}
};

/// Solves for one right-hand side. Each front has separate contiguous memory for its rows. The forward pass
/// adds the contributions of the front's children to this memory, always in the same order. So the result
/// does not depend on the number of threads.
template <class Scalar>
class Substitution {
 public:
  Substitution(const SymbolicFactor& symbolic, const Scalar* panels, Scalar* x, Scalar* work,
               const StopToken& stop)
      : symbolic_(symbolic), panels_(panels), x_(x), work_(work), stop_(stop) {}

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

  /// Returns false if the stop token was raised.
  bool forward_all() {
    if (!in_parallel()) return ascend(0, static_cast<std::uint32_t>(symbolic_.fronts.size()));
    for_each_share([&](const TreeSchedule::Subtree& subtree) { return ascend(subtree.begin, subtree.end); });
    const auto& top = symbolic_.schedule.top;
    return !stopped_ &&
           ascend(0, static_cast<std::uint32_t>(top.size()), [&](std::uint32_t k) { return top[k]; });
  }

  bool backward_all() {
    if (!in_parallel()) return backward_from(static_cast<std::uint32_t>(symbolic_.fronts.size()) - 1);
    const auto& top = symbolic_.schedule.top;
    if (!descend(0, static_cast<std::uint32_t>(top.size()), [&](std::uint32_t k) { return top[k]; }))
      return false;
    for_each_share([&](const TreeSchedule::Subtree& subtree) { return descend(subtree.begin, subtree.end); });
    return !stopped_;
  }

  bool backward_from(std::uint32_t last) { return descend(0, last + 1); }

 private:
  bool in_parallel() const {
    constexpr std::uint64_t kMinParallelValues = 200'000;  // values of the factor, read in about 50 µs
    return symbolic_.schedule.is_parallel() && symbolic_.panel_size >= kMinParallelValues;
  }

  static constexpr std::int64_t kNumbers = 1 << 15;  // the number of values of the factor between two checks

  /// Substitutes forward in the fronts front_of(begin), …, front_of(end − 1). Returns false if the token was
  /// raised.
  template <class F = std::identity>
  bool ascend(std::uint32_t begin, std::uint32_t end, F&& front_of = {}) const {
    PacedStop pace(stop_, kNumbers);
    for (std::uint32_t k = begin; k < end; ++k) {
      const std::uint32_t s = front_of(k);
      if (pace.is_raised_after(numbers_of(s))) return false;
      forward(symbolic_.fronts[s]);
    }
    return true;
  }
  /// Substitutes backward in the fronts front_of(end − 1), …, front_of(begin). Returns false if the token was
  /// raised.
  template <class F = std::identity>
  bool descend(std::uint32_t begin, std::uint32_t end, F&& front_of = {}) const {
    PacedStop pace(stop_, kNumbers);
    for (std::uint32_t k = end; k-- > begin;) {
      const std::uint32_t s = front_of(k);
      if (pace.is_raised_after(numbers_of(s))) return false;
      backward(symbolic_.fronts[s]);
    }
    return true;
  }
  std::int64_t numbers_of(std::uint32_t s) const {
    const Front& front = symbolic_.fronts[s];
    return std::int64_t{front.leading} * front.columns;
  }

  /// Lets each thread process its subtrees, until `work_on` returns false.
  template <class F>
  void for_each_share(F&& work_on) {
    const auto& shares = symbolic_.schedule.threads;
    detail::parallel_tasks(static_cast<int>(shares.size()), [&](int thread) {
      for (const auto& subtree : shares[thread]) {
        if (!work_on(subtree)) return void(stopped_ = true);
      }
    });
  }

  ScalarRun pivots_of(const Front& front) const {
    return {0, symbolic_.offset[front.first_block], front.columns};
  }

  const SymbolicFactor& symbolic_;
  const Scalar* panels_;
  Scalar *x_, *work_;
  const StopToken& stop_;
  std::atomic<bool> stopped_ = false;
  const dense::FactorKernels<Scalar>& kernels_ = dense::factor_kernels<Scalar>();
};

}  // namespace

template <class Scalar>
bool solve_lower(const SymbolicFactor& symbolic, const Scalar* panels, int columns, Scalar* x, Scalar* work,
                 const StopToken& stop) {
  if (columns == 1) return Substitution<Scalar>(symbolic, panels, x, work, stop).forward_all();
  const auto stride = static_cast<std::size_t>(columns);
  PacedStop pace(stop, kNumbersOfSeveral);
  for (const Front& front : symbolic.fronts) {
    if (pace.is_raised_after(std::int64_t{front.leading} * front.columns)) return false;
    const FrontView<Scalar> f(symbolic, front, panels, stride, x);
    dense::divide_by_transposed(f.pivots, columns, f.panel, f.leading, columns, f.columns);
    gather(symbolic, front, stride, x, work);
    dense::subtract_product_transposed(work, columns, f.pivots, columns, f.panel + f.columns, f.leading,
                                       columns, f.below, f.columns);
    scatter(symbolic, front, stride, work, x);
  }
  return true;
}

template <class Scalar>
void solve_upper_from(const SymbolicFactor& symbolic, const Scalar* panels, std::uint32_t last_front,
                      Scalar* x, Scalar* work) {
  const StopToken never;
  Substitution<Scalar>(symbolic, panels, x, work, never).backward_from(last_front);
}

template <class Scalar>
bool solve_upper(const SymbolicFactor& symbolic, const Scalar* panels, int columns, Scalar* x, Scalar* work,
                 const StopToken& stop) {
  if (columns == 1) return Substitution<Scalar>(symbolic, panels, x, work, stop).backward_all();
  const auto stride = static_cast<std::size_t>(columns);
  PacedStop pace(stop, kNumbersOfSeveral);
  for (auto s = static_cast<std::uint32_t>(symbolic.fronts.size()); s-- > 0;) {
    const Front& front = symbolic.fronts[s];
    if (pace.is_raised_after(std::int64_t{front.leading} * front.columns)) return false;
    const FrontView<Scalar> f(symbolic, front, panels, stride, x);
    gather(symbolic, front, stride, x, work);
    dense::subtract_product(f.pivots, columns, work, columns, f.panel + f.columns, f.leading, columns,
                            f.columns, f.below);
    dense::divide_by(f.pivots, columns, f.panel, f.leading, columns, f.columns);
  }
  return true;
}

template <class Scalar>
bool solve_with(const SymbolicFactor& symbolic, const BlockStructure& structure,
                const NumericFactor<Scalar>& factor, const double* b, int columns, double* x,
                const StopToken& stop) {
  const FlushSubnormals flush;
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
  if (!solve_lower(symbolic, factor.arena(), columns, factor.x(), factor.work(), stop)) return false;
  if (!solve_upper(symbolic, factor.arena(), columns, factor.x(), factor.work(), stop)) return false;
  for_all([x](Scalar from, std::size_t i) { x[i] = from; });
  return true;
}

template bool solve_lower(const SymbolicFactor&, const double*, int, double*, double*, const StopToken&);
template bool solve_upper(const SymbolicFactor&, const double*, int, double*, double*, const StopToken&);
template void solve_upper_from(const SymbolicFactor&, const double*, std::uint32_t, double*, double*);
template bool solve_with(const SymbolicFactor&, const BlockStructure&, const NumericFactor<double>&,
                         const double*, int, double*, const StopToken&);
template bool solve_lower(const SymbolicFactor&, const float*, int, float*, float*, const StopToken&);
template bool solve_upper(const SymbolicFactor&, const float*, int, float*, float*, const StopToken&);
template void solve_upper_from(const SymbolicFactor&, const float*, std::uint32_t, float*, float*);
template bool solve_with(const SymbolicFactor&, const BlockStructure&, const NumericFactor<float>&,
                         const double*, int, double*, const StopToken&);

}  // namespace boxplus
