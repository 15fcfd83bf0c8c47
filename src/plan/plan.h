// SPDX-License-Identifier: BSD-3-Clause
// The plan of a linearization, made once per structure: the vertices and edges that take part, the places in
// H and in the gradient to which each edge adds, and the work of each worker.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "boxplus/base/stop_token.h"
#include "boxplus/gauge/gauge.h"
#include "boxplus/graph/graph.h"
#include "boxplus/linear/block_structure.h"

namespace boxplus {

/// The columns of H that belong to eliminated vertices contain most of its values.
enum class ColumnStorage : std::uint8_t {
  kAll,        ///< stores all columns
  kBatch,      ///< stores the columns of one batch of vertices per chunk, and recomputes them when needed
  kAutomatic,  ///< chooses kBatch if it is predicted to save time or if all columns would not fit in memory
};

struct PlanRequest {
  int level = 0;  ///< edges of this level take part; if negative, edges of all levels
  std::span<const VertexRef> vertices =
      {};  ///< if not empty, only these vertices move, and only their edges take part
  std::span<const EdgeRef> edges = {};  ///< if not empty, only these edges take part
  GaugePolicy gauge = GaugePolicy::kFixFirst;
  int threads = 1;                              ///< maximum number; small problems use fewer
  StopToken stop = {};                          ///< when it is raised, make_plan() throws Stopped
  ColumnStorage columns = ColumnStorage::kAll;  ///< with fixed directions, all columns are stored
};

/// The active vertices of one pool.
struct VertexList {
  std::uint32_t pool;
  std::vector<std::uint32_t> slots;
  std::vector<std::uint32_t> offsets;  ///< index of the first entry of each vertex in a step vector
};

/// The active edges of one pool, in slot order. `first` is the index of the first of these edges among all
/// active edges.
struct EdgeList {
  std::uint32_t pool;
  std::uint32_t first;
  std::vector<std::uint32_t> edges;
};

/// The places in the gradient and in H to which the edges of one pool add. An edge of arity q has q offsets
/// into the gradient, then one offset into H's values per pair (i, j), j ≤ i, in the order (0,0) (1,0) (1,1)
/// (2,0) …
struct Scatter {
  static constexpr std::uint32_t kNowhere = 0xFFFFFFFFu;
  static constexpr std::uint32_t kTransposed = 0x80000000u;  ///< the block is stored at (j, i)
  std::uint32_t pool;
  std::vector<std::uint32_t> edges;
  std::vector<std::uint32_t> targets;
  std::vector<std::uint32_t> target_start;  ///< per edge; empty if all edges have the same arity

  /// The targets of the edge at `position`, which has `arity` vertices.
  const std::uint32_t* targets_of_edge(std::uint32_t position, int arity) const {
    return targets.data() + (target_start.empty() ? position * targets_of(arity) : target_start[position]);
  }
  static std::uint32_t targets_of(int arity) {
    return static_cast<std::uint32_t>(arity + arity * (arity + 1) / 2);
  }
};

/// A part of the linearization: the block columns of H that it owns, and the edges that touch these columns.
/// Chunks do not write to the same values, so that each can have its own worker.
///
/// If no vertex is eliminated, each worker has one chunk. If an edge touches columns of two chunks, both
/// linearize it, and each adds to its own columns. Exactly one chunk sums each block of H, in the order of
/// its runs. Therefore, H has the same bits for any number of workers.
///
/// If vertices are eliminated, each edge is in one chunk: in that of its eliminated vertex, or in the last
/// one. All chunks add to the columns of the other vertices, each to its own copy. The last chunk adds to the
/// copy in H. The number of chunks depends only on the problem, so that H has the same bits for any number of
/// workers.
struct Chunk {
  struct Run {
    std::uint32_t scatter, begin, end;  ///< edges [begin, end) of scatters[scatter]
  };
  /// The runs [previous end, end_run), which contain all edges of the eliminated vertices [previous
  /// end, end_column).
  struct Batch {
    std::uint32_t end_column, end_run;
  };
  /// The distance from an entry of a column that all chunks share to this chunk's copy of it: in the
  /// gradient, and in the values of H.
  struct CopyOffset {
    std::uint32_t in_gradient = 0, in_values = 0;
  };
  /// The entries of H and of the gradient that belong to fixed scalars (Graph::fix_directions()) and that
  /// this chunk owns.
  struct FixedScalars {
    std::vector<std::uint32_t> scalars;    ///< entries of the gradient
    std::vector<std::uint32_t> values;     ///< entries of H off the diagonal
    std::vector<std::uint32_t> diagonals;  ///< diagonal entries of H
  };
  std::uint32_t first_column = 0, last_column = 0;
  /// The first column that all chunks share.
  std::uint32_t first_shared = BlockStructure::kAbsent;
  CopyOffset copy;
  /// With ColumnStorage::kBatch: the memory for the columns of one batch, among the values of the Linearizer.
  struct Window {
    std::uint32_t first = 0, size = 0;
  };
  Window window;
  FixedScalars fixed;
  std::vector<Scatter> scatters;
  /// First, for each batch of eliminated vertices, their edges pool by pool; then the other edges, pool by
  /// pool. No two consecutive runs of a batch are of the same pool.
  std::vector<Run> runs;
  std::vector<Batch> batches;
};

/// Immutable once made.
struct Plan {
  /// The vertex of each block. Eliminated vertices come first, and both groups are sorted by id. But kept
  /// vertices that share edges with exactly the same eliminated vertices, such as a pose and the camera that
  /// only this pose uses, are side by side.
  std::vector<VertexRef> block_vertex;
  std::uint32_t eliminated_blocks = 0;
  BlockStructure structure;                     ///< of H
  ColumnStorage columns = ColumnStorage::kAll;  ///< never kAutomatic
  std::vector<VertexList> vertices;
  std::vector<EdgeList> edges;
  std::uint32_t edge_count = 0;
  std::vector<Chunk> chunks;
  int workers = 1;                        ///< the number of threads that linearize, at most one per chunk
  std::vector<detail::GaugeVertex> held;  ///< GaugePolicy::kFixFirst
  std::vector<detail::GaugeFreedom> freedoms;  ///< the freedom that remains if the vertices `held` are held
  /// The entries of a step that are held at zero because of `freedoms` (GaugePolicy::kFixFirst).
  std::vector<std::uint32_t> held_scalars;
  /// One block of each component that may have gauge freedom other than a similarity. The block is eliminated
  /// last. If pivots of the block vanish, their directions are gauge freedom.
  std::vector<std::uint32_t> undetermined_blocks;
  std::vector<std::uint32_t> fixed_scalars;  ///< zero in every step (Graph::fix_directions())
  int max_tile_values = 0;                   ///< doubles of the largest tile
  int max_tile_rows = 0;
  std::size_t max_dense_values = 0;  ///< scratch values for the largest edge that dense kernels multiply

  std::uint32_t scalars() const { return structure.scalars(); }
  /// The first value of H in this column, or the number of values if it is the end of the columns.
  std::uint32_t first_value(std::uint32_t column) const {
    return structure.value_start[structure.column_start[column]];
  }
  /// The number of values of H in the columns of eliminated vertices.
  std::uint32_t eliminated_values() const { return first_value(eliminated_blocks); }
  /// The first value of H that is stored permanently.
  std::uint32_t first_stored_value() const {
    return columns == ColumnStorage::kAll ? 0 : eliminated_values();
  }
  /// The numbers of values of H and of entries of the gradient that belong to columns that all chunks share.
  std::uint32_t shared_values() const { return structure.nonzero_values() - eliminated_values(); }
  std::uint32_t shared_scalars() const { return scalars() - structure.offset[eliminated_blocks]; }
  /// The number of scalars that may change.
  std::uint32_t free_scalars() const { return scalars() - static_cast<std::uint32_t>(fixed_scalars.size()); }
};

/// Builds the plan of `graph`. O(edges log edges). Throws InvalidArgument for stale handles in the request,
/// and if an edge joins two eliminated vertices.
Plan make_plan(const Graph& graph, const PlanRequest& request);

/// The number of edges of this shape to linearize at a time. Their tile then fits into the L1 cache.
int tile_capacity(const detail::EdgeShape& shape);

}  // namespace boxplus
