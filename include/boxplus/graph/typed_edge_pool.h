// SPDX-License-Identifier: BSD-3-Clause
// A pool of edges with one error function type and one list of vertex types, stored by value.
#pragma once

#include <array>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "boxplus/base/thread_scratch.h"
#include "boxplus/graph/differentiate.h"
#include "boxplus/graph/edge_pool.h"
#include "boxplus/graph/make_room.h"
#include "boxplus/graph/type_name.h"
#include "boxplus/graph/typed_vertex_pool.h"

namespace boxplus::detail {

/// Specialized for the edge types that have a kernel in the library that linearizes several edges at a time
/// (types/between.h). Then kExists is true, and kSources is the number of arrays that the kernel reads for
/// each edge. sources(edge, estimates…) returns the addresses of these arrays. linearize(count, sources,
/// error, jacobian) gets such addresses for each array and then each edge; `jacobian` may be null.
template <class E, class... V>
struct LaneKernel {
  static constexpr bool kExists = false;
};

/// For each array, its address for each edge of a tile.
template <int kSources>
using LaneSources = std::array<std::array<const double*, EdgeTile::kCapacity>, kSources>;

template <class E, class... V>
requires EdgeType<E, V...>
class TypedEdgePool final : public EdgePool {
  using Result = detail::Result<E, V...>;
  static constexpr int kArguments = sizeof...(V);
  static constexpr int kRows = detail::kRows<Result>;
  static constexpr int kCols = detail::kCols<V...>;
  static constexpr int kTails = (0 + ... + static_cast<int>(kIsTail<V>));
  using Indices = std::make_index_sequence<sizeof...(V)>;

 public:
  /// Whether the sizes of the error or of a vertex are chosen at run time. Then an error function may reject
  /// its vertices, and count_rows() finds out.
  static constexpr bool kHasRunTimeSizes =
      kRows == kDynamic || ((Manifold<detail::ElementOf<V>>::kDim == kDynamic) || ...);

  using VertexPools = std::tuple<const TypedVertexPool<detail::ElementOf<V>>*...>;

  TypedEdgePool(std::vector<std::uint32_t> vertex_pools, VertexPools pools)
      : EdgePool(std::move(vertex_pools), kTails), pools_(pools) {}

  /// The number of rows of the error at the current estimates. `tail_sizes`: the number of vertices in each
  /// tail. Calls the error function only if the edge has run-time sizes.
  int count_rows(const E& edge, std::span<const std::uint32_t> vertex_slots,
                 std::span<const std::uint32_t> tail_sizes) const {
    if constexpr (!kHasRunTimeSizes) {
      return kRows;
    } else {
      return with_slots(vertex_slots, tail_sizes,
                        [&](auto... x) { return detail::row_count(detail::evaluate(edge, x.get()...)); });
    }
  }

  /// `rows` is the result of count_rows(). If the function throws, nothing has changed.
  std::uint32_t add(E edge, const Information& information, int rows,
                    std::span<const std::uint32_t> vertex_slots, std::span<const std::uint32_t> tail_sizes) {
    std::uint32_t slot = next_slot(vertex_slots.size());
    if (slot < edges_.size()) {
      replace(slot, std::move(edge));
      slot = acquire_slot(vertex_slots, tail_sizes, information, rows);
      if constexpr (kRows == kDynamic) rows_[slot] = rows;
      return slot;
    }
    if constexpr (kRows == kDynamic) make_room(rows_);
    edges_.push_back(std::move(edge));
    try {
      slot = acquire_slot(vertex_slots, tail_sizes, information, rows);
    } catch (...) {
      edges_.pop_back();
      throw;
    }
    if constexpr (kRows == kDynamic) rows_.push_back(rows);
    return slot;
  }

  /// Replaces the error function of an edge. Throws InvalidArgument if its number of rows is another one.
  void exchange(std::uint32_t slot, E edge) {
    const int actual = count_rows(edge, vertex_slots(slot), tail_sizes(slot));
    if (actual != rows(slot)) throw_row_count(rows(slot), actual);
    replace(slot, std::move(edge));
  }

  /// Puts another error function into a slot. If E cannot be assigned (a lambda with captures), the old
  /// object is destroyed, and a new object is constructed.
  void replace(std::uint32_t slot, E edge) {
    if constexpr (std::is_move_assignable_v<E>) {
      edges_[slot] = std::move(edge);
    } else if constexpr (std::is_nothrow_move_constructible_v<E>) {
      std::destroy_at(&edges_[slot]);
      std::construct_at(&edges_[slot], std::move(edge));
    } else {
      std::vector<E> edges;
      edges.reserve(edges_.capacity());
      for (std::uint32_t k = 0; k < edges_.size(); ++k) edges.push_back(k == slot ? edge : edges_[k]);
      edges_.swap(edges);
    }
  }

  void reserve(std::size_t edges) override {
    reserve_slots(edges);
    detail::reserve(edges_, edges);
    if constexpr (kRows == kDynamic) detail::reserve(rows_, edges);
  }

  std::unique_ptr<EdgePool> clone(std::span<const std::unique_ptr<VertexPool>> vertex_pools) const override {
    auto copy = std::make_unique<TypedEdgePool>(*this);
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      copy->pools_ = {static_cast<const TypedVertexPool<detail::ElementOf<V>>*>(
          vertex_pools[argument_pool(static_cast<int>(I))].get())...};
    }
    (Indices{});
    return copy;
  }

  const E& value(std::uint32_t edge) const { return edges_[edge]; }

  std::vector<double>* shift(std::uint32_t edge) override {
    if constexpr (requires { requires E::kIsConstraint; }) {
      return &edges_[edge].shift;
    } else {
      return EdgePool::shift(edge);
    }
  }

  std::string_view type_name() const override { return detail::type_name<E>(); }
  bool uniform_shape() const override { return kRows != kDynamic && kCols != kDynamic; }
  JacobianSource jacobian_source() const override { return detail::kJacobianSource<E, V...>; }

  EdgeShape shape(std::uint32_t edge) const override {
    if constexpr (kCols != kDynamic) {
      return {kArguments, rows(edge), kCols};
    } else {
      const int cols =
          with_arguments(edge, [](auto... x) { return (detail::argument_dim<V>(x.get()) + ...); });
      return {arity(edge), rows(edge), cols};
    }
  }

  void errors(std::span<const std::uint32_t> edges, double* out) const override {
    for_each_with_arguments(edges, [&](std::uint32_t edge, const auto&... x) {
      const int n = rows(edge);
      detail::copy_rows(detail::evaluate(edges_[edge], x...), n, out);
      out += n;
    });
  }

  void linearize(std::span<const std::uint32_t> edges, EdgeTile& tile, bool force_numeric) const override {
    if (edges.empty()) return;
    const EdgeShape first = shape(edges[0]);
    tile.count = static_cast<int>(edges.size());
    tile.rows = first.rows;
    tile.cols = first.cols;
    if constexpr (LaneKernel<E, V...>::kExists) {
      if (tile.in_lanes && !force_numeric) {
        return linearize_in_lanes(edges, tile.error, tile.jacobian);
      }
    }
    tile.in_lanes = false;
    if (force_numeric) return linearize_numerically(edges, tile);
    if constexpr (detail::kAnalytic<E, V...>) {
      linearize_analytically(edges, tile);
    } else if constexpr (detail::kDifferentiable<E, V...>) {
      linearize_automatically(edges, tile);
    } else {
      linearize_numerically(edges, tile);
    }
  }

  bool errors_in_lanes(std::span<const std::uint32_t> edges, double* out) const override {
    if constexpr (LaneKernel<E, V...>::kExists) linearize_in_lanes(edges, out, nullptr);
    return LaneKernel<E, V...>::kExists;
  }

  bool is_rigid() const override { return detail::kIsRigid<E>; }

  bool relative_frame(std::uint32_t edge, RelativeFrame& out) const override {
    return with_arguments(edge, [&](auto... x) {
      if constexpr (requires { edges_[edge].relative_frame(x.get()...); }) {
        out = edges_[edge].relative_frame(x.get()...);
        return true;
      } else {
        return false;
      }
    });
  }

 private:
  /// The I-th argument of the error function. A tail is copied into contiguous memory of the worker, which
  /// nested calls do not touch: an error function may evaluate other edges of its own type.
  template <class A, std::size_t I>
  struct Loaded {
    const A* value;
    const A& get() const { return *value; }
  };
  template <class T, std::size_t I>
  struct Loaded<Tail<T>, I> {
    Loaded(const TypedVertexPool<T>& pool, std::span<const std::uint32_t> slots) {
      elements->clear();
      for (const std::uint32_t slot : slots) elements->push_back(pool.value(slot));
    }
    std::span<const T> get() const { return *elements; }

    BorrowedScratch<std::vector<T>, Loaded> elements;
  };

  /// The slots of the I-th argument, which is a tail.
  template <std::size_t I>
  static std::span<const std::uint32_t> slots_of_tail(std::span<const std::uint32_t> slots,
                                                      std::span<const std::uint32_t> tail_sizes) {
    std::size_t first = kArguments - kTails;
    if constexpr (kTails == 1) return slots.subspan(first);
    for (std::size_t t = 0; t < I - (kArguments - kTails); ++t) first += tail_sizes[t];
    return slots.subspan(first, tail_sizes[I - (kArguments - kTails)]);
  }

  template <class A, std::size_t I>
  Loaded<A, I> load(std::span<const std::uint32_t> slots, std::span<const std::uint32_t> tail_sizes) const {
    const auto& pool = *std::get<I>(pools_);
    if constexpr (kIsTail<A>) {
      return {pool, slots_of_tail<I>(slots, tail_sizes)};
    } else {
      return {&pool.value(slots[I])};
    }
  }

  template <class F>
  decltype(auto) with_slots(std::span<const std::uint32_t> slots, std::span<const std::uint32_t> tail_sizes,
                            F&& f) const {
    return [&]<std::size_t... I>(std::index_sequence<I...>)->decltype(auto) {
      return f(load<V, I>(slots, tail_sizes)...);
    }
    (Indices{});
  }

  template <class F>
  decltype(auto) with_arguments(std::uint32_t edge, F&& f) const {
    return with_slots(vertex_slots(edge), tail_sizes(edge), std::forward<F>(f));
  }

  /// Calls f(edge, its arguments…) for each edge. Consecutive edges with the same vertex get one copy of its
  /// estimate. The copy can stay in registers, because nothing that f writes can change it.
  template <class F>
  void for_each_with_arguments(std::span<const std::uint32_t> edges, F&& f) const {
    if constexpr (kArguments == 1 && kTails == 0 && (std::is_trivially_destructible_v<V> && ...)) {
      for (std::size_t k = 0; k < edges.size();) {
        const std::uint32_t slot = vertex_slots(edges[k])[0];
        const auto estimate = std::get<0>(pools_)->value(slot);
        do f(edges[k], estimate);
        while (++k < edges.size() && vertex_slots(edges[k])[0] == slot);
      }
    } else {
      for (const std::uint32_t edge : edges) with_arguments(edge, [&](auto... x) { f(edge, x.get()...); });
    }
  }

  /// This is a template, so that an explicit instantiation of the pool omits it for edges without a kernel.
  template <class Kernel = LaneKernel<E, V...>>
  requires(Kernel::kExists) void linearize_in_lanes(std::span<const std::uint32_t> edges, double* error,
                                                    double* jacobian) const {
    LaneSources<Kernel::kSources> sources;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const auto slots = vertex_slots(edges[k]);
      const auto of_edge = [&]<std::size_t... I>(std::index_sequence<I...>) {
        return Kernel::sources(edges_[edges[k]], std::get<I>(pools_)->value(slots[I])...);
      }
      (Indices{});
      for (std::size_t i = 0; i < of_edge.size(); ++i) sources[i][k] = of_edge[i];
    }
    Kernel::linearize(static_cast<int>(edges.size()), sources, error, jacobian);
  }

  int rows(std::uint32_t edge) const {
    if constexpr (kRows != kDynamic) {
      return kRows;
    } else {
      return rows_[edge];
    }
  }

  /// Calls f(edge, its error, its Jacobian) for each edge of a tile.
  template <class F>
  static void for_each_of_tile(std::span<const std::uint32_t> edges, const EdgeTile& tile, F&& f) {
    double* error = tile.error;
    double* jacobian = tile.jacobian;
    for (const std::uint32_t edge : edges) {
      f(edge, error, jacobian);
      error += tile.rows;
      jacobian += static_cast<std::ptrdiff_t>(tile.rows) * tile.cols;
    }
  }

  /// This is a template, so that an explicit instantiation of the pool omits it for edges without Jacobians.
  template <class Edge = E>
  requires(detail::kAnalytic<Edge, V...>) void linearize_analytically(std::span<const std::uint32_t> edges,
                                                                      const EdgeTile& tile) const {
    double* error = tile.error;
    double* jacobian = tile.jacobian;
    const int n = kRows != kDynamic ? kRows : tile.rows;
    for_each_with_arguments(edges, [&](std::uint32_t edge, const auto&... x) {
      detail::copy_rows(detail::evaluate(edges_[edge], x...), n, error);
      detail::analytic_jacobian<V...>(edges_[edge], jacobian, n, x...);
      error += n;
      jacobian += static_cast<std::ptrdiff_t>(n) * tile.cols;
    });
  }

  /// Differentiates all edges of the tile for one window of columns, then for the next window. So an estimate
  /// that consecutive edges share is lifted only once per window.
  template <class Edge = E>
  requires(detail::kDifferentiable<Edge, V...>) void linearize_automatically(
      std::span<const std::uint32_t> edges, const EdgeTile& tile) const {
    detail::AutomaticJacobian<V...> differentiate;
    int first = 0;
    do {
      for_each_of_tile(edges, tile, [&](std::uint32_t edge, double* error, double* jacobian) {
        const auto slots = vertex_slots(edge);
        with_arguments(edge, [&](auto... x) {
          differentiate.columns(edges_[edge], error, jacobian, tile.rows, tile.cols, first, slots,
                                x.get()...);
        });
      });
      first += differentiate.kWindow;
    } while (first < tile.cols);
  }

  void linearize_numerically(std::span<const std::uint32_t> edges, const EdgeTile& tile) const {
    for_each_of_tile(edges, tile, [&](std::uint32_t edge, double* error, double* jacobian) {
      with_arguments(edge, [&](auto... x) {
        detail::numeric_jacobian<V...>(edges_[edge], error, jacobian, tile.rows, tile.cols, x.get()...);
      });
    });
  }

  VertexPools pools_;
  std::vector<E> edges_;
  std::vector<int> rows_;  // used only if the size of the error is chosen at run time
};

}  // namespace boxplus::detail
