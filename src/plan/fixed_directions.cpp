// SPDX-License-Identifier: BSD-3-Clause
#include "plan/fixed_directions.h"

#include <algorithm>
#include <cmath>

namespace boxplus {
namespace {

/// The fixed directions of the vertex of each block. Leaves out directions that no longer exist, because an
/// estimate of run-time size may have shrunk since its directions were fixed.
class FixedOfBlocks {
 public:
  FixedOfBlocks(const Graph& graph, const Plan& plan) : graph_(graph), plan_(plan) {}

  template <class F>
  void for_each(std::uint32_t block, F&& f) const {
    const VertexRef& vertex = plan_.block_vertex[block];
    for (const int direction : graph_.vertex_pools()[vertex.pool]->fixed_directions(vertex.slot)) {
      if (static_cast<std::uint32_t>(direction) < plan_.structure.dim(block))
        f(static_cast<std::uint32_t>(direction));
    }
  }

 private:
  const Graph& graph_;
  const Plan& plan_;
};

/// Lists the entries of the k-th block of H that belong to fixed directions. The block lies in `column`.
/// Entry 0 is the one that H has at `origin`.
void list_block(const FixedOfBlocks& fixed_of, const BlockStructure& structure, std::uint32_t column,
                std::uint32_t k, std::uint32_t origin, Chunk::FixedScalars& out) {
  const std::uint32_t row = structure.row[k], rows = structure.dim(row), cols = structure.dim(column);
  const std::uint32_t first = structure.value_start[k] - origin;
  const auto add = [&](std::uint32_t r, std::uint32_t c) {
    if (row != column || r != c) out.values.push_back(first + c * rows + r);
  };
  fixed_of.for_each(column, [&](std::uint32_t c) {
    for (std::uint32_t r = 0; r < rows; ++r) add(r, c);
    if (row == column) out.diagonals.push_back(first + c * rows + c);
  });
  fixed_of.for_each(row, [&](std::uint32_t r) {
    for (std::uint32_t c = 0; c < cols; ++c) add(r, c);
  });
}

/// Lists the fixed scalars of the columns [first, last), and the entries of these columns whose values are
/// stored from `origin` on.
void list_columns(const FixedOfBlocks& fixed_of, const BlockStructure& structure, std::uint32_t first,
                  std::uint32_t last, std::uint32_t origin, Chunk::FixedScalars& out) {
  for (std::uint32_t column = first; column < last; ++column) {
    fixed_of.for_each(column, [&](std::uint32_t direction) {
      out.scalars.push_back(structure.offset[column] + direction);
    });
    for (std::uint32_t k = structure.column_start[column]; k < structure.column_start[column + 1]; ++k) {
      if (structure.value_start[k] >= origin) list_block(fixed_of, structure, column, k, origin, out);
    }
  }
}

}  // namespace

bool all_directions_fixed(const detail::VertexPool& pool, std::uint32_t slot) {
  const auto fixed = pool.fixed_directions(slot);
  const auto dim = static_cast<std::ptrdiff_t>(pool.tangent_dim(slot));
  return std::count_if(fixed.begin(), fixed.end(), [&](int direction) { return direction < dim; }) == dim;
}

void list_fixed_directions(const Graph& graph, Plan& plan) {
  const auto& pools = graph.vertex_pools();
  if (std::none_of(pools.begin(), pools.end(), [](const auto& pool) { return pool->has_fixed_directions(); }))
    return;
  const FixedOfBlocks fixed_of(graph, plan);
  for (Chunk& chunk : plan.chunks) {
    list_columns(fixed_of, plan.structure, chunk.first_column, chunk.last_column, plan.first_stored_value(),
                 chunk.fixed);
    plan.fixed_scalars.insert(plan.fixed_scalars.end(), chunk.fixed.scalars.begin(),
                              chunk.fixed.scalars.end());
  }
}

Chunk::FixedScalars all_fixed_scalars(const Graph& graph, const Plan& plan) {
  Chunk::FixedScalars all;
  if (plan.fixed_scalars.empty()) return all;
  list_columns(FixedOfBlocks(graph, plan), plan.structure, 0, plan.structure.blocks(), 0, all);
  return all;
}

void leave_out_fixed(const Chunk::FixedScalars& fixed, std::span<double> values, std::span<double> gradient) {
  for (const std::uint32_t scalar : fixed.scalars) gradient[scalar] = 0;
  for (const std::uint32_t value : fixed.values) values[value] = 0;
  for (const std::uint32_t diagonal : fixed.diagonals) {
    double& value = values[diagonal];
    if (!(value > 0 && std::isfinite(value))) value = 1;
  }
}

}  // namespace boxplus
