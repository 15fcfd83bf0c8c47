// SPDX-License-Identifier: BSD-3-Clause
// The pool that stores all vertices of one type.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
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
  /// x ← x ⊞ δ for every listed slot; the δ of slots[k] begins at delta[offsets[k]].
  virtual void oplus(std::span<const std::uint32_t> slots, std::span<const std::uint32_t> offsets,
                     const double* delta) = 0;
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

  std::uint32_t slots() const { return static_cast<std::uint32_t>(ids_.size()); }
  std::uint32_t alive_count() const { return slots() - static_cast<std::uint32_t>(free_.size()); }
  bool alive(std::uint32_t slot) const { return (flags_[slot] & kAlive) != 0; }
  bool fixed(std::uint32_t slot) const { return (flags_[slot] & kFixed) != 0; }
  bool eliminated(std::uint32_t slot) const { return (flags_[slot] & kEliminated) != 0; }
  bool parameter(std::uint32_t slot) const { return (flags_[slot] & kParameter) != 0; }
  /// The fixed directions of the vertex in its tangent space (Graph::fix_directions()), ascending.
  std::span<const int> fixed_directions(std::uint32_t slot) const {
    if (slot >= fixed_directions_.size()) return {};
    return fixed_directions_[slot];
  }
  bool has_fixed_directions() const { return !fixed_directions_.empty(); }
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
  void set_fixed_directions(std::uint32_t slot, std::vector<int> directions);

  std::vector<Id> ids_;
  std::vector<std::uint32_t> generations_;
  std::vector<std::uint8_t> flags_;
  std::vector<std::vector<int>> fixed_directions_;  // empty if no vertex has any; may be shorter than ids_
  std::vector<std::uint32_t> free_;
  std::uint32_t next_generation_ = 0;  // generation of the next vertex, in any slot
};

}  // namespace boxplus::detail
