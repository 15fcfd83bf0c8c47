// SPDX-License-Identifier: BSD-3-Clause
// The pool that stores all edges of one type, and the tile that holds the errors and Jacobians of a few
// edges.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "boxplus/graph/frame.h"
#include "boxplus/graph/handle.h"
#include "boxplus/graph/information.h"
#include "boxplus/graph/jacobian_source.h"
#include "boxplus/graph/vertex_pool.h"
#include "boxplus/robust/robust_kernel.h"

namespace boxplus {
class Graph;
}

namespace boxplus::detail {

/// The sizes of an edge: the number of its vertices, the number of rows of its error, and the sum of the
/// tangent sizes of its vertices.
struct EdgeShape {
  int arity = 0;
  int rows = 0;
  int cols = 0;
};

/// Errors and Jacobians of a few edges of one shape. One worker owns the memory, which fits into the cache.
///
/// In each array, an edge has n values: n = rows in `error`, n = rows · cols in `jacobian`. Value m of edge k
/// is at index k · n + m. If `in_lanes` is true, it is at index ((k / kLanes) · n + m) · kLanes + k % kLanes
/// instead, so that kernels can process kLanes edges at a time.
struct EdgeTile {
  static constexpr int kCapacity = 64, kLanes = 8;
  int count = 0, rows = 0, cols = 0;
  double* error = nullptr;     ///< not whitened
  double* jacobian = nullptr;  ///< rows × cols, column-major; the columns of its vertices in order
  /// The caller sets this flag before linearize() if it can read lanes. linearize() clears the flag if it did
  /// not write lanes. If the number of edges is not a multiple of kLanes, the remaining lanes are copies of
  /// the last edge.
  bool in_lanes = false;
};

/// The type-erased interface of the edges of one type. If all edges have the same shape, an iteration makes
/// one virtual call per tile, and none per edge.
class EdgePool {
 public:
  virtual ~EdgePool() = default;

  /// A copy with the same slots and generations. The edges of the copy use the vertices in `vertex_pools`,
  /// which are copies of the original's pools.
  virtual std::unique_ptr<EdgePool> clone(
      std::span<const std::unique_ptr<VertexPool>> vertex_pools) const = 0;
  virtual std::string_view type_name() const = 0;
  virtual EdgeShape shape(std::uint32_t edge) const = 0;
  /// Whether all edges of the pool have the same shape. Otherwise, the edges are linearized one at a time.
  virtual bool uniform_shape() const = 0;
  /// The errors of the listed edges, one after the other.
  virtual void errors(std::span<const std::uint32_t> edges, double* out) const = 0;
  /// eᵀΩe per listed edge, before any robust kernel.
  void chi2(std::span<const std::uint32_t> edges, double* out) const;
  /// Fills count, rows, cols, error and jacobian for the listed edges: at most EdgeTile::kCapacity edges of
  /// the same shape. Several workers may call this function at once. `force_numeric` asks for numeric
  /// Jacobians.
  virtual void linearize(std::span<const std::uint32_t> edges, EdgeTile& tile, bool force_numeric) const = 0;
  virtual JacobianSource jacobian_source() const = 0;
  /// Computes the errors of at most EdgeTile::kCapacity edges, in lanes. Does nothing and returns false if
  /// there is no kernel that evaluates several edges of this type at a time.
  virtual bool errors_in_lanes(std::span<const std::uint32_t> /*edges*/, double* /*out*/) const {
    return false;
  }
  /// True if each edge of this type completely measures a pose or a point relative to a pose, or a pose
  /// relative to the world (kRigid in graph/error_function.h).
  virtual bool is_rigid() const { return false; }
  /// Sets `out` to the relative frame that the edge measures, for initial guesses. Returns false if it
  /// measures none.
  virtual bool relative_frame(std::uint32_t /*edge*/, RelativeFrame& /*out*/) const { return false; }

  /// What is added to the error of an edge that is a constraint (types/constraint.h); empty means zeros.
  /// nullptr for other edges.
  virtual std::vector<double>* shift(std::uint32_t /*edge*/) { return nullptr; }

  /// Reserves memory for a total of `edges` edges with the sizes of the existing ones. Changes nothing else.
  virtual void reserve(std::size_t edges) = 0;

  std::uint32_t slots() const { return static_cast<std::uint32_t>(flags_.size()); }
  std::uint32_t alive_count() const { return slots() - static_cast<std::uint32_t>(free_.size()); }
  bool alive(std::uint32_t edge) const { return (flags_[edge] & kAlive) != 0; }
  bool enabled(std::uint32_t edge) const { return (flags_[edge] & kEnabled) != 0; }
  int level(std::uint32_t edge) const { return levels_.empty() ? 0 : levels_[edge]; }
  /// The edge's robust kernel, or nullptr.
  const RobustKernel* kernel(std::uint32_t edge) const {
    return kernels_.empty() ? nullptr : kernels_[edge].get();
  }
  bool has_kernels() const { return !kernels_.empty(); }
  int arity(std::uint32_t edge) const {
    return uniform_arity_ >= 0 ? uniform_arity_
                               : static_cast<int>(vertex_start_[edge + 1] - vertex_start_[edge]);
  }
  /// The slots of the edge's vertices in their pools.
  std::span<const std::uint32_t> vertex_slots(std::uint32_t edge) const {
    return {vertex_slots_.data() + vertex_start(edge), static_cast<std::size_t>(arity(edge))};
  }
  /// The pool of the i-th vertex of an edge.
  std::uint32_t vertex_pool(std::uint32_t edge, int i) const {
    if (tails_ > 1) return pool_in_tails(edge, i);
    return vertex_pools_[std::min(static_cast<std::size_t>(i), vertex_pools_.size() - 1)];
  }
  InformationView information(std::uint32_t edge) const { return information(edge, shape(edge).rows); }
  /// The same for a caller that knows the number of rows.
  InformationView information(std::uint32_t edge, int rows) const { return information_.view(edge, rows); }
  /// Sets omegas[k] to the address of the values of Ω of edges[k]. Returns the kind of all these Ω. If their
  /// kinds differ, writes all of them as full matrices to `full` (rows (rows + 1) / 2 values per edge).
  InformationKind informations(std::span<const std::uint32_t> edges, int rows, const double** omegas,
                               double* full) const;
  std::uint32_t generation(std::uint32_t edge) const { return generations_[edge]; }

 protected:
  /// `vertex_pools`: the pool of each argument of the error function. The last `tails` arguments are tails;
  /// each stands for any number of vertices.
  EdgePool(std::vector<std::uint32_t> vertex_pools, int tails);
  std::uint32_t argument_pool(int i) const { return vertex_pools_[static_cast<std::size_t>(i)]; }
  /// The number of vertices in each tail of an edge. Empty if there is at most one tail, because a single
  /// tail has all vertices that remain.
  std::span<const std::uint32_t> tail_sizes(std::uint32_t edge) const {
    if (tails_ <= 1) return {};
    const auto tails = static_cast<std::size_t>(tails_);
    return {tail_sizes_.data() + edge * tails, tails};
  }
  void reserve_slots(std::size_t edges);
  /// The slot that acquire_slot() will return for an edge of this arity: the slot of a removed edge, or
  /// slots().
  std::uint32_t next_slot(std::size_t arity) const;
  /// Registers a new edge and returns its slot. If there is a slot of a removed edge of the same arity,
  /// returns this slot. Otherwise, returns a new slot at the end, and the derived class must also append an
  /// element. If the function throws, nothing has changed.
  std::uint32_t acquire_slot(std::span<const std::uint32_t> vertex_slots,
                             std::span<const std::uint32_t> tail_sizes, const Information& information,
                             int rows);

 private:
  friend class boxplus::Graph;
  friend class PoolTable;
  std::size_t vertex_start(std::uint32_t edge) const {
    return uniform_arity_ >= 0 ? std::size_t{edge} * static_cast<std::size_t>(uniform_arity_)
                               : vertex_start_[edge];
  }
  enum Flag : std::uint8_t { kAlive = 1, kEnabled = 2 };

  bool chi2_in_lanes(std::span<const std::uint32_t> edges, double* out) const;
  void chi2_of_tile(std::span<const std::uint32_t> edges, int rows, double* out) const;
  void chi2_one_by_one(std::span<const std::uint32_t> edges, double* out) const;
  std::size_t find_free(std::size_t arity) const;
  std::uint32_t pool_in_tails(std::uint32_t edge, int i) const;
  void append_slot(std::span<const std::uint32_t> vertex_slots, std::span<const std::uint32_t> tail_sizes,
                   const Information& information, int rows);
  void remove(std::uint32_t edge);
  void set_kernel(std::uint32_t edge, std::shared_ptr<const RobustKernel> kernel);

  std::vector<std::uint32_t> vertex_pools_;
  int uniform_arity_ = -1, tails_ = 0;
  std::vector<std::uint32_t> vertex_slots_;
  std::vector<std::uint32_t> vertex_start_;  // used only if the arity is chosen at run time
  std::vector<std::uint32_t> tail_sizes_;    // tails_ entries per edge; used only if tails_ > 1
  InformationStore information_;
  std::vector<std::uint8_t> flags_;
  std::vector<int> levels_;  // empty while all levels are 0
  std::vector<std::uint32_t> generations_;
  std::vector<std::shared_ptr<const RobustKernel>> kernels_;  // empty while no edge has a kernel
  std::vector<std::uint32_t> free_;
  std::uint32_t next_generation_ = 0;  // of the next edge, in any slot
};

}  // namespace boxplus::detail
