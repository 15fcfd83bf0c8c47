// SPDX-License-Identifier: BSD-3-Clause
// The vertices of one C++ type, by value.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "boxplus/graph/manifold_frames.h"
#include "boxplus/graph/type_name.h"
#include "boxplus/graph/vertex_pool.h"
#include "boxplus/manifold/manifold.h"

namespace boxplus {

template <ManifoldType T>
class TypedVertexPool final : public VertexPool {
 public:
  /// Where it throws, nothing has changed.
  std::uint32_t add(T estimate, Id id) {
    if (next_slot() < values_.size()) {
      values_[next_slot()] = std::move(estimate);
      return acquire_slot(id);
    }
    values_.push_back(std::move(estimate));
    try {
      return acquire_slot(id);
    } catch (...) {
      values_.pop_back();
      throw;
    }
  }

  const T& value(std::uint32_t slot) const { return values_[slot]; }
  T& value(std::uint32_t slot) { return values_[slot]; }

  std::unique_ptr<VertexPool> clone() const override {
    auto copy = std::make_unique<TypedVertexPool>();
    static_cast<VertexPool&>(*copy) = *this;
    copy->values_ = values_;
    copy->backups_.resize(backups_.size());
    for (std::size_t level = kFirstStackLevel; level < backups_.size(); ++level) {
      copy->backups_[level] = backups_[level];
    }
    return copy;
  }
  std::string_view type_name() const override { return boxplus::type_name<T>(); }
  int tangent_dim(std::uint32_t slot) const override { return boxplus::tangent_dim(values_[slot]); }

  void oplus(std::span<const std::uint32_t> slots, std::span<const std::uint32_t> offsets,
             const double* delta) override {
    for (std::size_t k = 0; k < slots.size(); ++k) {
      T& x = values_[slots[k]];
      x = Manifold<T>::oplus(x, delta + offsets[k]);
    }
  }

  void ominus(std::span<const std::uint32_t> slots, std::span<const std::uint32_t> offsets, int level,
              double* delta) const override {
    const std::vector<T>& saved = backups_[static_cast<std::size_t>(level)];
    for (std::size_t k = 0; k < slots.size(); ++k) {
      Manifold<T>::ominus(values_[slots[k]], saved[slots[k]], delta + offsets[k]);
    }
  }

  void save(std::span<const std::uint32_t> slots, int level) override {
    const auto index = static_cast<std::size_t>(level);
    if (backups_.size() <= index) backups_.resize(index + 1);
    std::vector<T>& backup = backups_[index];
    if (backup.size() < values_.size()) {
      backup.insert(backup.end(), values_.begin() + static_cast<std::ptrdiff_t>(backup.size()),
                    values_.end());
    }
    for (std::uint32_t slot : slots) backup[slot] = values_[slot];
  }

  void restore(std::span<const std::uint32_t> slots, int level) override {
    const std::vector<T>& backup = backups_[static_cast<std::size_t>(level)];
    for (std::uint32_t slot : slots) values_[slot] = backup[slot];
  }

  void copy_backup(std::span<const std::uint32_t> slots, int from, int to) override {
    const std::vector<T>& source = backups_[static_cast<std::size_t>(from)];
    std::vector<T>& target = backups_[static_cast<std::size_t>(to)];
    for (std::uint32_t slot : slots) target[slot] = source[slot];
  }

  bool get_frame(std::uint32_t slot, Frame& out) const override {
    if constexpr (FrameType<T>) {
      out = FrameTrait<T>::get(values_[slot]);
      return true;
    } else {
      return VertexPool::get_frame(slot, out);
    }
  }

  void set_frame(std::uint32_t slot, const Frame& frame) override {
    if constexpr (FrameType<T>) {
      FrameTrait<T>::set(values_[slot], frame);
    } else {
      VertexPool::set_frame(slot, frame);
    }
  }

  void tangent_to_frame(std::uint32_t slot, const Frame& frame, double* delta) const override {
    T there = values_[slot];
    if constexpr (FrameType<T>) FrameTrait<T>::set(there, frame);
    Manifold<T>::ominus(there, values_[slot], delta);
  }

 private:
  std::vector<T> values_;
  std::vector<std::vector<T>> backups_;
};

}  // namespace boxplus
