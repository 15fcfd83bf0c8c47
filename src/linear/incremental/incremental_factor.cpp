// SPDX-License-Identifier: BSD-3-Clause
#include "linear/incremental/incremental_factor.h"

#include <algorithm>
#include <cmath>

#include "kernels/dense_kernels.h"
#include "linear/block_cholesky/front_elimination.h"
#include "linear/lost_pivot.h"

namespace boxplus {
namespace {

using Index = IncrementalFactor::Index;

/// The last element of `free`, or `fresh` if it is empty.
template <class T>
T reuse(std::vector<T>& free, T fresh) {
  if (free.empty()) return fresh;
  const T last = free.back();
  free.pop_back();
  return last;
}

template <std::uint32_t Rows>
void add_rows(const double* from, double* to, std::uint32_t columns, std::uint32_t leading) {
  for (std::uint32_t c = 0; c < columns; ++c, from += Rows, to += leading) {
    for (std::uint32_t r = 0; r < Rows; ++r) to[r] += from[r];
  }
}

/// to += from, which is rows × columns and dense.
void add_columns(const double* from, std::uint32_t rows, std::uint32_t columns, double* to,
                 std::uint32_t leading) {
  if (rows == 3) return add_rows<3>(from, to, columns, leading);
  if (rows == 6) return add_rows<6>(from, to, columns, leading);
  for (std::uint32_t c = 0; c < columns; ++c, from += rows, to += leading) {
    for (std::uint32_t r = 0; r < rows; ++r) to[r] += from[r];
  }
}

/// to += fromᵀ, where `from` is rows × columns and dense.
void add_transposed(const double* from, std::uint32_t rows, std::uint32_t columns, double* to,
                    std::uint32_t leading) {
  for (std::uint32_t c = 0; c < columns; ++c) {
    for (std::uint32_t r = 0; r < rows; ++r) to[c + std::size_t{r} * leading] += *from++;
  }
}

template <class T>
std::vector<T>& list_for(std::vector<std::vector<T>>& lists, std::size_t size) {
  if (size >= lists.size()) lists.resize(size + 1);
  return lists[size];
}

}  // namespace

// ---- The matrix ----

Index IncrementalFactor::add_block(std::span<const double> noticeable) {
  const auto dim = static_cast<std::uint32_t>(noticeable.size());
  const Index b = reuse(free_blocks_, static_cast<Index>(blocks_.size()));
  if (b == blocks_.size()) {
    blocks_.emplace_back();
    local_.push_back(kNone);
    noticed_pass_.push_back(0);
    mark_.push_back(0);
  }
  Block& block = blocks_[b];
  block.dim = dim;
  block.x = reuse(list_for(free_x_, dim), static_cast<std::uint32_t>(x_.size()));
  if (block.x == x_.size()) {
    for (auto* values : {&published_, &noticeable_, &x_}) values->resize(block.x + std::size_t{dim});
  }
  std::copy(noticeable.begin(), noticeable.end(), noticeable_.begin() + block.x);
  std::fill_n(x_.begin() + block.x, dim, 0.0);
  std::fill_n(published_.begin() + block.x, dim, 0.0);
  block.front = kNone;
  block.age = ++age_;
  block.is_alive = true;
  scalars_ += dim;
  touch(b);
  return b;
}

void IncrementalFactor::remove_block(Index b) {
  Block& block = blocks_[b];
  block.is_alive = false;
  block.held.clear();
  list_for(free_x_, block.dim).push_back(block.x);
  scalars_ -= block.dim;
  touch(b);
}

void IncrementalFactor::touch(Index b) {
  if (blocks_[b].is_touched) return;
  blocks_[b].is_touched = true;
  touched_.push_back(b);
}

Index IncrementalFactor::add_term(std::span<const Index> blocks) {
  const Index t = reuse(free_terms_, static_cast<Index>(terms_.size()));
  if (t == terms_.size()) terms_.emplace_back();
  Term& term = terms_[t];
  term.blocks.assign(blocks.begin(), blocks.end());
  std::uint32_t size = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    size += dim(blocks[i]);
    for (std::size_t j = 0; j <= i; ++j) size += dim(blocks[i]) * dim(blocks[j]);
    blocks_[blocks[i]].terms.push_back(t);
    touch(blocks[i]);
  }
  term.size = size;
  term.values =
      reuse(list_for(free_values_, SizedMemory::class_of(size)), static_cast<std::uint32_t>(values_.size()));
  if (term.values == values_.size()) values_.resize(values_.size() + SizedMemory::room_of(size));
  term.is_changed = false;
  clear_term(t);
  return t;
}

void IncrementalFactor::remove_term(Index t) {
  Term& term = terms_[t];
  for (const Index b : term.blocks) {
    std::vector<Index>& list = blocks_[b].terms;
    list.erase(std::find(list.begin(), list.end(), t));
    touch(b);
  }
  list_for(free_values_, SizedMemory::class_of(term.size)).push_back(term.values);
  term.blocks.clear();
  free_terms_.push_back(t);
}

void IncrementalFactor::clear_term(Index t) {
  Term& term = terms_[t];
  std::fill_n(values_.begin() + term.values, term.size, 0.0);
  if (term.is_changed) return;
  term.is_changed = true;
  changed_terms_.push_back(t);
}

std::uint32_t IncrementalFactor::gradient_of(Index t, std::size_t i) const {
  const Term& term = terms_[t];
  std::uint32_t offset = term.values;
  for (std::size_t k = 0; k < i; ++k) offset += dim(term.blocks[k]);
  return offset;
}

std::uint32_t IncrementalFactor::block_of(Index t, std::size_t i, std::size_t j) const {
  const Term& term = terms_[t];
  std::uint32_t before = 0, offset = gradient_of(t, term.blocks.size());
  for (std::size_t k = 0; k < i; ++k) {
    before += dim(term.blocks[k]);
    offset += dim(term.blocks[k]) * before;
  }
  for (std::size_t k = 0; k < j; ++k) offset += dim(term.blocks[i]) * dim(term.blocks[k]);
  return offset;
}

Index IncrementalFactor::root_of(Index block) const {
  Index f = blocks_[block].front;
  while (f != kNone && fronts_[f].parent != kNone) f = fronts_[f].parent;
  return f;
}

void IncrementalFactor::hold_scalars(Index block, std::span<const int> scalars) {
  blocks_[block].held.assign(scalars.begin(), scalars.end());
}

// ---- Factorization ----

void IncrementalFactor::mark_path(Index f) {
  for (; f != kNone && !fronts_[f].is_dirty; f = fronts_[f].parent) {
    fronts_[f].is_dirty = true;
    dirty_.push_back(f);
  }
}

/// Marks the fronts to which changed terms add, and their ancestors.
void IncrementalFactor::mark_changed() {
  for (const Index t : changed_terms_) {
    terms_[t].is_changed = false;
    for (const Index b : terms_[t].blocks) mark_path(blocks_[b].front);
  }
  changed_terms_.clear();
}

IncrementalFactor::Result IncrementalFactor::factorize(const StopToken& stop, FactorWork& work) {
  if (!touched_.empty()) take_top_apart(work);
  mark_changed();
  std::sort(dirty_.begin(), dirty_.end(), [&](Index a, Index b) {
    return blocks_[fronts_[a].blocks[0]].sequence < blocks_[fronts_[b].blocks[0]].sequence;
  });
  std::size_t done = 0;
  Result result;
  for (; done < dirty_.size() && result.status == LinearStatus::kOk; ++done) {
    Front& front = fronts_[dirty_[done]];
    const Result of_front = factorize_front(front, stop);
    result = {of_front.status, of_front.lost_block, result.is_suspicious || of_front.is_suspicious};
    if (result.status != LinearStatus::kOk) break;
    front.is_dirty = false;
    front.is_unsolved = true;
    if (front.parent == kNone) new_roots_.push_back(dirty_[done]);
    ++work.factorized_fronts;
    work.factorized_scalars += front.columns;
    work.flops += front.flops();
  }
  dirty_.erase(dirty_.begin(), dirty_.begin() + static_cast<std::ptrdiff_t>(done));
  return result;
}

/// Adds the parts of a term that belong to the columns of a pivot: its gradient in row `last`, and its blocks
/// in the rows of blocks that are not eliminated before it.
void IncrementalFactor::load_term(const Term& term, Index pivot, double* columns, std::uint32_t leading,
                                  std::uint32_t last) const {
  const double* from = values_.data() + term.values;
  const std::uint32_t dim = blocks_[pivot].dim;
  const std::uint64_t sequence = blocks_[pivot].sequence;
  for (const Index b : term.blocks) {
    if (b == pivot) {
      for (std::uint32_t c = 0; c < dim; ++c) columns[std::size_t{c} * leading + last] -= from[c];
    }
    from += blocks_[b].dim;
  }
  // Row i of the blocks has those with the blocks 0 … i. `before` is the sum of the sizes of the blocks
  // before i, and `at` is that of the blocks before the pivot.
  std::uint32_t before = 0, at = 0;
  bool is_after = false;
  for (const Index b : term.blocks) {
    const Block& block = blocks_[b];
    if (b == pivot) {
      is_after = true;
      at = before;
      const double* part = from;
      for (const Index other : term.blocks) {
        const Block& column = blocks_[other];
        if (column.sequence > sequence)
          add_transposed(part, dim, column.dim, columns + local_[other], leading);
        if (other == pivot) {
          add_columns(part, dim, dim, columns + local_[pivot], leading);
          break;
        }
        part += std::size_t{dim} * column.dim;
      }
    } else if (is_after && block.sequence > sequence) {
      add_columns(from + std::size_t{block.dim} * at, block.dim, dim, columns + local_[b], leading);
    }
    before += block.dim;
    from += std::size_t{block.dim} * before;
  }
}

/// Adds the terms to the panel of a front, and sets the limits of its pivots.
void IncrementalFactor::load(Front& front) {
  std::fill_n(front.values, front.panel_size(), 0.0);
  std::uint32_t row = 0;
  for (const Index b : front.blocks) {
    local_[b] = row;
    row += dim(b);
  }
  minimum_pivot_.resize(std::max<std::size_t>(minimum_pivot_.size(), front.columns));
  const std::uint32_t last = front.columns + front.below - 1;
  for (const Index b : front.pivot_blocks()) {
    const Block& block = blocks_[b];
    double* const columns = front.values + std::size_t{local_[b]} * front.leading;
    for (const Index t : block.terms) load_term(terms_[t], b, columns, front.leading, last);
    double* diagonal = columns + local_[b];
    for (const int held : block.held) diagonal[static_cast<std::size_t>(held) * (front.leading + 1)] += 1;
    for (std::uint32_t c = 0; c < block.dim; ++c, diagonal += front.leading + 1)
      minimum_pivot_[local_[b] + c] = kLostPivot * *diagonal;
  }
}

IncrementalFactor::Result IncrementalFactor::factorize_front(Front& front, const StopToken& stop) {
  if (stop.raised()) return {LinearStatus::kStopped, kNone};
  sort_blocks(front);
  if (front.is_moved) {
    for (const Index c : front.children) sort_separator(fronts_[c]);
  }
  load(front);
  if (front.is_moved) {
    for (const Index c : front.children) find_runs(fronts_[c], front);
    front.is_moved = false;
  }
  const LoadedFront<double> loaded{front.values,
                                   front.update(),
                                   minimum_pivot_.data(),
                                   static_cast<int>(front.columns),
                                   static_cast<int>(front.below),
                                   static_cast<int>(front.leading)};
  const int good = eliminate_front(loaded, 1, stop, [&](const auto& add) {
    for (const Index c : front.children) {
      const Front& child = fronts_[c];
      add(ChildUpdate<double>{child.update(), static_cast<int>(child.below), child.runs, child.pivot_runs});
    }
  });
  if (good == kPanelStopped) return {LinearStatus::kStopped, kNone};
  if (good == loaded.columns) {
    constexpr double kSuspicious = 1e-10 / kLostPivot;
    bool is_suspicious = false;
    for (std::size_t c = 0; c < front.columns; ++c) {
      const double root = front.values[c * (front.leading + 1)];
      is_suspicious = is_suspicious || root * root < kSuspicious * minimum_pivot_[c];
    }
    return {LinearStatus::kOk, kNone, is_suspicious};
  }
  const auto lost = static_cast<std::uint32_t>(good);
  const auto pivots = front.pivot_blocks();
  return {LinearStatus::kNotPositiveDefinite,
          *std::find_if(pivots.rbegin(), pivots.rend(), [&](Index b) { return local_[b] <= lost; })};
}

double IncrementalFactor::expect_change(Index block, double limit) {
  stack_.clear();  // the fronts that are not counted yet
  double flops = 0;
  for (const Index t : blocks_[block].terms) {
    for (const Index b : terms_[t].blocks) {
      for (Index f = blocks_[b].front; f != kNone && fronts_[f].prediction != prediction_;
           f = fronts_[f].parent) {
        fronts_[f].prediction = prediction_;
        flops += fronts_[f].flops();
        stack_.push_back(f);
      }
    }
  }
  if (flops > limit) {
    for (const Index f : stack_) fronts_[f].prediction = 0;
  }
  return flops;
}

// ---- The solution ----

void IncrementalFactor::reset_x(Index b) {
  const Block& block = blocks_[b];
  std::fill_n(x_.begin() + block.x, block.dim, 0.0);
  std::fill_n(published_.begin() + block.x, block.dim, 0.0);
}

/// Computes x of the pivots. Notes which blocks have changed noticeably.
void IncrementalFactor::solve_front(const Front& front, std::vector<Index>& solved) {
  const std::uint32_t rows = front.columns + front.below - 1;
  work_.resize(std::max<std::size_t>(work_.size(), rows));
  for (std::uint32_t c = 0; c < front.columns; ++c)
    work_[c] = front.values[std::size_t{c} * front.leading + rows];
  double* next = work_.data() + front.columns;
  for (std::size_t k = front.pivots; k < front.places.size(); ++k) {
    const Place& place = front.places[k];
    const double* const from = x_.data() + place.x;
    for (std::uint32_t i = 0; i < place.dim; ++i) *next++ = from[i];
  }
  dense::solve_backward(front.values, static_cast<int>(rows), static_cast<int>(front.columns),
                        static_cast<int>(front.leading), work_.data());
  const double* value = work_.data();
  for (Index k = 0; k < front.pivots; ++k) {
    const auto [x, size] = front.places[k];
    bool is_noticed = false;
    for (std::uint32_t i = x; i < x + size; ++i) {
      x_[i] = *value++;
      is_noticed = is_noticed || std::abs(x_[i] - published_[i]) > noticeable_[i];
    }
    solved.push_back(front.blocks[k]);
    if (!is_noticed) continue;
    std::copy_n(x_.begin() + x, size, published_.begin() + x);
    noticed_pass_[front.blocks[k]] = pass_;
  }
}

void IncrementalFactor::solve_all(std::vector<Index>& solved) {
  for (Index f = 0; f < fronts_.size(); ++f) {
    if (fronts_[f].columns == 0) continue;
    fronts_[f].is_unsolved = true;
    if (fronts_[f].parent == kNone) new_roots_.push_back(f);
  }
  solve(solved);
}

void IncrementalFactor::solve(std::vector<Index>& solved) {
  ++pass_;
  stack_.clear();
  for (const Index root : new_roots_) {
    if (fronts_[root].parent == kNone && fronts_[root].is_unsolved) stack_.push_back(root);
  }
  new_roots_.clear();
  while (!stack_.empty()) {
    Front& front = fronts_[stack_.back()];
    stack_.pop_back();
    solve_front(front, solved);
    front.is_unsolved = false;
    for (const Index c : front.children) {
      const auto separator = fronts_[c].separator();
      const bool is_affected =
          fronts_[c].is_unsolved ||
          std::any_of(separator.begin(), separator.end(), [&](Index b) { return noticed_pass_[b] == pass_; });
      if (is_affected) stack_.push_back(c);
    }
  }
}

}  // namespace boxplus
