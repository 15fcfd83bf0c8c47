// SPDX-License-Identifier: BSD-3-Clause
// The elements of a graph as blocks and terms of an IncrementalFactor, which follow the changes of the graph.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "boxplus/graph/change_log.h"
#include "boxplus/graph/graph.h"
#include "boxplus/incremental/smoother_options.h"
#include "linear/incremental/incremental_factor.h"
#include "linearize/edge_linearizer.h"
#include "linearize/tile_memory.h"

namespace boxplus {

/// A log with all vertices, parameters and edges of a graph.
detail::ChangeLog everything_in(const Graph& graph);

/// A block exists for each vertex that can move, has edges, and is not left out. Its linearization point θ is
/// kept here, and the graph has its estimate θ ⊞ δ, where δ is the x of the factor. A term exists for each
/// edge of level 0 that touches a block.
class LiveProblem {
 public:
  using Index = IncrementalFactor::Index;
  static constexpr Index kNone = IncrementalFactor::kNone;

  /// The edges in `aside` take no part.
  LiveProblem(Graph& graph, const SmootherOptions& options, const std::set<EdgeRef>& aside);

  /// Adapts blocks and terms to changes of the graph. Edges that have to be linearized are queued.
  void apply(const detail::ChangeLog& log);
  /// Holds the vertices and directions that a plan holds, instead of those of the last call. Returns false if
  /// they are the same.
  bool hold(const Plan& plan);
  std::span<const detail::GaugeVertex> held() const { return held_; }
  std::size_t held_directions() const { return held_directions_.size(); }
  /// After the factorization has lost the pivot of this block: leaves out the vertices around it that their
  /// own edges do not determine. Returns false if there is no such vertex.
  bool leave_out_undetermined(Index lost);
  /// The same for all vertices whose edges have too few rows. Returns false if there is none.
  bool leave_out_with_few_rows();
  /// Removes vertices that were left out from the graph if they have no edges any more. Returns their number.
  std::size_t remove_stranded();
  /// Vertices that their own edges do not determine, such as a landmark with a single range. These edges take
  /// no part, because they say nothing about other vertices. The vertices take part again when they or their
  /// edges change.
  std::span<const VertexRef> left_out() const { return left_out_; }

  bool has_queued_edges() const;
  enum class Linearized : std::uint8_t { kAll, kStopped, kNonFinite };
  /// Linearizes the queued edges at the linearization points of their vertices, and adds their number to
  /// `count`. The estimates of the graph are unchanged, also if the function throws. If the terms of an edge
  /// are not finite, non_finite() is this edge.
  Linearized linearize(const StopToken& stop, std::uint32_t& count);
  EdgeRef non_finite() const { return non_finite_; }
  /// Sets the estimates of the listed blocks to θ ⊞ δ.
  void move(std::span<const Index> blocks);
  /// Begins a transaction: restore() sets all estimates that move() changes back to what they are now.
  void begin() { moved_.clear(), ++transaction_; }
  void restore();
  /// Moves the linearization points of those blocks to their estimates that are farther from them than
  /// `scale` times what the options allow, and queues their edges; also those of earlier calls that had to
  /// wait. Returns the largest distance, divided by what the options allow.
  ///
  /// The farthest blocks come first, and block after block is taken as long as the operations that it adds to
  /// the next factorization are within `max_flops`; all others wait. Blocks on the path of a block that was
  /// taken are nearly free (RA-ISAM2: Chen et al., ASPLOS 2025). If `takes_one`, at least one block is taken.
  double relinearize(std::span<const Index> blocks, double scale, double max_flops, bool takes_one);
  bool has_waiting_blocks() const { return !waiting_.empty(); }

  /// Adapts to an edge that was set aside or taken back.
  void apply_verdict(EdgeRef edge);
  /// The vertices that have got a block since the last call.
  std::vector<VertexRef> take_new_vertices() { return std::exchange(new_vertices_, {}); }
  /// The vertices that share an edge with `leaving`, and that `stays` does not name, nor any other vertex of
  /// their edges. Priors of earlier calls of marginalize() do not count as edges.
  std::vector<VertexRef> followers(std::span<const VertexRef> leaving,
                                   detail::FunctionRef<bool(VertexRef)> stays) const;
  /// Replaces vertices in the graph by a prior on their neighbors, with the linearization that the terms
  /// have. The linearization points of these neighbors do not move any more, because the prior would
  /// contradict the other edges in directions that no edge measures (Huang, Mourikis and Roumeliotis,
  /// "Observability-based rules for designing consistent EKF SLAM estimators", IJRR 2010). The next apply()
  /// adapts the terms.
  void marginalize(std::span<const VertexRef> vertices);

  IncrementalFactor& factor() { return factor_; }
  const IncrementalFactor& factor() const { return factor_; }
  VertexRef vertex(Index block) const { return vertex_of_[block]; }
  /// The block of a vertex, or kNone.
  Index block(VertexRef vertex) const;
  /// Whether a vertex has a block, or is held or fixed.
  bool takes_part(VertexRef vertex) const;
  /// The edges that take part: of level 0, enabled, not set aside, and not left out.
  std::vector<EdgeRef> edges() const;
  std::uint32_t block_count() const { return block_count_; }
  std::uint32_t term_count() const { return term_count_; }
  /// Whether edges were removed or changed, or vertices released, since forget_cuts(), so that something may
  /// not be determined any more.
  bool may_be_cut() const { return may_be_cut_; }
  void forget_cuts() { may_be_cut_ = false; }
  /// Whether an edge was added, since the last hold(), that may anchor a component which was free before.
  bool may_be_anchored() const { return may_be_anchored_; }

 private:
  struct VertexEntry {
    std::uint32_t generation = 0;
    Index block = kNone;
    bool is_known = false, is_held = false, is_left_out = false;
    bool moved = false;      // could move after the last change
    bool is_pinned = false;  // its linearization point does not move
  };
  struct EdgeEntry {
    std::uint32_t generation = 0;
    Index term = kNone;
    bool is_queued = false;
  };
  struct EdgeName {
    std::uint32_t pool = 0, slot = 0;
  };
  /// The slots of some vertices of one pool.
  struct SlotList {
    std::vector<std::uint32_t> slots, offsets;
  };

  void grow();
  void drop_stale_edge(EdgeRef edge);
  void apply_vertex(VertexRef vertex);
  void apply_edge(EdgeRef edge);
  void remove_term(EdgeName name);
  void remove_unused_blocks();
  bool has_few_rows(Index block) const;
  void leave_out(std::span<const Index> blocks);
  void take_in(const detail::ChangeLog& log);
  void take_in(std::vector<VertexRef> vertices);
  void append_left_out(EdgeName edge, std::vector<VertexRef>& out) const;
  bool is_determined_alone(Index block) const;
  bool is_left_out(EdgeName edge) const;
  bool may_take_part(EdgeName edge) const;
  bool can_move(std::uint32_t pool, std::uint32_t slot) const;
  void note_anchor(std::uint32_t pool, std::uint32_t edge);
  bool joins_parts();
  Index require_block(std::uint32_t pool, std::uint32_t slot);
  void remove_block(VertexEntry& entry);
  const std::vector<std::uint8_t>& kinds_of(std::uint32_t pool, std::uint32_t slot);
  void set_point(std::uint32_t pool, std::uint32_t slot, Index block);
  void queue(EdgeName name);
  void list_points();
  void swap_points();
  Linearized linearize_pool(std::uint32_t pool, const StopToken& stop);
  void place(const detail::EdgePool& pool, std::uint32_t edge, Index term);
  void clear_fixed(Index term);
  void reserve_memory(const detail::EdgePool& pool, std::span<const std::uint32_t> edges);

  Graph& graph_;
  const SmootherOptions& options_;
  const std::set<EdgeRef>& aside_;
  IncrementalFactor factor_;
  EdgeLinearizer linearizer_;
  std::vector<std::vector<VertexEntry>> vertices_;           // per pool and slot
  std::vector<std::vector<EdgeEntry>> edges_;                // per pool and slot
  std::vector<std::unique_ptr<detail::VertexPool>> points_;  // θ, per pool
  std::vector<VertexRef> vertex_of_;                         // per block
  std::vector<EdgeName> edge_of_;                            // per term
  std::vector<std::vector<std::uint32_t>> queued_;           // per edge pool
  std::vector<std::vector<std::uint8_t>> kinds_;             // per vertex pool: the kind of each entry
  std::vector<SlotList> lists_;                              // per vertex pool; scratch memory
  std::vector<VertexRef> left_out_;
  std::vector<detail::GaugeVertex> held_;
  std::vector<std::pair<VertexRef, int>> held_directions_;
  std::vector<bool> is_relative_;  // per edge pool: its edges without fixed vertices do not anchor anything
  std::vector<std::unique_ptr<detail::VertexPool>> before_;  // the estimates before the transaction
  std::vector<Index> moved_;
  std::vector<std::uint64_t> moved_in_;  // per block: its last transaction
  std::uint64_t transaction_ = 0;
  std::vector<Index> maybe_unused_, few_rows_;
  std::vector<Index> waiting_;  // to be linearized anew when the budget allows it
  std::vector<VertexRef> new_vertices_;
  std::vector<EdgeRef> again_;           // edges whose vertices have changed
  std::vector<Index> blocks_, members_;  // of an edge; scratch memory
  std::vector<double> noticeable_;
  std::vector<std::pair<double, Index>> far_;
  std::vector<std::uint64_t> pass_of_;  // per block: the last linearize()
  std::uint64_t pass_ = 0;
  std::unique_ptr<TileMemory> memory_;
  std::size_t memory_values_ = 0, memory_rows_ = 0, memory_dense_ = 0;
  Scatter scatter_;
  EdgeRef non_finite_;
  std::uint32_t block_count_ = 0, term_count_ = 0;
  bool may_be_anchored_ = false, may_be_cut_ = true;
  /// The parts of the graph that new blocks have been joined to in this apply(): per block, with a stamp.
  std::vector<std::pair<std::uint64_t, Index>> part_of_;
  std::uint64_t applies_ = 0;
};

}  // namespace boxplus
