// SPDX-License-Identifier: BSD-3-Clause
// The handles that an edge takes for its vertices: VertexHandle<T>, or a range of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>
#include <type_traits>
#include <vector>

#include "boxplus/graph/edge_pool.h"
#include "boxplus/graph/handle.h"
#include "boxplus/graph/typed_edge_pool.h"

namespace boxplus::detail {

template <class H>
inline constexpr bool kIsVertexHandle = false;
template <class T>
inline constexpr bool kIsVertexHandle<VertexHandle<T>> = true;

template <class H>
struct VertexTypeOf;
template <class T>
struct VertexTypeOf<VertexHandle<T>> {
  using Type = StoredEstimate<T>;
};
template <std::ranges::range R>
requires kIsVertexHandle<std::ranges::range_value_t<R>>
struct VertexTypeOf<R> {
  using Type = Tail<typename std::ranges::range_value_t<R>::Estimate>;
};
/// T for VertexHandle<T>, Tail<T> for a range of such handles.
template <class H>
using VertexType = typename VertexTypeOf<std::remove_cvref_t<H>>::Type;

/// A list of at most N items, without allocation.
template <class T, std::size_t N>
class ShortList {
 public:
  void push_back(const T& item) { items_[size_++] = item; }
  const T* begin() const { return items_.data(); }
  const T* end() const { return items_.data() + size_; }
  operator std::span<const T>() const { return {items_.data(), size_}; }  // NOLINT: as a vector does

 private:
  std::array<T, N> items_{};
  std::size_t size_ = 0;
};
/// A list with one T per vertex, for an edge whose vertices have the types V…
template <class T, class... V>
using ListFor = std::conditional_t<(kIsTail<V> || ...), std::vector<T>, ShortList<T, sizeof...(V)>>;

template <class H>
concept Attachable = requires {
  typename VertexTypeOf<std::remove_cvref_t<H>>::Type;
};

/// Appends the number of vertices in a range of handles, and nothing for a single handle.
template <class List, class H>
void append_tail_size(List& out, const H& vertices) {
  if constexpr (std::ranges::range<H>)
    out.push_back(static_cast<std::uint32_t>(std::ranges::distance(vertices)));
}

}  // namespace boxplus::detail
