// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/numeric_factor.h"

#include <algorithm>
#include <cstddef>

#include "boxplus/base/parallel.h"
#include "kernels/kernel_table.h"
#include "linear/block_cholesky/parallel_front.h"

namespace boxplus {
namespace {

template <std::uint32_t Rows>
void copy_columns(const double* from, double* to, std::uint32_t leading, std::uint32_t columns) {
  for (std::uint32_t j = 0; j < columns; ++j, from += Rows, to += leading) {
    for (std::uint32_t i = 0; i < Rows; ++i) to[i] = from[i];
  }
}

void copy_block(const BlockCopy& copy, const double* from, double* to, std::uint32_t leading) {
  if (copy.transposed) {
    for (std::uint32_t j = 0; j < copy.columns; ++j) {
      for (std::uint32_t i = 0; i < copy.rows; ++i) to[j + i * leading] = *from++;
    }
    return;
  }
  if (copy.rows == 3) return copy_columns<3>(from, to, leading, copy.columns);
  if (copy.rows == 6) return copy_columns<6>(from, to, leading, copy.columns);
  for (std::uint32_t j = 0; j < copy.columns; ++j, from += copy.rows, to += leading) {
    std::copy_n(from, copy.rows, to);
  }
}

/// A + λD in the panel, with the limits of its pivots.
void load_panel(const SymbolicFactor& symbolic, const BlockStructure& structure, const Front& front,
                const double* values, const Damping& damping, double* panel, double* minimum_pivot) {
  std::fill_n(panel, std::size_t{front.leading} * front.columns, 0.0);
  for (const BlockCopy& copy : symbolic.copies_of(front)) {
    copy_block(copy, values + copy.source, panel + copy.destination, front.leading);
  }
  double* diagonal = panel;
  for (std::uint32_t k = front.first_block; k < front.end_block; ++k) {
    const std::uint32_t block = symbolic.order[k], offset = structure.offset[block];
    for (std::uint32_t i = 0; i < structure.dim(block); ++i, diagonal += front.leading + 1) {
      *diagonal += damping(offset + i);
      *minimum_pivot++ = kLostPivot * *diagonal;
    }
  }
}

void collect_suspects(const Front& front, std::uint32_t first_scalar, const double* panel,
                      const double* minimum_pivot, Suspects& suspects) {
  constexpr double kScale = kSuspiciousPivot / kLostPivot;
  for (std::uint32_t j = 0; j < front.columns; ++j) {
    const double root = panel[std::size_t{j} * (front.leading + 1)];
    const double pivot = root * root;
    if (pivot < kScale * minimum_pivot[j]) suspects.add({first_scalar + j, pivot / minimum_pivot[j]});
  }
}

/// All that factor_front needs besides the front.
struct Context {
  const SymbolicFactor& symbolic;
  const BlockStructure& structure;
  const double* values;
  const Damping& damping;
  const StopToken& stop;
  const NumericFactor& factor;
};

constexpr FrontsResult kStoppedResult{LinearStatus::kStopped, 0};

/// Assembles and factors one front whose children are done.
FrontsResult factor_front(const Context& context, const Front& front, int threads, Suspects& suspects) {
  const auto& [symbolic, structure, values, damping, stop, factor] = context;
  if (stop.raised()) return kStoppedResult;
  const std::uint32_t first_scalar = symbolic.offset[front.first_block];
  double* const panel = factor.arena + front.panel;
  double* const update = factor.arena + front.update;
  double* const minimum_pivot = factor.minimum_pivot + first_scalar;
  load_panel(symbolic, structure, front, values, damping, panel, minimum_pivot);
  for (const std::uint32_t c : symbolic.children_of(front)) {
    const Front& child = symbolic.fronts[c];
    const auto pivots = symbolic.pivot_runs(child), all = symbolic.all_runs(child);
    if (pivots.empty()) continue;
    extend_add_with(threads, {factor.arena + child.update, static_cast<int>(child.below), pivots.data(),
                              pivots.data() + pivots.size(), all.data() + all.size(), panel,
                              static_cast<int>(front.leading), 0, 0});
  }
  const int columns = static_cast<int>(front.columns), below = static_cast<int>(front.below);
  const int leading = static_cast<int>(front.leading);
  const int good = factor_panel_with(threads, stop, panel, columns + below, columns, leading, minimum_pivot);
  if (good == kPanelStopped) return kStoppedResult;
  if (good < columns)
    return {LinearStatus::kNotPositiveDefinite, first_scalar + static_cast<std::uint32_t>(good)};
  collect_suspects(front, first_scalar, panel, minimum_pivot, suspects);
  if (!set_to_minus_square_with(threads, stop, update, below, panel + columns, leading, below, columns))
    return kStoppedResult;
  for (const std::uint32_t c : symbolic.children_of(front)) {
    const Front& child = symbolic.fronts[c];
    const auto all = symbolic.all_runs(child);
    const ScalarRun* const end = all.data() + all.size();
    const ScalarRun* const begin = all.data() + symbolic.pivot_runs(child).size();
    if (begin == end) continue;
    extend_add_with(threads, {factor.arena + child.update, static_cast<int>(child.below), begin, end, end,
                              update, below, front.columns, front.columns});
  }
  return {};
}

FrontsResult factor_in_order(const Context& context, Suspects& suspects) {
  for (const Front& front : context.symbolic.fronts) {
    const FrontsResult result = factor_front(context, front, 1, suspects);
    if (result.status != LinearStatus::kOk) return result;
  }
  return {};
}

/// Subtrees by thread, then the rest with threads inside the fronts. A lost pivot need not be the first.
LinearStatus factor_in_parallel(const Context& context, NumericFactor& factor) {
  const auto& [threads, top] = context.symbolic.schedule;
  parallel_tasks(static_cast<int>(threads.size()), [&, &shares = threads](int thread) {
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

FrontsResult factorize_fronts(const SymbolicFactor& symbolic, const BlockStructure& structure,
                              const double* values, const Damping& damping, const StopToken& stop,
                              NumericFactor& factor) {
  const Context context{symbolic, structure, values, damping, stop, factor};
  factor.suspects.clear();
  if (symbolic.schedule.is_parallel()) {
    const LinearStatus status = factor_in_parallel(context, factor);
    if (status != LinearStatus::kNotPositiveDefinite) return {status, 0};
    factor.suspects.clear();  // once more in order, to name the first lost pivot
  }
  return factor_in_order(context, factor.suspects);
}

}  // namespace boxplus
