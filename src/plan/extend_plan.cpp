// SPDX-License-Identifier: BSD-3-Clause
#include "plan/extend_plan.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "plan/edge_targets.h"

namespace boxplus {
namespace {

/// Whether the element in a slot was added when the pool had used the generations before `noted`, or later.
/// Generations may wrap around.
template <class Pool>
bool is_later(const Pool& pool, const std::uint32_t* noted, std::uint32_t slot) {
  return noted == nullptr || pool.generation(slot) - *noted < pool.next_generation() - *noted;
}

/// The elements that were added to a graph and take part in the optimization.
struct Additions {
  std::vector<VertexRef> vertices;                // sorted by id
  std::vector<std::vector<std::uint32_t>> edges;  // the slots of the new edges of each pool, ascending
};

BlockOf block_of(const Graph& graph, const Plan& plan) {
  BlockOf result;
  for (const auto& pool : graph.vertex_pools()) result.emplace_back(pool->slots(), kNoBlock);
  for (std::uint32_t block = 0; block < plan.block_vertex.size(); ++block) {
    result[plan.block_vertex[block].pool][plan.block_vertex[block].slot] = block;
  }
  return result;
}

/// Finds the additions, and decides whether they need a new plan.
class Finder {
 public:
  Finder(const Graph& graph, const PlanRequest& request, const PlannedElements& planned, const Plan& plan)
      : graph_(graph), request_(request), planned_(planned), plan_(plan) {}

  /// `blocks` contains the blocks of the plan. Adds the blocks of the new vertices that take part. Returns
  /// false if a new plan is needed.
  bool find(BlockOf& blocks, Additions& out) {
    if (!request_.vertices.empty() || !request_.edges.empty()) return false;
    return find_edges(out) && find_vertices(blocks, out) && look_at_edges(blocks, out) && is_connected();
  }

 private:
  bool is_new(std::uint32_t pool, std::uint32_t slot) const {
    return !planned_.has_vertex(graph_, pool, slot);
  }

  bool find_edges(Additions& out) const {
    out.edges.resize(graph_.edge_pools().size());
    for (std::uint32_t p = 0; p < out.edges.size(); ++p) {
      const detail::EdgePool& pool = *graph_.edge_pools()[p];
      // Most additions are at the end. The search ends when all of them have been found.
      std::uint32_t left =
          p < planned_.edges.size() ? pool.next_generation() - planned_.edges[p] : pool.slots();
      for (std::uint32_t edge = pool.slots(); left > 0 && edge-- > 0;) {
        if (!is_later(pool, p < planned_.edges.size() ? &planned_.edges[p] : nullptr, edge)) continue;
        --left;
        if (request_.level < 0 || pool.level(edge) == request_.level) out.edges[p].push_back(edge);
      }
      std::reverse(out.edges[p].begin(), out.edges[p].end());
      const auto has_list = [&](const EdgeList& list) { return list.pool == p; };
      const bool known = std::any_of(plan_.edges.begin(), plan_.edges.end(), has_list);
      if (!out.edges[p].empty() && (!known || !pool.uniform_shape())) return false;
    }
    return true;
  }

  /// Finds the new vertices that may move and that a new edge touches.
  bool find_vertices(BlockOf& blocks, Additions& out) const {
    constexpr std::uint32_t kSeen = kNoBlock - 1;
    for (std::uint32_t p = 0; p < out.edges.size(); ++p) {
      const detail::EdgePool& pool = *graph_.edge_pools()[p];
      for (const std::uint32_t edge : out.edges[p]) {
        const auto slots = pool.vertex_slots(edge);
        for (std::size_t i = 0; i < slots.size(); ++i) {
          const std::uint32_t v = pool.vertex_pool(edge, static_cast<int>(i)), slot = slots[i];
          if (!is_new(v, slot) || blocks[v][slot] == kSeen || !moves(v, slot)) continue;
          blocks[v][slot] = kSeen;
          out.vertices.push_back({v, slot, graph_.vertex_pools()[v]->generation(slot)});
        }
      }
    }
    const auto id = [&](const VertexRef& v) { return graph_.vertex_pools()[v.pool]->id(v.slot); };
    std::sort(out.vertices.begin(), out.vertices.end(),
              [&](const VertexRef& a, const VertexRef& b) { return id(a) < id(b); });
    if (!out.vertices.empty() && id(out.vertices.front()) <= id(plan_.block_vertex.back())) return false;
    auto next = static_cast<std::uint32_t>(plan_.block_vertex.size());
    for (const VertexRef& vertex : out.vertices) blocks[vertex.pool][vertex.slot] = next++;
    return std::all_of(out.vertices.begin(), out.vertices.end(),
                       [&](const VertexRef& vertex) { return fits(vertex); });
  }

  bool moves(std::uint32_t v, std::uint32_t slot) const {
    const detail::VertexPool& pool = *graph_.vertex_pools()[v];
    return !pool.fixed(slot) && pool.tangent_dim(slot) > 0;
  }

  bool fits(const VertexRef& vertex) const {
    const detail::VertexPool& pool = *graph_.vertex_pools()[vertex.pool];
    const auto has_list = [&](const VertexList& list) { return list.pool == vertex.pool; };
    if (!std::any_of(plan_.vertices.begin(), plan_.vertices.end(), has_list)) return false;
    if (pool.eliminated(vertex.slot) || pool.parameter(vertex.slot)) return false;
    if (!pool.fixed_directions(vertex.slot).empty()) return false;
    if (!plan_.held.empty() && !pool.bounds(vertex.slot).empty()) return false;
    // A new plan would hold the first vertex of the largest dimension. This must still be the held vertex.
    return plan_.held.empty() ||
           (plan_.held[0].vertex.pool == vertex.pool
                ? pool.id(vertex.slot) > plan_.held[0].id
                : pool.tangent_dim(vertex.slot) < graph_.tangent_dim(plan_.held[0].vertex));
  }

  bool is_held(std::uint32_t pool, std::uint32_t slot) const {
    return !plan_.held.empty() && plan_.held[0].vertex.pool == pool && plan_.held[0].vertex.slot == slot;
  }

  /// Records which vertices are connected. Returns false if an edge makes an inactive old vertex active. Also
  /// returns false if a vertex is held because the whole graph can move freely, but a new edge may measure
  /// this motion. (An edge that measures only the relative pose of two moving vertices cannot measure it.)
  bool look_at_edges(const BlockOf& blocks, const Additions& out) {
    sets_ = DisjointSets(1 + out.vertices.size());  // 0 stands for all old vertices
    const auto old = static_cast<std::uint32_t>(plan_.block_vertex.size());
    for (std::uint32_t p = 0; p < out.edges.size(); ++p) {
      const detail::EdgePool& pool = *graph_.edge_pools()[p];
      for (const std::uint32_t edge : out.edges[p]) {
        const auto slots = pool.vertex_slots(edge);
        std::uint32_t free = 0, last = 0;
        bool reaches_fixed = false;
        for (std::uint32_t i = 0; i < slots.size(); ++i) {
          const std::uint32_t v = pool.vertex_pool(edge, static_cast<int>(i)), slot = slots[i];
          const std::uint32_t block = blocks[v][slot];
          const bool held = is_held(v, slot);
          if (block == kNoBlock && !held) {
            if (moves(v, slot)) return false;
            reaches_fixed |= !graph_.vertex_pools()[v]->parameter(slot);
            continue;
          }
          const std::uint32_t node = held || block < old ? 0 : 1 + block - old;
          if (free++ > 0) sets_.join(last, node);
          last = node;
        }
        if (!plan_.held.empty() && (free == 1 || reaches_fixed || !pool.is_rigid())) return false;
      }
    }
    return true;
  }

  bool is_connected() {
    for (std::uint32_t node = 1; node < sets_.size(); ++node) {
      if (sets_.find(node) != sets_.find(0)) return false;
    }
    return true;
  }

  const Graph& graph_;
  const PlanRequest& request_;
  const PlannedElements& planned_;
  const Plan& plan_;
  DisjointSets sets_{0};
};

/// The new blocks of H, sorted by column.
std::vector<BlockCoordinate> new_blocks(const Graph& graph, const Additions& additions,
                                        const BlockOf& block_of, const BlockStructure& structure) {
  std::vector<BlockCoordinate> added;
  std::vector<std::uint32_t> blocks;
  for (std::uint32_t p = 0; p < additions.edges.size(); ++p) {
    for (const std::uint32_t edge : additions.edges[p]) {
      edge_blocks(*graph.edge_pools()[p], edge, block_of, blocks);
      for (std::size_t i = 0; i < blocks.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if (blocks[i] == kNoBlock || blocks[j] == kNoBlock) continue;
          const auto [column, row] = std::minmax(blocks[i], blocks[j]);
          if (structure.find(row, column) == BlockStructure::kAbsent) added.push_back({row, column});
        }
      }
    }
  }
  const auto key = [](const BlockCoordinate& b) { return std::uint64_t{b.column} << 32 | b.row; };
  std::sort(added.begin(), added.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  const auto same = [&](const auto& a, const auto& b) { return key(a) == key(b); };
  added.erase(std::unique(added.begin(), added.end(), same), added.end());
  return added;
}

/// Inserting new blocks moves the values of H in memory. All values from value[k] up to value[k + 1], by
/// their old indices, move by shift[k].
struct Shifts {
  std::vector<std::uint32_t> value, shift;

  std::uint32_t operator()(std::uint32_t old) const {
    std::size_t k = value.size();
    while (k > 0 && old < value[k - 1]) --k;
    return k > 0 ? old + shift[k - 1] : old;
  }
};

/// Adds diagonal and off-diagonal blocks to a structure. PlanGrowth::added must be sorted by column.
class GrownStructure {
 public:
  GrownStructure(BlockStructure& structure, PlanGrowth& growth) : old_(structure), growth_(growth) {
    result_.offset = old_.offset;
    result_.row.reserve(old_.row.size() + growth.added.size());
    result_.value_start.reserve(old_.row.size() + growth.added.size() + 1);
    result_.column_start.reserve(old_.column_start.size() + growth.added.size());
    growth.new_index.reserve(old_.row.size());
  }

  Shifts grow(std::span<const std::uint32_t> new_dims) {
    for (const std::uint32_t dim : new_dims) result_.offset.push_back(result_.offset.back() + dim);
    Shifts shifts;
    std::uint32_t column = 0;  // the next column to be completed
    for (const BlockCoordinate& pair : growth_.added) {
      if (pair.column >= growth_.old_blocks) break;
      copy_columns(column, pair.column);
      const auto begin = old_.row.begin() + old_.column_start[pair.column];
      const auto end = old_.row.begin() + old_.column_start[pair.column + 1];
      const auto index =
          static_cast<std::uint32_t>(std::lower_bound(begin, end, pair.row) - old_.row.begin());
      copy_blocks(index);
      append(pair.row, pair.column);
      const std::uint32_t moved = result_.value_start.back() - old_.value_start[index];
      if (!shifts.value.empty() && shifts.value.back() == old_.value_start[index]) {
        shifts.shift.back() = moved;
      } else {
        shifts.value.push_back(old_.value_start[index]);
        shifts.shift.push_back(moved);
      }
    }
    copy_columns(column, growth_.old_blocks);
    append_columns();
    old_ = std::move(result_);
    return shifts;
  }

 private:
  /// Copies the old blocks of H with numbers below `end`.
  void copy_blocks(std::uint32_t end) {
    const std::uint32_t moved = result_.value_start.back() - old_.value_start[next_];
    for (; next_ < end; ++next_) {
      growth_.new_index.push_back(static_cast<std::uint32_t>(result_.row.size()));
      result_.row.push_back(old_.row[next_]);
      result_.value_start.push_back(old_.value_start[next_ + 1] + moved);
    }
  }

  /// Copies the old columns before `end`.
  void copy_columns(std::uint32_t& column, std::uint32_t end) {
    for (; column < end; ++column) {
      copy_blocks(old_.column_start[column + 1]);
      result_.column_start.push_back(static_cast<std::uint32_t>(result_.row.size()));
    }
  }

  void append_columns() {
    auto pair = std::find_if(growth_.added.begin(), growth_.added.end(),
                             [&](const BlockCoordinate& b) { return b.column >= growth_.old_blocks; });
    for (std::uint32_t column = growth_.old_blocks; column < result_.blocks(); ++column) {
      append(column, column);
      for (; pair != growth_.added.end() && pair->column == column; ++pair) append(pair->row, column);
      result_.column_start.push_back(static_cast<std::uint32_t>(result_.row.size()));
    }
  }

  void append(std::uint32_t row, std::uint32_t column) {
    result_.row.push_back(row);
    result_.value_start.push_back(result_.value_start.back() + result_.dim(row) * result_.dim(column));
  }

  BlockStructure& old_;
  PlanGrowth& growth_;
  BlockStructure result_;
  std::uint32_t next_ = 0;  // the next old block of H to be copied
};

/// The number of values of H after the new blocks are added.
std::uint64_t count_values(const BlockStructure& structure, std::span<const std::uint32_t> new_dims,
                           std::span<const BlockCoordinate> added) {
  const auto dim = [&](std::uint32_t block) -> std::uint64_t {
    return block < structure.blocks() ? structure.dim(block) : new_dims[block - structure.blocks()];
  };
  std::uint64_t values = structure.nonzero_values();
  for (const std::uint32_t d : new_dims) values += std::uint64_t{d} * d;
  for (const BlockCoordinate& pair : added) values += dim(pair.row) * dim(pair.column);
  return values;
}

/// Shifts the targets of the edges that the plan already had, because the blocks of H have moved.
void move_targets(const Graph& graph, const Shifts& shifts, Scatter& scatter) {
  if (shifts.value.empty()) return;
  const detail::EdgePool& pool = *graph.edge_pools()[scatter.pool];
  for (std::uint32_t k = 0; k < scatter.edges.size(); ++k) {
    const int arity = pool.arity(scatter.edges[k]);
    std::uint32_t* target =
        scatter.targets.data() + (scatter.targets_of_edge(k, arity) - scatter.targets.data());
    std::uint32_t* const end = target + Scatter::targets_of(arity);
    for (target += arity; target != end; ++target) {
      if (*target == Scatter::kNowhere) continue;
      const std::uint32_t flag = *target & Scatter::kTransposed;
      *target = shifts(*target & ~Scatter::kTransposed) | flag;
    }
  }
}

/// Appends the new edges of a pool to a chunk. The runs of a chunk are in the order of the pools.
void append_edges(const Graph& graph, std::uint32_t p, const std::vector<std::uint32_t>& edges,
                  const BlockOf& block_of, const BlockStructure& structure, Chunk& chunk) {
  const detail::EdgePool& pool = *graph.edge_pools()[p];
  std::vector<std::uint32_t> blocks;
  for (const std::uint32_t edge : edges) {
    edge_blocks(pool, edge, block_of, blocks);
    if (!touches(chunk, blocks)) continue;
    const auto pool_of = [&](const Chunk::Run& run) { return chunk.scatters[run.scatter].pool; };
    auto run = std::find_if(chunk.runs.begin(), chunk.runs.end(),
                            [&](const Chunk::Run& r) { return pool_of(r) >= p; });
    if (run == chunk.runs.end() || pool_of(*run) != p) {
      run = chunk.runs.insert(run, {static_cast<std::uint32_t>(chunk.scatters.size()), 0, 0});
      chunk.scatters.push_back({p, {}, {}, {}});
    }
    append_edge(pool, edge, blocks, structure, chunk, {}, chunk.scatters[run->scatter]);
    ++run->end;
  }
}

void append_to_lists(const Additions& additions, const BlockStructure& structure, Plan& plan) {
  for (const VertexRef& vertex : additions.vertices) {
    const auto list = std::find_if(plan.vertices.begin(), plan.vertices.end(),
                                   [&](const VertexList& l) { return l.pool == vertex.pool; });
    list->slots.push_back(vertex.slot);
    list->offsets.push_back(structure.offset[plan.block_vertex.size()]);
    plan.block_vertex.push_back(vertex);
  }
  plan.edge_count = 0;
  for (EdgeList& list : plan.edges) {
    const auto& more = additions.edges[list.pool];
    list.first = plan.edge_count;
    list.edges.insert(list.edges.end(), more.begin(), more.end());
    plan.edge_count += static_cast<std::uint32_t>(list.edges.size());
  }
}

}  // namespace

void PlannedElements::note(const Graph& graph) {
  vertices.clear();
  edges.clear();
  for (const auto& pool : graph.vertex_pools()) vertices.push_back(pool->next_generation());
  for (const auto& pool : graph.edge_pools()) edges.push_back(pool->next_generation());
}

bool PlannedElements::has_vertex(const Graph& graph, std::uint32_t pool, std::uint32_t slot) const {
  return pool < vertices.size() && !is_later(*graph.vertex_pools()[pool], &vertices[pool], slot);
}

bool is_extensible(const Graph& graph, const Plan& plan) {
  const bool is_held = plan.held.size() <= 1 && plan.freedoms.empty() && plan.held_scalars.empty();
  const bool is_plain = plan.undetermined_blocks.empty() && plan.fixed_scalars.empty();
  if (!is_held || !is_plain || plan.eliminated_blocks > 0 || plan.block_vertex.empty()) return false;
  DisjointSets sets(plan.block_vertex.size());
  std::size_t parts = plan.block_vertex.size();
  const BlockStructure& structure = plan.structure;
  for (std::uint32_t column = 0; column < structure.blocks(); ++column) {
    for (std::uint32_t k = structure.column_start[column] + 1; k < structure.column_start[column + 1]; ++k) {
      if (sets.find(column) == sets.find(structure.row[k])) continue;
      sets.join(column, structure.row[k]);
      --parts;
    }
  }
  return parts == 1 &&
         std::none_of(plan.block_vertex.begin(), plan.block_vertex.end(), [&](const VertexRef& vertex) {
           return graph.vertex_pools()[vertex.pool]->parameter(vertex.slot);
         });
}

std::optional<PlanGrowth> extend_plan(const Graph& graph, const PlanRequest& request,
                                      const PlannedElements& planned, Plan& plan) {
  Additions additions;
  BlockOf blocks = block_of(graph, plan);
  if (!Finder(graph, request, planned, plan).find(blocks, additions)) return std::nullopt;
  PlanGrowth growth;
  growth.old_blocks = plan.structure.blocks();
  growth.added = new_blocks(graph, additions, blocks, plan.structure);
  std::vector<std::uint32_t> dims;
  for (const VertexRef& vertex : additions.vertices)
    dims.push_back(static_cast<std::uint32_t>(graph.tangent_dim(vertex)));
  if (count_values(plan.structure, dims, growth.added) >= Scatter::kTransposed) return std::nullopt;
  const Shifts shifts = GrownStructure(plan.structure, growth).grow(dims);
  append_to_lists(additions, plan.structure, plan);
  plan.chunks.back().last_column = plan.structure.blocks();
  for (Chunk& chunk : plan.chunks) {
    for (Scatter& scatter : chunk.scatters) move_targets(graph, shifts, scatter);
    for (std::uint32_t p = 0; p < additions.edges.size(); ++p)
      append_edges(graph, p, additions.edges[p], blocks, plan.structure, chunk);
  }
  return growth;
}

}  // namespace boxplus
