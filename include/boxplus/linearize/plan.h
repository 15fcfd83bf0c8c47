// SPDX-License-Identifier: BSD-3-Clause
// What is decided once per structure: which vertices and edges take part, where each edge adds to H and to
// the gradient, and who does it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "boxplus/base/stop_token.h"
#include "boxplus/graph/graph.h"
#include "boxplus/linear/block_structure.h"
#include "boxplus/linearize/gauge.h"

namespace boxplus {

struct PlanRequest {
  int level = 0;  ///< edges of this level take part; negative: of all levels
  std::span<const VertexRef> vertices =
      {};  ///< if not empty: only these move, and only edges that touch them take part
  std::span<const EdgeRef> edges = {};  ///< if not empty: only these edges take part
  GaugePolicy gauge = GaugePolicy::kFixFirst;
  int threads = 1;      ///< upper bound; small problems are given fewer
  StopToken stop = {};  ///< once raised, make_plan() throws Stopped
};

/// The active vertices of one pool.
struct VertexList {
  std::uint32_t pool;
  std::vector<std::uint32_t> slots;
  std::vector<std::uint32_t> offsets;  ///< of each slot's entries in a step
};

/// The active edges of one pool, in slot order, and the index of the first of them among all active edges.
struct EdgeList {
  std::uint32_t pool;
  std::uint32_t first;
  std::vector<std::uint32_t> edges;
};

/// Where the edges of one pool add to the gradient and to H. Per edge of arity q: q offsets into the
/// gradient, then one offset into H's values per pair (i, j), j ≤ i, in the order (0,0) (1,0) (1,1) (2,0) …
struct Scatter {
  static constexpr std::uint32_t kNowhere = 0xFFFFFFFFu;
  static constexpr std::uint32_t kTransposed = 0x80000000u;  ///< the block lies at (j, i)
  std::uint32_t pool;
  std::vector<std::uint32_t> edges;
  std::vector<std::uint32_t> targets;
  std::vector<std::uint32_t> target_start;  ///< per edge; empty where all have one arity

  /// The targets of the edge at `position`, which has `arity` vertices.
  const std::uint32_t* targets_of_edge(std::uint32_t position, int arity) const {
    return targets.data() + (target_start.empty() ? position * targets_of(arity) : target_start[position]);
  }
  static std::uint32_t targets_of(int arity) {
    return static_cast<std::uint32_t>(arity + arity * (arity + 1) / 2);
  }
};

/// The share of one worker: the block columns of H that it owns and the edges that touch them. An edge that
/// touches the columns of two owners is linearised by both, each adding to its own; so every block of H is
/// summed by one worker in the order of the runs, which makes the bits independent of the number of workers.
struct Chunk {
  struct Run {
    std::uint32_t scatter, begin, end;  ///< edges [begin, end) of scatters[scatter]
  };
  /// The rows and columns of H of scalars that stay (Graph::fix_directions()), as far as the chunk owns them.
  struct FixedScalars {
    std::vector<std::uint32_t> scalars;    ///< of the gradient
    std::vector<std::uint32_t> values;     ///< of H, without the diagonal
    std::vector<std::uint32_t> diagonals;  ///< of H
  };
  std::uint32_t first_column = 0, last_column = 0;
  FixedScalars fixed;
  std::vector<Scatter> scatters;
  /// In this order: for each eliminated vertex its edges of every pool, then the other edges pool by pool.
  std::vector<Run> runs;
};

/// A vertex that is held because nothing else holds its component.
struct GaugeVertex {
  VertexRef vertex;
  Id id = 0;
};

/// Immutable once made.
struct Plan {
  std::vector<VertexRef>
      block_vertex;  ///< the vertex of each block: the eliminated ones first, each group by id
  std::uint32_t eliminated_blocks = 0;
  BlockStructure structure;  ///< of H
  std::vector<VertexList> vertices;
  std::vector<EdgeList> edges;
  std::uint32_t edge_count = 0;
  std::vector<Chunk> chunks;
  std::vector<GaugeVertex> held;       ///< GaugePolicy::kFixFirst
  std::vector<GaugeFreedom> freedoms;  ///< beyond what `held` holds
  /// Entries of a step that are held for `freedoms` (GaugePolicy::kFixFirst).
  std::vector<std::uint32_t> held_scalars;
  /// One block of each component that nothing anchors, and whose freedom is not known: should its pivots be
  /// lost when it is eliminated last, they are gauge.
  std::vector<std::uint32_t> loose_blocks;
  std::vector<std::uint32_t> fixed_scalars;  ///< in which every step is zero (Graph::fix_directions())
  int max_tile_values = 0;                   ///< doubles of the largest tile
  int max_tile_rows = 0;
  std::size_t max_dense_values = 0;  ///< scratch for the largest edge that dense kernels multiply

  std::uint32_t scalars() const { return structure.scalars(); }
  /// Those that may change.
  std::uint32_t free_scalars() const { return scalars() - static_cast<std::uint32_t>(fixed_scalars.size()); }
};

/// Builds the plan of `graph`. O(edges log edges). Throws InvalidArgument for stale handles in the request
/// and where an edge joins two eliminated vertices.
Plan make_plan(const Graph& graph, const PlanRequest& request);

/// How many edges of a shape are linearised at a time, so that their tile stays in L1.
int tile_capacity(const EdgeShape& shape);

}  // namespace boxplus
