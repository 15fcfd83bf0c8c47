// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/numeric_factor.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "base/flush_subnormals.h"
#include "boxplus/base/large_pages.h"
#include "boxplus/base/parallel.h"
#include "kernels/kernel_table.h"
#include "linear/block_cholesky/front_elimination.h"

namespace boxplus {
namespace {

template <std::uint32_t Rows, class Scalar>
void copy_columns(const double* from, Scalar* to, std::uint32_t leading, std::uint32_t columns) {
  for (std::uint32_t j = 0; j < columns; ++j, from += Rows, to += leading) {
    for (std::uint32_t i = 0; i < Rows; ++i) to[i] = static_cast<Scalar>(from[i]);
  }
}

template <class Scalar>
void copy_block(const BlockCopy& copy, const double* from, Scalar* to, std::uint32_t leading) {
  if (copy.transposed) {
    for (std::uint32_t j = 0; j < copy.columns; ++j) {
      for (std::uint32_t i = 0; i < copy.rows; ++i) to[j + i * leading] = static_cast<Scalar>(*from++);
    }
    return;
  }
  if (copy.rows == 3) return copy_columns<3>(from, to, leading, copy.columns);
  if (copy.rows == 6) return copy_columns<6>(from, to, leading, copy.columns);
  for (std::uint32_t j = 0; j < copy.columns; ++j, from += copy.rows, to += leading) {
    for (std::uint32_t i = 0; i < copy.rows; ++i) to[i] = static_cast<Scalar>(from[i]);
  }
}

/// Copies A + λD to the panel, and sets the lower limits of its pivots.
template <class Scalar>
void load_panel(const SymbolicFactor& symbolic, const BlockStructure& structure, const Front& front,
                const double* values, const Damping& damping, Scalar* panel, Scalar* minimum_pivot) {
  std::fill_n(panel, std::size_t{front.leading} * front.columns, Scalar{0});
  for (const BlockCopy& copy : symbolic.copies_of(front)) {
    copy_block(copy, values + copy.source, panel + copy.destination, front.leading);
  }
  Scalar* diagonal = panel;
  for (std::uint32_t k = front.first_block; k < front.end_block; ++k) {
    const std::uint32_t block = symbolic.order[k], offset = structure.offset[block];
    for (std::uint32_t i = 0; i < structure.dim(block); ++i, diagonal += front.leading + 1) {
      *diagonal += static_cast<Scalar>(damping(offset + i));
      *minimum_pivot++ = kLostPivotOf<Scalar> * *diagonal;
    }
  }
}

template <class Scalar>
void collect_suspects(const Front& front, std::uint32_t first_scalar, const Scalar* panel,
                      const Scalar* minimum_pivot, Suspects& suspects) {
  constexpr double kScale = double{kSuspiciousPivotOf<Scalar>} / kLostPivotOf<Scalar>;
  for (std::uint32_t j = 0; j < front.columns; ++j) {
    const double root = panel[std::size_t{j} * (front.leading + 1)], limit = minimum_pivot[j];
    const double pivot = root * root;
    if (pivot < kScale * limit) suspects.add({first_scalar + j, pivot / limit});
  }
}

/// The arguments that all calls of factor_front() share.
template <class Scalar>
struct Context {
  const SymbolicFactor& symbolic;
  const BlockStructure& structure;
  const double* values;
  const Damping& damping;
  const StopToken& stop;
  const NumericFactor<Scalar>& factor;
};

constexpr FrontsResult kStoppedResult{LinearStatus::kStopped, 0};

/// Assembles and factorizes one front whose children are already factorized.
template <class Scalar>
FrontsResult factor_front(const Context<Scalar>& context, const Front& front, int threads,
                          Suspects& suspects) {
  const auto& [symbolic, structure, values, damping, stop, factor] = context;
  if (stop.raised()) return kStoppedResult;
  const std::uint32_t first_scalar = symbolic.offset[front.first_block];
  Scalar* const panel = factor.arena() + front.panel;
  Scalar* const minimum_pivot = factor.minimum_pivot() + first_scalar;
  load_panel(symbolic, structure, front, values, damping, panel, minimum_pivot);
  const int columns = static_cast<int>(front.columns);
  const LoadedFront<Scalar> loaded{panel,   factor.arena() + front.update, minimum_pivot,
                                   columns, static_cast<int>(front.below), static_cast<int>(front.leading)};
  const int good =
      eliminate_front(loaded, threads, stop, [&, &symbolic = symbolic, &factor = factor](const auto& add) {
        for (const std::uint32_t c : symbolic.children_of(front)) {
          const Front& child = symbolic.fronts[c];
          add(ChildUpdate<Scalar>{factor.arena() + child.update, static_cast<int>(child.below),
                                  symbolic.all_runs(child), child.run_split - child.run_begin});
        }
      });
  if (good == kPanelStopped) return kStoppedResult;
  if (good < columns)
    return {LinearStatus::kNotPositiveDefinite, first_scalar + static_cast<std::uint32_t>(good)};
  collect_suspects(front, first_scalar, panel, minimum_pivot, suspects);
  return {};
}

template <class Scalar>
FrontsResult factor_in_order(const Context<Scalar>& context, Suspects& suspects) {
  for (const Front& front : context.symbolic.fronts) {
    const FrontsResult result = factor_front(context, front, 1, suspects);
    if (result.status != LinearStatus::kOk) return result;
  }
  return {};
}

/// Factorizes the subtrees in parallel, and then each of the other fronts with all threads. Does not return a
/// lost pivot, because the lost pivot that is found first is not always the first one in the elimination
/// order.
template <class Scalar>
LinearStatus factor_in_parallel(const Context<Scalar>& context, NumericFactor<Scalar>& factor) {
  const auto& [threads, top] = context.symbolic.schedule;
  detail::parallel_tasks(static_cast<int>(threads.size()), [&, &shares = threads](int thread) {
    const auto t = static_cast<std::size_t>(thread);
    Suspects suspects;
    LinearStatus status = LinearStatus::kOk;
    for (const auto& subtree : shares[t]) {
      for (std::uint32_t s = subtree.begin; s < subtree.end && status == LinearStatus::kOk; ++s) {
        status = factor_front(context, context.symbolic.fronts[s], 1, suspects).status;
      }
    }
    factor.status_of_thread[t] = status;
    factor.suspects_of_thread[t] = suspects;
  });
  const LinearStatus worst =
      *std::max_element(factor.status_of_thread.begin(), factor.status_of_thread.end());
  if (worst != LinearStatus::kOk) return worst;
  for (const Suspects& suspects : factor.suspects_of_thread) factor.suspects.add(suspects);
  for (const std::uint32_t s : top) {
    const Front& front = context.symbolic.fronts[s];
    const auto result = factor_front(context, front, static_cast<int>(threads.size()), factor.suspects);
    if (result.status != LinearStatus::kOk) return result.status;
  }
  return LinearStatus::kOk;
}

}  // namespace

void Suspects::add(Suspect suspect) {
  const auto comes_before = [](const Suspect& a, const Suspect& b) {
    return a.ratio < b.ratio || (a.ratio == b.ratio && a.scalar < b.scalar);
  };
  if (count_ == list_.size()) {
    if (!comes_before(suspect, list_.back())) return;
    --count_;
  }
  std::size_t place = count_++;
  for (; place > 0 && comes_before(suspect, list_[place - 1]); --place) list_[place] = list_[place - 1];
  list_[place] = suspect;
}

template <class Scalar>
void NumericFactor<Scalar>::allocate(const SymbolicFactor& symbolic, std::uint32_t scalars, int batch) {
  const std::size_t columns = static_cast<std::size_t>(batch);
  const std::size_t factor_size = symbolic.panel_size + symbolic.update_size;
  const std::size_t work_size = std::max<std::size_t>(columns * symbolic.largest_front, symbolic.all_rows);
  const std::size_t size = factor_size + scalars + columns * scalars + work_size;
  memory_ = std::make_unique_for_overwrite<Scalar[]>(size);
  detail::prefer_large_pages(memory_.get(), size * sizeof(Scalar));
  minimum_pivot_ = memory_.get() + factor_size;
  x_ = minimum_pivot_ + scalars;
  work_ = x_ + columns * scalars;
  suspects_of_thread.resize(symbolic.schedule.threads.size());
  status_of_thread.resize(symbolic.schedule.threads.size());
}

template <class Scalar>
FrontsResult factorize_fronts(const SymbolicFactor& symbolic, const BlockStructure& structure,
                              const double* values, const Damping& damping, const StopToken& stop,
                              NumericFactor<Scalar>& factor) {
  const FlushSubnormals flush;
  const Context<Scalar> context{symbolic, structure, values, damping, stop, factor};
  factor.suspects.clear();
  if (symbolic.schedule.is_parallel()) {
    const LinearStatus status = factor_in_parallel(context, factor);
    if (status != LinearStatus::kNotPositiveDefinite) return {status, 0};
    factor.suspects.clear();  // factorizes again in order, to find the first lost pivot
  }
  return factor_in_order(context, factor.suspects);
}

template class NumericFactor<double>;
template FrontsResult factorize_fronts(const SymbolicFactor&, const BlockStructure&, const double*,
                                       const Damping&, const StopToken&, NumericFactor<double>&);
template class NumericFactor<float>;
template FrontsResult factorize_fronts(const SymbolicFactor&, const BlockStructure&, const double*,
                                       const Damping&, const StopToken&, NumericFactor<float>&);

}  // namespace boxplus
