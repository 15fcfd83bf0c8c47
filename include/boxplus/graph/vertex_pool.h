// SPDX-License-Identifier: BSD-3-Clause
// The pool that stores all vertices of one type.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "boxplus/base/abi.h"
#include "boxplus/graph/frame.h"
#include "boxplus/graph/handle.h"

namespace boxplus {
class Graph;
}

namespace boxplus::detail {

/// A copy of the estimates of some vertices of one pool.
class SavedEstimates {
 public:
  virtual ~SavedEstimates() = default;
  virtual std::unique_ptr<SavedEstimates> clone() const = 0;
};

/// Limits of one entry of an estimate, lower ≤ entry ≤ upper (Graph::set_bounds()). The entry is numbered as
/// in the tangent.
struct Bound {
  int entry = 0;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool operator==(const Bound&) const = default;
};

/// A list per slot. Takes no memory while all lists are empty.
template <class T>
class SlotLists {
 public:
  std::span<const T> operator[](std::uint32_t slot) const {
    if (slot >= lists_.size()) return {};
    return lists_[slot];
  }
  bool empty() const { return lists_.empty(); }
  void set(std::uint32_t slot, std::vector<T> list) {
    if (slot >= lists_.size()) {
      if (list.empty()) return;
      lists_.resize(slot + std::size_t{1});
    }
    lists_[slot] = std::move(list);
    while (!lists_.empty() && lists_.back().empty()) lists_.pop_back();
  }

 private:
  std::vector<std::vector<T>> lists_;  // may be shorter than the pool; the last one is not empty
};

/// The type-erased interface of the vertices of one type. Functions that change or copy estimates take a list
/// of vertices, so that an iteration makes one virtual call per pool, not one per vertex.
///
/// Slots are stable. A removed vertex leaves a free slot, which a new vertex may reuse with a new generation.
class VertexPool {
 public:
  virtual ~VertexPool() = default;

  /// An entry that restore() skips in its list of slots.
  static constexpr std::uint32_t kNoSlot = 0xFFFFFFFFu;

  /// A copy with the same slots and generations.
  virtual std::unique_ptr<VertexPool> clone() const = 0;
  virtual std::string_view type_name() const = 0;
  /// The tangent size of the vertex in `slot`.
  virtual int tangent_dim(std::uint32_t slot) const = 0;
  /// x ← y ⊞ δ for every listed slot, where y is the estimate in the same slot of `from`, a pool of the same
  /// type. The δ of slots[k] begins at delta[offsets[k]].
  virtual void set_to_sum(std::span<const std::uint32_t> slots, const VertexPool& from,
                          std::span<const std::uint32_t> offsets, const double* delta) = 0;
  /// x ← x ⊞ δ.
  void oplus(std::span<const std::uint32_t> slots, std::span<const std::uint32_t> offsets,
             const double* delta) {
    set_to_sum(slots, *this, offsets, delta);
  }
  /// (x ⊞ δ) ⊟ y, where x is the estimate in `slot`, and y is the k-th estimate of `from`. A null δ is zero.
  virtual void difference(std::uint32_t slot, const double* delta, const SavedEstimates& from, std::size_t k,
                          double* out) const = 0;
  /// An empty pool of the same type. It can keep other estimates of the same vertices, in the same slots.
  virtual std::unique_ptr<VertexPool> make_store() const = 0;
  /// Copies (swaps) the listed estimates from (with) the same slots of a pool of the same type.
  virtual void copy_estimates(std::span<const std::uint32_t> slots, const VertexPool& from) = 0;
  virtual void swap_estimates(std::span<const std::uint32_t> slots, VertexPool& with) = 0;
  /// Copies the listed estimates to `saved`, and creates it if it is null. Allocates nothing if `saved`
  /// already holds as many estimates of the same sizes.
  virtual void save(std::span<const std::uint32_t> slots, std::unique_ptr<SavedEstimates>& saved) const = 0;
  /// Copies the k-th estimate of `saved` to slots[k]. The list that was passed to save() must have had the
  /// same length.
  virtual void restore(std::span<const std::uint32_t> slots, const SavedEstimates& saved) = 0;
  /// The frame of the pose or point in `slot`. Returns false if the type is neither a pose nor a point.
  virtual bool get_frame(std::uint32_t /*slot*/, Frame& /*out*/) const { return false; }
  virtual void set_frame(std::uint32_t /*slot*/, const Frame& /*frame*/) {}
  /// Computes the δ for which (estimate ⊞ δ) has the given frame, and its other parts are unchanged. δ is
  /// zero if the type is neither a pose nor a point.
  virtual void tangent_to_frame(std::uint32_t slot, const Frame& frame, double* delta) const = 0;
  /// The number in the estimate to which ⊞ adds the i-th entry of δ, or nullptr if there is none.
  virtual double* entry(std::uint32_t slot, int i) = 0;
  /// Says why the estimate in `slot` cannot be right, wherever the other vertices are. Empty if it can.
  virtual std::string implausible(std::uint32_t slot) const = 0;

  std::uint32_t slots() const { return static_cast<std::uint32_t>(ids_.size()); }
  std::uint32_t alive_count() const { return slots() - static_cast<std::uint32_t>(free_.size()); }
  bool alive(std::uint32_t slot) const { return (flags_[slot] & kAlive) != 0; }
  bool fixed(std::uint32_t slot) const { return (flags_[slot] & kFixed) != 0; }
  bool eliminated(std::uint32_t slot) const { return (flags_[slot] & kEliminated) != 0; }
  bool parameter(std::uint32_t slot) const { return (flags_[slot] & kParameter) != 0; }
  /// The fixed directions of the vertex in its tangent space (Graph::fix_directions()), ascending.
  std::span<const int> fixed_directions(std::uint32_t slot) const { return fixed_directions_[slot]; }
  bool has_fixed_directions() const { return !fixed_directions_.empty(); }
  /// The bounds of the vertex, ascending by entry.
  std::span<const Bound> bounds(std::uint32_t slot) const { return bounds_[slot]; }
  bool has_bounds() const { return !bounds_.empty(); }
  Id id(std::uint32_t slot) const { return ids_[slot]; }
  std::uint32_t generation(std::uint32_t slot) const { return generations_[slot]; }

 protected:
  /// The slot that acquire_slot() will return: the slot of a removed vertex, or slots().
  std::uint32_t next_slot() const { return free_.empty() ? slots() : free_.back(); }
  /// Returns the slot for a new vertex: a free slot if there is one. Otherwise, returns a new slot at the
  /// end, and the derived class must also append an element. If the function throws, nothing has changed.
  std::uint32_t acquire_slot(Id id);

 private:
  friend class boxplus::Graph;
  friend class PoolTable;
  enum Flag : std::uint8_t { kAlive = 1, kFixed = 2, kEliminated = 4, kParameter = 8 };

  void release_slot(std::uint32_t slot);
  void set_flag(std::uint32_t slot, Flag flag, bool on);

  std::vector<Id> ids_;
  std::vector<std::uint32_t> generations_;
  std::vector<std::uint8_t> flags_;
  SlotLists<int> fixed_directions_;
  SlotLists<Bound> bounds_;
  std::vector<std::uint32_t> free_;
  std::uint32_t next_generation_ = 0;  // of the next vertex, in any slot
};

}  // namespace boxplus::detail
