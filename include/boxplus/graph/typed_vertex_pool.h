// SPDX-License-Identifier: BSD-3-Clause
// A pool of vertices of one C++ type, stored by value.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "boxplus/graph/implausible.h"
#include "boxplus/graph/manifold_frames.h"
#include "boxplus/graph/type_name.h"
#include "boxplus/graph/vertex_pool.h"
#include "boxplus/manifold/manifold.h"

namespace boxplus::detail {

template <ManifoldType T>
class TypedVertexPool final : public VertexPool {
 public:
  /// Returns the slot of the new vertex. If the function throws, nothing has changed.
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
    return copy;
  }
  std::string_view type_name() const override { return boxplus::detail::type_name<T>(); }
  int tangent_dim(std::uint32_t slot) const override { return boxplus::detail::tangent_dim(values_[slot]); }

  void set_to_sum(std::span<const std::uint32_t> slots, const VertexPool& from,
                  std::span<const std::uint32_t> offsets, const double* delta) override {
    const std::vector<T>& base = static_cast<const TypedVertexPool&>(from).values_;
    for (std::size_t k = 0; k < slots.size(); ++k)
      values_[slots[k]] = Manifold<T>::oplus(base[slots[k]], delta + offsets[k]);
  }

  void difference(std::uint32_t slot, const double* delta, const SavedEstimates& from, std::size_t k,
                  double* out) const override {
    const T& base = static_cast<const Saved&>(from).values[k];
    if (delta == nullptr) return Manifold<T>::ominus(values_[slot], base, out);
    Manifold<T>::ominus(Manifold<T>::oplus(values_[slot], delta), base, out);
  }

  std::unique_ptr<VertexPool> make_store() const override { return std::make_unique<TypedVertexPool>(); }
  void copy_estimates(std::span<const std::uint32_t> slots, const VertexPool& from) override {
    for (const std::uint32_t slot : slots) {
      const T& value = static_cast<const TypedVertexPool&>(from).values_[slot];
      if (slot >= values_.size()) values_.resize(slot + std::size_t{1}, value);
      values_[slot] = value;
    }
  }
  void swap_estimates(std::span<const std::uint32_t> slots, VertexPool& with) override {
    for (const std::uint32_t slot : slots)
      std::swap(values_[slot], static_cast<TypedVertexPool&>(with).values_[slot]);
  }

  void save(std::span<const std::uint32_t> slots, std::unique_ptr<SavedEstimates>& saved) const override {
    if (!saved) saved = std::make_unique<Saved>();
    std::vector<T>& values = static_cast<Saved&>(*saved).values;
    if (values.size() > slots.size()) values.erase(values.begin() + std::ssize(slots), values.end());
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = values_[slots[k]];
    values.reserve(slots.size());
    for (const std::uint32_t slot : slots.subspan(values.size())) values.push_back(values_[slot]);
  }

  void restore(std::span<const std::uint32_t> slots, const SavedEstimates& saved) override {
    const std::vector<T>& values = static_cast<const Saved&>(saved).values;
    for (std::size_t k = 0; k < slots.size(); ++k) {
      if (slots[k] != kNoSlot) values_[slots[k]] = values[k];
    }
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

  double* entry(std::uint32_t slot, int i) override { return boxplus::detail::entry(values_[slot], i); }

  std::string implausible(std::uint32_t slot) const override { return why_implausible(values_[slot]); }

 private:
  struct Saved final : SavedEstimates {
    std::vector<T> values;
    std::unique_ptr<SavedEstimates> clone() const override { return std::make_unique<Saved>(*this); }
  };

  std::vector<T> values_;
};

}  // namespace boxplus::detail
