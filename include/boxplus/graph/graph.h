// SPDX-License-Identifier: BSD-3-Clause
// The problem: vertices (estimates on manifolds) and edges (measurements), owned by value.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/base/function_ref.h"
#include "boxplus/graph/attachable.h"
#include "boxplus/graph/change_log.h"
#include "boxplus/graph/check_types.h"
#include "boxplus/graph/id_map.h"
#include "boxplus/graph/lifetime.h"
#include "boxplus/graph/pool_table.h"
#include "boxplus/graph/saved_state.h"

namespace boxplus {

/// A hyper-graph: vertices of any manifold type, and edges that connect any number of vertices.
///
/// A handle stays valid until its element is removed. All methods throw InvalidArgument for a stale handle
/// and for a handle of another graph. Methods that take a handle are O(1) unless they say otherwise. Only one
/// thread may use a Graph at a time.
///
/// Eigen's column vectors of doubles are kept as Vector<double, N> (graph/stored_estimate.h). Every method
/// takes either type.
class Graph {
 public:
  Graph();
  ~Graph();
  /// A deep copy. A handle of `other` names the same element in the copy. A handle that either graph creates
  /// later is valid for that graph only. Estimates, error functions and the stack of push() are copied;
  /// robust kernels are shared. An Optimizer of `other` stays with `other`. O(vertices + edges).
  Graph(const Graph& other);
  Graph& operator=(const Graph& other);
  Graph(Graph&&) noexcept;
  Graph& operator=(Graph&&) noexcept;

  // ---- Vertices ----

  /// Adds a vertex. If no id is given, the vertex gets the next free id. Throws InvalidArgument if the id is
  /// taken or negative.
  template <class T>
  VertexHandle<detail::StoredEstimate<T>> add_vertex(T estimate, std::optional<Id> id = std::nullopt) {
    static_assert(detail::check_vertex_type<detail::StoredEstimate<T>>());
    const Id chosen = claim_id(vertex_ids_, next_id_, id, "vertex");
    return register_vertex<detail::StoredEstimate<T>>(std::move(estimate), chosen, vertex_ids_);
  }

  /// Adds a shared constant (a sensor offset, a camera): a vertex that is fixed at first, but does not remove
  /// gauge freedom. Parameters have their own ids. To calibrate the constant, unfix() it.
  template <class T>
  VertexHandle<detail::StoredEstimate<T>> add_parameter(T value, std::optional<Id> id = std::nullopt) {
    static_assert(detail::check_vertex_type<detail::StoredEstimate<T>>());
    const Id chosen = claim_id(parameter_ids_, next_parameter_id_, id, "parameter");
    const auto handle = register_vertex<detail::StoredEstimate<T>>(std::move(value), chosen, parameter_ids_);
    mark_parameter(handle);
    return handle;
  }

  /// The vertex (parameter) with that id. Throws InvalidArgument if there is none, or if it has another type.
  template <detail::ManifoldType T>
  VertexHandle<detail::StoredEstimate<T>> vertex(Id id) const {
    return typed<T>(lookup(vertex_ids_, id, "vertex"));
  }
  template <detail::ManifoldType T>
  VertexHandle<detail::StoredEstimate<T>> parameter(Id id) const {
    return typed<T>(lookup(parameter_ids_, id, "parameter"));
  }
  std::optional<VertexRef> find_vertex(Id id) const;
  std::optional<VertexRef> find_parameter(Id id) const;
  /// A typed handle of `vertex`. Throws InvalidArgument if the estimate is not a T.
  template <detail::ManifoldType T>
  VertexHandle<detail::StoredEstimate<T>> typed(VertexRef vertex) const {
    typed_pool<T>(vertex);
    return {vertex};
  }

  template <detail::ManifoldType T>
  const detail::StoredEstimate<T>& estimate(VertexHandle<T> vertex) const {
    return typed_pool<T>(vertex).value(vertex.slot);
  }
  /// Sets the estimate of a vertex. If a run-time-size estimate changes its size, the error functions of its
  /// edges must accept the new size and keep their number of rows. Otherwise, throws InvalidArgument that
  /// names the sizes, and nothing has changed. A change of the size takes as long as a call of edges(), and
  /// releases the bounds of the vertex.
  template <detail::ManifoldType T>
  void set_estimate(VertexHandle<T> vertex, std::type_identity_t<detail::StoredEstimate<T>> estimate) {
    detail::StoredEstimate<T>& value = typed_pool<T>(vertex).value(vertex.slot);
    note_change(vertex);
    const bool resized = boxplus::detail::tangent_dim(value) != boxplus::detail::tangent_dim(estimate);
    if (!resized) return void(value = std::move(estimate));
    std::swap(value, estimate);
    try {
      check_sizes_of_edges(vertex);
    } catch (...) {
      std::swap(value, estimate);
      throw;
    }
    pools_.vertices[vertex.pool]->bounds_.set(vertex.slot, {});
    note_new_structure();
  }

  Id id(VertexRef vertex) const;
  /// Throws InvalidArgument if the new id is taken or negative.
  void change_id(VertexRef vertex, Id new_id);
  bool contains(VertexRef vertex) const;
  int tangent_dim(VertexRef vertex) const;

  /// A fixed vertex keeps its estimate in every optimization.
  void fix(VertexRef vertex) { set_fixed(vertex, true); }
  void unfix(VertexRef vertex) { set_fixed(vertex, false); }
  void set_fixed(VertexRef vertex, bool fixed);
  bool is_fixed(VertexRef vertex) const;

  /// Fixes some directions of a vertex in its tangent space. They are numbered from 0. The vertex still moves
  /// in all other directions. For SE3, {2, 3, 4} keeps a vehicle in the plane: the tangent is (Δt, Δq) in the
  /// body frame. A second call replaces the directions of the first; an empty list releases all of them.
  ///
  /// In fixed directions, every optimization step and the covariance are exactly zero, with any edges,
  /// kernels, solvers and elimination. The ⊞ of the type determines which values of the estimate keep their
  /// bits. The entries of a vector or a Product keep their bits. The z of an SE3 keeps its bits only while
  /// the z-axis of the body is parallel to the z-axis of the world. Throws InvalidArgument if a direction is
  /// not in [0, tangent_dim).
  void fix_directions(VertexRef vertex, std::span<const int> directions);
  void fix_directions(VertexRef vertex, std::initializer_list<int> directions) {
    fix_directions(vertex, std::span(directions.begin(), directions.size()));
  }
  /// The fixed directions in ascending order. The span is valid until the next call of fix_directions() for
  /// any vertex.
  std::span<const int> fixed_directions(VertexRef vertex) const;

  /// Keeps an entry of an estimate, numbered as in the tangent, within limits: lower ≤ entry ≤ upper. It must
  /// be a number to which ⊞ adds: an entry of a number, a vector or a camera, also in a Product. ±∞ means no
  /// limit. optimize() first moves estimates that are outside to the nearest limit, and then finds a minimum
  /// within the limits. Report::active_bounds names the limits at which the result is, with their
  /// multipliers. Throws InvalidArgument if there is no such entry, if a limit is NaN, or if no finite number
  /// is within the limits.
  void set_bounds(VertexRef vertex, int entry, double lower, double upper);
  /// The bounds in ascending order of entries. The span is valid until the next call of set_bounds().
  std::span<const detail::Bound> bounds(VertexRef vertex) const;

  /// Marks a vertex to be eliminated first, by the Schur complement (such as a point in bundle adjustment).
  /// If an edge joins two eliminated vertices, optimize() throws InvalidArgument.
  void set_eliminated(VertexRef vertex, bool eliminated);
  bool is_eliminated(VertexRef vertex) const;

  /// Removes a vertex and every edge that uses it. O(edges), or O(edges of the vertex) after a call of
  /// edges().
  void remove(VertexRef vertex);

  // ---- Edges ----

  /// Adds an edge with the identity as information. The vertices are handles; the last arguments may be
  /// ranges of handles, each of one type. Throws InvalidArgument if a vertex appears twice or is stale. If
  /// the size of the error or of a vertex is chosen at run time, the error function is called once. If it
  /// throws InvalidArgument because a size does not fit, the message also names the vertices and their sizes.
  template <class E, class... H>
  requires(detail::Attachable<H>&&...) EdgeHandle<E> add_edge(E error, const H&... vertices) {
    return add_edge(std::move(error), Information(1.0), vertices...);
  }

  /// Adds an edge with information Ω (a number, an Eigen matrix, an Information). Throws InvalidArgument if Ω
  /// does not fit the size of the error, is not symmetric positive semi-definite, or is not finite.
  template <class E, class... H>
  requires(sizeof...(H) > 0 &&
           (detail::Attachable<H> && ...)) EdgeHandle<E> add_edge(E error, const Information& information,
                                                                  const H&... vertices) {
    static_assert(detail::kTailsAreLast<detail::VertexType<H>...>,
                  "only the last arguments may be ranges of handles");
    static_assert(detail::check_edge_type<E, detail::VertexType<H>...>());
    detail::ListFor<VertexRef, detail::VertexType<H>...> refs;
    (gather(refs, vertices), ...);
    check_distinct(refs);
    detail::ListFor<std::uint32_t, detail::VertexType<H>...> slots;
    for (const VertexRef& ref : refs) slots.push_back(ref.slot);
    const std::uint32_t index = pools_.require_edges<E, detail::VertexType<H>...>();
    auto& pool = static_cast<detail::TypedEdgePool<E, detail::VertexType<H>...>&>(*pools_.edges[index]);
    constexpr std::size_t kTails = (0 + ... + std::size_t{detail::kIsTail<detail::VertexType<H>>});
    detail::ShortList<std::uint32_t, std::max<std::size_t>(kTails, 1)> tail_sizes;
    (detail::append_tail_size(tail_sizes, vertices), ...);
    const int rows = count_rows(pool, error, refs, slots, tail_sizes);
    const std::uint32_t slot = pool.add(std::move(error), information, rows, slots, tail_sizes);
    note_new_structure();
    const EdgeHandle<E> handle{EdgeRef{index, slot, pool.generation(slot)}};
    note_change(handle);
    if (incidence_) index_edge(handle, refs);
    return handle;
  }

  /// Adds an empty pool for edges whose vertex types are known only at run time, as in bindings of other
  /// languages. measurement() and set_measurement() do not know its edges. Returns its index. Throws
  /// InvalidArgument if the graph lacks a vertex pool that the pool names.
  std::uint32_t add_edge_pool(std::unique_ptr<detail::EdgePool> pool);
  /// Adds an edge to a pool of add_edge_pool(). `add(slots of the vertices)` adds it to the pool, and returns
  /// its slot there. Throws InvalidArgument as the other add_edge(), and if the pool is for vertices of other
  /// types.
  EdgeRef add_edge(std::uint32_t pool, std::span<const VertexRef> vertices,
                   detail::FunctionRef<std::uint32_t(std::span<const std::uint32_t>)> add);

  /// Reserves memory for a total of `count` edges of the type of `like`. Saves time if you add many edges.
  /// Throws InvalidArgument if `count` is above 2³² − 1, the largest number of edges of one type.
  void reserve_edges(EdgeRef like, std::size_t count);

  /// The error function (measurement) of an edge.
  template <class E>
  const E& measurement(EdgeHandle<E> edge) const {
    return *static_cast<const E*>(edge_access<E>(edge).value(*pools_.edges[edge.pool], edge.slot));
  }
  /// Replaces the error function. Throws InvalidArgument if the number of rows changes, or if a size does not
  /// fit (as add_edge() does); then nothing has changed.
  template <class E>
  void set_measurement(EdgeHandle<E> edge, E error) {
    const detail::EdgeAccess& access = edge_access<E>(edge);
    note_change(edge);
    try {
      access.exchange(*pools_.edges[edge.pool], edge.slot, &error);
    } catch (const InvalidArgument& misfit) {
      throw_misfit(misfit, vertices(edge));
    }
  }

  bool contains(EdgeRef edge) const;
  std::vector<VertexRef> vertices(EdgeRef edge) const;
  /// The edges that use a vertex (or parameter), in the order of all_edges(). The first call builds an index
  /// of the edges of every vertex, in O(vertices + edges). The graph keeps this index up to date: each later
  /// call takes O(d log d) for d edges, and add_edge() takes a little longer.
  std::vector<EdgeRef> edges(VertexRef vertex) const;
  detail::InformationView information(EdgeRef edge) const;
  void set_information(EdgeRef edge, const Information& information);
  /// nullptr removes the kernel. Kernels may be shared between edges.
  void set_kernel(EdgeRef edge, std::shared_ptr<const RobustKernel> kernel);
  template <class K>
  requires std::derived_from<K, RobustKernel>
  void set_kernel(EdgeRef edge, const K& kernel) { set_kernel(edge, std::make_shared<const K>(kernel)); }
  const RobustKernel* kernel(EdgeRef edge) const;
  /// A disabled edge has zero weight, but stays in the structure of the problem. Therefore, GaugePolicy
  /// treats it like an enabled edge, as it does with an edge whose Ω is zero.
  void set_enabled(EdgeRef edge, bool enabled);
  bool is_enabled(EdgeRef edge) const;
  /// Options::level selects the edges that take part.
  void set_level(EdgeRef edge, int level);
  int level(EdgeRef edge) const;
  void remove(EdgeRef edge);

  /// eᵀΩe of one edge, without its kernel. error() returns e.
  double chi2(EdgeRef edge) const;
  std::vector<double> error(EdgeRef edge) const;
  /// The factor by which an optimizer multiplies Ω of one edge at the current estimates. It is ρ′(eᵀΩe) of
  /// the kernel, but at least 0. It is 1 if the edge has no kernel, and 0 if the edge is disabled. The
  /// weighted information of the edge is weight(edge) * information(edge).matrix().
  double weight(EdgeRef edge) const;
  /// The Jacobian of one edge's error at the current estimates, as one block per vertex, including fixed
  /// vertices. Block i belongs to vertices(edge)[i]: it is ∂ error(…, x_i ⊞ δ, …) / ∂δ at δ = 0, with rows ×
  /// tangent_dim(x_i) entries. Neither Ω nor the kernel is applied.
  std::vector<Eigen::MatrixXd> jacobian(EdgeRef edge) const;
  /// Σ ρ(eᵀΩe) over all enabled edges. O(edges).
  double chi2() const;

  // ---- State ----

  /// Pushes the estimates of all vertices and parameters, or of the given ones, on a stack. Calls may nest.
  void push();
  void push(std::span<const VertexRef> vertices);
  /// pop() restores the estimates that the matching push() saved; discard_top() drops them. pop() skips
  /// vertices that were removed in the meantime. Both throw InvalidArgument if nothing was pushed.
  void pop();
  void discard_top();
  int stack_size() const { return static_cast<int>(stack_.size()); }

  std::size_t vertex_count() const;  ///< without parameters
  std::size_t parameter_count() const { return parameter_ids_.size(); }
  std::size_t edge_count() const;
  /// All vertices except parameters, in the order of their ids. O(n log n).
  std::vector<VertexRef> all_vertices() const;
  std::vector<VertexRef> all_parameters() const;
  std::vector<EdgeRef> all_edges() const;
  void clear();

  // ---- For the engine ----

  std::span<const std::unique_ptr<detail::VertexPool>> vertex_pools() const { return pools_.vertices; }
  std::span<const std::unique_ptr<detail::EdgePool>> edge_pools() const { return pools_.edges; }
  /// A number that changes when the structure of the problem changes: elements, fixed and eliminated flags,
  /// fixed directions, levels, sizes. Estimates, weights, kernels and enabled flags are not part of the
  /// structure.
  std::uint64_t revision() const { return revision_; }

  /// The log to which the graph appends its changes from now on, or nullptr. The caller keeps it alive.
  void set_change_log(detail::ChangeLog* log) { log_ = log; }
  detail::ChangeLog* change_log() const { return log_; }
  /// Says that an algorithm has changed estimates.
  void note_moved() {
    if (log_) log_->everything = true;
  }

  /// Tells an observer whether this is still the same graph, and whether it is in use.
  const std::shared_ptr<detail::LifeState>& life() const { return lifetime_.state(); }

 private:
  /// The edges of each vertex.
  class Incidence;
  /// Takes everything from `other` except its lifetime.
  void take_elements(Graph& other) noexcept;

  void note_new_structure() { ++revision_; }
  void note_change(VertexRef vertex) {
    if (log_) log_->vertices.push_back(vertex);
  }
  void note_change(EdgeRef edge) {
    if (log_) log_->edges.push_back(edge);
  }
  static Id claim_id(const detail::IdMap& ids, Id& next, std::optional<Id> id, const char* what);
  VertexRef lookup(const detail::IdMap& ids, Id id, const char* what) const;
  [[noreturn]] void throw_wrong_type(VertexRef vertex, std::string_view expected) const;
  [[noreturn]] void throw_wrong_type(EdgeRef edge, std::string_view expected) const;
  void check(VertexRef vertex) const;
  void check(EdgeRef edge) const;
  static std::optional<VertexRef> find_repetition(std::span<const VertexRef> vertices);
  void check_distinct(std::span<const VertexRef> vertices) const;
  /// Throws an InvalidArgument with the message of `misfit`, the vertices of the edge and their sizes.
  [[noreturn]] void throw_misfit(const InvalidArgument& misfit, std::span<const VertexRef> vertices) const;
  /// The number of rows of a new edge.
  template <class Pool, class E>
  int count_rows(const Pool& pool, const E& error, std::span<const VertexRef> vertices,
                 std::span<const std::uint32_t> slots, std::span<const std::uint32_t> tail_sizes) const {
    try {
      return pool.count_rows(error, slots, tail_sizes);
    } catch (const InvalidArgument& misfit) {
      throw_misfit(misfit, vertices);
    }
  }
  /// Evaluates the edges of a vertex whose size has changed. Throws InvalidArgument if one does not fit.
  void check_sizes_of_edges(VertexRef vertex) const;
  void mark_parameter(VertexRef vertex);
  std::vector<EdgeRef> find_edges(VertexRef vertex) const;
  void index_edge(EdgeRef edge, std::span<const VertexRef> vertices) noexcept;
  /// The blocks of jacobian(), one after the other; each is column-major.
  std::vector<double> stacked_jacobian(EdgeRef edge) const;
  void save(detail::SavedState saved);

  /// Appends a handle, or a range of handles, to the vertices of a new edge.
  template <class List, class T>
  void gather(List& out, const VertexHandle<T>& vertex) const {
    typed_pool<T>(vertex);
    out.push_back(vertex);
  }
  template <class List, std::ranges::range R>
  void gather(List& out, const R& vertices) const {
    for (const auto& vertex : vertices) gather(out, vertex);
  }

  template <class T>
  detail::TypedVertexPool<detail::StoredEstimate<T>>& typed_pool(VertexRef vertex) const {
    check(vertex);
    detail::VertexPool& pool = *pools_.vertices[vertex.pool];
    if (typeid(pool) != typeid(detail::TypedVertexPool<detail::StoredEstimate<T>>)) {
      throw_wrong_type(vertex, detail::type_name<detail::StoredEstimate<T>>());
    }
    return static_cast<detail::TypedVertexPool<detail::StoredEstimate<T>>&>(pool);
  }
  template <class T>
  VertexHandle<T> register_vertex(T estimate, Id id, detail::IdMap& ids) {
    const std::uint32_t index = pools_.require_vertices<T>();
    auto& pool = static_cast<detail::TypedVertexPool<T>&>(*pools_.vertices[index]);
    ids.make_room();
    const std::uint32_t slot = pool.add(std::move(estimate), id);
    const VertexHandle<T> handle{{index, slot, pool.generation(slot)}};
    ids.insert(id, handle);
    note_new_structure();
    note_change(handle);
    return handle;
  }

  template <class E>
  const detail::EdgeAccess& edge_access(EdgeRef edge) const {
    check(edge);
    const detail::EdgeAccess& access = pools_.access(edge.pool);
    if (*access.type != typeid(E)) throw_wrong_type(edge, detail::type_name<E>());
    return access;
  }

  detail::PoolTable pools_;
  detail::IdMap vertex_ids_, parameter_ids_;
  Id next_id_ = 0, next_parameter_id_ = 0;
  std::uint64_t revision_ = 1;
  std::vector<detail::SavedState> stack_;
  detail::Lifetime lifetime_;
  detail::ChangeLog* log_ = nullptr;
  mutable std::unique_ptr<Incidence> incidence_;  // created by the first call of edges()
};

inline std::vector<Eigen::MatrixXd> Graph::jacobian(EdgeRef edge) const {
  const std::vector<double> values = stacked_jacobian(edge);
  const int rows = pools_.edges[edge.pool]->shape(edge.slot).rows;
  const double* next = values.data();
  std::vector<Eigen::MatrixXd> blocks;
  for (const VertexRef& vertex : vertices(edge)) {
    blocks.emplace_back(Eigen::Map<const Eigen::MatrixXd>(next, rows, tangent_dim(vertex)));
    next += blocks.back().size();
  }
  return blocks;
}

}  // namespace boxplus
