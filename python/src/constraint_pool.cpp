// SPDX-License-Identifier: BSD-3-Clause
#include "constraint_pool.h"

#include <array>
#include <utility>

#include "boxplus/graph/make_room.h"

namespace boxplus::python {

void add_shifts(std::span<const std::vector<double>> shifts, std::span<const std::uint32_t> edges, int rows,
                double* errors) {
  for (const std::uint32_t edge : edges) {
    for (std::size_t i = 0; i < shifts[edge].size(); ++i) errors[i] += shifts[edge][i];
    errors += rows;
  }
}

ConstraintPool::ConstraintPool(const EdgeKind& kind, std::vector<std::uint32_t> vertex_pools,
                               std::unique_ptr<EdgePool> edges)
    : EdgePool(std::move(vertex_pools), 0), kind_(&kind), edges_(std::move(edges)) {}

ConstraintPool::ConstraintPool(const ConstraintPool& other, std::unique_ptr<EdgePool> edges)
    : EdgePool(other),
      kind_(other.kind_),
      edges_(std::move(edges)),
      inner_(other.inner_),
      shifts_(other.shifts_) {}

std::unique_ptr<detail::EdgePool> ConstraintPool::clone(
    std::span<const std::unique_ptr<detail::VertexPool>> vertex_pools) const {
  return std::unique_ptr<EdgePool>(new ConstraintPool(*this, edges_->clone(vertex_pools)));
}

std::uint32_t ConstraintPool::add(const Information& information, std::span<const std::uint32_t> slots,
                                  detail::FunctionRef<std::uint32_t(EdgePool&)> add_edge) {
  const std::uint32_t inner = add_edge(*edges_);
  detail::make_room(inner_);
  detail::make_room(shifts_);
  const std::uint32_t slot = acquire_slot(slots, {}, information, kind_->rows);
  inner_.resize(this->slots());
  shifts_.resize(this->slots());
  inner_[slot] = inner;
  shifts_[slot].clear();
  return slot;
}

void ConstraintPool::reserve(std::size_t edges) {
  reserve_slots(edges);
  edges_->reserve(edges);
  inner_.reserve(edges);
  shifts_.reserve(edges);
}

void ConstraintPool::errors(std::span<const std::uint32_t> edges, double* out) const {
  std::vector<std::uint32_t> inner;
  inner.reserve(edges.size());
  for (const std::uint32_t edge : edges) inner.push_back(inner_[edge]);
  edges_->errors(inner, out);
  add_shifts(shifts_, edges, kind_->rows, out);
}

void ConstraintPool::linearize(std::span<const std::uint32_t> edges, detail::EdgeTile& tile,
                               bool force_numeric) const {
  std::array<std::uint32_t, detail::EdgeTile::kCapacity> inner;
  for (std::size_t k = 0; k < edges.size(); ++k) inner[k] = inner_[edges[k]];
  tile.in_lanes = false;
  edges_->linearize(std::span(inner.data(), edges.size()), tile, force_numeric);
  add_shifts(shifts_, edges, kind_->rows, tile.error);
}

const ConstraintPool* constraint_pool_of(const Graph& graph, EdgeRef edge) {
  if (!graph.contains(edge)) return nullptr;
  return dynamic_cast<const ConstraintPool*>(graph.edge_pools()[edge.pool].get());
}

EdgeRef add_constraint(Graph& graph, const EdgeKind& kind, std::span<const VertexRef> vertices,
                       const Information& information, detail::FunctionRef<EdgeRef(const EdgePlace&)> add) {
  const auto pool_at = [&](std::uint32_t index) {
    const auto* pool = dynamic_cast<const ConstraintPool*>(graph.edge_pools()[index].get());
    return const_cast<ConstraintPool*>(pool);  // the graph is not const
  };
  std::uint32_t index = 0;
  const auto count = static_cast<std::uint32_t>(graph.edge_pools().size());
  while (index < count && (pool_at(index) == nullptr || &pool_at(index)->kind() != &kind)) ++index;
  if (index == count) {
    std::vector<std::uint32_t> vertex_pools;
    for (const VertexRef& vertex : vertices) vertex_pools.push_back(vertex.pool);
    index = graph.add_edge_pool(std::make_unique<ConstraintPool>(kind, std::move(vertex_pools),
                                                                 kind.empty_pool(graph, vertices.data())));
  }
  return graph.add_edge(index, vertices, [&](std::span<const std::uint32_t> slots) {
    ConstraintPool& pool = *pool_at(index);
    return pool.add(information, slots, [&](detail::EdgePool& edges) {
      return add({&graph, vertices.data(), &edges, slots}).slot;
    });
  });
}

}  // namespace boxplus::python
